//! Tables of neighbours, and the way up and down by them.

use crate::look::Look;
use crate::widgets::{Lit, beside_or_below, caption, lit, segments};
use eframe::egui::{CollapsingHeader, Grid, Id, Response, RichText, Ui};
use octoscope_core::event::{Event, Lookup};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::locate::{Direction, adjacent, common_part, reflected};
use octoscope_core::tree::{Child, NodeId, Tree};

/// One of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Table {
    Adjacent,
    Common,
    Reflect,
}

impl Table {
    const ALL: [Self; 3] = [Self::Adjacent, Self::Common, Self::Reflect];

    /// Its name in the literature, which has no translation.
    fn name(self) -> &'static str {
        match self {
            Self::Adjacent => "ADJ",
            Self::Common => "COMMON",
            Self::Reflect => "REFLECT",
        }
    }

    /// Key of the rule that all its entries follow.
    fn why(self) -> &'static str {
        match self {
            Self::Adjacent => "tables-adjacent-why",
            Self::Common => "tables-common-why",
            Self::Reflect => "tables-reflect-why",
        }
    }
}

/// What a step has reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// A parent.
    Up,
    /// The mirrored child.
    Mirrored,
    /// A child on the side that faces where the way came from.
    Facing,
}

impl Kind {
    /// The tables that tell how it is reached.
    fn tables(self, lookup: Lookup) -> &'static [Table] {
        match (self, lookup) {
            (Self::Facing, Lookup::Tables | Lookup::Bits) => &[Table::Adjacent],
            (Self::Up | Self::Mirrored, Lookup::Bits) => &[Table::Common],
            (Self::Up, Lookup::Tables) => &[Table::Adjacent, Table::Common],
            (Self::Mirrored, Lookup::Tables) => &[Table::Reflect],
        }
    }
}

/// Which entries a step has used.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Used<const D: usize> {
    direction: [i8; D],
    child: Child<D>,
    kind: Kind,
    lookup: Lookup,
}

/// A step of the way: the node that was reached, and the entries used.
type Step<const D: usize> = (NodeId, Used<D>);

/// Steps of the last way to a neighbour.
struct Way<const D: usize> {
    up: Vec<Step<D>>,
    down: Vec<Step<D>>,
    /// Whether a leaf was reached since then: it is told, but quietly.
    is_over: bool,
}

impl<const D: usize> Way<D> {
    fn of(past: &[Event<D>]) -> Self {
        let starts = |event: &Event<D>| matches!(event, Event::Leaf { .. } | Event::Begin { .. });
        let goes_up = |event: &Event<D>| matches!(event, Event::Parent { .. });
        let Some(last) = past.iter().rposition(goes_up) else {
            return Self { up: Vec::new(), down: Vec::new(), is_over: false };
        };
        let start = past[..last].iter().rposition(starts).unwrap_or(0);
        let length = past[last..].iter().position(starts);
        let end = length.map_or(past.len(), |length| last + length);
        let mut way = Self { up: Vec::new(), down: Vec::new(), is_over: length.is_some() };
        for event in &past[start..end] {
            if let &Event::Facing { child, node } = event
                && let Some((_, used)) = way.up.first()
            {
                // It faces where the way came from.
                let direction = used.direction.map(|sign| -sign);
                let lookup = Lookup::Bits;
                let kind = Kind::Facing;
                way.down.push((node, Used { direction, child, kind, lookup }));
            }
            if let &Event::Parent { node, child, direction, lookup, .. } = event {
                way.up.push((node, Used { direction, child, kind: Kind::Up, lookup }));
            }
            if let &Event::Mirror { child, node, .. } = event {
                // The last parent's child is mirrored first.
                let parent = way.up.len().checked_sub(way.down.len() + 1);
                if let Some((_, used)) = parent.and_then(|index| way.up.get(index)) {
                    way.down.push((node, Used { child, kind: Kind::Mirrored, ..*used }));
                }
            }
        }
        way
    }

    fn last(&self) -> Option<Used<D>> {
        self.down.last().or(self.up.last()).map(|(_, used)| *used)
    }
}

/// The entries of all children in the present direction, the used one lit; the way
/// up and the mirrored way down; all directions on demand. `past` are the events
/// so far.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, past: &[Event<D>]) {
    let way = Way::of(past);
    let used = way.last();
    match used {
        Some(used) => {
            let direction = named(used.direction);
            let arguments = [("direction", direction.into()), ("child", used.child.0.into())];
            let key = match (way.is_over, used.kind, used.lookup) {
                (true, _, _) => "tables-used-before",
                (false, Kind::Up | Kind::Mirrored, Lookup::Bits) => "tables-used-bits",
                (false, Kind::Facing, _) | (false, _, Lookup::Tables) => "tables-used",
            };
            caption(ui, look, look.texts.format(key, &arguments));
            children(ui, look, used, way.is_over);
        }
        None => caption(ui, look, look.text("tables-none")),
    }
    if used.is_some() {
        ui.add_space(4.0);
        let both = |ui: &mut Ui| {
            for (key, steps) in [("tables-up", &way.up), ("tables-down", &way.down)] {
                ui.vertical(|ui| {
                    caption(ui, look, look.text(key));
                    list(ui, look, tree, steps);
                });
                ui.add_space(12.0);
            }
        };
        // Two short lists: they fit side by side where tables would not.
        if look.is_for_hall() {
            ui.horizontal_top(both);
        } else {
            beside_or_below(ui, both);
        }
    }
    // Too much for a hall.
    if look.is_for_hall() {
        return;
    }
    let title = RichText::new(look.text("tables-all")).size(13.0);
    CollapsingHeader::new(title).id_salt("all-directions").show(ui, |ui| all(ui, look, used));
}

/// Width of the column of a child, and of the captions before them.
const COLUMN: f32 = 22.0;
const CAPTIONS: f32 = 62.0;

/// Distance between columns: less where there is no room.
fn gap<const D: usize>(ui: &Ui) -> f32 {
    let columns = Child::<D>::COUNT as f32;
    ((ui.available_width() - CAPTIONS) / columns - COLUMN).clamp(2.0, 10.0)
}

/// The three tables for one direction.
fn children<const D: usize>(ui: &mut Ui, look: &Look, used: Used<D>, is_over: bool) {
    // What is over is lit no more than what is beside it.
    let [strong, line] = if is_over { [Lit::Line, Lit::No] } else { [Lit::Used, Lit::Line] };
    let grid = Grid::new("children").num_columns(1 + Child::<D>::COUNT);
    let spacing = [gap::<D>(ui), 0.0];
    grid.spacing(spacing).min_col_width(COLUMN).min_row_height(18.0).show(ui, |ui| {
        caption(ui, look, look.text("tables-child"));
        for child in Child::<D>::all() {
            let tone = if child == used.child { line } else { Lit::No };
            ui.label(lit(look, child.0.to_string(), tone));
        }
        ui.end_row();
        for table in Table::ALL {
            let in_use = used.kind.tables(used.lookup).contains(&table);
            caption(ui, look, table.name());
            for child in Child::<D>::all() {
                let tone = match (in_use, child == used.child) {
                    (true, true) => strong,
                    (true, false) | (false, true) => line,
                    (false, false) => Lit::No,
                };
                entry(ui, look, table, used.direction, child, tone);
            }
            ui.end_row();
        }
    });
}

/// An entry, which tells its rule where it is pointed at.
fn entry<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    table: Table,
    direction: [i8; D],
    child: Child<D>,
    tone: Lit,
) -> Response {
    let text = match table {
        Table::Adjacent if adjacent(direction, child) => look.text("tables-yes"),
        Table::Adjacent => "–".to_owned(),
        Table::Common if common_part(direction, child) == [0; D] => "–".to_owned(),
        Table::Common => signs(common_part(direction, child)),
        Table::Reflect => reflected(direction, child).0.to_string(),
    };
    let bits: Vec<_> =
        (0..D).map(|e| format!("{} = {}", AXIS_NAMES[e], u8::from(child.is_upper(e)))).collect();
    let arguments = [
        ("child", child.0.into()),
        ("bits", bits.join(", ").into()),
        ("direction", named(direction).into()),
    ];
    let why = look.texts.format(table.why(), &arguments);
    ui.label(lit(look, text, tone).size(look.type_size(12.0))).on_hover_text(why)
}

/// The nodes of one way, each with the child that led there.
fn list<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, steps: &[Step<D>]) {
    for (n, (node, used)) in steps.iter().enumerate() {
        let child = match used.kind {
            Kind::Mirrored => reflected(used.direction, used.child),
            Kind::Up | Kind::Facing => used.child,
        };
        let codes = tree.code(*node).map(|c| c.to_string()).join(", ");
        let arguments = [
            ("child", child.0.into()),
            ("level", tree.level(*node).into()),
            ("codes", codes.into()),
        ];
        let key = match used.kind {
            Kind::Up => "tables-step-up",
            Kind::Mirrored | Kind::Facing => "tables-step-down",
        };
        let text = RichText::new(look.texts.format(key, &arguments)).size(13.0);
        let color = if n + 1 == steps.len() { look.palette.ink } else { look.palette.quiet };
        let label = ui.label(text.color(color));
        label.on_hover_text(look.texts.format("node-note", &arguments));
    }
    if steps.is_empty() {
        ui.label(lit(look, "–", Lit::Quiet));
    }
}

/// One of the tables for all directions: sides, then edges, then corners.
fn all<const D: usize>(ui: &mut Ui, look: &Look, used: Option<Used<D>>) {
    let id = Id::unique("chosen-table");
    let mut table = ui.data(|data| data.get_temp(id)).unwrap_or(Table::Common);
    segments(ui, &mut table, &Table::ALL.map(|table| (table, table.name().to_owned())));
    ui.data_mut(|data| data.insert_temp(id, table));
    let grid = Grid::new("directions").num_columns(1 + Child::<D>::COUNT);
    let spacing = [gap::<D>(ui), 0.0];
    grid.spacing(spacing).min_col_width(COLUMN).min_row_height(17.0).show(ui, |ui| {
        caption(ui, look, AXIS_NAMES[..D].join(""));
        for child in Child::<D>::all() {
            let tone =
                if used.is_some_and(|used| used.child == child) { Lit::Line } else { Lit::Quiet };
            ui.label(lit(look, child.0.to_string(), tone));
        }
        ui.end_row();
        for n_axes in 1..=D {
            let is_kind = |d: &[i8; D]| d.iter().filter(|s| **s != 0).count() == n_axes;
            let kind = Direction::<D>::all().map(Direction::components).filter(is_kind);
            for direction in kind {
                let row = used.is_some_and(|used| used.direction == direction);
                ui.label(lit(look, signs(direction), if row { Lit::Line } else { Lit::Quiet }));
                for child in Child::<D>::all() {
                    let column = used.is_some_and(|used| used.child == child);
                    let tone = match (row, column) {
                        (true, true) => Lit::Used,
                        (true, false) | (false, true) => Lit::Line,
                        (false, false) => Lit::No,
                    };
                    entry(ui, look, table, direction, child, tone);
                }
                ui.end_row();
            }
        }
    });
}

/// A direction by its signs, x first: +−, +· …
fn signs<const D: usize>(direction: [i8; D]) -> String {
    direction
        .iter()
        .map(|s| {
            if *s > 0 {
                '+'
            } else if *s < 0 {
                '−'
            } else {
                '·'
            }
        })
        .collect()
}

/// A direction by axes and signs: +x −y.
fn named<const D: usize>(direction: [i8; D]) -> String {
    let axes = (0..D).filter(|&e| direction[e] != 0);
    let named =
        axes.map(|e| format!("{}{}", if direction[e] > 0 { '+' } else { '−' }, AXIS_NAMES[e]));
    named.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_told_by_their_signs() {
        assert_eq!(signs([1, 0, -1]), "+·−");
        assert_eq!(named([1, 0, -1]), "+x −z");
    }

    #[test]
    fn children_are_mirrored_in_the_opposite_order_of_their_parents() {
        let parent = |child: u8, direction: [i8; 2]| Event::<2>::Parent {
            node: NodeId::ROOT,
            child: Child(child),
            direction,
            common: [0; 2],
            lookup: Lookup::Tables,
        };
        let mirror = |child: u8| Event::<2>::Mirror {
            child: Child(child),
            mirrored: Child(0),
            node: NodeId::ROOT,
        };
        let way = Way::of(&[parent(3, [1, 1]), parent(2, [1, 0]), mirror(2), mirror(3)]);
        let told: Vec<_> =
            way.down.iter().map(|(_, used)| (used.child.0, used.direction)).collect();
        assert_eq!(told, [(2, [1, 0]), (3, [1, 1])]);
        assert_eq!(way.last().map(|used| used.kind), Some(Kind::Mirrored));
    }

    fn up(child: u8, direction: [i8; 2]) -> Event<2> {
        let (node, common, lookup) = (NodeId::ROOT, [0; 2], Lookup::Tables);
        Event::Parent { node, child: Child(child), direction, common, lookup }
    }

    #[test]
    fn a_child_that_faces_the_way_lies_on_the_lit_side() {
        let facing = Event::<2>::Facing { child: Child(0), node: NodeId::ROOT };
        let used = Way::of(&[up(1, [1, 0]), facing]).last().unwrap();
        assert_eq!((used.child, used.direction), (Child(0), [-1, 0]));
        assert_eq!(used.kind.tables(used.lookup), [Table::Adjacent]);
        assert!(adjacent(used.direction, used.child));
    }

    #[test]
    fn the_last_look_up_stays_in_sight_when_a_leaf_is_reached() {
        let leaf = Event::<2>::Leaf { node: NodeId::ROOT, enter: 0.0, exit: 1.0, full: false };
        let check = |past: &[Event<2>], used: Option<u8>, is_over: bool| {
            let way = Way::of(past);
            assert_eq!(way.last().map(|used| used.child.0), used);
            assert_eq!(way.is_over, is_over);
        };
        check(&[leaf], None, false);
        check(&[leaf, up(3, [1, 0])], Some(3), false);
        check(&[leaf, up(3, [1, 0]), leaf], Some(3), true);
        check(&[leaf, up(3, [1, 0]), leaf, up(1, [1, 0])], Some(1), false);
    }
}
