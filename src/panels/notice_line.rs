//! What has just happened, over the picture.

use crate::look::Look;
use crate::notice::Notice;
use eframe::egui::{
    Align2, Area, Context, Frame, Id, Key, Label, Margin, Order, Panel, Pos2, Rect, Ui, vec2,
};
use std::time::Duration;

/// Size of the line before it is known.
const USUAL: [f32; 2] = [460.0, 64.0];
/// Room between the line and the edges of the view.
const BELOW: f32 = 44.0;
const ABOVE: f32 = 12.0;

/// What the line lies over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Over {
    /// The space view.
    Space {
        /// Where it is.
        space: Rect,
        /// Where the handles of its ray are.
        ray: Option<[Pos2; 2]>,
    },
    /// The whole window, which may show a dialog.
    Window,
}

/// One line at the lower edge of the space view that says what has happened; a click
/// takes it away, and so does time. It is at the upper edge where it would lie on the
/// ray, and at that of the window where it would lie on a dialog.
pub fn ui(context: &Context, look: &Look, notice: &mut Notice, over: Over) {
    let Some(strength) = strength(context, notice) else { return };
    let id = Id::unique("status");
    let known = context.memory(|memory| memory.area_rect(id));
    let size = known.map_or(USUAL.into(), |rect| rect.size());
    let space = match over {
        Over::Space { space, .. } => space,
        Over::Window => context.content_rect(),
    };
    let [below, above] = places(space, size);
    // Above dialogs, which it may be about, and what is written into the corner of the view.
    let area = Area::new(id).order(Order::Tooltip);
    let area = area.pivot(Align2::CENTER_TOP);
    let area = match over {
        Over::Window => area.fixed_pos(above.center_top()),
        Over::Space { ray: Some(ray), .. } if meets(&below, ray) && !meets(&above, ray) => {
            area.fixed_pos(above.center_top())
        }
        Over::Space { .. } => area.pivot(Align2::CENTER_BOTTOM).fixed_pos(below.center_bottom()),
    };
    area.show(context, |ui| {
        ui.multiply_opacity(strength);
        let frame = Frame::popup(ui.style()).inner_margin(10.0).fill(look.palette.field);
        let most = (space.width() - 90.0).clamp(160.0, 420.0);
        frame.show(ui, |ui| line(ui, look, notice, most))
    });
}

/// The same as a band that takes its room from the picture above: in a hall everything
/// that is shown is to be seen.
pub fn band(ui: &mut Ui, look: &Look, notice: &mut Notice) {
    let Some(strength) = strength(ui.ctx(), notice) else { return };
    let frame = Frame::new().fill(look.palette.field).inner_margin(Margin::symmetric(16, 6));
    Panel::bottom("notice").frame(frame).show(ui, |ui| {
        ui.multiply_opacity(strength);
        let most = ui.available_width() - 90.0;
        line(ui, look, notice, most);
    });
}

/// How strong the notice is now; `None` if there is none.
fn strength(context: &Context, notice: &mut Notice) -> Option<f32> {
    if notice.is_empty() {
        return None;
    }
    let (strength, secs) = notice.strength(context.input(|input| input.time));
    context.request_repaint_after(Duration::from_secs_f64(secs));
    (!notice.is_empty()).then_some(strength)
}

/// What has happened, in lines of at most this width, and what takes it away.
fn line(ui: &mut Ui, look: &Look, notice: &mut Notice, most: f32) {
    let clicked = ui.horizontal(|ui| {
        ui.scope(|ui| {
            ui.set_max_width(most);
            ui.add(Label::new(notice.text()).wrap());
        });
        ui.button(look.text("dialog-close")).clicked()
    });
    let moved_on = ui.input(|input| input.key_pressed(Key::Escape));
    if clicked.inner || moved_on {
        notice.clear();
    }
}

/// Where a line of this size may be, what is better first.
fn places(space: Rect, size: eframe::egui::Vec2) -> [Rect; 2] {
    let below = space.center_bottom() - vec2(0.0, BELOW + 0.5 * size.y);
    let above = space.center_top() + vec2(0.0, ABOVE + 0.5 * size.y);
    [below, above].map(|centre| Rect::from_center_size(centre, size))
}

/// Whether a line from the first to the second point comes near a rectangle.
fn meets(rect: &Rect, [from, to]: [Pos2; 2]) -> bool {
    const NEAR: f32 = 12.0;
    const N: u8 = 100;
    let rect = rect.expand(NEAR);
    (0..=N).any(|n| rect.contains(from + (to - from) * (f32::from(n) / f32::from(N))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    #[test]
    fn the_line_lies_above_only_where_the_ray_is_below() {
        let space = Rect::from_min_max(pos2(0.0, 0.0), pos2(600.0, 500.0));
        let [below, above] = places(space, USUAL.into());
        assert!(space.contains_rect(below) && space.contains_rect(above));
        let flat = |y: f32| [pos2(-50.0, y), pos2(650.0, y)];
        let check = |ray, expected| assert_eq!([meets(&below, ray), meets(&above, ray)], expected);
        check(flat(below.center().y), [true, false]);
        check(flat(above.center().y), [false, true]);
        check(flat(250.0), [false, false]);
        check([pos2(300.0, -9.0), pos2(300.0, 520.0)], [true, true]);
    }
}
