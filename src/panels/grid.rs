//! The walk from cell to cell of the finest grid.

use crate::look::Look;
use crate::widgets::{caption, captioned, per_axis};
use eframe::egui::{
    Align2, FontFamily, FontId, Painter, Rangef, Rect, Sense, Stroke, Ui, WidgetInfo,
    accesskit::Role, pos2, vec2,
};
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::trace::{Counter, GridCell, Moment};
use octoscope_figure::views::planes_ahead;

/// Number of cells so far.
pub fn note<const D: usize>(look: &Look, moment: &Moment<D>) -> String {
    let n = moment.counters.get(Counter::GridCells);
    look.texts.format("grid-count", &[("n", n.into())])
}

/// Room for the letter of an axis before its bar.
const LETTER: f32 = 24.0;
/// Room for numbers behind the bars: the same in most steps, so that bars do not jump.
const ROOM: f32 = 140.0;
/// Between a bar and the numbers behind it.
const GAP: f32 = 10.0;
/// Bars are no shorter than this.
const LEAST: f32 = 48.0;

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    30.0 + 26.0 * D as f32
}

/// When the next plane of every axis is met, on bars that begin where the ray enters the
/// cell, and the codes of the cell. Lit is what is met first; in the step that crosses a
/// plane, that plane, with its parameter and the one of the plane behind it.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, moment: &Moment<D>) {
    let Some(grid) = moment.grid else {
        caption(ui, look, look.text("grid-none"));
        return;
    };
    bars(ui, look, &grid);
    let cell = match grid.cell {
        Some(cell) => per_axis(cell.map(|c| c.to_string())),
        None => look.text("grid-outside").into(),
    };
    let axes: Vec<_> = grid.crossed.iter().map(|axis| AXIS_NAMES[axis]).collect();
    let crossed = if axes.is_empty() {
        String::new()
    } else {
        look.texts.format("grid-crossed", &[("axes", axes.join(", ").into())])
    };
    captioned(ui, look, &look.text("grid-cell"), &cell, &crossed);
}

/// A bar for every axis, from the parameter of the cell on, with its numbers behind it.
fn bars<const D: usize>(ui: &mut Ui, look: &Look, grid: &GridCell<D>) {
    const ROW: f32 = 26.0;
    let shares = shares(&grid.next, grid.enter);
    let lit = lit(grid);
    let told = planes_ahead(grid.left, grid.next);
    let size = vec2(ui.available_width(), ROW * D as f32);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let spoken: Vec<_> = (0..D).map(|e| format!("tMax {} {}", AXIS_NAMES[e], told[e])).collect();
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.join(", ")));
    let painter = ui.painter_at(rect);
    let widths = told.iter().map(|text| {
        let font = FontId::new(13.0, look.mono_strong_family());
        painter.layout_no_wrap(text.clone(), font, look.palette.ink).size().x + GAP
    });
    let room = widths.fold(ROOM, f32::max).min(rect.width() - LETTER - LEAST);
    for axis in 0..D {
        let middle = rect.top() + ROW * (axis as f32 + 0.5);
        let row = Rect::from_center_size(pos2(rect.center().x, middle), vec2(rect.width(), ROW));
        let track = Rangef::new(row.left() + LETTER, row.right() - room);
        let bar = Bar { axis, share: shares[axis], wins: lit.contains(axis), told: &told[axis] };
        bar.paint(&painter, look, row, track);
    }
}

/// What is shown of an axis.
struct Bar<'a> {
    axis: usize,
    /// Its length; `None` if it has no end.
    share: Option<f32>,
    /// Whether its plane is met first.
    wins: bool,
    told: &'a str,
}

impl Bar<'_> {
    fn paint(&self, painter: &Painter, look: &Look, row: Rect, track: Rangef) {
        let palette = &look.palette;
        let (y, color) = (row.center().y, palette.axes[self.axis]);
        let strong = FontId::new(14.0, look.strong_family());
        let (start, letter) = (row.left_center(), AXIS_NAMES[self.axis]);
        painter.text(start, Align2::LEFT_CENTER, letter, strong, color);
        painter.hline(track, y, Stroke::new(1.0, palette.grid));
        if let Some(share) = self.share {
            let end = (track.min + share * track.span()).max(track.min + 2.0);
            let width = if self.wins { 11.0 } else { 6.0 };
            painter.hline(track.min..=end, y, Stroke::new(width, color));
        } else {
            let way = vec2(track.span(), 0.0);
            painter.arrow(pos2(track.min, y), way, Stroke::new(1.5, color));
        }
        let (ink, family) = if self.wins {
            (palette.ink, look.mono_strong_family())
        } else {
            (palette.quiet, FontFamily::Monospace)
        };
        let font = FontId::new(13.0, family);
        painter.text(row.right_center(), Align2::RIGHT_CENTER, self.told, font, ink);
    }
}

/// How far from `first` to the last of some parameters each lies, from 0 to 1; `None` of
/// those that are never reached.
fn shares<const D: usize>(parameters: &[f64; D], first: f64) -> [Option<f32>; D] {
    let last = parameters.iter().copied().filter(|t| t.is_finite()).fold(first, f64::max);
    parameters.map(|t| {
        let share = if last > first { (t - first) / (last - first) } else { 0.0 };
        t.is_finite().then_some(share.clamp(0.0, 1.0) as f32)
    })
}

/// The axes whose planes are met first: those that are crossed in this step.
fn lit<const D: usize>(grid: &GridCell<D>) -> Axes<D> {
    if grid.left.is_some() {
        return grid.crossed;
    }
    let nearest = grid.next.into_iter().fold(f64::INFINITY, f64::min);
    Axes::of(|axis| grid.next[axis] == nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_of_a_ray_from_far_away_tell_its_planes_apart() {
        assert_eq!(shares(&[10.25, 10.5], 10.0), [Some(0.5), Some(1.0)]);
        assert_eq!(shares(&[0.25, f64::INFINITY], 0.0), [Some(1.0), None]);
        assert_eq!(shares(&[3.0, 3.0], 3.0), [Some(0.0); 2]);
    }

    #[test]
    fn the_axis_that_is_crossed_is_lit() {
        let (cell, crossed) = (Some([17, 18]), Axes::one(1));
        let next = [0.7855, 0.7984];
        let grid = GridCell { enter: 0.748, cell, next, crossed, left: Some([0.7855, 0.748]) };
        assert_eq!(lit(&grid), Axes::one(1));
        let later = GridCell { left: None, ..grid };
        assert_eq!(lit(&later), Axes::one(0));
    }
}
