//! How the panels are laid out around the space view.

use crate::document::Document;
use crate::look::Look;
use crate::panels::{
    automaton, codes, compare, counters, listing, neighbour, query, ray, region, scene, show,
    stack, t_rail, variables,
};
use crate::space::{self, Layers, Space};
use crate::view::{PanelKind, Preset, View};
use eframe::egui::{CentralPanel, Frame, Margin, Panel, ScrollArea, Ui};
use octoscope_core::explain::{label, listing as listing_of, variables as variables_of};
use octoscope_core::query::Query;
use octoscope_core::trace::{Counters, Moment};

/// Windows of less than this, in points, have panels on one side only.
const NARROW: f32 = 900.0;

/// Shows the panels on both sides and the space view between them. Returns the
/// identifier of a built-in scene to open.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    view: &mut View,
    layers: Option<&mut Layers>,
    status: &mut String,
) -> Option<&'static str> {
    let moment = document.moment(view.playback.step);
    let frame = Frame::new().fill(look.palette.panel).inner_margin(Margin::symmetric(14, 12));
    let mut scene = None;
    let lecture = view.preset == Preset::Lecture;
    // In a narrow window the question stands below its explanation.
    let narrow = ui.available_width() < NARROW;
    if !lecture && !narrow {
        let left =
            Panel::left("question").frame(frame).default_size(276.0).size_range(220.0..=360.0);
        left.show(ui, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                scene = question(ui, look, document, view, status);
            });
        });
    }
    let width = if lecture || narrow { 300.0 } else { 390.0 };
    let right = Panel::right(("explanation", view.preset, narrow)).frame(frame).default_size(width);
    right.size_range(260.0..=620.0).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let panels = view.preset.panels(&document.scenario.query);
            for (n, kind) in panels.into_iter().enumerate() {
                if n > 0 {
                    ui.add_space(6.0);
                    ui.separator();
                    ui.add_space(6.0);
                }
                ui.push_id(n, |ui| panel(ui, look, document, &moment, view, kind));
            }
            if narrow && !lecture {
                ui.add_space(6.0);
                ui.separator();
                ui.add_space(6.0);
                scene = question(ui, look, document, view, status);
            }
        });
    });
    let middle = Frame::new().fill(look.palette.background);
    CentralPanel::default().frame(middle).show(ui, |ui| {
        space::ui(ui, look, Space { document, moment: &moment, view, layers });
    });
    scene
}

fn question<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    view: &mut View,
    status: &mut String,
) -> Option<&'static str> {
    let chosen = scene::ui(ui, look, document);
    ui.add_space(14.0);
    let side = document.tree.domain().side();
    if let Some(refused) = ray::ui(ui, look, &mut document.scenario.ray, side) {
        *status = refused;
    }
    ui.add_space(14.0);
    query::ui(ui, look, document);
    ui.add_space(14.0);
    show::ui(ui, look, view.show_mut::<D>(), D);
    chosen
}

fn panel<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    moment: &Moment<D>,
    view: &mut View,
    kind: PanelKind,
) {
    if kind == PanelKind::Compare {
        compare_panel(ui, look, document);
        return;
    }
    let (tree, trace) = (&document.tree, &document.trace);
    let event = moment.step.checked_sub(1).and_then(|index| trace.events.get(index));
    match kind {
        PanelKind::Codes => codes::ui(ui, look, tree, moment),
        PanelKind::Region => region::ui(ui, look, tree, moment),
        PanelKind::Neighbour => neighbour::ui(ui, look, tree, moment),
        PanelKind::Rail => {
            let note = moment.current.map_or_else(String::new, |node| {
                let codes = tree.code(node).map(|c| c.to_string()).join(", ");
                let level = tree.level(node);
                look.texts.format("node-note", &[("level", level.into()), ("codes", codes.into())])
            });
            if let Some(step) = t_rail::ui(ui, look, trace, moment, &note) {
                view.playback.playing = false;
                view.playback.go_to(step, trace.events.len());
            }
        }
        PanelKind::Automaton => automaton::ui(ui, look, moment, event),
        PanelKind::Listing => {
            let listing = listing_of(&document.scenario.query, view.language);
            listing::ui(ui, look, &listing, event.map(label), "");
        }
        PanelKind::Variables => {
            let now = variables_of(tree, moment);
            let before = match moment.step.checked_sub(1) {
                Some(step) => variables_of(tree, &document.moment(step)),
                None => now.clone(),
            };
            variables::ui(ui, look, &now, &before);
        }
        PanelKind::Compare => {}
        PanelKind::Stack => stack::ui(ui, look, tree, moment),
        PanelKind::Counters => {
            let mut of_step = Counters::default();
            if let Some(event) = event {
                of_step.add(event);
            }
            counters::ui(ui, look, &of_step, &moment.counters, &document.total);
        }
    }
}

fn compare_panel<const D: usize>(ui: &mut Ui, look: &Look, document: &mut Document<D>) {
    let runs = document.comparison();
    let Query::Ray { algorithm, .. } = &mut document.scenario.query else { return };
    if let Some(chosen) = compare::ui(ui, look, &runs, Some(*algorithm)) {
        *algorithm = chosen;
    }
}
