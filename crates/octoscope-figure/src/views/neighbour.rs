//! Neighbour computation, written out as on paper.

use super::bits::{BitRow, BitTable, Carries, Spacing, in_line};
use super::columns::columns;
use super::sheet::Sheet;
use super::subject::Subject;
use super::words::strong;
use crate::{Figure, Role};
use octoscope_core::explain::with_minus;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::trace::{Moment, Target};
use octoscope_core::tree::{self, Tree, common_level};

/// A neighbour computation.
#[derive(Clone, Debug, PartialEq)]
pub struct NeighbourTables {
    /// The sum or difference of every axis on which something changes.
    pub tables: Vec<BitTable>,
    /// Whether the result lies in the domain, in words, once it is known.
    pub border: Option<String>,
    /// How far the climb to the common ancestor has come, in words.
    pub climb: Option<String>,
}

/// The sum or difference of every crossed axis with its carries, the border, the
/// XOR with its run of ones, and the climb to the common ancestor; as long as no cell is
/// left, the codes of the node from which that will be; `None` where there is none.
pub fn neighbour_tables<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Option<NeighbourTables> {
    let mut tables = bits_of(texts, tree, moment);
    if tables.is_empty() {
        return None;
    }
    in_line(tables.iter_mut(), columns(texts, tree, moment));
    let border = moment.target.and_then(|target| target.outside).map(|outside| {
        let axes = outside.iter().map(|axis| AXIS_NAMES[axis]).collect::<Vec<_>>().join(", ");
        let key = if outside.is_empty() { "neighbour-inside" } else { "neighbour-outside" };
        texts.format(key, &[("axes", axes.into())])
    });
    let climb = moment.difference.map(|difference| {
        let arguments =
            [("climbed", difference.climbed.into()), ("level", difference.level.into())];
        texts.format("neighbour-ancestor", &arguments)
    });
    Some(NeighbourTables { tables, border, climb })
}

/// Heights of the tables of a neighbour once all of them is computed, one below the other:
/// the first has the numbers of the bits, the last the level that follows from all.
pub fn neighbour_heights<const D: usize>(target: &Target<D>, spacing: Spacing) -> Vec<f64> {
    let mut heights: Vec<f64> = (0..D)
        .map(|axis| {
            // Code, what is added, result, XOR; or code before and after, XOR; or one that stays.
            let n_rows = match (target.axes.contains(axis), is_told(target, axis)) {
                (true, _) => 4,
                (false, true) => 3,
                (false, false) => 1,
            };
            let is_carried = target.axes.contains(axis) && carries_of(target, axis) != 0;
            BitTable::height(n_rows, is_carried, spacing)
        })
        .collect();
    if let [first, ..] = heights.as_mut_slice() {
        *first += BitTable::HEADER;
    }
    if let [_, .., last] = heights.as_mut_slice() {
        *last += BitTable::height(1, false, spacing);
    }
    heights
}

/// Whether something is told of an axis.
fn is_told<const D: usize>(target: &Target<D>, axis: usize) -> bool {
    target.axes.contains(axis) || target.to[axis] != i64::from(target.from[axis])
}

/// The tables, as they are.
pub(super) fn bits_of<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Vec<BitTable> {
    let Some(target) = moment.target else { return own_tables(tree, moment) };
    let root_level = tree.domain().root_level();
    // The bit of the step, once the codes beyond are followed.
    let followed = moment.codes.filter(|codes| codes.code.map(i64::from) == target.to);
    let followed = followed.and_then(|codes| codes.bit);
    let table = |axis: usize| {
        let crossed = target.axes.contains(axis);
        let mut rows = match (crossed, is_told(&target, axis)) {
            (true, _) => sum_rows(&target, axis),
            (false, true) => moved_rows(texts, &target, axis),
            // It is followed like the others.
            (false, false) if followed.is_some() => vec![code_row(axis, target.to[axis])],
            (false, false) => return None,
        };
        // What is read now is lit in the place of what was computed.
        if let (Some(bit), Some(row)) = (followed, rows.last_mut()) {
            row.marked = 1 << bit;
        }
        // As soon as it is asked whether the result is outside.
        let sum = rows.last_mut().filter(|_| crossed && target.outside.is_some());
        sum.into_iter().for_each(|sum| sum.border = Some(root_level));
        let carries = Some(carries_of(&target, axis)).filter(|bits| crossed && *bits != 0);
        let upwards = target.to[axis] > i64::from(target.from[axis]);
        let key = if upwards { "neighbour-carries" } else { "neighbour-borrows" };
        let carries = carries.map(|bits| Carries { name: texts.get(key), bits });
        let width = root_level + 1;
        let mut table = BitTable { width, rows, carries, ..BitTable::default() };
        if is_told(&target, axis)
            && let Some(level) = axis_level(&target, axis, root_level)
            && moment.difference.is_some()
        {
            let run = ((1i64 << level) - 1) & !((1i64 << target.level) - 1);
            let run = if followed.is_some() { 0 } else { run };
            table.rows.push(BitRow {
                name: "xor".to_owned(),
                axis: Some(axis),
                bits: i64::from(target.from[axis]) ^ target.to[axis],
                // Along the other axes the place stays within the cell: no level follows.
                note: if crossed {
                    texts.format("neighbour-climb", &[("level", level.into())])
                } else {
                    String::new()
                },
                marked: if crossed { run } else { 0 },
                rule_above: true,
                ..BitRow::default()
            });
        }
        Some(table)
    };
    let mut tables: Vec<BitTable> = (0..D).filter_map(table).collect();
    // Where several axes differ, the level follows from all of them together.
    if let (Some(difference), Some(last)) = (moment.difference, tables.last_mut())
        && difference.xor.iter().filter(|&&bits| bits != 0).count() > 1
    {
        let union = tree::joined(difference.xor);
        let marked = union.checked_ilog2().filter(|_| followed.is_none()).map_or(0, |bit| 1 << bit);
        let (name, bits) = ("or".to_owned(), i64::from(union));
        // As formulas call it.
        let note = format!("Δ = {union}");
        last.rows.push(BitRow { name, bits, note, marked, rule_above: true, ..BitRow::default() });
    }
    tables
}

/// The codes of the current node.
fn own_tables<const D: usize>(tree: &Tree<D>, moment: &Moment<D>) -> Vec<BitTable> {
    let width = tree.domain().root_level() + 1;
    let table = |(axis, code): (usize, u32)| {
        let rows = vec![code_row(axis, i64::from(code))];
        BitTable { width, rows, ..BitTable::default() }
    };
    let code = moment.current.map(|node| tree.code(node));
    code.into_iter().flatten().enumerate().map(table).collect()
}

/// Code, what is added or subtracted, and the result.
fn sum_rows<const D: usize>(target: &Target<D>, axis: usize) -> Vec<BitRow> {
    let from = i64::from(target.from[axis]);
    let to = target.to[axis];
    let upwards = to > from;
    let step = step_of(target, axis);
    let changed = from ^ to;
    let row = |name: String, bits: i64, note: String| BitRow {
        name,
        axis: Some(axis),
        bits,
        note,
        ..BitRow::default()
    };
    let to_text = with_minus(to);
    vec![
        row(AXIS_NAMES[axis].to_owned(), from, from.to_string()),
        row(if upwards { "+" } else { "−" }.to_owned(), step, step.to_string()),
        BitRow { marked: changed, rule_above: true, ..row("=".to_owned(), to, to_text) },
    ]
}

/// What is added or subtracted: up the size of the cell, down that of the smallest; by
/// a printed rule something else.
fn step_of<const D: usize>(target: &Target<D>, axis: usize) -> i64 {
    (target.to[axis] - i64::from(target.from[axis])).abs()
}

/// The columns into which a one is carried, or from which one is borrowed.
fn carries_of<const D: usize>(target: &Target<D>, axis: usize) -> i64 {
    let from = i64::from(target.from[axis]);
    from ^ target.to[axis] ^ step_of(target, axis)
}

/// A code as it is.
fn code_row(axis: usize, bits: i64) -> BitRow {
    let (name, note) = (AXIS_NAMES[axis].to_owned(), bits.to_string());
    BitRow { name, axis: Some(axis), bits, note, ..BitRow::default() }
}

/// Code before and after, on an axis that is not crossed.
fn moved_rows<const D: usize>(texts: &Texts, target: &Target<D>, axis: usize) -> Vec<BitRow> {
    let row = |name: String, bits: i64| BitRow {
        name,
        axis: Some(axis),
        bits,
        note: bits.to_string(),
        ..BitRow::default()
    };
    vec![
        row(AXIS_NAMES[axis].to_owned(), i64::from(target.from[axis])),
        row(texts.get("neighbour-new"), target.to[axis]),
    ]
}

/// Level of the common ancestor as far as this axis goes; `None` outside.
fn axis_level<const D: usize>(target: &Target<D>, axis: usize, root_level: u8) -> Option<u8> {
    let to = u32::try_from(target.to[axis]).ok().filter(|&code| code < 1 << root_level)?;
    Some(common_level([target.from[axis]], [to]).max(target.level))
}

/// The computation, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Option<Figure> {
    const GAP: f64 = 10.0;
    let computed = neighbour_tables(subject.texts, subject.tree, subject.moment)?;
    let mut sheet = Sheet::default();
    let mut bottom = 0.0;
    for table in &computed.tables {
        let table = table.figure(width, Spacing::Wide);
        let height = table.page.height;
        sheet.place(table.drawn, [0.0, bottom]);
        bottom += height + GAP;
    }
    let words = [computed.border.map(strong), computed.climb.map(Into::into)];
    for text in words.into_iter().flatten() {
        bottom += sheet.paragraph(Role::Words, [0.0, bottom], width, &text);
    }
    Some(sheet.figure([width, bottom]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Axes;

    #[test]
    fn the_bits_that_change_are_lit_and_then_those_that_are_read() {
        use octoscope_core::scenario::{AnyScenario, built_in};
        use octoscope_core::text::Language;
        use octoscope_core::trace::Codes;
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let texts = Texts::new(Language::English, &[super::super::figure_texts(Language::English)]);
        let (from, to, axes) = ([0b0111, 3], [0b1000, 3], Axes::one(0));
        let target = Some(Target { level: 0, from, to, axes, outside: None });
        let lit = |codes| {
            let tables = bits_of(&texts, &tree, &Moment { target, codes, ..Moment::default() });
            let rows = tables.iter().flat_map(|table| &table.rows);
            rows.map(|row| row.marked).collect::<Vec<_>>()
        };
        assert_eq!(lit(None), [0, 0, 0b1111]);
        assert_eq!(lit(Some(Codes { code: [8, 3], bit: Some(2) })), [0, 0, 0b100, 0b100]);
    }

    #[test]
    fn a_one_is_carried_through_every_one_that_is_there() {
        let target = Target {
            level: 0,
            from: [0b0111, 0],
            to: [0b1000, 0],
            axes: Axes::one(0),
            outside: None,
        };
        assert_eq!(carries_of::<2>(&target, 0), 0b1110);
        let back = Target { from: [0b1000, 0], to: [0b0111, 0], ..target };
        assert_eq!(carries_of::<2>(&back, 0), 0b1110, "borrowed");
    }
}
