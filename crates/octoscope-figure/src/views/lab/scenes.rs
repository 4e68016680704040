//! Bars of all algorithms in every scene, in the manner of figures 8 to 10 of the paper.

use super::names::{in_unit, measured_once, ratio as in_units, scene_name, short, way_name};
use crate::views::sheet::Sheet;
use crate::{Anchor, Figure, Form, Part, Role, metrics};
use octoscope_core::explain::RichText;
use octoscope_core::measure::{Quantity, Results, Site};
use octoscope_core::text::Texts;

const ROW: f64 = 17.0;
const BAR: f64 = 10.0;
const HEAD: f64 = 24.0;
const GAP: f64 = 28.0;
/// Narrowest room for the bars of a scene.
const LEAST: f64 = 250.0;
/// Where bars begin, as a multiple of the best, on a logarithmic scale; the least that it
/// goes to; and the values that are marked on it.
const FROM: f64 = 0.7;
const LEAST_END: f64 = 2.0;
const MARKED: [f64; 9] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1e3, 1e4];

/// A bar an algorithm for every scene at `depth`, in units of the best; as a figure of
/// this width.
pub fn scenes_chart(
    results: &Results,
    quantity: Quantity,
    depth: u8,
    texts: &Texts,
    width: f64,
) -> Figure {
    let mut sheet = Sheet::default();
    let sites: Vec<&Site> = results.sites.iter().filter(|site| site.depth == depth).collect();
    if sites.is_empty() {
        let nothing = texts.get("lab-nothing");
        let bottom = sheet.paragraph(Role::Words, [0.0, 0.0], width, &nothing.into());
        return sheet.figure([width, bottom]);
    }
    let title = texts.get(&format!("lab-quantity-{}", quantity.id()));
    sheet.text(Role::Heading, [0.0, 9.0], Anchor::Start, title);
    let unit = texts.get(&format!("lab-unit-{}", quantity.id()));
    let arguments = [("depth", depth.into()), ("unit", unit.into())];
    let once = measured_once(results, quantity, texts);
    let note = texts.format("lab-scenes-note", &arguments) + &once;
    let top = 22.0 + sheet.paragraph(Role::Note, [0.0, 22.0], width, &note.into()) + 10.0;

    let n_columns = (((width + GAP) / (LEAST + GAP)) as usize).clamp(1, sites.len());
    let wide = (width + GAP) / n_columns as f64 - GAP;
    let mut y = top;
    for row in sites.chunks(n_columns) {
        let mut height = 0.0f64;
        for (column, site) in row.iter().enumerate() {
            let x = column as f64 * (wide + GAP);
            height = height.max(panel(&mut sheet, site, quantity, texts, [x, y], wide));
        }
        y += height + 16.0;
    }
    sheet.figure([width, y - 16.0])
}

/// Draws the bars of one scene; returns their height.
fn panel(
    sheet: &mut Sheet,
    site: &Site,
    quantity: Quantity,
    texts: &Texts,
    [x, y]: [f64; 2],
    width: f64,
) -> f64 {
    let names: Vec<RichText> =
        site.rows.iter().map(|row| way_name(row.way, texts).into()).collect();
    let names_wide = names.iter().map(|name| metrics::width(Role::Note, name)).fold(0.0, f64::max);
    let Some(best) = site.least(quantity) else {
        sheet.text(Role::Words, [x, y + 10.0], Anchor::Start, texts.get("lab-uncounted"));
        return 20.0;
    };
    let value = short(in_unit(quantity, best));
    let note = texts.format("lab-best", &[("value", value.into())]);
    let note_wide = metrics::width(Role::Note, &note.as_str().into());
    sheet.text(Role::Note, [x + width, y + 8.0], Anchor::End, note);
    let name = scene_name(&site.scene, texts);
    let lines = metrics::wrapped(Role::Words, &name.into(), width - note_wide - 8.0);
    for (n, line) in lines.into_iter().take(1).enumerate() {
        sheet.text(Role::Words, [x, y + 8.0 + 15.0 * n as f64], Anchor::Start, line);
    }

    let left = x + names_wide + 8.0;
    let numbers_wide = metrics::width(Role::Note, &"00.00".into()) + 8.0;
    let room = x + width - left - numbers_wide;
    let ratios: Vec<f64> = site.rows.iter().map(|row| quantity.of(site, row) / best).collect();
    let longest = ratios.iter().copied().filter(|r| r.is_finite()).fold(LEAST_END, f64::max);
    // What costs nothing has no bar.
    let length = |ratio: f64| (ratio.max(FROM) / FROM).ln() / (longest / FROM).ln() * room;
    let bottom = y + HEAD + ROW * site.rows.len() as f64;
    let told = |ratio: f64| -> RichText { in_units(Some(ratio)).into() };
    let ends: Vec<f64> = ratios
        .iter()
        .map(|&ratio| left + length(ratio) + 8.0 + metrics::width(Role::Note, &told(ratio)))
        .collect();
    let mut free_from = f64::NEG_INFINITY;
    for marked in MARKED.into_iter().filter(|&marked| marked <= longest) {
        let (x, number) = (left + length(marked), short(marked));
        let half = 0.5 * metrics::width(Role::Scale, &number.as_str().into());
        if x - half < free_from {
            continue;
        }
        free_from = x + half + 6.0;
        // Not through a bar or its value.
        for (n, _) in ends.iter().enumerate().filter(|(_, end)| **end < x) {
            let top = y + HEAD + ROW * n as f64;
            sheet.line(Role::Scale, [[x, top], [x, top + ROW]]);
        }
        sheet.line(Role::Scale, [[x, bottom], [x, bottom + 3.0]]);
        sheet.text(Role::Scale, [x, bottom + 10.0], Anchor::Middle, number);
    }
    for (n, (name, ratio)) in names.into_iter().zip(ratios).enumerate() {
        let middle = y + HEAD + ROW * (n as f64 + 0.5);
        sheet.text(Role::Note, [left - 8.0, middle], Anchor::End, name);
        if !ratio.is_finite() {
            sheet.text(Role::Note, [left + 6.0, middle], Anchor::Start, "–");
            continue;
        }
        let [above, below] = [middle - 0.5 * BAR, middle + 0.5 * BAR];
        let end = left + length(ratio);
        let points = vec![[left, above], [end, above], [end, below], [left, below]];
        let role = if ratio == 1.0 { Role::Spent } else { Role::Compared };
        sheet.push(role, Part::Whole, Form::Polygon(points));
        sheet.text(Role::Note, [end + 5.0, middle], Anchor::Start, told(ratio));
    }
    sheet.line(Role::Rule, [[left, y + HEAD - 2.0], [left, bottom + 2.0]]);
    bottom + 16.0 - y
}
