//! Notes for the lecturer, on a second screen: the sentence of the step, the next
//! one, and how long the lecture has run.

use crate::look::Look;
use crate::widgets::rich_label;
use eframe::egui::{RichText as Words, Ui};
use octoscope_core::explain::RichText;

/// What the notes tell.
pub struct Notes {
    /// The sentence of the step.
    pub now: RichText,
    /// That of the next step; `None` after the last one.
    pub next: Option<RichText>,
    /// The step, and the number of steps.
    pub step: [usize; 2],
    /// Time since the clock was started, in seconds.
    pub secs: f64,
    /// Whether the students see nothing.
    pub is_blank: bool,
}

/// Shows the notes; true if the clock is to start anew.
pub fn ui(ui: &mut Ui, look: &Look, notes: &Notes) -> bool {
    let mut restart = false;
    ui.horizontal(|ui| {
        let [step, n_steps] = notes.step;
        ui.label(Words::new(format!("{step} / {n_steps}")).size(22.0));
        ui.add_space(24.0);
        ui.label(Words::new(clock(notes.secs)).size(22.0).monospace());
        restart = ui.button(look.text("notes-restart")).clicked();
    });
    if notes.is_blank {
        ui.label(Words::new(look.text("notes-blank")).strong().color(look.palette.rejected));
    }
    ui.separator();
    let width = ui.available_width();
    rich_label(ui, look, &notes.now, 24.0, width);
    ui.add_space(16.0);
    ui.label(Words::new(look.text("notes-next")).color(look.palette.quiet));
    match &notes.next {
        Some(next) => rich_label(ui, look, next, 18.0, width),
        None => ui.label(look.text("notes-end")),
    };
    restart
}

/// Minutes and seconds.
fn clock(secs: f64) -> String {
    let secs = secs.max(0.0) as u64;
    format!("{}:{:02}", secs / 60, secs % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_counts_minutes_and_seconds() {
        assert_eq!([0.0, 59.9, 61.0, 5400.0].map(clock), ["0:00", "0:59", "1:01", "90:00"]);
    }
}
