//! What an algorithm has cost, as bars.

use super::sheet::Sheet;
use super::subject::Subject;
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::{RichText, algorithm_name, counter_name, query_name};
use octoscope_core::query::Query;
use octoscope_core::trace::{Counter, Counters};

/// A bar a counter that the run uses: what is done is filled, the whole run is
/// outlined; as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    const ROW: f64 = 22.0;
    const BAR: f64 = 12.0;
    const HEAD: f64 = 26.0;
    let language = subject.language();
    let mut total = Counters::default();
    subject.trace.events.iter().for_each(|event| total.add(event));
    let bars: Vec<(RichText, [u64; 2])> = Counter::ALL
        .into_iter()
        .filter(|&counter| total.get(counter) > 0)
        .map(|counter| {
            let counts = [&subject.moment.counters, &total].map(|c| c.get(counter));
            (counter_name(counter, language).into(), counts)
        })
        .collect();
    let most = bars.iter().map(|(_, [_, total])| *total).max().unwrap_or(1).max(1);
    let number = |[so_far, total]: [u64; 2]| -> RichText {
        if so_far == total { total.to_string() } else { format!("{so_far} / {total}") }.into()
    };
    let names = bars.iter().map(|(name, _)| metrics::width(Role::Words, name)).fold(0.0, f64::max);
    let numbers =
        bars.iter().map(|(_, n)| metrics::width(Role::Note, &number(*n))).fold(0.0, f64::max);
    let left = names + 10.0;
    let room = (width - left - numbers - 8.0).max(40.0);

    let mut sheet = Sheet::default();
    let title = match subject.query() {
        Query::Ray { algorithm, .. } => algorithm_name(*algorithm, language),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            query_name(subject.query(), language)
        }
    };
    let title_width = sheet.text(Role::Heading, [0.0, 8.0], Anchor::Start, title);
    let mut head = HEAD;
    let is_done = subject.moment.step >= subject.trace.events.len();
    if !is_done {
        let texts = subject.texts;
        let arguments =
            [("step", subject.moment.step.into()), ("of", subject.trace.events.len().into())];
        let note = RichText::from(texts.format("chart-step", &arguments));
        // Below the title where there is no room beside it.
        if title_width + 16.0 + metrics::width(Role::Note, &note) <= width {
            sheet.text(Role::Note, [width, 8.0], Anchor::End, note);
        } else {
            sheet.text(Role::Note, [0.0, 26.0], Anchor::Start, note);
            head += 18.0;
        }
    }
    for (n, (name, counts)) in bars.iter().enumerate() {
        let y = head + ROW * (n as f64 + 0.5);
        sheet.text(Role::Words, [names, y], Anchor::End, name.clone());
        let [so_far, total] = counts.map(|count| count as f64 / most as f64 * room);
        if !is_done {
            sheet.rect(Role::Planned, [left, y - 0.5 * BAR], [total, BAR]);
        }
        if so_far > 0.0 {
            sheet.rect(Role::Spent, [left, y - 0.5 * BAR], [so_far, BAR]);
        }
        sheet.text(Role::Note, [left + total + 6.0, y], Anchor::Start, number(*counts));
    }
    let bottom = head + ROW * bars.len() as f64;
    sheet.line(Role::Rule, [[left, head], [left, bottom]]);
    sheet.figure([width, bottom])
}
