//! Hexadecimal floating-point numbers as C prints them.

/// Number nearest to `text`, ties to even: sign, `0x`, hexadecimal digits with
/// at most one point, then `p` and a decimal exponent of 2, which may be left out.
/// `None` if `text` is not written so; infinite beyond the largest double.
pub fn hexadecimal(text: &str) -> Option<f64> {
    let (negative, unsigned) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let digits = unsigned.strip_prefix("0x").or_else(|| unsigned.strip_prefix("0X"))?;
    let (mantissa, exponent) = match digits.split_once(['p', 'P']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (digits, 0),
    };
    let mut exponent = i64::from(exponent);
    let (mut bits, mut lost, mut n_digits, mut behind_point) = (0u64, false, 0, false);
    for c in mantissa.chars() {
        if c == '.' && !behind_point {
            behind_point = true;
            continue;
        }
        let digit = u64::from(c.to_digit(16)?);
        n_digits += 1;
        if bits >> 60 == 0 {
            bits = bits << 4 | digit;
            exponent -= if behind_point { 4 } else { 0 };
        } else {
            lost |= digit != 0;
            exponent += if behind_point { 0 } else { 4 };
        }
    }
    if n_digits == 0 {
        return None;
    }
    let magnitude = scaled(bits, lost, exponent);
    Some(if negative { -magnitude } else { magnitude })
}

/// `bits` · 2^`exponent`, a little more if something was `lost`, rounded once.
fn scaled(bits: u64, lost: bool, exponent: i64) -> f64 {
    if bits == 0 {
        return 0.0;
    }
    // Left-aligned, the value is in [2^top, 2^(top+1)).
    let shift = bits.leading_zeros();
    let aligned = bits << shift;
    let top = exponent - i64::from(shift) + 63;
    if top > 1023 {
        return f64::INFINITY;
    }
    // Doubles below 2^-1022 have fewer bits.
    let kept = (53 + (top + 1022).min(0)).max(0);
    if kept == 0 && top < -1075 {
        return 0.0;
    }
    let dropped = 64 - kept as u32;
    let (whole, rest) = match dropped {
        64 => (0, aligned),
        _ => (aligned >> dropped, aligned & ((1 << dropped) - 1)),
    };
    let half = 1u64 << (dropped - 1);
    let up = rest > half || rest == half && (lost || whole & 1 == 1);
    let whole = whole + u64::from(up);
    let biased = (top + 1022).max(0) as u64;
    // The leading bit of `whole` adds one to the exponent, as does a carry.
    f64::from_bits((biased << 52) + whole)
}

#[cfg(test)]
mod tests {
    use super::hexadecimal;

    #[test]
    fn numbers_read_as_c_prints_them() {
        for (text, number) in [
            ("0x1.8p-1", 0.75),
            ("-0X1P4", -16.0),
            ("0x.8", 0.5),
            ("0xff", 255.0),
            ("0x1.999999999999ap-4", 0.1),
            ("0x1.fffffffffffffp+1023", f64::MAX),
            ("0x0.0000000000001p-1022", f64::from_bits(1)),
            ("0x1p-1074", f64::from_bits(1)),
            ("0x1p-1075", 0.0),
            ("0x1.8p-1075", f64::from_bits(1)),
            ("0x1p-1022", f64::MIN_POSITIVE),
            ("0x1.00000000000008p0", 1.0),
            ("0x1.000000000000080000001p0", 1.0 + f64::EPSILON),
            ("0x1p1024", f64::INFINITY),
            ("0x1.fffffffffffff8p1023", f64::INFINITY),
        ] {
            assert_eq!(hexadecimal(text), Some(number), "{text}");
        }
    }

    #[test]
    fn anything_else_is_refused() {
        for text in ["", "0x", "0x.", "1.5", "0x1.8.1", "0xg", "0x1p", "0x1p1.5", "--0x1"] {
            assert_eq!(hexadecimal(text), None, "{text}");
        }
    }
}
