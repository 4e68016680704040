//! The paper lab: rules as printed against corrected.

mod hall;

pub use hall::{most_height, why};

use crate::document::Found;
use crate::look::Look;
use crate::widgets::{in_segments, printed_and_right, rich_label};
use crate::wish::Wish;
use eframe::egui::{CollapsingHeader, Label, RichText, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::{RichText as Words, misprint_formula};
use octoscope_core::paper::{
    ERRATA, Erratum, Severity, Verdict, erratum_of, misprint_title, paper_texts,
};
use octoscope_core::query::Query;
use octoscope_core::traverse::Variant;

/// Switches for the misprints of what is asked, what they do, and the list of all
/// errata. `verdict` is that of the present run. Returns what is wished for.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    query: &mut Query<D>,
    verdict: &Found<Verdict>,
) -> Option<Wish> {
    if look.is_for_hall() {
        return hall::ui(ui, look, query, verdict);
    }
    let mut wish = None;
    let own = misprints_of(query);
    if own.is_empty() {
        ui.add(Label::new(quiet(look, look.text("paper-none"))).wrap());
    }
    switches(ui, look, query, &own);

    let printed = printed_in(query);
    for &variant in &printed {
        if let Some(erratum) = erratum_of(variant) {
            ui.add_space(4.0);
            let title = misprint_title(variant, look.texts.language()).unwrap_or_default();
            ui.label(RichText::new(format!("{} · {title}", variant.id())).strong());
            explained(ui, look, erratum, &[variant]);
            if ui.button(look.text("paper-counterexample")).clicked() {
                wish = Some(Wish::Counterexample(variant));
            }
        }
    }
    if !printed.is_empty() {
        ui.add_space(4.0);
        wish = judged(ui, look, query, verdict).or(wish);
    }
    ui.add_space(4.0);
    CollapsingHeader::new(look.text("paper-all")).id_salt("errata").show(ui, |ui| {
        wish = list(ui, look).or(wish.take());
    });
    wish
}

/// The misprints that a query can follow.
fn misprints_of<const D: usize>(query: &Query<D>) -> Vec<Variant> {
    Variant::ALL.into_iter().filter(|&v| v.is_misprint() && query.takes(v)).collect()
}

/// Those that it follows.
fn printed_in<const D: usize>(query: &Query<D>) -> Vec<Variant> {
    query.variants_at_work().iter().filter(|v| v.is_misprint()).collect()
}

/// The key of what the marks in the picture mean.
fn marks_of<const D: usize>(query: &Query<D>) -> &'static str {
    if query.variants_at_work().has(Variant::B7) { "paper-marks-mirrored" } else { "paper-marks" }
}

/// Turns each of them on and off.
fn switches<const D: usize>(ui: &mut Ui, look: &Look, query: &mut Query<D>, of: &[Variant]) {
    let names: Vec<&str> = of.iter().map(|variant| variant.id()).collect();
    in_segments(ui, of, &names, |ui, &variant| switch(ui, look, query, variant));
}

/// Turns one of them on and off.
fn switch<const D: usize>(ui: &mut Ui, look: &Look, query: &mut Query<D>, variant: Variant) {
    let on = query.variants().has(variant);
    let title = misprint_title(variant, look.texts.language());
    let response = ui.selectable_label(on, RichText::new(variant.id()).size(14.0));
    if variant.other_reading().is_some() {
        response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, on, variant.id()));
    }
    if response.on_hover_text(title.unwrap_or_default()).clicked() {
        *query = query.with_variants(query.variants().switched(variant));
    }
}

/// Whether the run goes wrong, where, and a search for another question that does.
fn judged<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    query: &Query<D>,
    verdict: &Found<Verdict>,
) -> Option<Wish> {
    let mut wish = None;
    let verdict = match verdict {
        Found::Known(verdict) | Found::Coming(Some(verdict)) => verdict,
        Found::Coming(None) => {
            ui.label(quiet(look, look.text("paper-coming")));
            return None;
        }
        Found::Never => {
            ui.label(quiet(look, look.text("paper-too-large")));
            return None;
        }
    };
    ui.add(Label::new(told_of(look, verdict, "paper-longer")).wrap());
    if let Some(step) = verdict.first_step_off()
        && ui.button(look.text("paper-go")).clicked()
    {
        wish = Some(Wish::Step(step));
    }
    let other = match query {
        Query::Ray { .. } => "paper-other",
        Query::Point { .. } => "paper-other-point",
        Query::Region { .. } => "paper-other-region",
        Query::Neighbour { .. } => "paper-other-cell",
    };
    if ui.button(look.text(other)).clicked() {
        wish = Some(Wish::OtherQuestion);
    }
    ui.add(Label::new(quiet(look, look.text(marks_of(query)))).wrap());
    wish
}

/// Whether a run goes wrong, and where; `longer` is the key of what is said of a detour.
fn told_of(look: &Look, verdict: &Verdict, longer: &str) -> RichText {
    let told = match (verdict.first_wrong_step, verdict.detour) {
        (Some(step), _) => look.texts.format("paper-wrong", &[("step", step.into())]),
        (None, Some(step)) => {
            let [steps, right] = verdict.n_steps;
            let arguments =
                [("steps", steps.into()), ("right", right.into()), ("step", step.into())];
            look.texts.format(longer, &arguments)
        }
        (None, None) => return RichText::new(look.text("paper-agrees")),
    };
    RichText::new(told).strong().color(look.palette.rejected)
}

/// What is printed and what is right: as formulas where these tell it.
fn both_rules(ui: &mut Ui, look: &Look, erratum: &Erratum, variants: &[Variant]) {
    let misprints: Vec<_> = variants.iter().filter_map(|&v| misprint_formula(v)).collect();
    misprints.iter().for_each(|misprint| printed_and_right(ui, look, misprint));
    if !misprints.is_empty() {
        return;
    }
    for (key, part) in [("paper-printed", "printed"), ("paper-right", "right")] {
        let [caption, text] = [look.text(key), told(look, erratum, part)];
        if look.is_for_hall() {
            hall::rule(ui, look, &caption, &text);
        } else {
            ui.label(quiet(look, caption));
            ui.add(Label::new(RichText::new(text).monospace().size(13.0)).wrap());
        }
    }
}

/// The same, and why.
fn explained(ui: &mut Ui, look: &Look, erratum: &Erratum, variants: &[Variant]) {
    both_rules(ui, look, erratum, variants);
    let why = Words::with_subscripts(&told(look, erratum, "why"));
    let width = ui.available_width();
    rich_label(ui, look, &why, 15.0, width);
}

/// All errata; a click unfolds one.
fn list(ui: &mut Ui, look: &Look) -> Option<Wish> {
    let mut wish = None;
    let meaning = |severity: Severity| look.text(&format!("paper-severity-{}", severity.id()));
    let signs = [Severity::Wrong, Severity::Misleading, Severity::Cosmetic];
    let legend = signs.map(|severity| format!("{} {}", sign(severity), meaning(severity)));
    ui.add(Label::new(quiet(look, legend.join("\n"))).wrap());
    for erratum in &ERRATA {
        let sign = sign(erratum.severity);
        let title = format!("{} {sign} {}", erratum.id, told(look, erratum, "title"));
        let header = CollapsingHeader::new(RichText::new(title).size(13.0)).id_salt(erratum.id);
        let shown = header.show(ui, |ui| {
            explained(ui, look, erratum, erratum.variants);
            for &variant in erratum.variants {
                let text = look.texts.format("paper-try", &[("variant", variant.id().into())]);
                if ui.button(text).clicked() {
                    wish = Some(Wish::Counterexample(variant));
                }
            }
        });
        shown.header_response.on_hover_text(meaning(erratum.severity));
    }
    wish
}

/// How bad an erratum is, at a glance.
fn sign(severity: Severity) -> &'static str {
    match severity {
        Severity::Wrong => "!!",
        Severity::Misleading => "!",
        Severity::Cosmetic => "·",
    }
}

fn told(look: &Look, erratum: &Erratum, part: &str) -> String {
    paper_texts(look.texts.language()).get(&erratum.key(part))
}

fn quiet(look: &Look, text: String) -> RichText {
    RichText::new(text).size(13.0).color(look.palette.quiet)
}
