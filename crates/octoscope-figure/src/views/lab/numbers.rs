//! Numbers that were measured, as tables.

use super::growth::{Growth, growth_chart};
use super::names::{in_unit, short, way_name};
use crate::views::sheet::Sheet;
use crate::views::table::{Entry, Setting, Table, Tone};
use crate::{Anchor, Figure, Role};
use octoscope_core::measure::{Results, Site, Way};
use octoscope_core::text::Texts;

/// Room between tables, and height of their titles.
const GAP: f64 = 28.0;
const TITLE: f64 = 22.0;

const SETTING: Setting = Setting { role: Role::Words, row: 19.0, gap: 18.0, least: 8.0 };

/// What stands above tables.
#[derive(Clone, Copy, Debug)]
pub struct Above<'a> {
    /// What they are of.
    pub heading: &'a str,
    /// What is to be known about them.
    pub note: &'a str,
}

/// A table with its title.
#[derive(Clone, Debug)]
pub struct Titled {
    /// The title.
    pub title: String,
    /// The table.
    pub table: Table,
}

/// Tables with their titles, beside each other where a figure of this width has room,
/// below what stands above them.
pub fn numbers_chart(above: Above, tables: &[Titled], width: f64) -> Figure {
    let mut sheet = Sheet::default();
    let mut top = sheet.paragraph(Role::Heading, [0.0, 0.0], width, &above.heading.into()) + 2.0;
    top += sheet.paragraph(Role::Note, [0.0, top], width, &above.note.into()) + 12.0;
    let ([mut left, mut bottom], mut right) = ([0.0, top], 0.0f64);
    for Titled { title, table } in tables {
        let [wide, high] = table.size(SETTING);
        if left > 0.0 && left + wide > width {
            (left, top) = (0.0, bottom + GAP);
        }
        sheet.text(Role::Heading, [left, top + 8.0], Anchor::Start, title.as_str());
        table.draw(&mut sheet, [left, top + TITLE], SETTING);
        bottom = bottom.max(top + TITLE + high);
        right = right.max(left + wide);
        left += wide + GAP;
    }
    sheet.figure([width.max(right), bottom])
}

/// A row for each algorithm and a column for each depth that was measured of a scene.
fn by_depth(results: &Results, of: Growth, texts: &Texts) -> Table {
    let sites: Vec<&Site> = results.sites.iter().filter(|site| site.scene == of.scene).collect();
    let depth = |site: &&Site| texts.format("lab-depth-n", &[("depth", site.depth.into())]);
    let unit = texts.get(&format!("lab-unit-{}", of.cost.id()));
    let cell = |site: &&Site, way: Way| {
        let row = site.rows.iter().find(|row| row.way == way);
        let value = row.map(|row| in_unit(of.cost, of.cost.of(site, row)));
        match value.filter(|x| x.is_finite()) {
            Some(value) => Entry::new(short(value), Tone::Plain),
            None => Entry::new("–", Tone::Quiet),
        }
    };
    let row = |way: Way| {
        let name = Entry::new(way_name(way, texts), Tone::Plain);
        std::iter::once(name).chain(sites.iter().map(|site| cell(site, way))).collect()
    };
    let mut columns = vec![Anchor::Start];
    columns.resize(1 + sites.len(), Anchor::End);
    let head = std::iter::once(unit).chain(sites.iter().map(depth)).map(Into::into).collect();
    Table { columns, head, rows: results.ways().into_iter().map(row).collect() }
}

/// How costs grow, as a chart and in numbers at its right; `None` where a figure of this
/// size has no room for both, or there are no numbers.
pub fn growth_and_numbers(
    results: &Results,
    of: Growth,
    texts: &Texts,
    [width, height]: [f64; 2],
) -> Option<Figure> {
    /// Least width of a chart beside a table.
    const LEAST: f64 = 560.0;
    let table = by_depth(results, of, texts);
    let [wide, high] = table.size(SETTING);
    let left = width - wide - GAP;
    let has_room = left >= LEAST && high <= height;
    if !has_room || results.depths().len() < 2 {
        return None;
    }
    let chart = growth_chart(results, of, texts, [left, height]);
    let mut sheet = Sheet::default();
    sheet.place(chart.drawn, [0.0, 0.0]);
    table.draw(&mut sheet, [left + GAP, 0.0], SETTING);
    Some(sheet.figure([width, height]))
}
