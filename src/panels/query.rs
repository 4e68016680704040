//! What is asked of the tree.

use crate::document::Document;
use crate::look::Look;
use crate::query_kind::QueryKind;
use crate::widgets::{
    Listed, Present, choose, drop_down, explained_segments, heading, number_field, segments, tick,
};
use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{Align, Grid, Layout, PopupCloseBehavior, RichText, Ui};
use octoscope_core::explain::{algorithm_authors, algorithm_name};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::paper::{erratum_of, misprint_title, paper_texts};
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::traverse::{Algorithm, Options, StopAt, Variant, Variants};

/// Chooses the query and edits its parameters.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, document: &mut Document<D>) {
    heading(ui, look, &look.text("panel-query"), "");
    let mut kind = QueryKind::of(&document.scenario.query);
    let choices = QueryKind::ALL.map(|kind| (kind, look.text(kind.key())));
    if segments(ui, &mut kind, &choices) {
        kind.ask(document);
    }
    let side = document.tree.domain().side();
    let max_level = document.tree.domain().root_level();
    match &mut document.scenario.query {
        Query::Ray { algorithm, options, arithmetic } => {
            ray_query::<D>(ui, look, algorithm, options, arithmetic);
        }
        Query::Point { at, method, variants: _ } => {
            let choices = [
                (PointMethod::Codes, look.text("point-codes")),
                (PointMethod::Comparison, look.text("point-comparison")),
            ];
            segments(ui, method, &choices);
            fields(ui, look, "query-point", &mut [at], side);
            hint(ui, look, "query-point-hint");
        }
        Query::Region { min, max, variants: _ } => {
            fields(ui, look, "query-region", &mut [min, max], side);
            hint(ui, look, "query-region-hint");
        }
        Query::Neighbour { level, code, direction, reach, method, variants: _ } => {
            let shown = code.map(|c| c.to_string()).join(", ");
            let arguments = [("level", (*level).min(max_level).into()), ("codes", shown.into())];
            ui.label(look.texts.format("neighbour-cell", &arguments));
            let choices = [
                (Reach::EqualOrLarger, look.text("reach-equal")),
                (Reach::Leaf, look.text("reach-leaf")),
                (Reach::EveryLeaf, look.text("reach-every-leaf")),
            ];
            segments(ui, reach, &choices);
            let choices = [
                (NeighbourMethod::Codes, look.text("neighbour-codes")),
                (NeighbourMethod::Tables, look.text("neighbour-tables")),
            ];
            segments(ui, method, &choices);
            pick_direction(ui, look, direction);
            hint(ui, look, "query-neighbour-hint");
        }
    }
}

fn ray_query<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    algorithm: &mut Algorithm,
    options: &mut Options,
    arithmetic: &mut Arithmetic,
) {
    let name = |algorithm: Algorithm| algorithm_name(algorithm, look.texts.language());
    let label = look.text("query-algorithm");
    let lines: Vec<_> = groups()
        .into_iter()
        .flat_map(|(key, group)| {
            let entries = group.into_iter().map(|choice| {
                Listed::Explained(choice, name(choice), algorithm_authors(choice).to_owned())
            });
            std::iter::once(Listed::Title(look.text(key))).chain(entries)
        })
        .collect();
    let present = Present { entry: Some(*algorithm), name: name(*algorithm) };
    let width = ui.available_width();
    let (list, chosen) = drop_down(ui, look, "algorithm", width, present, &lines);
    list.on_hover_text(label);
    *algorithm = chosen.unwrap_or(*algorithm);
    let choices =
        [(Arithmetic::Doubles, "arithmetic-doubles"), (Arithmetic::Exact, "arithmetic-exact")];
    // What tests every leaf by itself does so exactly, whatever is chosen for the others.
    let is_fixed = *algorithm == Algorithm::Exhaustive;
    let choices = choices.map(|(choice, key)| {
        let why = if is_fixed { "arithmetic-fixed-why" } else { &format!("{key}-why") };
        (choice, look.text(key), look.text(why))
    });
    ui.horizontal(|ui| {
        if is_fixed {
            let [_, (_, exact, why)] = &choices;
            ui.label(RichText::new(exact).size(14.0)).on_hover_text(why);
        } else {
            explained_segments(ui, arithmetic, &choices);
        }
        // Apart: it is no third choice beside them.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            rules::<D>(ui, look, *algorithm, &mut options.variants);
        });
    });
    let mut first = options.stop_at == StopAt::FirstFull;
    let response = ui.checkbox(&mut first, look.text("query-first-full"));
    response.on_hover_text(look.text("query-first-full-why"));
    options.stop_at = if first { StopAt::FirstFull } else { StopAt::End };
    segment_end(ui, look, &mut options.segment_end);
}

/// Name of a variant and what it does.
fn variant_texts(look: &Look, variant: Variant) -> (String, String) {
    let language = look.texts.language();
    let misprint = erratum_of(variant).zip(misprint_title(variant, language));
    let Some((erratum, title)) = misprint else {
        let key = format!("variant-{}", variant.id());
        return (look.text(&key), look.text(&format!("{key}-why")));
    };
    let why = paper_texts(language).get(&erratum.key("why"));
    (format!("{} · {title}", variant.id()), why)
}

/// The algorithms by the way they go, each group with the key of its title.
fn groups() -> [(&'static str, Vec<Algorithm>); 4] {
    use Algorithm::{
        AllChildren, Bsp, Codes, Dda, DdaOctree, Esvo, Exhaustive, Gargantini, Glassner, Hero,
        Parametric, ParametricTable, Samet, SametCorner, SametNet,
    };
    [
        (
            "algorithms-top-down",
            vec![Parametric, ParametricTable, Esvo, AllChildren, Hero, Gargantini, Bsp],
        ),
        ("algorithms-bottom-up", vec![Codes, Samet, SametCorner, SametNet, Glassner]),
        ("algorithms-grid", vec![Dda, DdaOctree]),
        ("algorithms-reference", vec![Exhaustive]),
    ]
}

/// Where the ray ends, if it does.
fn segment_end(ui: &mut Ui, look: &Look, end: &mut Option<f64>) {
    ui.horizontal(|ui| {
        let name = look.text("query-segment-end");
        let mut ends = end.is_some();
        ui.checkbox(&mut ends, &name);
        *end = ends.then_some(end.unwrap_or(1.0));
        if let Some(t) = end {
            number_field(ui, look, &name, t, 0.01, look.palette.ink);
        }
    });
}

/// Menu of the rules of the algorithm that can be had in another form.
fn rules<const D: usize>(ui: &mut Ui, look: &Look, algorithm: Algorithm, chosen: &mut Variants) {
    let is_own = |variant: &Variant| variant.belongs_to(algorithm) && variant.is_of_dimension(D);
    let own = Variant::ALL.into_iter().filter(is_own);
    let n_changed = chosen.iter().count();
    let title = look.texts.format("query-rules", &[("n", n_changed.into())]);
    let stays = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let (button, _) = MenuButton::new(title).config(stays).ui(ui, |ui| {
        if own.clone().next().is_none() {
            ui.label(look.text("query-rules-none"));
        }
        for variant in own {
            let mut on = chosen.has(variant);
            let (name, why) = variant_texts(look, variant);
            let response = match variant.other_reading() {
                Some(_) => choose(ui, look, on, name),
                None => tick(ui, look, &mut on, name),
            };
            if response.on_hover_text(why).clicked() {
                *chosen = chosen.switched(variant);
            }
        }
    });
    button.on_hover_text(look.text("query-rules-why"));
    // Those of another algorithm mean nothing here.
    *chosen = chosen.iter().filter(|variant| variant.belongs_to(algorithm)).collect();
}

fn fields<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    key: &str,
    points: &mut [&mut [f64; D]],
    side: f64,
) {
    const GAP: f32 = 8.0;
    let name = ui.spacing().interact_size.x;
    let width = (0.5 * (ui.available_width() - name) - GAP).floor();
    let grid = Grid::new(key).num_columns(1 + points.len()).spacing([GAP, 4.0]);
    grid.max_col_width(width).show(ui, |ui| {
        if points.len() > 1 {
            ui.label("");
            for end in ["query-region-from", "query-region-to"] {
                ui.label(RichText::new(look.text(end)).size(13.0).color(look.palette.quiet));
            }
            ui.end_row();
        }
        for axis in 0..D {
            let color = look.palette.axes[axis];
            ui.label(RichText::new(AXIS_NAMES[axis]).strong().color(color));
            for (n, point) in points.iter_mut().enumerate() {
                let name = format!("{} {}{}", look.text(key), AXIS_NAMES[axis], n);
                number_field(ui, look, &name, &mut point[axis], side / 256.0, color);
            }
            ui.end_row();
        }
    });
}

/// Three buttons an axis: down, stay, up.
fn pick_direction<const D: usize>(ui: &mut Ui, look: &Look, direction: &mut Direction<D>) {
    let mut components = direction.components();
    for axis in 0..D {
        ui.horizontal(|ui| {
            let color = look.palette.axes[axis];
            ui.label(RichText::new(AXIS_NAMES[axis]).strong().color(color));
            for (step, sign) in [(-1i8, "− 1"), (0, "0"), (1, "+ 1")] {
                let response = ui.selectable_label(components[axis] == step, sign);
                let spoken =
                    format!("{} {} {sign}", look.text("neighbour-direction"), AXIS_NAMES[axis]);
                response.widget_info(|| {
                    let role = eframe::egui::accesskit::Role::RadioButton;
                    eframe::egui::WidgetInfo::selected(
                        role,
                        true,
                        components[axis] == step,
                        &spoken,
                    )
                });
                if response.clicked() {
                    components[axis] = step;
                }
            }
        });
    }
    // All zeros point nowhere; the old direction stays.
    if let Ok(chosen) = Direction::new(components) {
        *direction = chosen;
    }
}

fn hint(ui: &mut Ui, look: &Look, key: &str) {
    ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_algorithm_is_in_one_group() {
        let mut grouped: Vec<_> = groups().into_iter().flat_map(|(_, group)| group).collect();
        assert_eq!(grouped.len(), Algorithm::ALL.len());
        grouped.sort_by_key(|algorithm| algorithm.id());
        grouped.dedup();
        assert_eq!(grouped.len(), Algorithm::ALL.len());
    }
}
