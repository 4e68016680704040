//! Location codes, bit by bit.

use super::bits::{BitRow, BitTable, Spacing};
use super::sheet::Sheet;
use super::subject::Subject;
use crate::{Anchor, Figure, Role};
use octoscope_core::explain::number;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::trace::Moment;
use octoscope_core::traverse::{Variant, Variants};
use octoscope_core::tree::{Tree, branch, morton};

/// Codes of a place as a table, and what is read off them.
#[derive(Clone, Debug, PartialEq)]
pub struct CodeTable {
    /// A row an axis.
    pub table: BitTable,
    /// The child that the framed bits select, in words.
    pub child: Option<String>,
    /// The Morton code, in words, or that there is none yet.
    pub morton: String,
}

/// Codes of the place that is looked for, as the rules of the query take them, else of
/// the current node.
pub fn code_table<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
    variants: Variants,
) -> CodeTable {
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
            let coordinate = number(domain.plane(axis, code[axis]));
            format!("{} ({} = {coordinate})", code[axis], AXIS_NAMES[axis])
        } else {
            String::new()
        },
        ..BitRow::default()
    });
    let rows = rows.collect();
    let width = root_level + 1;
    let table = BitTable { width, framed, rows, ..BitTable::default() };
    let child = framed.map(|bit| {
        let child = branch(code, bit + 1);
        let bits = (0..D).map(|e| format!("{} = {}", AXIS_NAMES[e], u8::from(child.is_upper(e))));
        let bits = bits.collect::<Vec<_>>().join(", ");
        let arguments = [
            ("bit", bit.into()),
            ("bits", bits.into()),
            ("child", child.0.into()),
            ("morton", child.morton_index().into()),
        ];
        // By these rules other bits are read, as if the codes were those that are shown.
        let is_printed = variants.has(Variant::B18) || variants.has(Variant::B19);
        texts.format(if is_printed { "codes-child-printed" } else { "codes-child" }, &arguments)
    });
    let morton = if is_known {
        texts.format("codes-morton", &[("code", morton(code).to_string().into())])
    } else {
        texts.get("codes-none")
    };
    CodeTable { table, child, morton }
}

/// How the bits of a level number the children.
pub fn child_rule<const D: usize>(texts: &Texts) -> String {
    let rule = if D == 2 { "2x + y" } else { "4x + 2y + z" };
    texts.format("codes-child-rule", &[("rule", rule.into())])
}

/// The codes with what is read off them, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    let variants = subject.query().variants_at_work();
    let CodeTable { table, child, morton } =
        code_table(subject.texts, subject.tree, subject.moment, variants);
    let mut sheet = Sheet::default();
    let mut head = child_rule::<D>(subject.texts);
    if let Some(node) = subject.moment.current {
        head = format!("{}; {head}", super::node_note(subject, node));
    }
    let mut bottom = sheet.paragraph(Role::Note, [0.0, 0.0], width, &head.into()) + 6.0;
    let table = table.figure(width, Spacing::Wide);
    let height = table.page.height;
    sheet.place(table.drawn, [0.0, bottom]);
    bottom += height + 8.0;
    if let Some(child) = child {
        bottom += sheet.paragraph(Role::Words, [0.0, bottom], width, &child.into()) + 4.0;
    }
    sheet.text(Role::Note, [0.0, bottom + 8.0], Anchor::Start, morton);
    sheet.figure([width, bottom + 16.0])
}
