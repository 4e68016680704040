//! Location codes, bit by bit.

use super::bits::{BitRow, BitTable, Spacing, in_line};
use super::columns::columns;
use super::sheet::Sheet;
use super::subject::Subject;
use crate::{Anchor, Figure, Role};
use octoscope_core::event::Event;
use octoscope_core::explain::shown_number;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::trace::{Moment, Target};
use octoscope_core::traverse::{Variant, Variants};
use octoscope_core::tree::{Code, NodeId, Tree, branch, morton};

/// Codes of a place as a table, and what is read off them.
#[derive(Clone, Debug, PartialEq)]
pub struct CodeTable {
    /// Whose codes they are, in words; empty as long as there are none.
    pub of: String,
    /// A row an axis.
    pub table: BitTable,
    /// The child that the framed bits select, in words.
    pub child: Option<String>,
    /// The Morton code, in words, or that there is none yet.
    pub morton: String,
}

/// What the codes are those of.
enum CodesOf<const D: usize> {
    /// A cell of the grid that is walked through.
    Cell(Code<D>),
    /// The smallest cell of the place that is looked for.
    Wanted(Code<D>),
    /// The current node.
    Node(NodeId),
}

impl<const D: usize> CodesOf<D> {
    fn of(tree: &Tree<D>, moment: &Moment<D>) -> Option<Self> {
        let cell = moment.grid.and_then(|grid| grid.cell);
        // From the step that computes them until it is known where to look for them; not
        // those that have led to the leaf that is left.
        let left = moment.exits.and(moment.leaves.last());
        let is_beyond = |target: &Target<D>| {
            left.is_none_or(|leaf| tree.code(leaf.node) == target.from)
                && moment.difference.is_none()
        };
        let beyond = moment.target.filter(is_beyond);
        let beyond = beyond.and_then(|target| tree.domain().code_inside(target.to));
        let wanted = beyond.or(moment.codes.map(|codes| codes.code));
        cell.map(Self::Cell).or(wanted.map(Self::Wanted)).or(moment.current.map(Self::Node))
    }

    fn code(&self, tree: &Tree<D>) -> Code<D> {
        match *self {
            Self::Cell(code) | Self::Wanted(code) => code,
            Self::Node(node) => tree.code(node),
        }
    }

    /// In words.
    fn note(&self, texts: &Texts, tree: &Tree<D>) -> String {
        let codes = self.code(tree).map(|c| c.to_string()).join(", ");
        match *self {
            Self::Cell(_) => texts.format("codes-of-cell", &[("codes", codes.into())]),
            Self::Wanted(_) => texts.format("codes-of-wanted", &[("codes", codes.into())]),
            Self::Node(node) => super::place_note(texts, (tree.level(node), tree.code(node))),
        }
    }
}

/// The codes at a moment, as they are.
pub(super) fn bits_of<const D: usize>(tree: &Tree<D>, moment: &Moment<D>) -> BitTable {
    let domain = tree.domain();
    let root_level = domain.root_level();
    let of = CodesOf::of(tree, moment);
    let code = of.as_ref().map_or([0; D], |of| of.code(tree));
    let followed = moment.codes.filter(|codes| codes.code == code);
    let (known_from, framed) = match of {
        None => (root_level, None),
        Some(CodesOf::Cell(_) | CodesOf::Wanted(_)) => (0, followed.and_then(|codes| codes.bit)),
        // The bit that led to it.
        Some(CodesOf::Node(node)) => {
            let level = tree.level(node);
            (level, (level < root_level).then_some(level))
        }
    };
    let row = |axis: usize| BitRow {
        name: AXIS_NAMES[axis].to_owned(),
        axis: Some(axis),
        bits: i64::from(code[axis]),
        known_from,
        note: if of.is_some() {
            let coordinate = shown_number(domain.plane(axis, code[axis]));
            format!("{} ({} = {coordinate})", code[axis], AXIS_NAMES[axis])
        } else {
            String::new()
        },
        ..BitRow::default()
    };
    let rows = (0..D).map(row).collect();
    BitTable { width: root_level + 1, framed, rows, ..BitTable::default() }
}

/// Codes of the place that is looked for, as the rules of the query take them, else of
/// the current node, after `event`.
pub fn code_table<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
    variants: Variants,
) -> CodeTable {
    let of = CodesOf::of(tree, moment);
    let mut table = bits_of(tree, moment);
    in_line(std::iter::once(&mut table), columns(texts, tree, moment));
    let code = of.as_ref().map_or([0; D], |of| of.code(tree));
    let child = table.framed.filter(|_| event.is_some_and(reaches_child)).map(|bit| {
        let child = branch(code, bit + 1);
        let bits = (0..D)
            .map(|e| format!("{}\u{a0}=\u{a0}{}", AXIS_NAMES[e], u8::from(child.is_upper(e))));
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
    let morton = if of.is_some() {
        texts.format("codes-morton", &[("code", morton(code).to_string().into())])
    } else {
        texts.get("codes-none")
    };
    let of = of.map_or_else(String::new, |of| of.note(texts, tree));
    CodeTable { of, table, child, morton }
}

/// Whether an event goes from a node to one of its children.
fn reaches_child<const D: usize>(event: &Event<D>) -> bool {
    match event {
        Event::Visit { .. }
        | Event::Enter { .. }
        | Event::Follow { .. }
        | Event::Compare { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. } => true,
        Event::Clip { .. }
        | Event::Test { .. }
        | Event::Sort { .. }
        | Event::Skip { .. }
        | Event::Halve { .. }
        | Event::First { .. }
        | Event::Step { .. }
        | Event::Up { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Pop { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Rope { .. }
        | Event::Push { .. }
        | Event::Begin { .. }
        | Event::Encode { .. }
        | Event::Exits { .. }
        | Event::Target { .. }
        | Event::Border { .. }
        | Event::Difference { .. }
        | Event::Leave { .. }
        | Event::Resume { .. }
        | Event::Climb { .. }
        | Event::Corners { .. }
        | Event::Leaf { .. }
        | Event::Touch { .. }
        | Event::Found { .. }
        | Event::End(_) => false,
    }
}

/// How the bits of a level number the children.
pub fn child_rule<const D: usize>(texts: &Texts) -> String {
    let rule = if D == 2 { "2x + y" } else { "4x + 2y + z" };
    texts.format("codes-child-rule", &[("rule", rule.into())])
}

/// The codes with what is read off them, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    let variants = subject.query().variants_at_work();
    let CodeTable { of, table, child, morton } =
        code_table(subject.texts, subject.tree, subject.moment, subject.event(), variants);
    let mut sheet = Sheet::default();
    let mut head = child_rule::<D>(subject.texts);
    if !of.is_empty() {
        head = format!("{of}; {head}");
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

#[cfg(test)]
mod tests {
    use super::super::{figure_texts, neighbour_tables, region_table};
    use super::*;

    use octoscope_core::query::{Arithmetic, Query};
    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::text::Language;
    use octoscope_core::trace::record;
    use octoscope_core::traverse::{Algorithm, Options};

    /// Shows `check` the texts, the tree and every moment of a query on the 82 points with
    /// the event before it.
    fn for_every_step(
        query: &Query<2>,
        mut check: impl FnMut(&Texts, &Tree<2>, &Moment<2>, &Event<2>),
    ) {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let texts = Texts::new(Language::English, &[figure_texts(Language::English)]);
        let trace = record(&tree, &scenario.ray, query);
        let mut moment = Moment::default();
        for event in &trace.events {
            moment.apply(&tree, event);
            check(&texts, &tree, &moment, event);
        }
    }

    fn along(algorithm: Algorithm) -> Query<2> {
        let options = Options::default();
        Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles }
    }

    #[test]
    fn on_the_grid_the_codes_are_those_of_the_cell_that_the_step_goes_to() {
        let mut n_crossed = 0;
        for_every_step(&along(Algorithm::Dda), |texts, tree, moment, event| {
            let Event::Cross { cell, outside, .. } = event else { return };
            let codes = code_table(texts, tree, moment, Some(event), Variants::NONE);
            if outside.is_empty() {
                assert_eq!(codes.of, format!("cell {}, {}", cell[0], cell[1]));
                assert_eq!([0, 1].map(|e| codes.table.rows[e].bits), *cell);
                n_crossed += 1;
            }
        });
        assert!(n_crossed > 10);
    }

    #[test]
    fn codes_that_a_step_gives_are_shown_in_that_step() {
        for algorithm in [Algorithm::Esvo, Algorithm::Codes, Algorithm::Glassner] {
            let mut n_beyond = 0;
            for_every_step(&along(algorithm), |texts, tree, moment, event| {
                let told = match *event {
                    Event::Target { to, .. } => tree.domain().code_inside(to),
                    Event::Enter { node, .. } => Some(tree.code(node)),
                    Event::Follow { code, .. } => Some(code),
                    _ => None,
                };
                let Some(told) = told else { return };
                let codes = code_table(texts, tree, moment, Some(event), Variants::NONE);
                let shown = [0, 1].map(|e| codes.table.rows[e].bits);
                assert_eq!(shown, told.map(i64::from), "{algorithm:?} {event:?}");
                n_beyond += usize::from(matches!(event, Event::Target { .. }));
            });
            assert!(n_beyond > 10 || algorithm == Algorithm::Glassner);
        }
    }

    #[test]
    fn where_a_leaf_is_left_its_own_codes_are_shown() {
        use Algorithm::{Codes, Glassner, Samet, SametCorner, SametNet};
        for algorithm in [Codes, Glassner, Samet, SametCorner, SametNet] {
            let mut n_left = 0;
            for_every_step(&along(algorithm), |texts, tree, moment, event| {
                let (Event::Exits { .. }, Some(leaf)) = (event, moment.current) else { return };
                let codes = code_table(texts, tree, moment, Some(event), Variants::NONE);
                let shown = [0, 1].map(|e| codes.table.rows[e].bits);
                assert_eq!(shown, tree.code(leaf).map(i64::from), "{algorithm:?}");
                assert!(codes.of.starts_with("level"), "{algorithm:?}: {}", codes.of);
                n_left += 1;
            });
            assert!(n_left > 10, "{algorithm:?}");
        }
    }

    #[test]
    fn a_child_is_told_only_where_a_step_reaches_one() {
        let mut n_told = 0;
        for_every_step(&along(Algorithm::ParametricTable), |texts, tree, moment, event| {
            let child = code_table(texts, tree, moment, Some(event), Variants::NONE).child;
            let is_visit = matches!(event, Event::Visit { state: Some(_), .. });
            assert_eq!(child.is_some(), is_visit, "{event:?}");
            // An equation is not broken over lines.
            assert!(child.is_none_or(|child| !child.contains(" = ")));
            n_told += usize::from(is_visit);
        });
        assert!(n_told > 10);
    }

    #[test]
    fn tables_of_bits_that_stand_one_below_the_other_share_their_columns() {
        let variants = Variants::NONE;
        let region = Query::Region { min: [0.3, 0.35], max: [0.41, 0.44], variants };
        for query in [along(Algorithm::Codes), region] {
            let mut n_tables = 0;
            for_every_step(&query, |texts, tree, moment, event| {
                let codes = code_table(texts, tree, moment, Some(event), variants).table;
                let room = codes.room;
                let computed = neighbour_tables(texts, tree, moment);
                let computed = computed.into_iter().flat_map(|computed| computed.tables);
                let region = region_table(texts, tree, moment).map(|(table, _)| table);
                for table in computed.chain(region) {
                    assert_eq!(table.room, room, "{event:?}");
                    let needed = table.needed();
                    assert!(needed.names <= room.names && needed.notes <= room.notes);
                    n_tables += 1;
                }
            });
            assert!(n_tables > 0);
        }
    }

    #[test]
    fn the_bit_of_a_step_is_lit_in_the_codes_of_the_lower_corner() {
        let variants = Variants::NONE;
        let region = Query::Region { min: [0.3, 0.35], max: [0.41, 0.44], variants };
        let mut n_followed = 0;
        for_every_step(&region, |texts, tree, moment, event| {
            let Event::Follow { level, .. } = *event else { return };
            let (table, _) = region_table(texts, tree, moment).unwrap();
            let lit = table.rows.iter().filter(|row| row.marked != 0);
            let lit: Vec<_> = lit.map(|row| (row.name.as_str(), row.marked)).collect();
            assert_eq!(lit, ["c_x0", "c_y0"].map(|name| (name, 1 << (level - 1))));
            n_followed += 1;
        });
        assert!(n_followed > 0);
    }
}
