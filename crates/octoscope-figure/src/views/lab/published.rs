//! What was published, beside what was measured.

use super::names::{claim_names, ratio};
use crate::views::sheet::Sheet;
use crate::views::table::{Entry, Setting, Table, Tone};
use crate::{Anchor, Figure, Role};
use octoscope_core::measure::{Judged, Published, Results, Verdict, judged};
use octoscope_core::text::Texts;

/// Every published statement with what `results` say of it, and in words what agrees
/// and what not; as a figure of this width.
pub fn published_chart(results: &Results, texts: &Texts, width: f64) -> Figure {
    let all = judged(results);
    let heads = ["statement", "published", "here", "nodes", "comparisons", "holds"];
    let mut columns = vec![Anchor::End; heads.len()];
    (columns[0], columns[5]) = (Anchor::Start, Anchor::Start);
    let table = Table {
        columns,
        head: heads.map(|head| texts.get(&format!("lab-{head}")).into()).to_vec(),
        rows: all.iter().map(|one| row(one, texts)).collect(),
    };
    let setting = Setting { role: Role::Words, row: 21.0, gap: 18.0, ..Setting::default() };
    let mut sheet = Sheet::default();
    let mut y = 0.0;
    y += sheet.paragraph(Role::Heading, [0.0, y], width, &verdict(results, texts).into()) + 10.0;
    table.draw(&mut sheet, [0.0, y], setting);
    let [table_width, table_height] = table.size(setting);
    y += table_height + 8.0;
    let note = texts.get("lab-published-note");
    y += sheet.paragraph(Role::Note, [0.0, y], width, &note.into()) + 12.0;
    for one in all.iter().filter(|one| one.verdict != Verdict::NotMeasured) {
        let why = why(one, texts);
        y += sheet.paragraph(Role::Words, [0.0, y], width, &why.into()) + 5.0;
    }
    y += 7.0;
    y += sheet.paragraph(Role::Note, [0.0, y], width, &texts.get("lab-sources").into());
    sheet.figure([width.max(table_width), y])
}

fn row(one: &Judged, texts: &Texts) -> Vec<Entry> {
    let holds = texts.get(&format!("lab-holds-{}", id(one.verdict)));
    let tone = match one.verdict {
        Verdict::Agrees => Tone::Used,
        Verdict::SameSide => Tone::Line,
        Verdict::Differs => Tone::Plain,
        Verdict::NotMeasured => Tone::Quiet,
    };
    let plain = if tone == Tone::Quiet { Tone::Quiet } else { Tone::Plain };
    let [of, against, place] = claim_names(one.claim, texts);
    let name = format!("{of} / {against}{place}");
    let numbers = [published(one, texts), ratio(one.time)];
    let counts = [one.node_touches, one.comparisons].map(ratio);
    let mut row = vec![Entry::new(name, plain)];
    row.extend(numbers.into_iter().chain(counts).map(|number| Entry::new(number, plain)));
    row.push(Entry::new(holds, tone));
    row
}

/// In a sentence: how many of the statements hold.
pub fn verdict(results: &Results, texts: &Texts) -> String {
    if results.sites.is_empty() {
        return texts.get("lab-nothing");
    }
    let all = judged(results);
    let count = |verdict| all.iter().filter(|one| one.verdict == verdict).count();
    let measured = all.len() - count(Verdict::NotMeasured);
    if measured == 0 {
        return texts.get("lab-verdict-none");
    }
    let arguments = [
        ("measured", measured.into()),
        ("agrees", count(Verdict::Agrees).into()),
        ("side", count(Verdict::SameSide).into()),
        ("differs", count(Verdict::Differs).into()),
    ];
    texts.format("lab-verdict", &arguments)
}

/// In a sentence: what was measured of a statement, and what may be the reason.
fn why(one: &Judged, texts: &Texts) -> String {
    let [of, against, place] = claim_names(one.claim, texts);
    let arguments = [
        ("of", of.into()),
        ("against", against.into()),
        ("place", place.into()),
        ("here", ratio(one.time).into()),
        ("published", published(one, texts).into()),
        ("nodes", ratio(one.node_touches).into()),
        ("comparisons", ratio(one.comparisons).into()),
    ];
    texts.format(&format!("lab-why-{}", id(one.verdict)), &arguments)
}

fn published(one: &Judged, texts: &Texts) -> String {
    match one.claim.published {
        Published::Equal => texts.get("lab-about-one"),
        Published::Share(share) => ratio(Some(share)),
    }
}

fn id(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Agrees => "agrees",
        Verdict::SameSide => "same-side",
        Verdict::Differs => "differs",
        Verdict::NotMeasured => "not-measured",
    }
}
