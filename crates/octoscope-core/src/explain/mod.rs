//! What happens, in words and formulas: a sentence a step, what it computes, the
//! listing, the variables, and what becomes of every node.

mod as_printed;
mod decision;
mod ending;
mod fate;
mod formula;
mod latex;
mod listing;
mod names;
mod number;
mod rich;
mod sentence;
mod table;
mod teller;
mod title;
mod variables;
mod words;
mod write;

pub use fate::{Naming, fate_name, fate_numbers, fate_sentence};
pub use formula::{
    Fence, Formula, Misprint, Notation, Room, Sign, Statement, UnknownNotation, formulas, math,
    misprint_formula, spoken, spoken_formula,
};
pub use latex::latex;
pub use listing::{Line, Listing, branch, label, listing};
pub use names::{
    algorithm_authors, algorithm_name, counter_name, end_name, query_name, step_texts,
};
pub use number::{approx, distinct, number, shown_number, signed_number, with_minus};
pub use rich::{RichText, Span};
pub use sentence::{sentence, sentences};
pub use table::{trace_latex, trace_markdown};
pub use title::short_title;
pub use variables::{Variable, variables};
pub use write::{trace_csv, trace_jsonl, trace_text};

#[cfg(test)]
mod tests;
