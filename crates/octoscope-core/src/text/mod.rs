//! User-visible texts, in English and German.

mod bilingual;
mod language;
mod message;
mod texts;

pub use bilingual::Bilingual;
pub use language::{Language, UnknownLanguage};
pub use message::{Argument, Message};
pub use texts::{Texts, Value};
