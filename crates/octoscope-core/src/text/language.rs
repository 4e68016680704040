//! The languages of the interface.

use serde::{Deserialize, Serialize};
use thiserror::Error;
use unic_langid::LanguageIdentifier;

/// A language of the interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Language {
    /// English.
    #[default]
    #[serde(rename = "en")]
    English,
    /// German.
    #[serde(rename = "de")]
    German,
}

/// No language has this identifier.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no language ‘{0}’; there are en and de")]
pub struct UnknownLanguage(pub String);

impl Language {
    /// All languages.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Identifier on the command line and in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// Name in the language itself.
    pub fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::German => "Deutsch",
        }
    }

    /// Identifier by which plurals are chosen.
    pub(super) fn tag(self) -> LanguageIdentifier {
        self.id().parse().unwrap_or_default()
    }
}

impl std::str::FromStr for Language {
    type Err = UnknownLanguage;

    fn from_str(id: &str) -> Result<Self, UnknownLanguage> {
        let found = Self::ALL.into_iter().find(|language| language.id() == id);
        found.ok_or_else(|| UnknownLanguage(id.to_owned()))
    }
}
