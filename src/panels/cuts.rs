//! Mid planes sorted along the ray, and the pieces that they cut it into.

use crate::look::Look;
use crate::widgets::{
    ROW, Setting, beside_or_below, bit_of, caption, child_bits, is_narrow, node_note, range,
    rich_label, row_height, table,
};
use eframe::egui::Ui;
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText, Span, approx};
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::query::Query;
use octoscope_core::trace::{Cuts, Extent, Frame, Moment};
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::{Child, Tree};
use octoscope_figure::Anchor;
use octoscope_figure::views::{Entry, Table, Tone};

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

/// The node that is cut.
pub fn note<const D: usize>(look: &Look, tree: &Tree<D>, moment: &Moment<D>) -> String {
    node_note(look, tree, at_work(moment).map(|(frame, _)| frame.node))
}

/// The innermost frame at work whose mid planes are known, with their parameters.
fn at_work<const D: usize>(moment: &Moment<D>) -> Option<(&Frame<D>, [f64; D])> {
    let is_at_work = |frame: &&Frame<D>| matches!(frame.extent, Extent::Interval(_));
    let mut frames = moment.stack.iter().rev().filter(is_at_work);
    frames.find_map(|frame| Some((frame, frame.mid?)))
}

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    112.0 + 39.0 * D as f32
}

/// How the children of pieces are told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The first by the signs of the direction; from then on bits are flipped.
    Flips,
    /// Each by the sides of the mid planes on which its middle lies.
    Middles,
}

impl Rule {
    /// That of a query.
    pub fn of<const D: usize>(query: &Query<D>) -> Self {
        match query {
            Query::Ray { algorithm: Algorithm::Gargantini, .. } => Self::Middles,
            Query::Ray { .. }
            | Query::Point { .. }
            | Query::Region { .. }
            | Query::Neighbour { .. } => Self::Flips,
        }
    }
}

/// The mid planes of the node at work in their order, those outside its interval
/// quiet, and the child of every piece in between: by the `rule` with the flipped bits
/// lit, or with the comparisons that tell it.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    rule: Rule,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
) {
    let Some((frame, mid)) = at_work(moment) else {
        caption(ui, look, look.text("cuts-none"));
        return;
    };
    let mask = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
    let ends = [frame.enter(), frame.exit()];
    let pieces = frame.cuts.map(|cuts| pieces(ends, mid, cuts, mask));
    match rule {
        Rule::Flips => {
            ui.horizontal(|ui| {
                caption(ui, look, look.text("cuts-mask"));
                child_bits(ui, look, Child::<D>(mask.0));
            });
        }
        Rule::Middles => {
            let now = pieces.iter().flatten().find(|piece| Some(piece.child) == frame.child);
            let told = now.map_or_else(|| "–".into(), |piece| sides(piece, mask));
            ui.horizontal(|ui| {
                caption(ui, look, look.text("cuts-middle"));
                rich_label(ui, look, &told, 13.0, f32::INFINITY);
            });
        }
    }
    let planes = planes(look, frame, mid);
    let pieces = pieces.map(|all| pieces_table(look, rule, &all, frame.child, event));
    // Side by side, their rows are level.
    let shown = std::iter::once(&planes).chain(&pieces).filter(|_| !is_narrow(ui));
    let row = shown.map(|table| row_height(ui, look, table)).fold(ROW, f32::max);
    beside_or_below(ui, |ui| {
        ui.vertical(|ui| {
            table(ui, look, &planes, Setting { gap: 8.0, least: 16.0, row });
        });
        ui.add_space(12.0);
        ui.vertical(|ui| {
            if let Some(pieces) = &pieces {
                table(ui, look, pieces, Setting { gap: 6.0, least: 8.0, row });
            }
        });
    });
}

/// On which side of each mid plane the middle of a piece lies: 0.5034 ≥ t_xm, < t_ym. The
/// bits of its child tell it, as no plane is met within a piece, however short it is.
fn sides<const D: usize>(piece: &Piece<D>, mask: Axes<D>) -> RichText {
    let mut told = RichText::from(format!("{} ", approx(0.5 * piece.from + 0.5 * piece.to)));
    let passed = Axes::<D>(piece.child.0 ^ mask.0);
    for (axis, name) in AXIS_NAMES.into_iter().enumerate().take(D) {
        let sign = if passed.contains(axis) { "≥" } else { "<" };
        let gap = if axis == 0 { "" } else { ", " };
        told.0.push(Span { text: format!("{gap}{sign} "), ..Span::default() });
        let mut plane = RichText::with_subscripts(&format!("t_{name}m"));
        plane.0.iter_mut().for_each(|span| span.axis = Some(axis));
        told.0.append(&mut plane.0);
    }
    told
}

/// The mid planes: sorted if they are, else in the order of the axes.
fn planes<const D: usize>(look: &Look, frame: &Frame<D>, mid: [f64; D]) -> Table {
    let order = frame.cuts.map_or_else(|| std::array::from_fn(|e| e as u8), |cuts| cuts.order);
    let row = |axis: usize| {
        let inside = frame.cuts.is_some_and(|cuts| cuts.inside.contains(axis));
        let (tone, key) = if inside {
            (Tone::Plain, "cuts-inside")
        } else if mid[axis] <= frame.enter() {
            (Tone::Quiet, "cuts-before")
        } else {
            (Tone::Quiet, "cuts-after")
        };
        let told = if frame.cuts.is_some() { look.text(key) } else { String::new() };
        vec![
            Entry::new(RichText::with_subscripts(&format!("t_{}m", AXIS_NAMES[axis])), tone),
            Entry::new(approx(mid[axis]), tone),
            Entry::words(told, tone),
        ]
    };
    Table {
        columns: vec![Anchor::Start; 3],
        head: vec![look.text("cuts-plane").into(), "t".into(), "".into()],
        rows: order.map(usize::from).into_iter().map(row).collect(),
    }
}

fn pieces_table<const D: usize>(
    look: &Look,
    rule: Rule,
    pieces: &[Piece<D>],
    child: Option<Child<D>>,
    event: Option<&Event<D>>,
) -> Table {
    let now = pieces.iter().position(|piece| Some(piece.child) == child);
    let flips = matches!(event, Some(Event::Flip { .. }));
    let row = |(n, piece): (usize, &Piece<D>)| {
        let is_now = now == Some(n);
        let tone = match now {
            Some(_) if is_now && flips => Tone::Line,
            Some(_) if is_now => Tone::Used,
            Some(now) if n < now => Tone::Plain,
            Some(_) | None => Tone::Quiet,
        };
        // What comes later is not known yet.
        let is_known = now.is_some_and(|now| n <= now);
        let child = if is_known { piece.child.0.to_string() } else { "·".to_owned() };
        let bit = |axis: usize| {
            let text =
                RichText(if is_known { vec![bit_of(piece.child, axis)] } else { Vec::new() });
            let is_flipped = rule == Rule::Flips && piece.flipped.contains(axis) && is_known;
            let tone = match (is_flipped, is_now) {
                (true, true) if flips => Tone::Used,
                // Later it is still to be seen which bit was flipped, if one was.
                (true, _) => Tone::Line,
                (false, true) if rule == Rule::Flips && !flips && !piece.flipped.is_empty() => {
                    Tone::Plain
                }
                (false, _) => tone,
            };
            Entry::new(text, tone)
        };
        let first = [Entry::new(range([piece.from, piece.to]), tone), Entry::new(child, tone)];
        first.into_iter().chain((0..D).map(bit)).collect()
    };
    let [piece, child] = ["cuts-piece", "cuts-child"].map(|key| RichText::from(look.text(key)));
    Table {
        columns: [Anchor::Start, Anchor::Middle].into_iter().chain([Anchor::End; D]).collect(),
        head: vec![piece, child],
        rows: pieces.iter().enumerate().map(row).collect(),
    }
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
    use octoscope_core::text::Language;
    use octoscope_figure::Theme;

    #[test]
    fn each_plane_inside_flips_the_bit_of_its_axis() {
        let cuts = Cuts { order: [1, 0], inside: Axes(0b11) };
        let all = pieces([0.0, 1.0], [0.75, 0.25], cuts, Axes::<2>::NONE);
        let told: Vec<_> = all.iter().map(|p| (p.from, p.to, p.child.0, p.flipped.0)).collect();
        assert_eq!(told, [(0.0, 0.25, 0, 0), (0.25, 0.75, 1, 1), (0.75, 1.0, 3, 2)]);
    }

    #[test]
    fn the_flipped_bit_is_lit_in_every_piece_so_far() {
        let look = crate::theme::look(Language::English, Theme::Light);
        let cuts = Cuts { order: [1, 0], inside: Axes(0b11) };
        let all = pieces([0.0, 1.0], [0.75, 0.25], cuts, Axes::<2>::NONE);
        let up = Event::<2>::Up { node: None };
        let flip = Event::<2>::Flip { at: 0.75, child: Child(3), axes: Axes(2) };
        for (event, last) in [(up, Tone::Line), (flip, Tone::Used)] {
            let table = pieces_table(&look, Rule::Flips, &all, Some(Child(3)), Some(&event));
            let lit = |row: &Vec<Entry>| [2, 3].map(|at| row[at].tone);
            let lit: Vec<_> = table.rows.iter().map(lit).collect();
            let other = if last == Tone::Used { Tone::Line } else { Tone::Plain };
            let plain = Tone::Plain;
            assert_eq!(lit, [[plain, plain], [plain, Tone::Line], [last, other]]);
        }
    }

    #[test]
    fn planes_at_the_same_parameter_flip_together() {
        let cuts = Cuts { order: [0, 1], inside: Axes(0b11) };
        let all = pieces([0.0, 1.0], [0.5, 0.5], cuts, Axes::<2>(0b10));
        let told: Vec<_> = all.iter().map(|p| (p.child.0, p.flipped.0)).collect();
        assert_eq!(told, [(0b10, 0), (0b01, 0b11)]);
    }

    #[test]
    fn a_middle_lies_on_a_side_of_every_mid_plane() {
        let piece = Piece { from: 0.25, to: 0.5, child: Child::<2>(2), flipped: Axes(0) };
        let told = |mask: u8| sides(&piece, Axes(mask)).plain();
        assert_eq!(told(0), "0.375 ≥ t_xm, < t_ym");
        assert_eq!(told(3), "0.375 < t_xm, ≥ t_ym");
    }

    #[test]
    fn a_plane_outside_cuts_nothing_but_decides_the_side() {
        let cuts = Cuts { order: [0, 1], inside: Axes(0) };
        let all = pieces([0.0, 1.0], [-1.0, 2.0], cuts, Axes::<2>::NONE);
        assert_eq!(all, [Piece { from: 0.0, to: 1.0, child: Child(0b10), flipped: Axes(0) }]);
    }
}
