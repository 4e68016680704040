//! Region location by XOR.

use super::bits::{BitRow, BitTable, Conclusion, Spacing, in_line};
use super::columns::columns;
use super::sheet::Sheet;
use super::subject::Subject;
use super::words::strong;
use crate::{Figure, Role};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Code, Tree, joined};

/// Corner codes, their XOR, the OR of those, and the level that follows, in words
/// as soon as it is known; `None` as long as no region is located.
pub fn region_table<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Option<(BitTable, Option<String>)> {
    let mut table = bits_of(tree, moment)?;
    in_line(std::iter::once(&mut table), columns(texts, tree, moment));
    let Some(difference) = moment.difference else { return Some((table, None)) };
    let level = difference.level;
    let Some(bit) = highest_of(difference.xor) else {
        return Some((table, Some(texts.get("region-same"))));
    };
    // A misprinted rule takes another level than the codes say: nothing follows from them.
    let is_right = bit + 1 == level;
    if is_right {
        let text = texts.format("region-plus-one", &[("level", level.into())]);
        table.conclusion = Some(Conclusion { bit, text });
    }
    let key = if is_right { "region-level" } else { "region-printed" };
    let result = texts.format(key, &[("bit", bit.into()), ("level", level.into())]);
    Some((table, Some(result)))
}

/// The highest bit in which places differ.
fn highest_of<const D: usize>(xor: Code<D>) -> Option<u8> {
    joined(xor).checked_ilog2().map(|bit| bit as u8)
}

/// The codes and what is computed from them, as they are. Lit is the bit that is followed,
/// in the rows of the codes it belongs to; framed the highest in which the corners differ.
pub(super) fn bits_of<const D: usize>(tree: &Tree<D>, moment: &Moment<D>) -> Option<BitTable> {
    let [from, to] = moment.corners?;
    let followed = moment.codes.and_then(|codes| Some((codes.code, 1 << codes.bit?)));
    let bit_row = |name: String, axis: Option<usize>, bits: u32| BitRow {
        name,
        axis,
        bits: i64::from(bits),
        note: bits.to_string(),
        ..BitRow::default()
    };
    let row_of = |name: String, axis: usize, codes: Code<D>| {
        let marked = followed.filter(|(code, _)| *code == codes).map_or(0, |(_, bit)| bit);
        BitRow { marked, ..bit_row(name, Some(axis), codes[axis]) }
    };
    let mut rows = Vec::new();
    for (axis, name) in AXIS_NAMES.into_iter().enumerate().take(D) {
        rows.push(row_of(format!("c_{name}0"), axis, from));
        rows.push(bit_row(format!("c_{name}1"), Some(axis), to[axis]));
        if let Some(difference) = moment.difference {
            let row = row_of("xor".to_owned(), axis, difference.xor);
            rows.push(BitRow { rule_above: true, ..row });
        }
    }
    if let Some(difference) = moment.difference {
        let border = highest_of(difference.xor);
        let row = bit_row("or".to_owned(), None, joined(difference.xor));
        rows.push(BitRow { rule_above: true, border, ..row });
    }
    let width = tree.domain().root_level() + 1;
    Some(BitTable { width, rows, ..BitTable::default() })
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

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::trace::{Codes, Difference};

    /// Names of the rows in which a bit is lit while these codes are followed.
    fn lit(code: Code<2>) -> Vec<String> {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let difference =
            Difference { from: [10, 11], to: [13, 14], xor: [7, 5], level: 3, climbed: 0 };
        let moment = Moment {
            corners: Some([[10, 11], [13, 14]]),
            difference: Some(difference),
            codes: Some(Codes { code, bit: Some(3) }),
            ..Moment::default()
        };
        let rows = bits_of(&tree, &moment).unwrap().rows;
        rows.into_iter().filter(|row| row.marked != 0).map(|row| row.name).collect()
    }

    #[test]
    fn only_the_codes_that_are_followed_are_lit() {
        assert_eq!(lit([10, 11]), ["c_x0", "c_y0"]);
        assert_eq!(lit([7, 5]), ["xor", "xor"], "by a misprint");
    }
}
