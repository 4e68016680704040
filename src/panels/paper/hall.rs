//! The paper lab in a hall: what is printed, what is right, and whether it goes wrong; all
//! of it at once, above the formulas of the step.

use super::{both_rules, marks_of, misprints_of, printed_in, switches, told_of};
use crate::document::Found;
use crate::look::Look;
use crate::widgets::height_of_both;
use crate::wish::Wish;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{FontId, Label, RichText, Sense, Ui};
use octoscope_core::explain::{RichText as Words, misprint_formula};
use octoscope_core::paper::{Verdict, erratum_of, misprint_title, paper_texts};
use octoscope_core::query::Query;
use octoscope_core::traverse::Variant;

/// Distance of lines.
const GAP: f32 = 2.0;

/// Height of what is said of the misprints of a query in a room of this width, in points.
pub fn most_height<const D: usize>(look: &Look, query: &Query<D>, width: f32) -> f32 {
    // Of rules in words, and of the names of several misprints.
    const WORDS: f32 = 159.0;
    // Of a name on two lines, of a caption, and of a verdict.
    const NAME: f32 = 33.0;
    const CAPTION: f32 = 16.0;
    const VERDICT: f32 = 19.0;
    let [printed] = printed_in(query)[..] else { return WORDS };
    let Some(misprint) = misprint_formula(printed) else { return WORDS };
    let rules = height_of_both(look, &misprint, width, CAPTION + 2.0 * GAP);
    (NAME + GAP + rules + VERDICT).max(WORDS)
}

/// The misprints that are followed, each with a switch that turns it off; without one, the
/// switches of all that could be. A click on the verdict goes to the step that it names.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    query: &mut Query<D>,
    verdict: &Found<Verdict>,
) -> Option<Wish> {
    ui.spacing_mut().item_spacing.y = GAP;
    let printed = printed_in(query);
    if printed.is_empty() {
        let own = misprints_of(query);
        switches(ui, look, query, &own);
        return None;
    }
    for &variant in &printed {
        ui.horizontal(|ui| {
            switches(ui, look, query, &[variant]);
            let title = misprint_title(variant, look.texts.language()).unwrap_or_default();
            ui.add(Label::new(RichText::new(title).size(13.5).family(look.strong_family())).wrap());
        });
        // Of several there is room for their names.
        if let (Some(erratum), [_]) = (erratum_of(variant), printed.as_slice()) {
            both_rules(ui, look, erratum, &[variant]);
        }
    }
    judged(ui, look, verdict)
}

/// A rule in words, behind its caption: below it there is no room.
pub(super) fn rule(ui: &mut Ui, look: &Look, caption: &str, text: &str) {
    let font = FontId::proportional(look.type_size(13.0));
    let mut job = LayoutJob::default();
    for (text, colour) in
        [(caption, look.palette.quiet), ("  ", look.palette.ink), (text, look.palette.ink)]
    {
        job.append(text, 0.0, TextFormat::simple(font.clone(), colour));
    }
    ui.add(Label::new(job).wrap());
}

/// Where the run goes wrong, to be clicked.
fn judged(ui: &mut Ui, look: &Look, verdict: &Found<Verdict>) -> Option<Wish> {
    let verdict = match verdict {
        Found::Known(verdict) | Found::Coming(Some(verdict)) => verdict,
        Found::Coming(None) | Found::Never => return None,
    };
    let told = Label::new(told_of(look, verdict, "paper-longer-short")).wrap();
    let Some(step) = verdict.first_step_off() else {
        ui.add(told);
        return None;
    };
    let shown = ui.add(told.sense(Sense::click())).on_hover_text(look.text("paper-go"));
    shown.clicked().then_some(Wish::Step(step))
}

/// Why the misprint that is followed is one, and what its marks in the picture mean; `None`
/// where none is followed.
pub fn why<const D: usize>(look: &Look, query: &Query<D>) -> Option<[Words; 2]> {
    let variant: Variant = *printed_in(query).first()?;
    let erratum = erratum_of(variant)?;
    let why = paper_texts(look.texts.language()).get(&erratum.key("why"));
    Some([Words::with_subscripts(&why), Words::with_subscripts(&look.text(marks_of(query)))])
}
