//! The panels that explain the step, each under its heading.

use crate::document::{Document, Found};
use crate::look::Look;
use crate::map::Maps;
use crate::panels::{
    automaton, children, codes, compare, counters, cuts, grid, halves, links, listing, map,
    mid_planes, neighbour, paper, region, stack, t_rail, tables, tree, variables, way_down,
    why_not,
};
use crate::view::{PanelKind, Preset, View};
use crate::widgets::{InColumn, caption, panel_heading};
use crate::wish::Wish;
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{Align, Rect, RichText, Ui, UiBuilder, vec2};
use octoscope_core::event::Event;
use octoscope_core::explain::listing as listing_of;
use octoscope_core::query::Query;
use octoscope_core::trace::{Counters, Moment};
use octoscope_core::traverse::Variant;
use octoscope_core::tree::NodeId;
use octoscope_figure::views::{RailRows, changed_variables};
use std::sync::Arc;

/// Sides of at least this width, in points, have two columns of panels.
const TWO_COLUMNS: f32 = 520.0;
/// Distance between two columns.
const GAP: f32 = 24.0;
/// Height of the tree's diagram where it is what the preset is about.
const TREE: f32 = 286.0;
/// Its height beside other panels.
const SMALL_TREE: f32 = 236.0;
/// Its height in the lowest windows.
const LEAST_TREE: f32 = 170.0;

/// The panels from top to bottom; where there is room in two columns, in turn
/// to the left and to the right.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    moment: &Moment<D>,
    view: &mut View,
    maps: &mut Maps,
    panels: &[PanelKind],
) -> Option<Wish> {
    let mut wish = None;
    let n_columns = if ui.available_width() >= TWO_COLUMNS { 2 } else { 1 };
    let whole = ui.available_rect_before_wrap();
    let width = (whole.width() + GAP) / n_columns as f32 - GAP;
    let mut bottom = whole.top();
    let mut chosen = None;
    for first in 0..n_columns {
        let corner = whole.min + vec2(first as f32 * (width + GAP), 0.0);
        let rect = Rect::from_min_size(corner, vec2(width, whole.height()));
        let mut column = ui.new_child(UiBuilder::new().id_salt(first).max_rect(rect));
        // What is too wide for its column is not drawn over the next one.
        column.shrink_clip_rect(Rect::everything_left_of(rect.right() + GAP / 2.0));
        for (index, &kind) in panels.iter().enumerate().skip(first).step_by(n_columns) {
            if index > first {
                column.separator();
            }
            let by_preset = view.preset.folded::<D>();
            let folded = view.arrangement().is_folded(kind, by_preset);
            let place = InColumn { folded, index, n_panels: panels.len() };
            let note = note(look, document, moment, kind);
            let top = column.cursor().top();
            let change = panel_heading(&mut column, look, &look.text(kind.id()), &note, place);
            chosen = change.map(|change| (kind, change)).or(chosen);
            if view.sought.take_if(|sought| *sought == kind).is_some() {
                let heading = rect.with_min_y(top).with_max_y(column.cursor().top());
                let jump = ScrollAnimation::none();
                column.scroll_to_rect_animation(heading, Some(Align::TOP), jump);
            }
            if !folded {
                // By its kind: what is remembered of a panel moves with it.
                let body = |ui: &mut Ui| body(ui, look, document, moment, view, maps, kind);
                wish = column.push_id(kind, body).inner.or(wish);
            }
        }
        bottom = column.min_rect().bottom().max(bottom);
    }
    view.sought = None;
    ui.advance_cursor_after_rect(whole.with_max_y(bottom));
    if let Some((kind, change)) = chosen {
        view.arrangement().change(kind, change, panels);
    }
    wish
}

/// Quiet words beside the title of a panel.
fn note<const D: usize>(
    look: &Look,
    document: &Document<D>,
    moment: &Moment<D>,
    kind: PanelKind,
) -> String {
    match kind {
        PanelKind::Codes => {
            codes::note(look, &document.tree, moment, document.trace.query.variants_at_work())
        }
        PanelKind::Rail => t_rail::note(look, &document.tree, moment),
        PanelKind::Automaton => automaton::note(look, moment, &document.trace.query),
        PanelKind::Stack => stack::note(moment),
        PanelKind::WayDown => way_down::note(look, moment),
        PanelKind::Grid => grid::note(look, moment),
        PanelKind::Tree => tree::note(look, &document.shown(moment)),
        PanelKind::WhyNot => why_not::note(look, &document.shown(moment)),
        PanelKind::Cuts => cuts::note(look, &document.tree, moment),
        PanelKind::Children => {
            let events = &document.trace.events;
            let past = &events[..moment.step.min(events.len())];
            children::note(look, &document.tree, moment, past)
        }
        PanelKind::Links => links::note(look, &document.tree, &document.trace, moment),
        PanelKind::Halves
        | PanelKind::MidPlanes
        | PanelKind::Region
        | PanelKind::Neighbour
        | PanelKind::Listing
        | PanelKind::Variables
        | PanelKind::Counters
        | PanelKind::Tables
        | PanelKind::Compare
        | PanelKind::Paper
        | PanelKind::Map => String::new(),
    }
}

fn body<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    moment: &Moment<D>,
    view: &mut View,
    maps: &mut Maps,
    kind: PanelKind,
) -> Option<Wish> {
    let trace = Arc::clone(&document.trace);
    let tree = Arc::clone(&document.tree);
    let past = &trace.events[..moment.step.min(trace.events.len())];
    let event = past.last();
    match kind {
        PanelKind::Codes => {
            let variants = trace.query.variants_at_work();
            let shown = ui.scope(|ui| codes::ui(ui, look, &tree, moment, event, variants)).response;
            offer_if_pointed(ui, shown.rect, moment.current, view);
        }
        PanelKind::Region => region::ui(ui, look, &tree, moment),
        PanelKind::Neighbour => neighbour::ui(ui, look, &tree, moment),
        PanelKind::Rail => {
            let is_lecture = view.preset == Preset::Lecture;
            let rows = if is_lecture { t_rail::lecture_rows::<D>() } else { RailRows::Small };
            let pointed = t_rail::ui(ui, look, &trace, &document.shown(moment), rows);
            if let Some(step) = pointed.step {
                view.playback.playing = false;
                view.playback.go_to(step, trace.events.len());
            }
            pointed.node.into_iter().for_each(|node| view.hover.offer(node));
        }
        PanelKind::Automaton => {
            automaton::ui(ui, look, moment, event, &trace.query);
        }
        PanelKind::Listing => {
            let listing = listing_of(&trace.query, view.language);
            let lit = listing::ui(ui, look, &listing, &listing.lit(past));
            let node = event.and_then(Event::node).or(moment.current);
            lit.into_iter().for_each(|rect| offer_if_pointed(ui, rect, node, view));
        }
        PanelKind::Variables => {
            let variables = changed_variables(&tree, &trace, moment);
            let pointed = variables::ui(ui, look, &variables);
            pointed.into_iter().for_each(|node| view.hover.offer(node));
        }
        PanelKind::Tables => tables::ui(ui, look, &tree, past),
        PanelKind::Cuts => cuts::ui(ui, look, cuts::Rule::of(&trace.query), moment, event),
        PanelKind::Children => children::ui(ui, look, &tree, moment, past),
        PanelKind::WayDown => {
            way_down::ui(ui, look, &tree, document.traced_ray(), moment, past);
        }
        PanelKind::Links => {
            let ray = document.traced_ray();
            links::ui(ui, look, links::Net { tree: &tree, ray }, &trace, moment);
        }
        PanelKind::Halves => {
            let is_gem = trace.query.variants().has(Variant::Gem);
            let form = if is_gem { halves::Form::Gem } else { halves::Form::Robust };
            halves::ui(ui, look, form, past);
        }
        PanelKind::MidPlanes => mid_planes::ui(ui, look, past),
        PanelKind::Grid => grid::ui(ui, look, moment),
        PanelKind::Compare => comparison(ui, look, document),
        PanelKind::Paper => {
            let verdict = document.verdict();
            let query = &mut document.scenario.query;
            let before = *query;
            let wish = paper::ui(ui, look, query, &verdict);
            if *query != before {
                // It stays under the pointer, also when no misprint is left.
                view.arrangement().add(kind);
            }
            return wish;
        }
        PanelKind::Tree => {
            let of = document.shown(moment);
            let (theme, language) = (view.theme, view.language);
            let wanted = if view.preset == Preset::Tree { TREE } else { SMALL_TREE };
            // In a low window all of it is seen at once.
            let height = wanted.min((ui.clip_rect().height() - 56.0).max(LEAST_TREE));
            let shown = tree::Shown { of, trace: &trace, theme, language, height };
            let step = tree::ui(ui, look, &shown, &mut view.tree, &mut view.hover);
            if view.preset == Preset::Tree && height == wanted {
                caption(ui, look, look.text("tree-key"));
            }
            return step.map(Wish::Step);
        }
        PanelKind::WhyNot => {
            let of = document.shown(moment);
            why_not::ui(ui, look, &of, view.language, &mut view.hover);
        }
        PanelKind::Map => {
            let query = document.scenario.query;
            let (ray, camera) = (document.scenario.ray, view.camera());
            let subject = map::Subject { tree: &tree, query: &query, ray: &ray, camera };
            if let Some(ray) = map::ui(ui, look, &subject, &mut view.map, maps.of()) {
                document.scenario.ray = ray;
            }
        }
        PanelKind::Stack => {
            let pointed = stack::ui(ui, look, &tree, moment);
            pointed.into_iter().for_each(|node| view.hover.offer(node));
        }
        PanelKind::Counters => {
            let mut step = Counters::default();
            if let Some(event) = event {
                step.add(event);
            }
            let detail = if view.preset == Preset::Debug {
                counters::Detail::Full
            } else {
                counters::Detail::Summary
            };
            let is_met = matches!(event, Some(Event::Test { interval: Some(_), .. }));
            let met = [u64::from(is_met), moment.met.len() as u64];
            let (so_far, total) = (&moment.counters, &document.total);
            counters::ui(ui, look, counters::Costs { step: &step, so_far, total, met }, detail);
        }
    }
    None
}

/// Lights `node` in all views if the pointer is over what shows it.
fn offer_if_pointed(ui: &Ui, rect: Rect, node: Option<NodeId>, view: &mut View) {
    if let Some(node) = node
        && ui.rect_contains_pointer(rect)
    {
        view.hover.offer(node);
    }
}

fn comparison<const D: usize>(ui: &mut Ui, look: &Look, document: &mut Document<D>) {
    let shown = match document.scenario.query {
        Query::Ray { algorithm, .. } => Some(algorithm),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
    };
    let found = if shown.is_some() { document.comparison() } else { Found::Never };
    let runs = match &found {
        Found::Known(runs) | Found::Coming(Some(runs)) => runs.as_slice(),
        Found::Never => &[],
        Found::Coming(None) => {
            ui.label(RichText::new(look.text("compare-coming")).color(look.palette.quiet));
            return;
        }
    };
    let chosen = compare::ui(ui, look, runs, shown);
    if let Some(chosen) = chosen {
        document.scenario.query = document.scenario.query.with_algorithm(chosen);
    }
}
