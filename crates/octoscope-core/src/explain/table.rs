//! Traces as tables for texts: Markdown and LaTeX.

use super::write::{Step, steps};
use super::{RichText, approx, latex, sentence::sentences, step_texts};
use crate::geometry::Ray;
use crate::text::Language;
use crate::trace::Trace;
use crate::tree::Tree;

/// Keys of the headings of the columns.
const HEADINGS: [&str; 5] =
    ["heading-step", "heading-event", "heading-node", "heading-t", "heading-what"];

/// The steps of `trace` as a Markdown table: number, event, node as level and
/// codes, interval of t, sentence.
pub fn trace_markdown<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    language: Language,
) -> String {
    let headings = HEADINGS.map(|key| step_texts(language).get(key));
    let mut out = format!("| {} |\n|---:|---|---|---|---|\n", headings.join(" | "));
    for row in rows(tree, ray, trace, language) {
        let Row { number, event, node, interval, sentence } = row;
        let sentence = markdown(&sentence);
        out += &format!("| {number} | {event} | {node} | {interval} | {sentence} |\n");
    }
    out
}

/// The same for LaTeX, as a table that goes on from page to page.
pub fn trace_latex<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    language: Language,
) -> String {
    let headings = HEADINGS.map(|key| escaped(&step_texts(language).get(key)));
    let mut out = format!(
        "% Needs \\usepackage{{longtable}}.\n\\begin{{longtable}}{{rlllp{{0.5\\linewidth}}}}\n\
         {} \\\\\n\\hline\n\\endhead\n",
        headings.join(" & ")
    );
    for row in rows(tree, ray, trace, language) {
        let Row { number, event, node, interval, sentence } = row;
        let [event, node, interval] = [event, node, interval].map(|text| escaped(&text));
        let sentence = latex(&sentence, None);
        out += &format!("{number} & {event} & {node} & {interval} & {sentence} \\\\\n");
    }
    out + "\\end{longtable}\n"
}

struct Row {
    number: usize,
    event: String,
    node: String,
    interval: String,
    sentence: RichText,
}

/// A row a step, the first of which says what is asked.
fn rows<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    language: Language,
) -> Vec<Row> {
    let begin = Step::default();
    let steps = std::iter::once(begin).chain(steps(tree, trace));
    let sentences = sentences(tree, ray, trace, language);
    let row = |(number, (step, sentence)): (usize, (Step, RichText))| Row {
        number,
        event: step.event.to_owned(),
        node: step.node.map_or(String::new(), |node| place(&node)),
        interval: step.interval.map_or(String::new(), |t| t.map(approx).join(" … ")),
        sentence,
    };
    steps.zip(sentences).enumerate().map(row).collect()
}

/// Level and codes: 2: 0, 4.
fn place(node: &[u32]) -> String {
    let codes: Vec<String> = node[1..].iter().map(u32::to_string).collect();
    format!("{}: {}", node[0], codes.join(", "))
}

fn escaped(text: &str) -> String {
    let span = super::Span { text: text.to_owned(), ..super::Span::default() };
    latex(&RichText(vec![span]), None)
}

/// Text for a cell of Markdown, with its subscripts and emphasis.
fn markdown(text: &RichText) -> String {
    let mut out = String::new();
    for span in &text.0 {
        let mut set = String::new();
        for c in span.text.chars() {
            match c {
                '|' | '*' | '_' | '\\' | '`' | '[' | ']' | '#' => set.extend(['\\', c]),
                '<' => set += "&lt;",
                '>' => set += "&gt;",
                '&' => set += "&amp;",
                c => set.push(c),
            }
        }
        if span.sub {
            set = format!("<sub>{set}</sub>");
        }
        out += &if span.strong { format!("**{set}**") } else { set };
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::query::Query;
    use crate::trace::record;
    use crate::tree::{Cell, Domain, Split, grow};

    /// Tables of a ray along x through one leaf.
    fn tables(language: Language) -> [String; 2] {
        let split = |_: Cell<2>, ()| Split::Full(Vec::new());
        let tree = grow(Domain::unit(0), (), &Progress::default(), split).unwrap();
        let ray = Ray::new([-0.1, 0.5], [1.0, 0.0]).unwrap();
        let trace = record(&tree, &ray, &Query::default());
        [trace_markdown(&tree, &ray, &trace, language), trace_latex(&tree, &ray, &trace, language)]
    }

    #[test]
    fn a_row_of_markdown_has_five_cells() {
        let [text, _] = tables(Language::English);
        assert_eq!(text.lines().next(), Some("| Step | Event | Node | t | What happens |"));
        assert_eq!(text.lines().count(), 2 + 5);
        assert_eq!(
            text.lines().nth(5),
            Some(
                "| 3 | leaf | 0: 0, 0 | 0.1 … 1.1 | Leaf (0, 0) of level 0 is on the ray from \
                 t = **0.1** to t = **1.1**, and it is occupied. |"
            )
        );
        for line in text.lines() {
            assert_eq!(line.replace("\\|", "").matches('|').count(), 6, "{line}");
        }
    }

    #[test]
    fn a_row_of_latex_is_safe() {
        let [_, text] = tables(Language::German);
        assert!(text.contains("Schritt & Ereignis & Knoten & t & Was geschieht \\\\"));
        let rows = text.lines().filter(|line| line.ends_with("\\\\"));
        for row in rows {
            assert_eq!(row.replace("\\&", "").matches('&').count(), 4, "{row}");
            assert_eq!(row.matches('$').count() % 2, 0, "{row}");
        }
        assert!(text.contains("0.1 \\dots{} 1.1"), "{text}");
    }
}
