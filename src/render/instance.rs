//! Cells of a tree as 8-byte instances.
//!
//! A location code of three 21-bit numbers fills 64 bits but one; what many
//! instances share (level, style, axis) is told once per [`Group`], a
//! consecutive range of them. Neighbouring cells share their edges, so that
//! edges are instances of their own: a third of the vertices of whole boxes,
//! and no line is drawn twice.

use super::camera::World;
use std::ops::Range;

/// The grid of smallest cells that codes count on, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Minimum corner of the root; z is 0 in the plane.
    pub min: [f64; 3],
    /// Edge length of the smallest cell.
    pub cell: f64,
    /// Level R of the root: the grid has 2^R cells per axis, R ≤ 20.
    pub root_level: u8,
}

impl Grid {
    /// Edge length of the root in world units.
    pub fn side(&self) -> f64 {
        self.cell * f64::from(1u32 << self.root_level)
    }

    /// Lowest and highest corner of the root.
    pub(super) fn bounds(&self) -> [World; 2] {
        [self.min, self.min.map(|x| x + self.side())]
    }
}

/// One cell of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Cell {
    /// Level of the node, 0 for the smallest cells.
    pub level: u8,
    /// Index into the styles of the layer.
    pub style: u8,
    /// Location code; z is 0 in the plane.
    pub code: [u32; 3],
}

/// Instances that share one draw call.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Group {
    pub level: u8,
    pub style: u8,
    /// Direction of edges; 0 for cells.
    pub axis: u8,
    pub range: Range<u32>,
}

/// An instance as the GPU reads it: x in bits 0–20, y in 21–41, z in 42–62.
pub(super) type Packed = [u32; 2];

/// The three numbers of a code, each below 2^21, in 64 bits.
pub(super) fn pack(code: [u32; 3]) -> Packed {
    let [x, y, z] = code.map(u64::from);
    let bits = x | y << 21 | z << 42;
    [bits as u32, (bits >> 32) as u32]
}

/// Instances of the cells, coarse levels first. O(n log n).
pub(super) fn cells(cells: &[Cell]) -> (Vec<Packed>, Vec<Group>) {
    grouped(cells.iter().map(|cell| (key(cell.level, cell.style, 0), cell.code)).collect())
}

/// Instances of the edges of the cells, those in common once. O(n log n).
pub(super) fn edges(cells: &[Cell]) -> (Vec<Packed>, Vec<Group>) {
    let mut edges = Vec::with_capacity(cells.len() * 12);
    for cell in cells {
        let side = 1 << cell.level;
        for axis in 0..3 {
            for [v, w] in [[0, 0], [side, 0], [0, side], [side, side]] {
                let mut code = cell.code;
                code[(axis + 1) % 3] += v;
                code[(axis + 2) % 3] += w;
                edges.push((key(cell.level, cell.style, axis as u8), code));
            }
        }
    }
    grouped(edges)
}

/// Instances of the edges of the faces at the lower ends of the cells on `across`,
/// those in common once. O(n log n).
pub(super) fn face_edges(cells: &[Cell], across: usize) -> (Vec<Packed>, Vec<Group>) {
    let mut edges = Vec::with_capacity(cells.len() * 4);
    for cell in cells {
        for axis in (0..3).filter(|axis| *axis != across) {
            for beside in [0, 1 << cell.level] {
                let mut code = cell.code;
                code[3 - axis - across] += beside;
                edges.push((key(cell.level, cell.style, axis as u8), code));
            }
        }
    }
    grouped(edges)
}

/// Sorts coarse levels first.
fn key(level: u8, style: u8, axis: u8) -> u32 {
    u32::from(u8::MAX - level) << 16 | u32::from(style) << 8 | u32::from(axis)
}

fn grouped(mut keyed: Vec<(u32, [u32; 3])>) -> (Vec<Packed>, Vec<Group>) {
    keyed.sort_unstable();
    keyed.dedup();
    let mut groups = Vec::new();
    let mut start = 0;
    for same in keyed.chunk_by(|a, b| a.0 == b.0) {
        let [_, level, style, axis] = same[0].0.to_be_bytes();
        let end = start + same.len() as u32;
        groups.push(Group { level: u8::MAX - level, style, axis, range: start..end });
        start = end;
    }
    (keyed.into_iter().map(|(_, code)| pack(code)).collect(), groups)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_packed_code_keeps_21_bits_an_axis() {
        let largest = (1 << 21) - 1;
        assert_eq!(pack([largest, 0, 0]), [0x001f_ffff, 0]);
        assert_eq!(pack([0, largest, 0]), [0xffe0_0000, 0x3ff]);
        assert_eq!(pack([0, 0, largest]), [0, 0x7fff_fc00]);
    }

    #[test]
    fn cells_are_grouped_coarse_levels_first() {
        let cell = |level, style, x| Cell { level, style, code: [x, 0, 0] };
        let (packed, groups) = cells(&[cell(0, 1, 1), cell(3, 0, 8), cell(0, 1, 0)]);
        assert_eq!(packed, [[8, 0], [0, 0], [1, 0]]);
        let expected = [
            Group { level: 3, style: 0, axis: 0, range: 0..1 },
            Group { level: 0, style: 1, axis: 0, range: 1..3 },
        ];
        assert_eq!(groups, expected);
    }

    #[test]
    fn neighbours_share_their_edges() {
        let cell = |x| Cell { level: 1, style: 0, code: [x, 0, 0] };
        assert_eq!(edges(&[cell(0)]).0.len(), 12);
        assert_eq!(edges(&[cell(0), cell(2)]).0.len(), 20);
        assert_eq!(edges(&[cell(0), cell(2)]).1.len(), 3);
        // The face across y of two cells side by side on x.
        assert_eq!(face_edges(&[cell(0), cell(2)], 1).0.len(), 7);
    }
}
