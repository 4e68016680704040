//! The dialog of the bench lab: what to measure at the left, what came of it
//! at the right.

mod settings;

use crate::lab::{Choice, ENDINGS, Ending, Tab, figure_in};
use crate::look::Look;
use crate::widgets::{self, Listed, Present, drop_down, paint_larger, segments};
use eframe::egui::{
    Align, Button, Context, Frame, Id, Layout, Modal, RichText, ScrollArea, Sense, Ui, WidgetInfo,
    accesskit::Role,
};
use octoscope_core::measure::{Quantity, Results, Watched};
use octoscope_core::text::Language;
use octoscope_figure::views::lab::scene_name;
use octoscope_figure::{Figure, Form, Page};
use std::sync::Arc;

/// What the dialog shows, and what it changes.
pub struct Shown<'a> {
    /// What is chosen.
    pub choice: &'a mut Choice,
    /// What was measured.
    pub results: &'a Results,
    /// What algorithms do on the present ray.
    pub watched: &'a [Watched],
    /// Whether something is being measured.
    pub state: State,
    /// What is to be known about the results, in words.
    pub note: Option<&'a str>,
}

/// Whether something is being measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum State {
    /// Nothing is.
    Idle,
    /// So much of it is done, if that is known.
    Running(Option<f64>),
}

/// What the user asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Measure.
    Run,
    /// Stop measuring.
    Stop,
    /// Save what is shown to a file with this ending.
    Save(Ending),
    /// Close the dialog.
    Close,
}

/// Width of the settings.
const SETTINGS: f32 = 262.0;

/// Shows the dialog.
pub fn ui(context: &Context, look: &Look, mut shown: Shown) -> Option<Answer> {
    let mut answer = None;
    let frame = Frame::popup(&context.global_style()).inner_margin(18.0);
    let size = context.content_rect().size();
    let [width, height] = [(size.x - 72.0).clamp(300.0, 1500.0), (size.y - 150.0).max(160.0)];
    let response = Modal::new(Id::unique("lab")).frame(frame).show(context, |ui| {
        ui.set_width(width);
        ui.horizontal(|ui| {
            ui.label(RichText::new(look.text("lab-title")).heading().strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if ui.button(look.text("dialog-close")).clicked() {
                    answer = Some(Answer::Close);
                }
            });
        });
        ui.separator();
        ui.horizontal_top(|ui| {
            let asked = ui.vertical(|ui| {
                ui.set_width(SETTINGS.min(0.5 * width));
                ui.set_height(height);
                settings::ui(ui, look, &mut shown, height)
            });
            answer = answer.or(asked.inner);
            ui.separator();
            ui.vertical(|ui| {
                // In a small window the choices alone fill it.
                let all = ScrollArea::vertical().id_salt("lab side").auto_shrink([false, true]);
                all.max_height(height).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    tabs(ui, look, shown.choice, shown.results);
                    let below = 40.0;
                    let above = ui.cursor().top() - ui.min_rect().top();
                    content(ui, look, &shown, (height - above - below).max(80.0));
                    ui.add_space(4.0);
                    answer = answer.or(save(ui, look, &shown));
                });
            });
        });
    });
    if response.should_close() { answer.or(Some(Answer::Close)) } else { answer }
}

/// What is shown, and what of it.
fn tabs(ui: &mut Ui, look: &Look, choice: &mut Choice, results: &Results) {
    let tabs = Tab::ALL.map(|tab| (tab, look.text(tab.id())));
    segments(ui, &mut choice.tab, &tabs);
    if matches!(choice.tab, Tab::Published | Tab::Processor) {
        ui.add_space(6.0);
        return;
    }
    ui.horizontal_wrapped(|ui| match choice.tab {
        Tab::Scenes => {
            costs(ui, look, choice);
            depths(ui, look, choice, results);
        }
        Tab::Growth => {
            costs(ui, look, choice);
            ui.label(look.text("lab-against"));
            let sizes =
                Quantity::SIZES.map(|size| look.text(&format!("lab-quantity-{}", size.id())));
            list(ui, look, ListOf { id: "lab size", key: "lab-against" }, &mut choice.size, &sizes);
            scenes(ui, look, choice, results);
        }
        Tab::Table => {
            scenes(ui, look, choice, results);
            depths(ui, look, choice, results);
        }
        Tab::Published | Tab::Processor => {}
    });
    ui.add_space(6.0);
}

/// Which of the depths that were measured.
fn depths(ui: &mut Ui, look: &Look, choice: &mut Choice, results: &Results) {
    let depths: Vec<(u8, String)> =
        results.depths().into_iter().map(|depth| (depth, depth.to_string())).collect();
    if depths.len() > 1 {
        ui.label(look.text("lab-depth"));
        choice.depth = choice.depth_in(results);
        segments(ui, &mut choice.depth, &depths);
    }
}

/// Which of the scenes that were measured.
fn scenes(ui: &mut Ui, look: &Look, choice: &mut Choice, results: &Results) {
    let scenes: Vec<String> =
        results.scenes().into_iter().map(|scene| scene_name(scene, &look.texts)).collect();
    if scenes.len() > 1 {
        list(ui, look, ListOf { id: "lab scene", key: "lab-scene" }, &mut choice.scene, &scenes);
    }
}

/// Which of the costs.
fn costs(ui: &mut Ui, look: &Look, choice: &mut Choice) {
    let costs = Quantity::COSTS.map(|cost| look.text(&format!("lab-quantity-{}", cost.id())));
    list(ui, look, ListOf { id: "lab cost", key: "lab-quantity" }, &mut choice.cost, &costs);
}

/// What a list is of.
#[derive(Clone, Copy, Debug)]
struct ListOf {
    id: &'static str,
    /// Key of its name.
    key: &'static str,
}

/// A list from which one entry is chosen by its number.
fn list(ui: &mut Ui, look: &Look, of: ListOf, chosen: &mut usize, entries: &[String]) {
    let name = look.text(of.key);
    let shown = entries.get(*chosen).or(entries.first()).cloned().unwrap_or_default();
    let spoken = format!("{name}: {shown}");
    let lines = entries.iter().cloned().enumerate();
    let lines: Vec<_> = lines.map(|(number, entry)| Listed::Entry(number, entry)).collect();
    let present = Present { entry: Some(*chosen), name: shown };
    let (list, taken) = drop_down(ui, look, of.id, 170.0, present, &lines);
    list.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, spoken.as_str()));
    *chosen = taken.unwrap_or(*chosen);
}

fn content(ui: &mut Ui, look: &Look, shown: &Shown, height: f32) {
    // The bars stand beside what they move.
    const BAR: f32 = 10.0;
    ui.spacing_mut().scroll.floating_allocated_width = BAR;
    let room = [ui.available_width(), height].map(|extent| f64::from(extent - BAR));
    let Drawn { figure, scale, .. } = &*drawn(ui, look, shown, room);
    let page = Page { width: scale * figure.page.width, height: scale * figure.page.height };
    let scroll = ScrollArea::both().id_salt("lab chart").auto_shrink([false, false]);
    scroll.max_height(height).show(ui, |ui| {
        let (rect, response) = widgets::room(ui, page, Sense::hover());
        paint_larger(ui, look, rect, figure, *scale as f32);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, told(figure)));
    });
}

/// What is drawn, and of what.
struct Drawn {
    choice: Choice,
    results: Results,
    watched: Vec<Watched>,
    language: Language,
    room: [f64; 2],
    figure: Figure,
    scale: f64,
}

/// What is chosen, drawn for a room of this size: the same figure as long as nothing that
/// it shows has changed.
fn drawn(ui: &Ui, look: &Look, shown: &Shown, room: [f64; 2]) -> Arc<Drawn> {
    let id = Id::unique("chart of the lab");
    let (choice, language) = (&*shown.choice, look.texts.language());
    let is_same = |drawn: &Arc<Drawn>| {
        (&drawn.choice, drawn.language, drawn.room) == (choice, language, room)
            && (&drawn.results, &drawn.watched[..]) == (shown.results, shown.watched)
    };
    if let Some(kept) = ui.data(|data| data.get_temp::<Arc<Drawn>>(id)).filter(is_same) {
        return kept;
    }
    let (figure, scale) = figure_in(choice, shown.results, shown.watched, &look.texts, room);
    let drawn = Arc::new(Drawn {
        choice: choice.clone(),
        results: shown.results.clone(),
        watched: shown.watched.to_vec(),
        language,
        room,
        figure,
        scale,
    });
    ui.data_mut(|data| data.insert_temp(id, Arc::clone(&drawn)));
    drawn
}

/// What is written in a figure, for readers that cannot see it.
fn told(figure: &Figure) -> String {
    let texts = figure.drawn.iter().filter_map(|drawn| match &drawn.form {
        Form::Text { text, .. } => Some(text.plain()),
        Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => None,
    });
    texts.collect::<Vec<_>>().join("; ")
}

/// Files that can be written, where there is something to write.
fn save(ui: &mut Ui, look: &Look, shown: &Shown) -> Option<Answer> {
    let (tab, has_results) = (shown.choice.tab, !shown.results.sites.is_empty());
    let has_chart = if tab == Tab::Processor { !shown.watched.is_empty() } else { has_results };
    let mut answer = None;
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(look.text("lab-save")).color(look.palette.quiet));
        for ending in ENDINGS {
            let is_table = matches!(ending, "csv" | "md");
            let kind = if is_table { "table" } else { "chart" };
            let name = RichText::new(look.text(&format!("lab-{kind}-{ending}"))).size(13.0);
            let has_it = if is_table { has_results } else { has_chart };
            if ui.add_enabled(has_it, Button::new(name)).clicked() {
                answer = Some(Answer::Save(ending));
            }
        }
    });
    answer
}
