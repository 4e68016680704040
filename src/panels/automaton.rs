//! The automaton that leads from child to child.

use crate::look::Look;
use crate::widgets::{ROW, Setting, paint_figure, room, table, table_width};
use eframe::egui::{Align, Layout, RichText, Sense, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::event::Event;
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_figure::views::Automaton;

/// The mirror mask, and what it means.
pub fn note<const D: usize>(look: &Look, moment: &Moment<D>, query: &Query<D>) -> String {
    Automaton::of(moment, None, query).note(&look.texts)
}

/// States as corners of a square or cube, the lit transition, and the tables
/// with the used row and column lit. `event` is what has just happened in `query`.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
    query: &Query<D>,
) {
    let automaton = Automaton::of(moment, event, query);
    const SETTING: Setting = Setting { gap: 14.0, least: 28.0, row: ROW };
    let exits = automaton.exit_table(&look.texts);
    // The table beside it needs the same room whatever is lit, and what is lit a margin.
    let beside_it = table_width(ui, look, &exits, SETTING) + ui.spacing().item_spacing.x + 4.0;
    let [least, most] = if D == 2 { [96.0, 120.0] } else { [150.0, 184.0] };
    let beside = ui.available_width() - beside_it;
    let side = if beside < least { most } else { beside.min(most) };
    let direction = if beside < least {
        Layout::top_down(Align::Min)
    } else {
        Layout::left_to_right(Align::Min)
    };
    let caption = |ui: &mut Ui, key: &str| {
        ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
    };
    ui.with_layout(direction, |ui| {
        let diagram = automaton.diagram(f64::from(side));
        let (rect, response) = room(ui, diagram.page, Sense::hover());
        let now = automaton.state.map_or("–".to_owned(), |state| state.0.to_string());
        let spoken = look.texts.format("automaton-state", &[("state", now.into())]);
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.as_str()));
        paint_figure(ui, look, rect, &diagram);
        ui.vertical(|ui| {
            caption(ui, if D == 2 { "automaton-table-in-plane" } else { "automaton-table-3" });
            table(ui, look, &exits, SETTING);
        });
    });
    if D == 3 {
        caption(ui, "automaton-table-2");
        let setting = Setting { gap: 12.0, least: 0.0, row: ROW };
        table(ui, look, &automaton.entry_table(), setting);
    }
}
