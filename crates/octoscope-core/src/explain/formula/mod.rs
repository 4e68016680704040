//! The formula of a step: what it computes or compares, with symbols and with its
//! numbers, as data. Who draws it, writes it or speaks it decides how it looks.

mod borders;
mod children;
mod clip;
mod codes;
mod cuts;
mod math;
mod notation;
mod numbers;
mod parameters;
mod printed;
mod spoken;
mod term;
mod ways;
mod writer;

pub use math::math;
pub use notation::{Notation, UnknownNotation};
pub use printed::{Misprint, misprint_formula};
pub use spoken::{spoken, spoken_formula};
pub use term::{Fence, Formula, Room, Sign};

use crate::geometry::Ray;
use crate::text::{Bilingual, Language, Texts};
use crate::trace::{Moment, Trace};
use crate::tree::Tree;
use writer::Writer;

/// One computation or comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// With symbols.
    pub symbols: Formula,
    /// The same with the numbers of the step, where it has any.
    pub numbers: Option<Formula>,
}

/// What `step` of `trace`, counted from 1, computes and compares; nothing for steps
/// that do neither, and for step 0. The numbers are those of the run.
pub fn formulas<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    step: usize,
    notation: Notation,
    language: Language,
) -> Vec<Statement> {
    let Some(index) = step.min(trace.events.len()).checked_sub(1) else { return Vec::new() };
    let before = Moment::after(tree, trace, index);
    let texts = formula_texts(language);
    let past = &trace.events[..index];
    let query = &trace.query;
    let writer = Writer { tree, ray, query, past, before: &before, notation, texts };
    let mut statements = writer.of(&trace.events[index]);
    numbers::tell_apart(&mut statements);
    statements
}

/// Words in formulas, and how formulas are spoken.
pub(super) fn formula_texts(language: Language) -> &'static Texts {
    static TEXTS: Bilingual = Bilingual::new(ENGLISH, GERMAN);
    TEXTS.texts(language)
}

const ENGLISH: &str = include_str!("../../../../../assets/texts/en/formulas.ftl");
const GERMAN: &str = include_str!("../../../../../assets/texts/de/formulas.ftl");
