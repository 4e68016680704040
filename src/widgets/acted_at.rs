//! Where a drag or a click takes place.

use eframe::egui::{Event, Pos2, Response};

/// Where the pointer is that clicks or drags; where it let go, if it did so in this frame:
/// in one that takes long, it may have gone on since.
pub fn acted_at(response: &Response) -> Option<Pos2> {
    let now = response.interact_pointer_pos()?;
    let let_go = |event: &Event| match event {
        Event::PointerButton { pos, pressed: false, .. } => Some(*pos),
        _ => None,
    };
    let released = response.ctx.input(|input| input.events.iter().find_map(let_go));
    Some(released.unwrap_or(now))
}
