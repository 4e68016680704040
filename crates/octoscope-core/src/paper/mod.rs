//! The paper "Ray Tracing mit Octrees" by M. Kirschmann: what is misprinted in it,
//! and where that goes wrong.

mod counterexample;
mod errata;
mod find_other;
mod verdict;

pub use counterexample::counterexample;
pub use errata::{ERRATA, Erratum, Severity, erratum_of, misprint_title, paper_texts};
pub use find_other::find_other;
pub use verdict::{Verdict, verdict};
