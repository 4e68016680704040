//! Trees of pictures.

use super::build::Growth;
use super::{BuildError, Child, Split, Tree};
use crate::scene::{Image, pixels_of};
use std::ops::Range;

/// Region quadtree of a picture.
pub(super) fn image_tree<const D: usize>(
    image: &Image,
    growth: &Growth<D>,
) -> Result<Tree<D>, BuildError> {
    if D != 2 {
        return Err(BuildError::ImageInSpace);
    }
    let expected = u64::from(image.width) * u64::from(image.height);
    if expected != image.pixels.len() as u64 {
        return Err(BuildError::PixelCount { expected, found: image.pixels.len() });
    }
    let (root_level, threshold) = (growth.domain.root_level(), growth.recipe.threshold);
    // Side of the root in pixels, or of a pixel in cells.
    let pixels_a_side = 1u64 << image.grid_level();
    let divide = |_, ()| std::iter::repeat_n((), Child::<D>::COUNT);
    growth.tree((), divide, |cell, (), _| {
        let code = [cell.code[0], cell.code[1]];
        let [columns, rows] = pixels_of(image, root_level, cell.level, code);
        let side = (pixels_a_side << cell.level >> root_level).max(1);
        let inside = columns.len() as u64 == side && rows.len() as u64 == side;
        if columns.is_empty() || rows.is_empty() {
            Split::Empty
        } else if cell.level == 0 || inside && is_even(image, columns, rows, threshold) {
            Split::Full(())
        } else {
            Split::Inner(())
        }
    })
}

/// Whether no channel differs by more than `threshold` between two pixels.
fn is_even(image: &Image, columns: Range<u32>, rows: Range<u32>, threshold: u8) -> bool {
    let (mut low, mut high) = ([u8::MAX; 3], [0; 3]);
    for row in rows {
        for column in columns.clone() {
            let pixel = image.pixel_from_below(column, row);
            for channel in 0..3 {
                low[channel] = low[channel].min(pixel[channel]);
                high[channel] = high[channel].max(pixel[channel]);
                if high[channel] - low[channel] > threshold {
                    return false;
                }
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::scene::Content;
    use crate::tree::{Domain, Recipe, build};

    #[test]
    fn a_picture_is_cut_where_it_is_uneven_and_empty_beside() {
        // Three columns, two rows: 0 0 9 above 0 0 0, in a grid of 4 × 4.
        let pixels = [0, 0, 9, 0, 0, 0].map(|grey| [grey; 3]).to_vec();
        let content = Content::Image(Image { width: 3, height: 2, pixels });
        let recipe = Recipe { depth: 2, threshold: 8, ..Recipe::default() };
        let tree = build(&content, Domain::unit(2), &recipe, &Progress::default()).unwrap();
        let full: Vec<_> = tree.leaves().filter(|leaf| leaf.is_full()).collect();
        let places: Vec<_> = full.iter().map(|f| (tree.level(f.id), tree.code(f.id))).collect();
        assert_eq!(places, [(1, [0, 0]), (0, [2, 0]), (0, [2, 1])]);
    }
}
