//! Numbers with no more digits than can be told apart.

/// `x` to a power of ten below `resolution`, so that numbers stay short.
pub fn rounded(x: f64, resolution: f64) -> f64 {
    /// Powers of ten up to this one are doubles.
    const MOST_EXACT: i32 = 22;
    let digits = (-(resolution * 0.5).log10().floor()).clamp(0.0, 320.0);
    let power = 10f64.powi(MOST_EXACT.min(digits as i32));
    let whole = (x * power).round();
    if digits <= f64::from(MOST_EXACT) && whole.abs() < 2f64.powi(53) {
        // The quotient of two exact numbers is the double nearest to it.
        return whole / power;
    }
    let digits = digits as usize;
    format!("{x:.digits$}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_short_as_the_view_is_coarse() {
        assert_eq!(rounded(0.123_456, 0.01), 0.123);
        assert_eq!(rounded(-0.123_456, 0.01), -0.123);
        assert_eq!(rounded(1.234_567e-18, 1e-20), 1.235e-18);
        assert_eq!(rounded(1_234.567, 1e-3), 1_234.567);
        assert_eq!(rounded(1.5e300, 1e-3), 1.5e300);
    }
}
