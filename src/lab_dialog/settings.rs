//! What is to be measured.

use super::{Answer, Shown, State};
use crate::bench::{MOST_DEPTH, MOST_RAYS, MOST_REPEATS};
use crate::lab::Choice;
use crate::look::Look;
use crate::widgets::{MOST_SEED, default_button, progress_bar, ranged_field, tick};
use eframe::egui::emath::Numeric;
use eframe::egui::{Grid, Label, RichText, ScrollArea, Ui, vec2};
use octoscope_core::explain::algorithm_name;
use octoscope_core::measure::{SCENES, Way};
use octoscope_core::traverse::Algorithm;
use octoscope_figure::views::lab::{scene_name, way_name};

/// Shows what is to be measured, and how far that is.
pub(super) fn ui(ui: &mut Ui, look: &Look, shown: &mut Shown, height: f32) -> Option<Answer> {
    let mut answer = None;
    let below = if shown.note.is_some() { 132.0 } else { 76.0 };
    ScrollArea::vertical().id_salt("lab settings").max_height(height - below).show(ui, |ui| {
        // The bar stands beside the controls.
        ui.set_width(ui.available_width() - 10.0);
        what(ui, look, shown.choice);
    });
    ui.add_space(6.0);
    match shown.state {
        State::Idle => {
            let can_run = shown.choice.plan().is_some();
            let run = default_button(look, look.text("lab-run"));
            if ui.add_enabled(can_run, run).clicked() {
                answer = Some(Answer::Run);
            }
            if !can_run {
                quiet(ui, look, &look.text("lab-nothing-chosen"));
            }
        }
        State::Running(fraction) => {
            let size = vec2(240.0, ui.spacing().interact_size.y);
            let bar = ui.allocate_ui(size, |ui| progress_bar(ui, fraction.unwrap_or(0.0)));
            bar.response.on_hover_text(look.text("lab-running"));
            if ui.button(look.text("lab-stop")).clicked() {
                answer = Some(Answer::Stop);
            }
        }
    }
    if let Some(note) = shown.note {
        quiet(ui, look, note);
    }
    answer
}

fn quiet(ui: &mut Ui, look: &Look, text: &str) {
    ui.add(Label::new(RichText::new(text).size(13.0).color(look.palette.quiet)).wrap());
}

fn what(ui: &mut Ui, look: &Look, choice: &mut Choice) {
    let heading = |ui: &mut Ui, key: &str| {
        ui.add_space(4.0);
        ui.label(RichText::new(look.text(key)).size(14.0).family(look.strong_family()));
    };
    heading(ui, "lab-scenes");
    for (scene, on) in SCENES.into_iter().zip(&mut choice.scenes) {
        tick(ui, look, on, scene_name(scene, &look.texts));
    }
    Grid::new("lab numbers").num_columns(2).spacing([10.0, 6.0]).show(ui, |ui| {
        ui.label(look.text("lab-depths"));
        ui.horizontal(|ui| {
            let [least, most] = &mut choice.depths;
            field(ui, look, "lab-least-depth", least, [1, MOST_DEPTH]);
            ui.label(look.text("lab-to"));
            field(ui, look, "lab-most-depth", most, [1, MOST_DEPTH]);
        });
        ui.end_row();
        ui.label(look.text("lab-rays"));
        field(ui, look, "lab-rays", &mut choice.n_rays, [1, MOST_RAYS]);
        ui.end_row();
        ui.label(look.text("lab-repeats"));
        field(ui, look, "lab-repeats", &mut choice.n_repeats, [1, MOST_REPEATS]);
        ui.end_row();
        ui.label(look.text("lab-seed"));
        field(ui, look, "lab-seed", &mut choice.seed, [0, MOST_SEED]);
        ui.end_row();
    });
    heading(ui, "lab-algorithms");
    ui.horizontal_wrapped(|ui| {
        let n = Algorithm::ALL.len();
        let all: Vec<bool> = Algorithm::ALL.map(|one| one != Algorithm::Exhaustive).to_vec();
        for (key, chosen) in [
            ("lab-paper", Choice::OF_THE_PAPER.to_vec()),
            ("lab-all", all),
            ("lab-none", vec![false; n]),
        ] {
            if ui.button(RichText::new(look.text(key)).size(13.0)).clicked() {
                choice.algorithms.copy_from_slice(&chosen);
                choice.kernels = [key == "lab-all"; Way::KERNELS.len()];
            }
        }
    });
    for (algorithm, on) in Algorithm::ALL.into_iter().zip(&mut choice.algorithms) {
        tick(ui, look, on, algorithm_name(algorithm, look.texts.language()));
    }
    for (kernel, on) in Way::KERNELS.into_iter().zip(&mut choice.kernels) {
        tick(ui, look, on, way_name(kernel, &look.texts));
    }
}

fn field<N: Numeric>(ui: &mut Ui, look: &Look, key: &str, value: &mut N, range: [N; 2]) {
    ranged_field(ui, look, &look.text(key), value, range, 1.0);
}
