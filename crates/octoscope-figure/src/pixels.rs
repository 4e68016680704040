//! Figures as pixels.

use crate::{Figure, FileOptions, Rasteriser};
use resvg::usvg;
use thiserror::Error;

/// A picture of pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Number of pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// Red, green, blue and opacity of each, row by row from the top.
    pub rgba: Vec<u8>,
}

/// Why a picture could not be made.
#[derive(Debug, Error)]
pub enum PixelsError {
    /// The figure cannot be read as SVG.
    #[error("the figure could not be drawn: {0}")]
    Svg(#[from] usvg::Error),
    /// The picture would have no pixels, or far too many.
    #[error(
        "a picture of {0} × {1} pixels is not possible; choose 1 to 16384 along each side, and at \
         most 100 million in all"
    )]
    Size(f64, f64),
}

impl Pixels {
    /// Pixels of a figure. A page unit is as many as the scale says, in whatever
    /// unit; text is set in the typefaces of [`fonts`](crate::fonts).
    ///
    /// # Errors
    /// Refuses sizes without pixels or with far too many.
    pub fn of(figure: &Figure, options: &FileOptions) -> Result<Self, PixelsError> {
        Rasteriser::new(options).pixels(figure)
    }

    /// Where this picture differs from another one of its size: left, top, width
    /// and height; `None` if it does not.
    pub(crate) fn changed_from(&self, before: &Self) -> Option<[u32; 4]> {
        let stride = 4 * self.width as usize;
        let rows = self.rgba.chunks_exact(stride).zip(before.rgba.chunks_exact(stride));
        let (mut left, mut right, mut top, mut bottom) = (u32::MAX, 0, None, 0);
        for (y, (now, then)) in (0..).zip(rows) {
            if now == then {
                continue;
            }
            top = top.or(Some(y));
            bottom = y;
            let differs = |x: &u32| now[4 * *x as usize..][..4] != then[4 * *x as usize..][..4];
            left = left.min((0..self.width).find(differs).unwrap_or(left));
            right = right.max((0..self.width).rev().find(differs).unwrap_or(right));
        }
        let top = top?;
        Some([left, top, right - left + 1, bottom - top + 1])
    }

    /// The part with this left, top, width and height.
    pub(crate) fn part(&self, [left, top, width, height]: [u32; 4]) -> Vec<u8> {
        let stride = 4 * self.width as usize;
        let rows = self.rgba.chunks_exact(stride).skip(top as usize).take(height as usize);
        rows.flat_map(|row| &row[4 * left as usize..][..4 * width as usize]).copied().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_changed_is_the_smallest_rectangle() {
        let before = Pixels { width: 4, height: 3, rgba: vec![0; 48] };
        assert_eq!(before.changed_from(&before), None);
        let mut after = before.clone();
        after.rgba[4 * (4 + 1)] = 1;
        after.rgba[4 * (8 + 2)] = 2;
        let part = after.changed_from(&before).unwrap();
        assert_eq!(part, [1, 1, 2, 2]);
        let first_bytes: Vec<u8> = after.part(part).into_iter().step_by(4).collect();
        assert_eq!(first_bytes, [1, 0, 0, 2]);
    }
}
