//! Location codes, bit by bit.

use crate::look::Look;
use crate::widgets::{BitRow, BitTable, bit_table};
use eframe::egui::{RichText, Ui};
use octoscope_core::explain::number;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Tree, branch, morton};

/// How the bits of a level number the children.
pub fn note<const D: usize>(look: &Look) -> String {
    let rule = if D == 2 { "2x + y" } else { "4x + 2y + z" };
    look.texts.format("codes-child-rule", &[("rule", rule.into())])
}

/// Codes of the place that is looked for, else of the current node.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let domain = tree.domain();
    let root_level = domain.root_level();
    let node = moment.current;
    let level = node.map_or(root_level, |id| tree.level(id));
    let (code, known_from) = match (moment.codes, node) {
        (Some(codes), _) => (codes.code, 0),
        (None, Some(id)) => (tree.code(id), level),
        (None, None) => ([0; D], root_level),
    };
    let is_known = moment.codes.is_some() || node.is_some();
    // The bit that led to the current node.
    let framed = moment.codes.map_or((level < root_level).then_some(level), |codes| codes.bit);
    let rows = (0..D).map(|axis| BitRow {
        name: AXIS_NAMES[axis].to_owned(),
        axis: Some(axis),
        bits: i64::from(code[axis]),
        known_from,
        note: if is_known {
            format!("{} = {}", code[axis], number(domain.plane(axis, code[axis])))
        } else {
            String::new()
        },
        ..BitRow::default()
    });
    let table = BitTable { width: root_level + 1, framed, rows: rows.collect() };
    bit_table(ui, look, &table, &look.text("panel-codes"));

    let quiet = |text: String| RichText::new(text).size(13.0).color(look.palette.quiet);
    if let Some(bit) = framed {
        let child = branch(code, bit + 1);
        let bits = (0..D).map(|e| format!("{} = {}", AXIS_NAMES[e], u8::from(child.is_upper(e))));
        let bits = bits.collect::<Vec<_>>().join(", ");
        let arguments = [
            ("bit", bit.into()),
            ("bits", bits.into()),
            ("child", child.0.into()),
            ("morton", child.morton_index().into()),
        ];
        ui.label(RichText::new(look.texts.format("codes-child", &arguments)).size(14.0));
    }
    ui.label(quiet(if is_known {
        let code = morton(code).to_string();
        look.texts.format("codes-morton", &[("code", code.into())])
    } else {
        look.text("codes-none")
    }));
}
