//! Texts in both languages that are part of the program.

use super::{Language, Texts};
use std::sync::OnceLock;

/// Fluent sources in both languages, each read when its texts are first asked for.
pub struct Bilingual {
    english: (&'static str, OnceLock<Texts>),
    german: (&'static str, OnceLock<Texts>),
}

impl Bilingual {
    /// Texts from these sources.
    pub const fn new(english: &'static str, german: &'static str) -> Self {
        Self { english: (english, OnceLock::new()), german: (german, OnceLock::new()) }
    }

    /// The texts in `language`.
    pub fn texts(&self, language: Language) -> &Texts {
        let (source, texts) = match language {
            Language::English => &self.english,
            Language::German => &self.german,
        };
        texts.get_or_init(|| Texts::new(language, &[source]))
    }
}
