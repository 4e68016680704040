//! Mid planes sorted along the ray, and the pieces that they cut it into.

use crate::look::Look;
use crate::widgets::{Lit, beside_or_below, caption, child_bits, lit, rich_job};
use eframe::egui::{Grid, Label, Ui};
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText, Span, approx};
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::trace::{Cuts, Extent, Frame, Moment};
use octoscope_core::tree::{Child, Tree};

/// Piece of the ray between two neighbouring cuts.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece<const D: usize> {
    from: f64,
    to: f64,
    /// The child that it is in.
    child: Child<D>,
    /// Axes whose bits differ from those of the piece before.
    flipped: Axes<D>,
}

/// The mid planes of the node at work in their order, those outside its interval
/// quiet, and the child of every piece in between, with the flipped bits lit.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
) {
    let at_work = |frame: &&Frame<D>| matches!(frame.extent, Extent::Interval(_));
    let frames = moment.stack.iter().rev().filter(at_work);
    let inner = frames.clone().find(|frame| frame.mid.is_some());
    let Some((frame, mid)) = inner.and_then(|frame| Some((frame, frame.mid?))) else {
        caption(ui, look, look.text("cuts-none"));
        return;
    };
    let mask = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
    ui.horizontal(|ui| {
        let codes = tree.code(frame.node).map(|c| c.to_string()).join(", ");
        let level = tree.level(frame.node);
        let arguments = [("level", level.into()), ("codes", codes.into())];
        caption(ui, look, look.texts.format("node-note", &arguments));
        ui.add_space(12.0);
        caption(ui, look, look.text("cuts-mask"));
        child_bits(ui, look, Child::<D>(mask.0), Axes::NONE);
    });
    beside_or_below(ui, |ui| {
        ui.vertical(|ui| planes(ui, look, frame, mid));
        ui.add_space(12.0);
        ui.vertical(|ui| {
            if let Some(cuts) = frame.cuts {
                let all = pieces([frame.enter(), frame.exit()], mid, cuts, mask);
                pieces_table(ui, look, &all, frame.child, event);
            }
        });
    });
}

/// The mid planes: sorted if they are, else in the order of the axes.
fn planes<const D: usize>(ui: &mut Ui, look: &Look, frame: &Frame<D>, mid: [f64; D]) {
    let grid = Grid::new("cuts").num_columns(3);
    grid.spacing([8.0, 0.0]).min_col_width(16.0).min_row_height(18.0).show(ui, |ui| {
        caption(ui, look, look.text("cuts-plane"));
        caption(ui, look, "t");
        ui.label("");
        ui.end_row();
        let order = frame.cuts.map_or_else(|| std::array::from_fn(|e| e as u8), |cuts| cuts.order);
        for axis in order.map(usize::from) {
            let inside = frame.cuts.is_some_and(|cuts| cuts.inside.contains(axis));
            let name = vec![
                Span { text: "t".to_owned(), axis: Some(axis), ..Span::default() },
                Span {
                    text: format!("{}m", AXIS_NAMES[axis]),
                    axis: Some(axis),
                    sub: true,
                    ..Span::default()
                },
            ];
            ui.add(Label::new(rich_job(&RichText(name), look, 14.0, 60.0)));
            let (tone, key) = if inside {
                (Lit::No, "cuts-inside")
            } else if mid[axis] <= frame.enter() {
                (Lit::Quiet, "cuts-before")
            } else {
                (Lit::Quiet, "cuts-after")
            };
            ui.label(lit(look, approx(mid[axis]), tone));
            if frame.cuts.is_some() {
                ui.label(lit(look, look.text(key), tone).size(look.type_size(12.0)));
            }
            ui.end_row();
        }
    });
}

fn pieces_table<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    pieces: &[Piece<D>],
    child: Option<Child<D>>,
    event: Option<&Event<D>>,
) {
    let now = pieces.iter().position(|piece| Some(piece.child) == child);
    let grid = Grid::new("pieces").num_columns(3);
    grid.spacing([8.0, 0.0]).min_col_width(16.0).min_row_height(18.0).show(ui, |ui| {
        caption(ui, look, look.text("cuts-piece"));
        caption(ui, look, look.text("cuts-child"));
        ui.label("");
        ui.end_row();
        for (n, piece) in pieces.iter().enumerate() {
            let tone = match now {
                Some(now) if n == now => Lit::Used,
                Some(now) if n < now => Lit::No,
                _ => Lit::Quiet,
            };
            ui.label(lit(look, format!("{} – {}", approx(piece.from), approx(piece.to)), tone));
            let flips = matches!(event, Some(Event::Flip { .. })) && now == Some(n);
            // What comes later is not known yet.
            if now.is_some_and(|now| n <= now) {
                ui.label(lit(look, piece.child.0.to_string(), tone));
                child_bits(ui, look, piece.child, if flips { piece.flipped } else { Axes::NONE });
            } else {
                ui.label(lit(look, "·", Lit::Quiet));
                ui.label("");
            }
            ui.end_row();
        }
    });
}

/// The pieces into which the mid planes cut the interval, with their children.
fn pieces<const D: usize>(
    [enter, exit]: [f64; 2],
    mid: [f64; D],
    cuts: Cuts<D>,
    mask: Axes<D>,
) -> Vec<Piece<D>> {
    let inside = cuts.order.map(usize::from).into_iter().filter(|&axis| cuts.inside.contains(axis));
    let mut pieces: Vec<Piece<D>> = Vec::new();
    let mut from = enter;
    for to in inside.map(|axis| mid[axis]).chain([exit]) {
        // Planes at the same parameter leave no piece between them.
        if from < to {
            let child = Child::from_upper_halves(mid.map(|t| t <= from)).mirrored(mask);
            let before = pieces.last().map_or(child, |piece| piece.child);
            let flipped = Axes(child.0 ^ before.0);
            pieces.push(Piece { from, to, child, flipped });
            from = to;
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_plane_inside_flips_the_bit_of_its_axis() {
        let cuts = Cuts { order: [1, 0], inside: Axes(0b11) };
        let all = pieces([0.0, 1.0], [0.75, 0.25], cuts, Axes::<2>::NONE);
        let told: Vec<_> = all.iter().map(|p| (p.from, p.to, p.child.0, p.flipped.0)).collect();
        assert_eq!(told, [(0.0, 0.25, 0, 0), (0.25, 0.75, 1, 1), (0.75, 1.0, 3, 2)]);
    }

    #[test]
    fn planes_at_the_same_parameter_flip_together() {
        let cuts = Cuts { order: [0, 1], inside: Axes(0b11) };
        let all = pieces([0.0, 1.0], [0.5, 0.5], cuts, Axes::<2>(0b10));
        let told: Vec<_> = all.iter().map(|p| (p.child.0, p.flipped.0)).collect();
        assert_eq!(told, [(0b10, 0), (0b01, 0b11)]);
    }

    #[test]
    fn a_plane_outside_cuts_nothing_but_decides_the_side() {
        let cuts = Cuts { order: [0, 1], inside: Axes(0) };
        let all = pieces([0.0, 1.0], [-1.0, 2.0], cuts, Axes::<2>::NONE);
        assert_eq!(all, [Piece { from: 0.0, to: 1.0, child: Child(0b10), flipped: Axes(0) }]);
    }
}
