//! The tables by which neighbours are found.

use crate::look::Look;
use crate::widgets::cell_text;
use eframe::egui::{Grid, Label, RichText, Ui};
use octoscope_core::event::{Event, Lookup};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::locate::{adjacent, common_part, reflected};
use octoscope_core::tree::Child;

/// What the last step of the search has looked up.
struct Used<const D: usize> {
    direction: [i8; D],
    son: Child<D>,
    /// Whether the way led down, by REFLECT.
    down: bool,
}

/// ADJ, COMMON and REFLECT for the direction of the search, with the row of the
/// son lit; `events` are those until now.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, events: &[Event<D>]) {
    let Some(used) = used(events) else {
        ui.label(RichText::new(look.text("tables-none")).color(look.palette.quiet));
        return;
    };
    let Used { direction, son, down } = used;
    let quiet = |text: String| RichText::new(text).size(13.0).color(look.palette.quiet);
    let text = look.texts.format("tables-direction", &[("direction", signs(direction).into())]);
    ui.label(quiet(text));
    let grid = Grid::new("neighbour-tables").num_columns(4).striped(true);
    grid.spacing([14.0, 2.0]).min_row_height(20.0).show(ui, |ui| {
        for head in ["tables-son", "tables-adjacent", "tables-common", "tables-reflect"] {
            ui.label(quiet(look.text(head))).on_hover_text(look.text(&format!("{head}-why")));
        }
        ui.end_row();
        for row in Child::<D>::all() {
            let lit = row == son;
            ui.label(cell_text(look, format!("{} ({})", row.0, bits(row)), lit, lit));
            let beside =
                look.text(if adjacent(direction, row) { "tables-yes" } else { "tables-no" });
            ui.label(cell_text(look, beside, lit, lit && !down));
            ui.label(cell_text(look, signs(common_part(direction, row)), lit, lit && !down));
            ui.label(cell_text(look, reflected(direction, row).0.to_string(), lit, lit && down));
            ui.end_row();
        }
    });
    ui.add(Label::new(quiet(look.text("tables-rule"))).wrap());
}

/// The look-up of the last event, or of the last that was one.
fn used<const D: usize>(events: &[Event<D>]) -> Option<Used<D>> {
    let last = events.iter().rposition(|event| {
        matches!(event, Event::Father { lookup: Lookup::Tables, .. } | Event::Mirror { .. })
    })?;
    let son_left = |event: &Event<D>| match *event {
        Event::Father { son, direction, .. } => Some((son, direction)),
        _ => None,
    };
    match events[last] {
        Event::Father { son, direction, .. } => Some(Used { direction, son, down: false }),
        // On the way down every look-up repeats one on the way up.
        Event::Mirror { son, mirrored, .. } => {
            let fits = |&(left, direction): &(Child<D>, [i8; D])| {
                left == son && reflected(direction, son) == mirrored
            };
            let (_, direction) = events[..last].iter().rev().filter_map(son_left).find(fits)?;
            Some(Used { direction, son, down: true })
        }
        _ => None,
    }
}

/// A direction as (+x, −z); (0) for none.
fn signs<const D: usize>(direction: [i8; D]) -> String {
    let parts: Vec<String> = (0..D)
        .filter(|&e| direction[e] != 0)
        .map(|e| format!("{}{}", if direction[e] > 0 { '+' } else { '−' }, AXIS_NAMES[e]))
        .collect();
    if parts.is_empty() { "0".to_owned() } else { parts.join(" ") }
}

fn bits<const D: usize>(child: Child<D>) -> String {
    (0..D).map(|e| if child.is_upper(e) { '1' } else { '0' }).collect()
}
