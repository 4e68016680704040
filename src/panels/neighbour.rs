//! Neighbour computation, written out as on paper.

use crate::look::Look;
use crate::widgets::bit_table;
use eframe::egui::{Id, RichText, Ui};
use octoscope_core::event::Event;
use octoscope_core::trace::{Moment, Target, Trace};
use octoscope_core::tree::Tree;
use octoscope_figure::views::{BitTable, Spacing, neighbour_heights, neighbour_tables};
use std::sync::{Arc, Weak};

/// Room below each table.
const GAP: f32 = 6.0;

/// The sum or difference of every crossed axis with its carries, the border, the
/// XOR with its run of ones, and the climb to the common ancestor.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let Some(computed) = neighbour_tables(&look.texts, tree, moment) else {
        ui.label(RichText::new(look.text("neighbour-none")).color(look.palette.quiet));
        return;
    };
    for (n, table) in computed.tables.iter().enumerate() {
        // Three axes have little room: the numbers of the bits stand once.
        let is_low = D == 3 || look.is_for_hall();
        let table = &BitTable { headless: n > 0 && is_low, ..table.clone() };
        let spacing = if is_low { Spacing::Close } else { Spacing::Wide };
        bit_table(ui, look, table, spacing, &look.text("panel-neighbour"));
        ui.add_space(GAP);
    }
    // In a hall the sentence says it.
    if look.is_for_hall() {
        return;
    }
    if let Some(border) = computed.border {
        ui.label(RichText::new(border).strong());
    }
    if let Some(climb) = computed.climb {
        ui.label(climb);
    }
}

/// Height of all of it in a hall, in points, in the step of the walk in which it is highest.
/// It is kept as long as the walk is the same.
pub fn most_height<const D: usize>(ui: &Ui, trace: &Arc<Trace<D>>) -> f32 {
    let id = Id::unique(("height-of-neighbours", D));
    let kept = ui.data(|data| data.get_temp::<(Weak<Trace<D>>, f32)>(id));
    if let Some((_, height)) = kept.filter(|(of, _)| of.as_ptr() == Arc::as_ptr(trace)) {
        return height;
    }
    let height = highest(trace);
    ui.data_mut(|data| data.insert_temp(id, (Arc::downgrade(trace), height)));
    height
}

fn highest<const D: usize>(trace: &Trace<D>) -> f32 {
    let height = |event: &Event<D>| {
        let Event::Target { level, from, to, axes, .. } = *event else { return 0.0 };
        let target = Target { level, from, to, axes, outside: None };
        let heights = neighbour_heights(&target, Spacing::Close);
        // Each table is followed by a gap, and by the distance of two entries.
        heights.iter().map(|height| *height as f32 + 2.0 * GAP).sum()
    };
    trace.events.iter().map(height).fold(0.0, f32::max)
}
