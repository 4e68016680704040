//! Titles and round values along the sides of a map.

use crate::look::Look;
use crate::map::{Axis, Tick};
use crate::widgets::caption;
use eframe::egui::{Align2, FontId, Painter, Rect, Sense, Stroke, Ui, Vec2, pos2, vec2};

/// Height of type.
const SIZE: f32 = 12.0;
/// Length of the mark of a value, and room between it and the value.
const MARK: f32 = 4.0;
const GAP: f32 = 3.0;

/// Room for a map of this height against its width, with its sides to the left and below
/// if it has any. Returns where the map is.
pub fn room(ui: &mut Ui, look: &Look, axes: Option<&[Axis; 2]>, height: f32) -> Rect {
    let [left, below] = axes.map_or([0.0; 2], |axes| margins(ui, look, axes));
    if let Some([_, up]) = axes {
        caption(ui, look, format!("↑ {}", look.text(up.title)));
    }
    let width = (ui.available_width() - left).floor();
    let map = vec2(width, (height * width).floor());
    let (all, _) = ui.allocate_exact_size(map + vec2(left, below), Sense::hover());
    if let Some([right, _]) = axes {
        caption(ui, look, format!("→ {}", look.text(right.title)));
    }
    Rect::from_min_size(all.min + Vec2::RIGHT * left, map)
}

/// Room for the values to the left of a map and below it.
fn margins(ui: &Ui, look: &Look, [_, up]: &[Axis; 2]) -> [f32; 2] {
    let size_of =
        |tick: Tick| ui.painter().layout_no_wrap(tick.text, font(look), look.palette.quiet).size();
    let all = up.ticks().into_iter().map(size_of).fold(Vec2::ZERO, Vec2::max);
    [all.x.ceil() + MARK + GAP, all.y.ceil() + MARK]
}

fn font(look: &Look) -> FontId {
    FontId::proportional(look.type_size(SIZE))
}

/// The values with their marks around a map in `rect`.
pub fn paint(painter: &Painter, look: &Look, rect: Rect, [right, up]: &[Axis; 2]) {
    let stroke = Stroke::new(1.0, look.palette.quiet);
    for Tick { share, text } in right.ticks() {
        let x = rect.left() + share as f32 * rect.width();
        painter.vline(x, rect.bottom()..=rect.bottom() + MARK, stroke);
        let galley = painter.layout_no_wrap(text, font(look), look.palette.quiet);
        let most = rect.right() - galley.size().x;
        let left = (x - 0.5 * galley.size().x).min(most);
        painter.galley(pos2(left, rect.bottom() + MARK), galley, look.palette.quiet);
    }
    for Tick { share, text } in up.ticks() {
        let y = rect.bottom() - share as f32 * rect.height();
        painter.hline(rect.left() - MARK..=rect.left(), y, stroke);
        let at = pos2(rect.left() - MARK - GAP, y);
        painter.text(at, Align2::RIGHT_CENTER, text, font(look), look.palette.quiet);
    }
}
