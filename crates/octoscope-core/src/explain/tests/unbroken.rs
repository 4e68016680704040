//! Where the lines of a sentence may end.

use super::*;

/// Whether a line that ends after `left` and goes on with `right` tears something apart.
fn is_torn(left: &str, right: &str) -> bool {
    let is_relation = |token: &str| matches!(token, "=" | "<" | ">" | "≤" | "≥" | "≠");
    let starts_as_number = |c: char| c.is_ascii_digit() || matches!(c, '−' | '∞' | '+');
    let is_word_end = |c: char| c.is_alphanumeric();
    let is_number = right.starts_with(starts_as_number) || right.starts_with("NaN");
    let is_unit = right.trim_end_matches(['.', ',', ';', ':']);
    let is_symbol = |token: &str| {
        let token = token.trim_end_matches(['.', ',', ';', ':']);
        token.chars().count() == 1 && token.chars().all(char::is_alphanumeric)
            || token.contains('_')
    };
    // After a relation, and before the sign of a value.
    is_relation(left)
        || right == "="
        // A word and its number.
        || is_number && left.ends_with(is_word_end)
        || matches!(is_unit, "°" | "%")
        || matches!(left, "+" | "−" | "xor" | "∧") || matches!(right, "xor" | "∧")
        || is_symbol(left) && !left.ends_with([',', ';', '.', ':']) && right.starts_with('(')
}

#[test]
fn no_line_of_a_sentence_ends_within_what_belongs_together() {
    let mut torn = BTreeMap::new();
    let mut n_lines = 0;
    let mut see = |text: &RichText| {
        let unbroken = text.unbroken().plain();
        let tokens: Vec<&str> = unbroken.split(' ').collect();
        for two in tokens.windows(2) {
            n_lines += 1;
            let [left, right] = two else { continue };
            let last = left.rsplit('\u{a0}').next().unwrap_or_default();
            let next = right.split('\u{a0}').next().unwrap_or_default();
            if is_torn(last, next) {
                torn.entry(format!("{last} | {next}")).or_insert_with(|| text.plain());
            }
        }
    };
    fn all<const D: usize>(see: &mut impl FnMut(&RichText)) {
        let rays = rays();
        let tree = tree(3);
        for (_, query) in queries() {
            let along_ray = matches!(query, Query::Ray { .. });
            for ray in rays.iter().take(if along_ray { 12 } else { 1 }) {
                let trace = record(&tree, ray, &query);
                for language in Language::ALL {
                    sentences::<D>(&tree, ray, &trace, language).for_each(|text| see(&text));
                }
            }
        }
    }
    all::<2>(&mut see);
    all::<3>(&mut see);
    assert!(n_lines > 10_000, "{n_lines}");
    assert!(torn.is_empty(), "{}\n{torn:#?}", torn.len());
}
