//! What a ray has a processor fetch from memory and guess.

use super::names::way_name;
use crate::views::sheet::Sheet;
use crate::views::table::{Entry, Setting, Table, Tone};
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::RichText;
use octoscope_core::measure::{BranchKind, Watched};
use octoscope_core::text::Texts;

const ROW: f64 = 38.0;
const STRIP: f64 = 13.0;
const GAP: f64 = 22.0;

/// For every algorithm its reads and its decisions, one after the other: short what
/// went well, tall what did not; and by kind how many were predicted wrongly. A figure of
/// this width.
pub fn processor_chart(watched: &[Watched], texts: &Texts, width: f64) -> Figure {
    let mut sheet = Sheet::default();
    let note = texts.get("lab-processor-note");
    let top = sheet.paragraph(Role::Note, [0.0, 0.0], width, &note.into()) + 14.0;
    if watched.is_empty() {
        sheet.text(Role::Words, [0.0, top + 8.0], Anchor::Start, texts.get("lab-no-algorithm"));
        return sheet.figure([width, top + 18.0]);
    }
    let names: Vec<RichText> =
        watched.iter().map(|one| way_name(one.algorithm.into(), texts).into()).collect();
    let names_wide = names.iter().map(|name| metrics::width(Role::Words, name)).fold(0.0, f64::max);
    let left = names_wide + 14.0;
    let room = (width - left - GAP).max(80.0);
    let [memory, branches] = [0.36 * room, 0.64 * room];
    let second = left + memory + GAP;
    sheet.text(Role::Heading, [left, top], Anchor::Start, texts.get("lab-memory"));
    sheet.text(Role::Heading, [second, top], Anchor::Start, texts.get("lab-branches"));
    for (x, quiet, tall) in
        [(left, "lab-cached", "lab-uncached"), (second, "lab-predicted", "lab-mispredicted")]
    {
        key(&mut sheet, [x, top + 10.0], [quiet, tall].map(|key| texts.get(key)));
    }
    let head = top + 34.0;
    for (n, (one, name)) in watched.iter().zip(names).enumerate() {
        let y = head + ROW * n as f64;
        sheet.text(Role::Words, [0.0, y + 8.0], Anchor::Start, name);
        let cut = if one.is_cut { texts.get("lab-cut") } else { String::new() };
        let reads = [("n", one.reads.len().into()), ("lines", one.n_lines.into())];
        let reads = texts.format("lab-reads", &reads);
        let guesses = [("n", one.branches.len().into()), ("wrong", one.n_wrong().into())];
        let guesses = texts.format("lab-guesses", &guesses);
        for (x, text) in [(left, reads), (second, format!("{guesses} {cut}"))] {
            sheet.text(Role::Note, [x, y + 8.0], Anchor::Start, text.trim_end().to_owned());
        }
        let missed: Vec<bool> = one.reads.iter().map(|read| !read.is_cached).collect();
        strip(&mut sheet, &missed, [left, y + 19.0], memory);
        let missed: Vec<bool> = one.branches.iter().map(|branch| !branch.is_predicted).collect();
        strip(&mut sheet, &missed, [second, y + 19.0], branches);
    }
    let mut y = head + ROW * watched.len() as f64 + 12.0;
    sheet.text(Role::Heading, [0.0, y + 8.0], Anchor::Start, texts.get("lab-kinds"));
    y += 22.0;
    let table = kinds(watched, texts);
    let setting = Setting { role: Role::Words, row: 19.0, gap: 20.0, ..Setting::default() };
    table.draw(&mut sheet, [0.0, y], setting);
    let [table_width, table_height] = table.size(setting);
    sheet.figure([width.max(table_width), y + table_height])
}

/// What a short stroke says, and what a tall one.
fn key(sheet: &mut Sheet, [x, y]: [f64; 2], [short, tall]: [String; 2]) {
    const WIDE: f64 = 5.0;
    let base = y + STRIP;
    let mut x = x;
    for (role, height, text) in [(Role::Hit, 0.3 * STRIP, short), (Role::Miss, STRIP, tall)] {
        sheet.rect(role, [x, base - height], [WIDE, height]);
        let wide = sheet.text(Role::Note, [x + WIDE + 5.0, base - 5.0], Anchor::Start, text);
        x += WIDE + 5.0 + wide + 16.0;
    }
}

/// Draws a stroke for everything in order; where there is no room for each, a stroke for
/// several, as tall as the share of them that was missed.
fn strip(sheet: &mut Sheet, missed: &[bool], [x, y]: [f64; 2], width: f64) {
    const LEAST: f64 = 3.0;
    let n_strokes = missed.len().min((width / LEAST) as usize).max(1);
    let pitch = (width / n_strokes as f64).min(8.0);
    let base = y + STRIP;
    for n in 0..n_strokes {
        let part = &missed[n * missed.len() / n_strokes..(n + 1) * missed.len() / n_strokes];
        if part.is_empty() {
            continue;
        }
        let share = part.iter().filter(|&&missed| missed).count() as f64 / part.len() as f64;
        let left = x + pitch * n as f64;
        let mut bar = |role, height: f64| {
            sheet.rect(role, [left, base - height], [0.7 * pitch, height]);
        };
        if share > 0.0 {
            bar(Role::Miss, STRIP * (0.35 + 0.65 * share));
        } else {
            bar(Role::Hit, 0.3 * STRIP);
        }
    }
    sheet.line(Role::Scale, [[x, base + 1.0], [x + width, base + 1.0]]);
}

/// Of every kind of decision how many were predicted wrongly, of how many.
fn kinds(watched: &[Watched], texts: &Texts) -> Table {
    let mut columns = vec![Anchor::Start];
    columns.extend([Anchor::End; BranchKind::ALL.len()]);
    let mut head = vec![RichText::default()];
    head.extend(BranchKind::ALL.map(|kind| texts.get(&format!("lab-kind-{}", kind.id())).into()));
    let row = |one: &Watched| {
        let mut row = vec![Entry::new(way_name(one.algorithm.into(), texts), Tone::Plain)];
        row.extend(one.kinds.map(|[n, wrong]| match n {
            0 => Entry::new("–", Tone::Quiet),
            _ => Entry::new(format!("{wrong} / {n}"), Tone::Plain),
        }));
        row
    };
    Table { columns, head, rows: watched.iter().map(row).collect() }
}
