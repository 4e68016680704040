//! One value for every axis.

use std::hint::select_unpredictable;

/// What `of` gives for the axes 0 … D−1. The same as [`std::array::from_fn`], but
/// always unrolled in place: walks call it several times a step.
#[inline(always)]
pub fn per_axis<const D: usize, T: Copy>(mut of: impl FnMut(usize) -> T) -> [T; D] {
    let mut values = [of(0); D];
    for axis in 1..D {
        values[axis] = of(axis);
    }
    values
}

/// Without a jump, `yes` or `no`: which of them is as good as random in a walk, so
/// that a jump would be mispredicted half of the times.
#[inline(always)]
pub fn either<T>(condition: bool, yes: T, no: T) -> T {
    select_unpredictable(condition, yes, no)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_come_in_order() {
        assert_eq!(per_axis::<3, _>(|axis| axis), [0, 1, 2]);
        assert_eq!(either(true, 1, 2) + either(false, 10, 20), 21);
    }
}
