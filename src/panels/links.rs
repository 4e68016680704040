//! The net of links between neighbours.

use crate::look::Look;
use crate::widgets::{Lit, caption, lit, per_axis, rich_job};
use eframe::egui::{Grid, Label, RichText, Ui};
use octoscope_core::event::Event;
use octoscope_core::geometry::{AXIS_NAMES, Ray};
use octoscope_core::trace::{Moment, Trace};
use octoscope_core::tree::Tree;

/// A tree, and the ray that goes through it along links.
#[derive(Clone, Copy, Debug)]
pub struct Net<'a, const D: usize> {
    /// The tree.
    pub tree: &'a Tree<D>,
    /// The ray.
    pub ray: &'a Ray<D>,
}

/// Where the links of the leaf that is left lead to, a row each; the one that is
/// followed is lit.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    Net { tree, ray }: Net<'_, D>,
    trace: &Trace<D>,
    moment: &Moment<D>,
) {
    // Only an algorithm that follows links has had them made; and not while the
    // first leaf is still looked for.
    let has_links = trace.events.iter().any(|event| matches!(event, Event::Rope { .. }));
    let past = &trace.events[..moment.step.min(trace.events.len())];
    let Some(leaf) = moment.leaves.last().filter(|_| has_links) else {
        caption(ui, look, look.text("links-none"));
        return;
    };
    let left = moment.detour.links.last().map(|link| link[0]);
    let since_leaf = past.iter().rev().take_while(|event| !matches!(event, Event::Leaf { .. }));
    let mut followed = since_leaf.filter_map(|event| {
        if let Event::Rope { axis, node } = event {
            Some((usize::from(*axis), *node))
        } else {
            None
        }
    });
    let followed = followed.next();
    // At the border a link leads nowhere, and the node stays.
    let from = match followed {
        Some((_, None)) => moment.current.unwrap_or(leaf.node),
        Some((_, Some(_))) => left.unwrap_or(leaf.node),
        None => leaf.node,
    };
    let codes = tree.code(from).map(|c| c.to_string()).join(", ");
    let arguments = [("level", tree.level(from).into()), ("codes", codes.into())];
    caption(ui, look, look.texts.format("links-of", &arguments));
    let grid = Grid::new("links").num_columns(4);
    // The longest words of all columns take about 260 points.
    let gap = ((ui.available_width() - 260.0) / 3.0).clamp(4.0, 14.0);
    grid.spacing([gap, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
        for key in ["links-side", "stack-level", "stack-codes", "links-size"] {
            caption(ui, look, look.text(key));
        }
        ui.end_row();
        for axis in 0..D {
            for (upper, sign) in [(false, "−"), (true, "+")] {
                let forward = ray.direction()[axis] > 0.0;
                let used = followed.is_some_and(|(a, _)| a == axis) && forward == upper;
                let tone = if used { Lit::Used } else { Lit::No };
                let side = RichText::new(format!("{}{sign}", AXIS_NAMES[axis])).size(13.0);
                ui.label(side.strong().color(look.palette.axes[axis]));
                match tree.neighbour_across(from, axis, upper) {
                    Some(node) => {
                        ui.label(lit(look, tree.level(node).to_string(), tone));
                        let codes = per_axis(tree.code(node).map(|c| c.to_string()));
                        ui.add(Label::new(rich_job(&codes, look, 13.0, 160.0)));
                        let key = if tree.level(node) > tree.level(from) {
                            "links-larger"
                        } else if tree.node(node).is_leaf() {
                            "links-equal"
                        } else {
                            "links-divided"
                        };
                        ui.label(lit(look, look.text(key), tone).size(look.type_size(12.0)));
                    }
                    None => {
                        ui.label(lit(look, "–", tone));
                        ui.label(
                            lit(look, look.text("links-border"), Lit::Quiet)
                                .size(look.type_size(12.0)),
                        );
                        ui.label("");
                    }
                }
                ui.end_row();
            }
        }
    });
}
