//! How the panels are laid out around the space view.

mod explanation;
mod foot;
mod formulas;

use crate::document::Document;
use crate::look::Look;
use crate::map::Maps;
use crate::notice::Notice;
use crate::panels::{query, ray, scene, show};
use crate::space::{self, Layers, Space};
use crate::view::{PanelKind, Preset, View};
use crate::wish::Wish;
use eframe::egui::{CentralPanel, Frame, Margin, Panel, Rangef, ScrollArea, Ui, UiBuilder, vec2};
use formulas::OfFormulas;
use octoscope_core::query::Query;

/// Windows of less than this, in points, have panels on one side only.
const NARROW: f32 = 900.0;
/// Windows of more than this have room for two columns of panels.
const WIDE: f32 = 1200.0;
/// Windows of more than this, in points at their zoom, have room for wider panels beside a
/// picture as high as they are.
const SPACIOUS: f32 = 1400.0;
/// Lectures in windows of less than this, in points, have narrower panels.
const LECTURE_WIDE: f32 = 700.0;
/// The space view keeps at least this, in points; less in a narrow window.
const LEAST_VIEW: f32 = 320.0;
const LEAST_NARROW_VIEW: f32 = 240.0;
/// Width of what scrolls a column.
const BAR: f32 = 8.0;
/// Width of the question's side, margins included.
const QUESTION: f32 = 280.0;

/// Shows the panels on both sides and the space view between them. Returns what
/// they wish for.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    view: &mut View,
    layers: Option<&mut Layers>,
    maps: &mut Maps,
    notice: &mut Notice,
) -> Option<Wish> {
    let moment = document.moment(view.playback.step);
    // The scroll bar lies in the margin.
    let margin = Margin { left: 16, right: 8, top: 8, bottom: 8 };
    let frame = Frame::new().fill(look.palette.panel).inner_margin(margin);
    let (mut scene, mut wish) = (None, None);
    let lecture = view.preset == Preset::Lecture;
    // In a narrow window the question stands below its explanation.
    let room = ui.available_width();
    let narrow = room < NARROW;
    let shown = view.question.unwrap_or(!lecture && !narrow);
    view.question_shown = shown;
    if shown && !narrow {
        let left = Panel::left("question").frame(frame).default_size(QUESTION);
        left.size_range(240.0..=360.0).show(ui, |ui| {
            scrolled(ui, look, |ui| scene = question(ui, look, document, view, notice));
        });
    }
    let panels = view.panels(&document.scenario.query);
    let mut place = OfFormulas::BelowPicture;
    // In a narrow window there is one side for both; what was asked for comes first.
    let question_first = narrow && shown;
    let question_below = narrow && !lecture && view.question.is_none();
    if question_first || question_below || !panels.is_empty() {
        let width_key = view.arrangement().width_key();
        let width = width(view.preset, &panels, room);
        let key = ("explanation", view.preset, narrow, width as u32, width_key);
        let right = Panel::right(key).frame(frame).default_size(width);
        let least_view = if narrow { LEAST_NARROW_VIEW } else { LEAST_VIEW };
        let most = (ui.available_width() - least_view).clamp(260.0, 760.0);
        right.size_range(Rangef::new(260.0, most)).show(ui, |ui| {
            let column = ui.available_size() - vec2(BAR, 0.0);
            place = OfFormulas::of(ui, look, view, &document.trace, &panels, column);
            if let OfFormulas::BelowPanel(_) = place {
                formulas::ui(ui, look, document, view, place);
            }
            scrolled(ui, look, |ui| {
                if question_first {
                    scene = question(ui, look, document, view, notice);
                    ui.separator();
                }
                wish = explanation::ui(ui, look, document, &moment, view, maps, &panels);
                if question_below {
                    ui.separator();
                    scene = question(ui, look, document, view, notice);
                }
            });
        });
    }
    if place == OfFormulas::BelowPicture {
        formulas::ui(ui, look, document, view, place);
    }
    let middle = Frame::new().fill(look.palette.background);
    CentralPanel::default().frame(middle).show(ui, |ui| {
        space::ui(ui, look, Space { document, moment: &moment, view, layers });
    });
    scene.map(Wish::Scene).or(wish)
}

/// First width of the explanation in a window of so many points.
fn width(preset: Preset, panels: &[PanelKind], room: f32) -> f32 {
    match preset {
        Preset::Debug if room >= WIDE => 616.0,
        Preset::Lecture if room < LECTURE_WIDE && panels == [PanelKind::Rail] => 288.0,
        Preset::Lecture if room < LECTURE_WIDE => 304.0,
        // What a wide window has beside a square picture is the panel's.
        Preset::Lecture => (room - 440.0).clamp(320.0, 416.0),
        Preset::Compare if room >= WIDE => 500.0,
        Preset::Compare if room >= NARROW => 392.0,
        Preset::Map if (WIDE..SPACIOUS).contains(&room) => 440.0,
        Preset::Bits
        | Preset::Rail
        | Preset::Automaton
        | Preset::Debug
        | Preset::Compare
        | Preset::Tree
        | Preset::Map => {
            if room < WIDE {
                320.0
            } else if room < SPACIOUS {
                392.0
            } else {
                456.0
            }
        }
    }
}

/// Shows something in all the room there is, scrolled if it is higher, with a mark where it
/// goes on below. It never widens the room, so that widths stay the same from
/// step to step.
fn scrolled(ui: &mut Ui, look: &Look, add: impl FnOnce(&mut Ui)) {
    let rect = ui.available_rect_before_wrap();
    let mut inside = ui.new_child(UiBuilder::new().id_salt("scrolled").max_rect(rect));
    let shown = ScrollArea::vertical().auto_shrink(false).show(&mut inside, |ui| {
        ui.set_max_width(rect.width() - BAR);
        add(ui);
    });
    let below = shown.content_size.y - shown.state.clamped_offset().y - shown.inner_rect.height();
    if below > 1.0 {
        let column = rect.with_max_x(rect.right() - BAR);
        foot::end_above_what_is_cut(&inside, look, column);
    }
    ui.advance_cursor_after_rect(rect);
}

fn question<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
    view: &mut View,
    notice: &mut Notice,
) -> Option<&'static str> {
    const GAP: f32 = 8.0;
    let chosen = scene::ui(ui, look, document);
    ui.add_space(GAP);
    // Other queries keep the ray, but have nothing to do with it.
    if matches!(document.scenario.query, Query::Ray { .. }) {
        let side = document.tree.domain().side();
        if let Some(refused) = ray::ui(ui, look, &mut document.scenario.ray, side) {
            notice.say(refused);
        }
        ui.add_space(GAP);
    }
    query::ui(ui, look, document);
    ui.add_space(GAP);
    let of = show::Of::tree(&document.tree, &document.scenario.query);
    show::ui(ui, look, view.show_mut::<D>(), of);
    chosen
}
