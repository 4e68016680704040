//! What the lab shows of results.

use super::{Choice, Tab};
use crate::bench::{Column, GROUPS};
use octoscope_core::measure::{Results, Site, Watched};
use octoscope_core::text::Texts;
use octoscope_figure::views::lab::{
    Above, Growth, Titled, growth_and_numbers, growth_chart, growth_least_height, numbers_chart,
    processor_chart, published_chart, scene_name, scenes_chart, way_name,
};
use octoscope_figure::views::{Entry, Table, Tone};
use octoscope_figure::{Anchor, Figure};

/// Size of charts in files.
pub const SIZE_OF_FILES: [f64; 2] = [860.0, 520.0];

/// The chart that is chosen, as wide as this and, where it can choose, as high.
pub fn figure(
    choice: &Choice,
    results: &Results,
    watched: &[Watched],
    texts: &Texts,
    [width, height]: [f64; 2],
) -> Figure {
    match choice.tab {
        Tab::Scenes => scenes_chart(results, choice.cost(), choice.depth_in(results), texts, width),
        Tab::Growth => growth_chart(results, growth(choice, results), texts, [width, height]),
        Tab::Published => published_chart(results, texts, width),
        Tab::Table => numbers(choice, results, texts, width),
        Tab::Processor => processor_chart(watched, texts, width),
    }
}

/// The chart that is chosen for a room of this size, and how many times as large as in
/// a file it is there: as large as the room lets it be whole, with its numbers beside it.
pub fn figure_in(
    choice: &Choice,
    results: &Results,
    watched: &[Watched],
    texts: &Texts,
    room: [f64; 2],
) -> (Figure, f64) {
    let small = |scale: f64| room.map(|extent| extent / scale);
    let fits = |figure: &Figure, scale: f64| {
        let [width, height] = small(scale);
        // A chart of growth takes the height that there is, whether its names have room or not.
        let least = if choice.tab == Tab::Growth { growth_least_height(results) } else { 0.0 };
        figure.page.width <= width && figure.page.height.max(least) <= height
    };
    if choice.tab == Tab::Growth {
        let of = growth(choice, results);
        let both =
            |scale: f64| Some((growth_and_numbers(results, of, texts, small(scale))?, scale));
        if let Some(found) = SCALES.into_iter().find_map(both) {
            return found;
        }
    }
    let scaled = |scale: f64| (figure(choice, results, watched, texts, small(scale)), scale);
    let mut larger = SCALES.into_iter().map(scaled);
    larger.find(|(figure, scale)| fits(figure, *scale)).unwrap_or_else(|| scaled(1.0))
}

/// How much larger than in a file a chart may be in the window, the largest first.
const SCALES: [f64; 4] = [1.3, 1.2, 1.1, 1.0];

fn growth<'a>(choice: &Choice, results: &'a Results) -> Growth<'a> {
    let (size, cost) = (choice.size(), choice.cost());
    Growth { scene: choice.scene_in(results), size, cost }
}

/// All numbers of the scene at the depth that are chosen.
fn numbers(choice: &Choice, results: &Results, texts: &Texts, width: f64) -> Figure {
    let (scene, depth) = (choice.scene_in(results), choice.depth_in(results));
    let site = results.sites.iter().find(|site| site.scene == scene && site.depth == depth);
    let Some(site) = site else {
        let none = [("scene", scene_name(scene, texts).into()), ("depth", depth.into())];
        let none = match results.sites.is_empty() {
            true => texts.get("lab-nothing"),
            false => texts.format("lab-no-site", &none),
        };
        return numbers_chart(Above { heading: &none, note: "" }, &[], width);
    };
    let arguments = [
        ("scene", scene_name(&site.scene, texts).into()),
        ("depth", site.depth.into()),
        ("leaves", site.n_leaves.into()),
        ("rays", site.n_rays.into()),
    ];
    let heading = texts.format("lab-site", &arguments);
    let tables = GROUPS.map(|(title, columns)| Titled {
        title: texts.get(title),
        table: table(site, columns, texts),
    });
    let above = Above { heading: &heading, note: &texts.get("lab-table-note") };
    numbers_chart(above, &tables, width)
}

fn table(site: &Site, columns: &[Column], texts: &Texts) -> Table {
    let mut anchors = vec![Anchor::Start];
    anchors.resize(1 + columns.len(), Anchor::End);
    let keys = std::iter::once("lab-algorithm").chain(columns.iter().map(|column| column.key));
    let rows = site.rows.iter().map(|row| {
        let cells = columns.iter().map(|column| match (column.of)(site, row) {
            Some(number) => Entry::new(number, Tone::Plain),
            None => Entry::new("–", Tone::Quiet),
        });
        let name = Entry::new(way_name(row.way, texts), Tone::Plain);
        std::iter::once(name).chain(cells).collect()
    });
    Table {
        columns: anchors,
        head: keys.map(|key| texts.get(key).into()).collect(),
        rows: rows.collect(),
    }
}
