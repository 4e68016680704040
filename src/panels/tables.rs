//! Tables of neighbours, and the way up and down by them.

mod way;

use crate::look::Look;
use crate::widgets::{ROW, Setting, beside_or_below, caption, segments, table, table_width};
use eframe::egui::{CollapsingHeader, Id, Response, RichText, Ui};
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText as Coloured, Span};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::locate::{Direction, adjacent, common_part, reflected};
use octoscope_core::tree::{Child, Tree};
use octoscope_figure::Anchor;
use octoscope_figure::views::{self, Entry, Tone};
use way::{Kind, NeighbourTable, Step, Used, Way};

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
            let key = match (used.tables(), way.is_over) {
                ([], true) => "tables-bits-before",
                ([], false) => "tables-used-bits",
                (_, true) => "tables-used-before",
                (_, false) => "tables-used",
            };
            let mut told = look.texts.format(key, &arguments);
            // Nobody in a hall can point at it.
            if key == "tables-used" && !look.is_for_hall() {
                told += &look.text("tables-point");
            }
            caption(ui, look, told);
            children(ui, look, used, way.is_over);
        }
        None => caption(ui, look, look.text("tables-none")),
    }
    if used.is_some() {
        ui.add_space(4.0);
        // A search below what is reached by the mirrored way goes down without a mirror.
        let is_mirrored = |step: &Step<D>| step.used.kind != Kind::Facing;
        let down =
            if way.down.iter().all(is_mirrored) { "tables-down" } else { "tables-down-facing" };
        let both = |ui: &mut Ui| {
            // Some go up by tables, and down again by codes.
            let lists = [("tables-up", &way.up), (down, &way.down)];
            for (key, steps) in lists.into_iter().filter(|(_, steps)| !steps.is_empty()) {
                ui.vertical(|ui| {
                    caption(ui, look, look.text(key));
                    list(ui, look, tree, steps, way.is_over);
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
    CollapsingHeader::new(title).id_salt("all-directions").show(ui, |ui| {
        all(ui, look, used.filter(|_| !way.is_over));
    });
}

/// The height that it takes in a lecture, in points.
pub const LECTURE_HEIGHT: f32 = 200.0;

/// Width of the column of a child, and of the captions before them.
const COLUMN: f32 = 22.0;
const CAPTIONS: f32 = 62.0;
/// Directions by their axes are told apart from this distance on.
const LEAST_GAP: f32 = 8.0;

/// How the tables are set: closer where there is no room.
fn setting<const D: usize>(ui: &Ui) -> Setting {
    let columns = Child::<D>::COUNT as f32;
    let gap = ((ui.available_width() - CAPTIONS) / columns - COLUMN).clamp(2.0, 10.0);
    Setting { gap, least: COLUMN, row: ROW }
}

/// A caption, then an entry for every child below its number.
fn columns<const D: usize>() -> Vec<Anchor> {
    let children = std::iter::repeat_n(Anchor::Middle, Child::<D>::COUNT);
    std::iter::once(Anchor::Start).chain(children).collect()
}

/// The three tables for one direction.
fn children<const D: usize>(ui: &mut Ui, look: &Look, used: Used<D>, is_over: bool) {
    // What no table told is not lit, and what is over stands back.
    let [strong, line, plain] = match (is_over, used.tables()) {
        (true, _) => [Tone::Quiet; 3],
        (false, []) => [Tone::Plain, Tone::Plain, Tone::Quiet],
        (false, _) => [Tone::Used, Tone::Line, Tone::Plain],
    };
    let row = |caption: String, entry: &dyn Fn(Child<D>) -> Entry| {
        let caption = Entry::words(caption, Tone::Quiet);
        std::iter::once(caption).chain(Child::<D>::all().map(entry)).collect()
    };
    let numbers: Vec<Entry> = row(look.text("tables-child"), &|child| {
        let tone = if child == used.child { line } else { plain };
        Entry::new(child.0.to_string(), tone)
    });
    let rows_of = |table: NeighbourTable, told: Told| {
        let in_use = used.tables().contains(&table);
        row(table.name().to_owned(), &|child| {
            let tone = match (in_use, child == used.child) {
                (true, true) => strong,
                (true, false) | (false, true) => line,
                (false, false) => plain,
            };
            entry(look, table, used.direction, child, told, tone)
        })
    };
    let (shown, setting) = fitting::<D>(ui, look, |told| views::Table {
        columns: columns::<D>(),
        head: Vec::new(),
        rows: std::iter::once(numbers.clone())
            .chain(NeighbourTable::ALL.map(|table| rows_of(table, told)))
            .collect(),
    });
    let mut responses = table(ui, look, &shown, setting).into_iter().skip(1);
    for table in NeighbourTable::ALL {
        explain(look, table, used.direction, responses.next().unwrap_or_default());
    }
}

/// Lets every entry of a row tell its rule where it is pointed at.
fn explain<const D: usize>(
    look: &Look,
    table: NeighbourTable,
    direction: [i8; D],
    responses: Vec<Response>,
) {
    for (child, response) in Child::<D>::all().zip(responses.into_iter().skip(1)) {
        let bits: Vec<_> = (0..D)
            .map(|e| format!("{} = {}", AXIS_NAMES[e], u8::from(child.is_upper(e))))
            .collect();
        let arguments = [
            ("child", child.0.into()),
            ("bits", bits.join(", ").into()),
            ("direction", named(direction).into()),
        ];
        response.on_hover_text(look.texts.format(table.why(), &arguments));
    }
}

/// What a table says of a child; a direction as `told` writes it.
fn entry<const D: usize>(
    look: &Look,
    table: NeighbourTable,
    direction: [i8; D],
    child: Child<D>,
    told: Told,
    tone: Tone,
) -> Entry {
    let common = common_part(direction, child);
    match table {
        NeighbourTable::Adjacent if adjacent(direction, child) => {
            Entry::words(look.text("tables-yes"), tone)
        }
        NeighbourTable::Adjacent => Entry::new("–", tone),
        NeighbourTable::Common if common == [0; D] => Entry::new("–", tone),
        NeighbourTable::Common => Entry::new(told.of(common), tone),
        NeighbourTable::Reflect => Entry::new(reflected(direction, child).0.to_string(), tone),
    }
}

/// The nodes of one way, each with the child that led there.
fn list<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    steps: &[Step<D>],
    is_over: bool,
) {
    for (n, Step { node, used }) in steps.iter().enumerate() {
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
        let is_now = n + 1 == steps.len() && !is_over;
        let color = if is_now { look.palette.ink } else { look.palette.quiet };
        let label = ui.label(text.color(color));
        label.on_hover_text(look.texts.format("node-note", &arguments));
    }
    if steps.is_empty() {
        caption(ui, look, "–");
    }
}

/// One of the tables for all directions: sides, then edges, then corners.
fn all<const D: usize>(ui: &mut Ui, look: &Look, used: Option<Used<D>>) {
    let id = Id::unique("chosen-table");
    let mut chosen = ui.data(|data| data.get_temp(id)).unwrap_or(NeighbourTable::Common);
    segments(ui, &mut chosen, &NeighbourTable::ALL.map(|table| (table, table.name().to_owned())));
    ui.data_mut(|data| data.insert_temp(id, chosen));
    let in_use = used.is_some_and(|used| used.tables().contains(&chosen));
    let row = |direction: [i8; D], told: Told| {
        let in_row = used.is_some_and(|used| used.direction == direction);
        let name = Entry::new(told.of(direction), if in_row { Tone::Line } else { Tone::Plain });
        let entries = Child::<D>::all().map(|child| {
            let tone = match (in_row, used.is_some_and(|used| used.child == child)) {
                (true, true) if in_use => Tone::Used,
                (true, _) | (_, true) => Tone::Line,
                (false, false) => Tone::Plain,
            };
            entry(look, chosen, direction, child, told, tone)
        });
        std::iter::once(name).chain(entries).collect()
    };
    // Sides, then edges, then corners.
    let n_axes = |d: &[i8; D]| d.iter().filter(|sign| **sign != 0).count();
    let mut directions: Vec<_> = Direction::<D>::all().map(Direction::components).collect();
    directions.sort_by_key(n_axes);
    let numbers = |told: Told| {
        let caption = match told {
            Told::ByAxes => Entry::words(look.text("tables-child"), Tone::Quiet),
            Told::ByPlace => Entry::new(letters::<D>(), Tone::Plain),
        };
        let numbers = Child::<D>::all().map(|child| {
            let in_column = used.is_some_and(|used| used.child == child);
            Entry::new(child.0.to_string(), if in_column { Tone::Line } else { Tone::Quiet })
        });
        std::iter::once(caption).chain(numbers).collect()
    };
    let (shown, setting) = fitting::<D>(ui, look, |told| views::Table {
        columns: columns::<D>(),
        head: Vec::new(),
        rows: std::iter::once(numbers(told))
            .chain(directions.iter().map(|direction| row(*direction, told)))
            .collect(),
    });
    let responses = table(ui, look, &shown, setting).into_iter().skip(1);
    for (direction, responses) in directions.into_iter().zip(responses) {
        explain(look, chosen, direction, responses);
    }
}

/// How directions are told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Told {
    /// By signs before the letters of their axes.
    ByAxes,
    /// By signs alone, each in the place of its axis.
    ByPlace,
}

impl Told {
    fn of<const D: usize>(self, direction: [i8; D]) -> Coloured {
        match self {
            Self::ByAxes => with_axes(direction),
            Self::ByPlace => signs(direction),
        }
    }
}

/// A table with directions told by their axes, as wide as there is room, and how it is set;
/// where it has no room at all, with directions by place.
fn fitting<const D: usize>(
    ui: &Ui,
    look: &Look,
    written: impl Fn(Told) -> views::Table,
) -> (views::Table, Setting) {
    let by_place = setting::<D>(ui);
    let wide = Setting { gap: by_place.gap.max(LEAST_GAP), ..by_place };
    let close = Setting { gap: LEAST_GAP, least: 16.0, row: ROW };
    let by_axes = written(Told::ByAxes);
    let fits =
        |setting: &Setting| table_width(ui, look, &by_axes, *setting) <= ui.available_width();
    match [wide, close].into_iter().find(fits) {
        Some(setting) => (by_axes, setting),
        None => (written(Told::ByPlace), by_place),
    }
}

/// The letters of the axes in their places.
fn letters<const D: usize>() -> Coloured {
    let letter = |axis: usize| {
        let text = AXIS_NAMES[axis].to_owned();
        Span { text, axis: Some(axis), ..Span::default() }
    };
    Coloured((0..D).map(letter).collect())
}

/// A direction by its signs, x first, each in the colour of its axis: +−, +· …
fn signs<const D: usize>(direction: [i8; D]) -> Coloured {
    let sign = |axis: usize| match direction[axis].signum() {
        1 => ("+".to_owned(), Some(axis)),
        -1 => ("−".to_owned(), Some(axis)),
        _ => ("·".to_owned(), None),
    };
    let spans = (0..D).map(sign);
    Coloured(spans.map(|(text, axis)| Span { text, axis, ..Span::default() }).collect())
}

/// The same by axes and signs: +z, +x−y.
fn with_axes<const D: usize>(direction: [i8; D]) -> Coloured {
    let mut told = signs(direction);
    told.0.retain(|span| span.axis.is_some());
    for span in &mut told.0 {
        span.text.extend(span.axis.map(|axis| AXIS_NAMES[axis]));
    }
    told
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
        assert_eq!(signs([1, 0, -1]).plain(), "+·−");
        assert_eq!(with_axes([0, 0, -1]).plain(), "−z");
        assert_eq!(with_axes([1, 1, -1]).plain(), "+x+y−z");
        assert_eq!(named([1, 0, -1]), "+x −z");
    }
}
