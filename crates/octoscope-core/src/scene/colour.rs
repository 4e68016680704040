//! Colours of leaves that are made from a picture.

use super::Image;
use crate::tree::{Code, NodeId, Tree};
use std::ops::Range;

/// Mean colour of the picture in a node, or `None` where the node lies beside
/// the picture. Looks at every pixel of the node.
pub fn mean_colour(image: &Image, tree: &Tree<2>, id: NodeId) -> Option<[u8; 3]> {
    let root_level = tree.domain().root_level();
    let [columns, rows] = pixels_of(image, root_level, tree.level(id), tree.code(id));
    let count = columns.len() as u64 * rows.len() as u64;
    let mut sum = [0u64; 3];
    for row in rows {
        for column in columns.clone() {
            let pixel = image.pixel_from_below(column, row);
            sum = std::array::from_fn(|channel| sum[channel] + u64::from(pixel[channel]));
        }
    }
    (count > 0).then(|| sum.map(|s| ((s + count / 2) / count) as u8))
}

/// Mean colour of every leaf by node number; `None` for inner nodes and beside
/// the picture. O(pixels + nodes).
pub fn leaf_colours(image: &Image, tree: &Tree<2>) -> Vec<Option<[u8; 3]>> {
    let colour = |id| mean_colour(image, tree, id);
    tree.nodes().map(|node| if node.is_leaf() { colour(node.id) } else { None }).collect()
}

/// Columns and rows of the picture, rows counted from below, that lie in the
/// cell with this level and code of a tree with `root_level` levels below the
/// root. The root has 2^k × 2^k pixels, the picture in its lower left corner.
/// A cell smaller than a pixel has the pixel around it.
pub fn pixels_of(image: &Image, root_level: u8, level: u8, code: Code<2>) -> [Range<u32>; 2] {
    let grid_level = image.grid_level();
    // A picture may be as large as 2^32 pixels along a side.
    let pixel = |index: u32, round_up: u64| match root_level.checked_sub(grid_level) {
        Some(finer) => (u64::from(index) + round_up * ((1 << finer) - 1)) >> finer,
        None => u64::from(index) << (grid_level - root_level),
    };
    let range = |axis: usize, size: u32| {
        let within = |pixel: u64| pixel.min(u64::from(size)) as u32;
        let end = within(pixel(code[axis] + (1 << level), 1));
        within(pixel(code[axis], 0)).min(end)..end
    };
    [range(0, image.width), range(1, image.height)]
}
