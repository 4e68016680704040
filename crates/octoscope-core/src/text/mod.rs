//! User-visible texts, in English and German.

mod language;
mod texts;

pub use language::{Language, UnknownLanguage};
pub use texts::{Texts, Value};
