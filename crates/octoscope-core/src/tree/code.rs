//! Location codes [Frisken, Perry 2002, §2].

use super::Child;

/// Location code of a node: one unsigned integer per axis, the coordinates of
/// its minimum corner on the grid of the smallest cells. Bit k tells the branch
/// taken from level k+1 down to level k; a node of level l has l low bits 0.
pub type Code<const D: usize> = [u32; D];

/// Child that bit `level − 1` of every code selects in a node of `level` ≥ 1.
#[inline]
pub fn branch<const D: usize>(code: Code<D>, level: u8) -> Child<D> {
    Child::in_upper_half_where(|e| code[e] >> (level - 1) & 1 == 1)
}

/// Level of the smallest cell, occupied or not, that holds both codes: one more
/// than the number of the highest bit in which they differ on any axis.
#[inline]
pub fn common_level<const D: usize>(a: Code<D>, b: Code<D>) -> u8 {
    let union = (0..D).fold(0, |bits, e| bits | a[e] ^ b[e]);
    (u32::BITS - union.leading_zeros()) as u8
}

/// Morton code: the bits of all axes interleaved, the x bit least significant
/// in every group of D.
pub fn morton<const D: usize>(code: Code<D>) -> u64 {
    let mut interleaved = 0;
    for bit in 0..u32::BITS.min(64 / D as u32) {
        for (axis, c) in code.iter().enumerate() {
            interleaved |= u64::from(c >> bit & 1) << (bit * D as u32 + axis as u32);
        }
    }
    interleaved
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_level_is_one_more_than_the_highest_different_bit() {
        assert_eq!(common_level([0b0101, 0b1001], [0b0110, 0b1010]), 2);
        assert_eq!(common_level([7, 7, 7], [7, 7, 7]), 0);
        assert_eq!(common_level([2], [4]), 3);
    }

    #[test]
    fn branch_reads_the_bit_below_the_level() {
        assert_eq!(branch([0b100, 0b000, 0b100], 3), Child(0b101));
    }

    #[test]
    fn morton_interleaves_with_x_lowest() {
        assert_eq!(morton([0b11, 0b01]), 0b0111);
        assert_eq!(morton([1, 0, 0]), 1);
        assert_eq!(morton([0, 0, 2]), 0b100_000);
    }
}
