//! Figures as pixels.

use crate::{Background, Drawn, Figure, FileOptions, Scale, fonts, svg};
use resvg::{tiny_skia, usvg};
use std::ops::Range;
use std::sync::{Arc, LazyLock};
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

/// Most pixels along a side, and in all.
const LARGEST: u32 = 1 << 14;
const MOST_PIXELS: f64 = 1e8;

impl Pixels {
    /// Pixels of a figure. A page unit is as many as the scale says, in whatever
    /// unit; text is set in the typefaces of [`fonts`].
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

/// Figures as pixels, one after the other. What several begin with is drawn once:
/// the steps of a run differ above the leaves only.
pub struct Rasteriser<'a> {
    options: FileOptions<'a>,
    /// The figure before.
    before: Vec<Drawn>,
    /// The first shapes of it as pixels, and their number.
    base: Option<(tiny_skia::Pixmap, usize)>,
}

impl<'a> Rasteriser<'a> {
    /// One that has drawn nothing yet.
    pub fn new(options: &FileOptions<'a>) -> Self {
        // The picture holds neither a title nor a scenario.
        let options = FileOptions { title: "", scenario: "", ..*options };
        Self { options, before: Vec::new(), base: None }
    }

    /// Pixels of a figure, as [`Pixels::of`].
    ///
    /// # Errors
    /// Refuses sizes without pixels or with far too many.
    pub fn pixels(&mut self, figure: &Figure) -> Result<Pixels, PixelsError> {
        let page = [figure.page.width, figure.page.height];
        let [width, height] = page.map(|side| (side * self.options.scale.factor).round());
        let fits = |side: f64| (1.0..=f64::from(LARGEST)).contains(&side);
        let size = || PixelsError::Size(width, height);
        if !fits(width) || !fits(height) || width * height > MOST_PIXELS {
            return Err(size());
        }
        let (width, height) = (width as u32, height as u32);
        let is_as_large = |(base, _): &(tiny_skia::Pixmap, usize)| {
            [base.width(), base.height()] == [width, height]
        };
        let n_shared = figure.drawn.iter().zip(&self.before).take_while(|(a, b)| a == b).count();
        let base = self.base.take().filter(is_as_large).filter(|(_, n_drawn)| {
            // Much more is shared than is drawn: then it is worth drawing that.
            (n_shared / 2..=n_shared).contains(n_drawn)
        });
        let base = match base {
            Some(base) => base,
            None => {
                let mut blank = tiny_skia::Pixmap::new(width, height).ok_or_else(size)?;
                let background = self.options.background;
                self.draw(figure, 0..n_shared, background, &mut blank)?;
                (blank, n_shared)
            }
        };
        let mut pixmap = base.0.clone();
        let rest = base.1..figure.drawn.len();
        self.draw(figure, rest, Background::Transparent, &mut pixmap)?;
        (self.base, self.before) = (Some(base), figure.drawn.clone());
        let rgba = pixmap.pixels().iter().flat_map(|pixel| {
            let pixel = pixel.demultiply();
            [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()]
        });
        Ok(Pixels { width, height, rgba: rgba.collect() })
    }

    /// Draws some of the shapes of a figure over what is there.
    fn draw(
        &self,
        figure: &Figure,
        shapes: Range<usize>,
        background: Background,
        pixmap: &mut tiny_skia::Pixmap,
    ) -> Result<(), PixelsError> {
        static TYPEFACES: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
            let mut database = usvg::fontdb::Database::new();
            for font in fonts::ALL {
                database.load_font_data(font.to_vec());
            }
            database.set_sans_serif_family("Inter");
            database.set_monospace_family("JetBrains Mono");
            Arc::new(database)
        });
        if shapes.is_empty() && background == Background::Transparent {
            return Ok(());
        }
        let setting = usvg::Options {
            fontdb: TYPEFACES.clone(),
            font_family: "Inter".to_string(),
            ..usvg::Options::default()
        };
        let page = figure.page;
        let part = Figure { page, drawn: figure.drawn[shapes].to_vec() };
        let options = FileOptions { scale: Scale::default(), background, ..self.options };
        let tree = usvg::Tree::from_str(&svg(&part, &options), &setting)?;
        let transform = tiny_skia::Transform::from_scale(
            (f64::from(pixmap.width()) / page.width) as f32,
            (f64::from(pixmap.height()) / page.height) as f32,
        );
        resvg::render(&tree, transform, &mut pixmap.as_mut());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Form, Page, Part, Role};

    /// A few leaves, visited ones above them, and a text.
    fn figure(n_visited: usize) -> Figure {
        let square = |n: usize| {
            let x = 8.0 * n as f64 + 3.3;
            Form::Polygon(vec![[x, 5.0], [x + 8.0, 5.0], [x + 8.0, 20.5], [x, 20.5]])
        };
        let drawn = |role, form| Drawn { form, role, part: Part::Whole, node: None };
        let mut all: Vec<_> = (0..9).map(|n| drawn(Role::FullLeaf, square(n))).collect();
        all.extend((0..n_visited).map(|n| drawn(Role::Visited { share: 0.1 }, square(n))));
        let (at, anchor) = ([40.0, 12.0], crate::Anchor::Middle);
        let text = n_visited.to_string().into();
        all.push(drawn(Role::Words, Form::Text { at, anchor, text }));
        Figure { page: Page { width: 80.0, height: 30.0 }, drawn: all }
    }

    #[test]
    fn figures_one_after_the_other_look_as_each_alone() {
        for background in [Background::Filled, Background::Transparent] {
            let options = FileOptions { background, ..FileOptions::default() };
            let mut rasteriser = Rasteriser::new(&options);
            for n_visited in [0, 1, 2, 7, 3, 0, 9, 9, 8] {
                let figure = figure(n_visited);
                let expected = Pixels::of(&figure, &options).unwrap();
                let found = rasteriser.pixels(&figure).unwrap();
                let worst = found.rgba.iter().zip(&expected.rgba).map(|(a, b)| a.abs_diff(*b));
                assert!(worst.max() <= Some(1), "{n_visited} {background:?}");
            }
            let larger = Figure { page: Page { width: 90.0, height: 30.0 }, ..figure(8) };
            assert_eq!(rasteriser.pixels(&larger).unwrap().width, 90);
        }
    }

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
