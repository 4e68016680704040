//! Neighbour computation, written out as on paper.

use crate::look::Look;
use crate::widgets::{BitRow, BitTable, bit_table};
use eframe::egui::{RichText, Ui};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::{Moment, Target};
use octoscope_core::tree::{Tree, common_level};

/// The sum or difference of every crossed axis with its carries, the border, the
/// XOR with its run of ones, and the climb to the common ancestor.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let name = look.text("panel-neighbour");
    let Some(target) = moment.target else {
        ui.label(RichText::new(look.text("neighbour-none")).color(look.palette.quiet));
        return;
    };
    let root_level = tree.domain().root_level();
    for axis in 0..D {
        let crossed = target.axes.contains(axis);
        if !crossed && target.to[axis] == i64::from(target.from[axis]) {
            continue;
        }
        let rows =
            if crossed { sum_rows(look, &target, axis) } else { moved_rows(look, &target, axis) };
        let xor_level = axis_level(&target, axis, root_level);
        let mut table = BitTable { width: root_level + 1, framed: None, rows };
        if crossed && let (Some(level), true) = (xor_level, moment.difference.is_some()) {
            let run = ((1i64 << level) - 1) & !((1i64 << target.level) - 1);
            table.rows.push(BitRow {
                name: "xor".to_owned(),
                axis: Some(axis),
                bits: i64::from(target.from[axis]) ^ target.to[axis],
                note: look.texts.format("neighbour-climb", &[("level", level.into())]),
                marked: run,
                rule_above: true,
                ..BitRow::default()
            });
        }
        bit_table(ui, look, &table, &name);
        ui.add_space(6.0);
    }
    if let Some(outside) = target.outside {
        let axes = outside.iter().map(|axis| AXIS_NAMES[axis]).collect::<Vec<_>>().join(", ");
        let key = if outside.is_empty() { "neighbour-inside" } else { "neighbour-outside" };
        ui.label(RichText::new(look.texts.format(key, &[("axes", axes.into())])).strong());
    }
    if let Some(difference) = moment.difference {
        let arguments =
            [("climbed", difference.climbed.into()), ("level", difference.level.into())];
        ui.label(look.texts.format("neighbour-ancestor", &arguments));
    }
}

/// Code, what is added or subtracted, and the result; carries are marked.
fn sum_rows<const D: usize>(look: &Look, target: &Target<D>, axis: usize) -> Vec<BitRow> {
    let from = i64::from(target.from[axis]);
    let to = target.to[axis];
    let upwards = to > from;
    let step = if upwards { 1i64 << target.level } else { 1 };
    let changed = from ^ to;
    let row = |name: String, bits: i64, note: String| BitRow {
        name,
        axis: Some(axis),
        bits,
        note,
        ..BitRow::default()
    };
    let key = if upwards { "neighbour-carry" } else { "neighbour-borrow" };
    vec![
        row(AXIS_NAMES[axis].to_owned(), from, from.to_string()),
        row(if upwards { "+" } else { "−" }.to_owned(), step, step.to_string()),
        BitRow {
            marked: changed & !step,
            rule_above: true,
            ..row("=".to_owned(), to, format!("{to} · {}", look.text(key)))
        },
    ]
}

/// Code before and after, on an axis that is not crossed.
fn moved_rows<const D: usize>(look: &Look, target: &Target<D>, axis: usize) -> Vec<BitRow> {
    let row = |name: String, bits: i64| BitRow {
        name,
        axis: Some(axis),
        bits,
        note: bits.to_string(),
        ..BitRow::default()
    };
    vec![
        row(AXIS_NAMES[axis].to_owned(), i64::from(target.from[axis])),
        row(look.text("neighbour-new"), target.to[axis]),
    ]
}

/// Level of the common ancestor as far as this axis goes; `None` outside.
fn axis_level<const D: usize>(target: &Target<D>, axis: usize, root_level: u8) -> Option<u8> {
    let to = u32::try_from(target.to[axis]).ok().filter(|&code| code < 1 << root_level)?;
    Some(common_level([target.from[axis]], [to]).max(target.level))
}
