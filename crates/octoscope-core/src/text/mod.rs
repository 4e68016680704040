//! User-visible texts, in English and German.

mod language;
mod message;
mod texts;

pub use language::{Language, UnknownLanguage};
pub use message::{Argument, Message};
pub use texts::{Texts, Value};
