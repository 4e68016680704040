//! Region location by XOR.

use super::bits::{BitRow, BitTable, Conclusion, Spacing};
use super::sheet::Sheet;
use super::subject::Subject;
use super::words::strong;
use crate::{Figure, Role};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::trace::Moment;
use octoscope_core::tree::Tree;

/// Corner codes, their XOR, the OR of those, and the level that follows, in words
/// as soon as it is known; `None` as long as no region is located.
pub fn region_table<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Option<(BitTable, Option<String>)> {
    let [from, to] = moment.corners?;
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
    let result = moment.difference.map(|difference| {
        let level = difference.level;
        let highest = union.checked_ilog2();
        let marked = highest.map_or(0, |bit| 1 << bit);
        let row = bit_row("or".to_owned(), None, union);
        rows.push(BitRow { rule_above: true, marked, ..row });
        match highest {
            None => texts.get("region-same"),
            Some(bit) => {
                // A misprinted rule takes another level than the codes say.
                let is_right = bit + 1 == u32::from(level);
                let key = if is_right { "region-level" } else { "region-printed" };
                texts.format(key, &[("bit", bit.into()), ("level", level.into())])
            }
        }
    });
    // A misprinted rule takes another level than the codes say: nothing follows from them.
    let level = moment.difference.map(|difference| difference.level);
    let conclusion =
        union.checked_ilog2().filter(|bit| level.map(u32::from) == Some(bit + 1)).map(|bit| {
            Conclusion {
                bit: bit as u8,
                text: texts.format("region-plus-one", &[("level", (bit + 1).into())]),
            }
        });
    let width = tree.domain().root_level() + 1;
    Some((BitTable { width, rows, conclusion, ..BitTable::default() }, result))
}

/// The table and its result, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Option<Figure> {
    let (table, result) = region_table(subject.texts, subject.tree, subject.moment)?;
    let table = table.figure(width, Spacing::Wide);
    let mut bottom = table.page.height;
    let mut sheet = Sheet::default();
    sheet.place(table.drawn, [0.0, 0.0]);
    if let Some(result) = result {
        bottom += 8.0;
        bottom += sheet.paragraph(Role::Words, [0.0, bottom], width, &strong(result));
    }
    Some(sheet.figure([width, bottom]))
}
