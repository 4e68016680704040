//! A formula as a line of words, for readers that cannot see it.

use super::term::Formula;
use super::{Statement, formula_texts};
use crate::text::{Language, Texts};

/// All statements, one after the other: symbols, then numbers.
pub fn spoken(statements: &[Statement], language: Language) -> String {
    let texts = formula_texts(language);
    let lines = statements.iter().flat_map(|statement| {
        [Some(&statement.symbols), statement.numbers.as_ref()].into_iter().flatten()
    });
    let lines: Vec<String> = lines.map(|formula| words(formula, texts)).collect();
    lines.join("; ")
}

/// `formula` in words: "t xm equals x m minus p x, over d x".
pub fn spoken_formula(formula: &Formula, language: Language) -> String {
    words(formula, formula_texts(language))
}

fn words(formula: &Formula, texts: &Texts) -> String {
    let spoken = |part: &Formula| words(part, texts);
    match formula {
        Formula::Row(parts) => {
            let mut row = String::new();
            for part in parts {
                let part = spoken(part);
                let is_tight = row.is_empty() || part.starts_with(',') || part.is_empty();
                row.push_str(if is_tight { "" } else { " " });
                row.push_str(&part);
            }
            row
        }
        Formula::Symbol { name, .. } if name == "ℓ" => "l".to_owned(),
        Formula::Symbol { name, .. } => name.clone(),
        Formula::Number { shown, .. } => shown.clone(),
        Formula::Digits(text) | Formula::Words(text) => text.clone(),
        Formula::Sign(sign) => texts.get(sign.key()),
        Formula::Sub { body, below } => format!("{} {}", spoken(body), spoken(below)),
        Formula::Sup { body, above } => {
            let (body, above) = (spoken(body), spoken(above));
            if above == "′" {
                return texts.format("spoken-prime", &[("body", body.into())]);
            }
            texts.format("spoken-power", &[("body", body.into()), ("above", above.into())])
        }
        Formula::Fraction { over, under } => {
            let arguments = [("over", grouped(over, texts)), ("under", grouped(under, texts))];
            let values = arguments.map(|(name, text)| (name, text.into()));
            texts.format("spoken-fraction", &values)
        }
        Formula::Over { operator, limit } => {
            let values = [("operator", (*operator).into()), ("limit", spoken(limit).into())];
            texts.format("spoken-over", &values)
        }
        Formula::Fenced { fence, body } => {
            let key = format!("spoken-{}", fence.id());
            texts.format(&key, &[("body", spoken(body).into())])
        }
    }
}

/// In brackets, if it is more than one part.
fn grouped(formula: &Formula, texts: &Texts) -> String {
    let text = words(formula, texts);
    match formula {
        Formula::Row(parts) if parts.len() > 1 => format!("({text})"),
        Formula::Row(_)
        | Formula::Symbol { .. }
        | Formula::Number { .. }
        | Formula::Digits(_)
        | Formula::Words(_)
        | Formula::Sign(_)
        | Formula::Sub { .. }
        | Formula::Sup { .. }
        | Formula::Fraction { .. }
        | Formula::Over { .. }
        | Formula::Fenced { .. } => text,
    }
}
