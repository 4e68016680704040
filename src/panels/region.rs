//! Region location by XOR.

use crate::look::Look;
use crate::widgets::{BitRow, BitTable, bit_table};
use eframe::egui::{RichText, Ui};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::Moment;
use octoscope_core::tree::Tree;

/// Corner codes, their XOR, the OR of those, and the level that follows.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let Some([from, to]) = moment.corners else {
        ui.label(RichText::new(look.text("region-none")).color(look.palette.quiet));
        return;
    };
    let bit_row = |name: String, axis: Option<usize>, bits: u32| BitRow {
        name,
        axis,
        bits: i64::from(bits),
        note: bits.to_string(),
        ..BitRow::default()
    };
    let mut rows = Vec::new();
    let mut union = 0;
    for (axis, name) in AXIS_NAMES.into_iter().enumerate().take(D) {
        rows.push(bit_row(format!("{name}₀"), Some(axis), from[axis]));
        rows.push(bit_row(format!("{name}₁"), Some(axis), to[axis]));
        if let Some(difference) = moment.difference {
            union |= difference.xor[axis];
            let row = bit_row("xor".to_owned(), Some(axis), difference.xor[axis]);
            rows.push(BitRow { rule_above: true, ..row });
        }
    }
    if let Some(difference) = moment.difference {
        let marked = if union == 0 { 0 } else { 1 << (difference.level - 1) };
        let row = bit_row("or".to_owned(), None, union);
        rows.push(BitRow { rule_above: true, marked, ..row });
    }
    let table = BitTable { width: tree.domain().root_level() + 1, framed: None, rows };
    bit_table(ui, look, &table, &look.text("panel-region"));
    if let Some(difference) = moment.difference {
        let key = if union == 0 { "region-same" } else { "region-level" };
        let bit = i64::from(difference.level) - 1;
        let arguments = [("bit", bit.into()), ("level", difference.level.into())];
        ui.label(RichText::new(look.texts.format(key, &arguments)).strong());
    }
}
