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

/// The bits that are set along any axis.
#[inline]
pub fn joined<const D: usize>(code: Code<D>) -> u32 {
    code.into_iter().fold(0, |bits, c| bits | c)
}

/// Level of the smallest cell, occupied or not, that holds both codes: one more
/// than the number of the highest bit in which they differ on any axis.
#[inline]
pub fn common_level<const D: usize>(a: Code<D>, b: Code<D>) -> u8 {
    let differences = joined(std::array::from_fn::<u32, D, _>(|e| a[e] ^ b[e]));
    (u32::BITS - differences.leading_zeros()) as u8
}

/// Morton code: the bits of all axes interleaved, the x bit least significant
/// in every group of D. Of each code the lowest 64 / D bits count.
pub fn morton<const D: usize>(code: Code<D>) -> u64 {
    let mut interleaved = 0;
    for (axis, &c) in code.iter().enumerate() {
        interleaved |= spread::<D>(c.into()) << axis;
    }
    interleaved
}

/// Bits of a number with D − 1 zeros between them: halves are moved apart, then
/// halves of halves, down to single bits.
fn spread<const D: usize>(mut bits: u64) -> u64 {
    let halvings: &[(u32, u64)] = match D {
        2 => &[
            (16, 0x0000_ffff_0000_ffff),
            (8, 0x00ff_00ff_00ff_00ff),
            (4, 0x0f0f_0f0f_0f0f_0f0f),
            (2, 0x3333_3333_3333_3333),
            (1, 0x5555_5555_5555_5555),
        ],
        3 => &[
            (32, 0x001f_0000_0000_ffff),
            (16, 0x001f_0000_ff00_00ff),
            (8, 0x100f_00f0_0f00_f00f),
            (4, 0x10c3_0c30_c30c_30c3),
            (2, 0x1249_2492_4924_9249),
        ],
        _ => return (0..64 / D as u32).fold(0, |s, b| s | (bits >> b & 1) << (b * D as u32)),
    };
    bits &= u64::MAX >> (64 - 64 / D);
    for &(shift, mask) in halvings {
        bits = (bits | bits << shift) & mask;
    }
    bits
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

    /// Bit by bit.
    fn interleaved<const D: usize>(code: Code<D>) -> u64 {
        let bits = (0..64 / D as u32).flat_map(|bit| (0..D).map(move |axis| (bit, axis)));
        bits.fold(0, |all, (bit, axis)| {
            all | (u64::from(code[axis]) >> bit & 1) << (bit * D as u32 + axis as u32)
        })
    }

    #[test]
    fn spreading_by_halves_interleaves_bit_by_bit() {
        let mut random = crate::random::Random::new(1);
        for _ in 0..1000 {
            let [x, y, z] = [(); 3].map(|()| random.bits() as u32);
            assert_eq!(morton([x, y, z]), interleaved([x, y, z]));
            assert_eq!(morton([x, y]), interleaved([x, y]));
            assert_eq!(morton([x >> 16]), interleaved([x >> 16]));
        }
    }
}
