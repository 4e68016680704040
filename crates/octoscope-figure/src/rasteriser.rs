//! Figures as pixels, one after the other.

use crate::changes::changes;
use crate::{
    Background, Drawn, Extent, Figure, FileOptions, Form, Page, Part, Pixels, PixelsError, Scale,
    Style, fonts, metrics, svg,
};
use resvg::{tiny_skia, usvg};
use std::sync::{Arc, LazyLock};
use tiny_skia::Pixmap;

/// Most pixels along a side, and in all.
const LARGEST: u32 = 1 << 14;
const MOST_PIXELS: f64 = 1e8;

/// Figures as pixels, one after the other. What one shares with the figure before is
/// not drawn again: the steps of a run differ in few places. The pixels are those of
/// each figure alone.
pub struct Rasteriser<'a> {
    options: FileOptions<'a>,
    /// The figure before, and its pixels.
    before: Option<(Figure, Pixmap)>,
}

/// Part of a picture: the first and the last column and row.
type Rectangle = [[u32; 2]; 2];

impl<'a> Rasteriser<'a> {
    /// One that has drawn nothing yet.
    pub fn new(options: &FileOptions<'a>) -> Self {
        // The picture holds neither a title nor a scenario.
        let options = FileOptions { title: "", scenario: "", ..*options };
        Self { options, before: None }
    }

    /// Pixels of a figure, as [`Pixels::of`].
    ///
    /// # Errors
    /// Refuses sizes without pixels or with far too many.
    pub fn pixels(&mut self, figure: &Figure) -> Result<Pixels, PixelsError> {
        let figure = figure.spelled_out().into_owned();
        let page = [figure.page.width, figure.page.height];
        let [width, height] = page.map(|side| (side * self.options.scale.factor).round());
        let fits = |side: f64| (1.0..=f64::from(LARGEST)).contains(&side);
        let size = || PixelsError::Size(width, height);
        if !fits(width) || !fits(height) || width * height > MOST_PIXELS {
            return Err(size());
        }
        let (width, height) = (width as u32, height as u32);
        let before = self.before.take().filter(|(before, _)| before.page == figure.page);
        let again = match &before {
            Some((before, pixmap)) => self.to_draw_again(before, &figure, pixmap),
            None => None,
        };
        let pixmap = match (before, again) {
            (Some((_, mut pixmap)), Some((places, shapes))) => {
                if !places.is_empty() {
                    let mut now = Pixmap::new(width, height).ok_or_else(size)?;
                    self.draw(figure.page, shapes, &mut now)?;
                    places.into_iter().for_each(|place| copy(&now, place, &mut pixmap));
                }
                pixmap
            }
            (_, _) => {
                let mut pixmap = Pixmap::new(width, height).ok_or_else(size)?;
                self.draw(figure.page, figure.drawn.clone(), &mut pixmap)?;
                pixmap
            }
        };
        let rgba = pixmap.pixels().iter().flat_map(|pixel| {
            let pixel = pixel.demultiply();
            [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()]
        });
        let rgba = rgba.collect();
        self.before = Some((figure, pixmap));
        Ok(Pixels { width, height, rgba })
    }

    /// Where a figure may look other than the one before, and all shapes that may be
    /// seen there; `None` if these are many.
    fn to_draw_again(
        &self,
        before: &Figure,
        now: &Figure,
        pixmap: &Pixmap,
    ) -> Option<(Vec<Rectangle>, Vec<Drawn>)> {
        /// More changes than this are as much work to find as to draw.
        const MOST: usize = 300;
        let ends = [pixmap.width() - 1, pixmap.height() - 1];
        let [x, y] = [
            f64::from(pixmap.width()) / now.page.width,
            f64::from(pixmap.height()) / now.page.height,
        ];
        let in_pixels = |extent: Extent| -> Option<Rectangle> {
            // Edges are smoothed over a pixel.
            let first = [extent.min[0] * x, extent.min[1] * y].map(|side| side.floor() - 1.0);
            let last = [extent.max[0] * x, extent.max[1] * y].map(|side| side.ceil() + 1.0);
            let is_on_it = (0..2).all(|e| last[e] >= 0.0 && first[e] <= f64::from(ends[e]));
            // What lies beyond the ends is cut off.
            let first = first.map(|side| side as u32);
            let last = std::array::from_fn(|e| (last[e] as u32).min(ends[e]));
            is_on_it.then_some([first, last])
        };
        let changed = changes(&before.drawn, &now.drawn, MOST)?;
        let places: Vec<Rectangle> = changed
            .into_iter()
            .flat_map(|drawn| self.places(drawn))
            .filter_map(in_pixels)
            .collect();
        let is_seen_there = |drawn: &&Drawn| {
            self.places(drawn).into_iter().filter_map(in_pixels).any(|[first, last]| {
                let meets =
                    |[a, b]: &Rectangle| (0..2).all(|e| a[e] <= last[e] && first[e] <= b[e]);
                places.iter().any(meets)
            })
        };
        let shapes: Vec<Drawn> = now.drawn.iter().filter(is_seen_there).cloned().collect();
        (2 * shapes.len() <= now.drawn.len() || places.is_empty()).then_some((places, shapes))
    }

    /// Parts of the page beyond which nothing of a shape is seen: of a mere line, those
    /// of its pieces.
    fn places(&self, drawn: &Drawn) -> Vec<Extent> {
        let style = Style::of(self.options.theme, drawn.role);
        let half = (0.5 * style.width + style.casing) * self.options.line_scale;
        let around = |points: &[[f64; 2]]| {
            Extent::around(points.iter().copied()).map(|extent| extent.widened(half))
        };
        let is_line = match drawn.part {
            Part::Edge | Part::FineEdge | Part::HiddenEdge | Part::Casing => true,
            Part::Whole | Part::Fine => style.fill.is_none(),
            Part::Face(_) | Part::Head | Part::Lit(_) => false,
        };
        match &drawn.form {
            Form::Polygon(points) if is_line => {
                let next = points.iter().cycle().skip(1);
                points.iter().zip(next).filter_map(|(a, b)| around(&[*a, *b])).collect()
            }
            Form::Polyline(points) if is_line => points.windows(2).filter_map(around).collect(),
            Form::Polygon(points) | Form::Polyline(points) => around(points).into_iter().collect(),
            Form::Circle { centre, radius } => {
                vec![Extent { min: *centre, max: *centre }.widened(radius + half)]
            }
            Form::Text { .. } | Form::Formula { .. } => {
                // Letters lean out of their widths, and below their line.
                let size = metrics::size(drawn.role);
                let figure = Figure { page: PAGE, drawn: vec![drawn.clone()] };
                figure.extent().map(|extent| extent.widened(size)).into_iter().collect()
            }
        }
    }

    /// Draws shapes over a page of nothing, its background first.
    fn draw(&self, page: Page, shapes: Vec<Drawn>, pixmap: &mut Pixmap) -> Result<(), PixelsError> {
        static TYPEFACES: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
            let mut database = usvg::fontdb::Database::new();
            for font in fonts::ALL {
                database.load_font_data(font.to_vec());
            }
            database.set_sans_serif_family("Inter");
            database.set_monospace_family("JetBrains Mono");
            Arc::new(database)
        });
        if shapes.is_empty() && self.options.background == Background::Transparent {
            return Ok(());
        }
        let setting = usvg::Options {
            fontdb: TYPEFACES.clone(),
            font_family: "Inter".to_string(),
            ..usvg::Options::default()
        };
        let part = Figure { page, drawn: shapes };
        let options = FileOptions { scale: Scale::default(), ..self.options };
        let tree = usvg::Tree::from_str(&svg(&part, &options), &setting)?;
        // The page as it is written, in few digits: an SVG shows the same pixels.
        let size = tree.size();
        let transform = tiny_skia::Transform::from_scale(
            pixmap.width() as f32 / size.width(),
            pixmap.height() as f32 / size.height(),
        );
        resvg::render(&tree, transform, &mut pixmap.as_mut());
        Ok(())
    }
}

/// A page for a shape whose extent is asked for; that does not depend on it.
const PAGE: Page = Page { width: 1.0, height: 1.0 };

/// Copies a part of one picture to another one of its size.
fn copy(from: &Pixmap, [[left, top], [right, bottom]]: Rectangle, to: &mut Pixmap) {
    let width = from.width();
    for y in top..=bottom {
        let row = (y * width + left) as usize..=(y * width + right) as usize;
        to.pixels_mut()[row.clone()].copy_from_slice(&from.pixels()[row]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Anchor, Role};

    /// A few leaves, visited ones above them, and a text.
    fn figure(n_visited: usize) -> Figure {
        let square = |n: usize| {
            let x = 8.0 * n as f64 + 3.3;
            Form::Polygon(vec![[x, 5.0], [x + 8.0, 5.0], [x + 8.0, 20.5], [x, 20.5]])
        };
        let drawn = |role, form| Drawn { form, role, part: Part::Whole, node: None };
        let mut all: Vec<_> = (0..9).map(|n| drawn(Role::FullLeaf, square(n))).collect();
        all.extend((0..n_visited).map(|n| drawn(Role::Visited { share: 0.1 }, square(n))));
        let (at, anchor) = ([40.0, 12.0], Anchor::Middle);
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
                assert!(found == expected, "{n_visited} {background:?}");
            }
            let larger = Figure { page: Page { width: 90.0, height: 30.0 }, ..figure(8) };
            assert_eq!(rasteriser.pixels(&larger).unwrap().width, 90);
        }
    }
}
