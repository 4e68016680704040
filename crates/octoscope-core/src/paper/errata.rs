//! All errata of the paper.

use crate::text::{Bilingual, Language, Texts};
use crate::traverse::Variant;

/// An error in the paper. Its texts are `erratum-b-N-title`, `-printed`,
/// `-right` and `-why` of [`paper_texts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// Name, such as `B-2`.
    pub id: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Variants that follow what is printed; none where no rule of computation
    /// is misprinted.
    pub variants: &'static [Variant],
}

/// How bad an erratum is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// Only a matter of words.
    Cosmetic,
    /// Misleading.
    Misleading,
    /// Gives wrong results if it is followed.
    Wrong,
}

impl Severity {
    /// Name in keys of texts and style sheets.
    pub fn id(self) -> &'static str {
        match self {
            Self::Cosmetic => "cosmetic",
            Self::Misleading => "misleading",
            Self::Wrong => "wrong",
        }
    }
}

impl Erratum {
    /// Key of its text `part`: `title`, `printed`, `right` or `why`.
    pub fn key(&self, part: &str) -> String {
        format!("erratum-{}-{part}", self.id.to_ascii_lowercase())
    }
}

/// The erratum whose printed rule a variant follows; `None` for variants that
/// are no misprints.
pub fn erratum_of(variant: Variant) -> Option<&'static Erratum> {
    ERRATA.iter().find(|erratum| erratum.variants.contains(&variant))
}

/// Title of the erratum whose printed rule a variant follows. Where what is printed can
/// be read in several ways, each of which has a variant, it says in which.
pub fn misprint_title(variant: Variant, language: Language) -> Option<String> {
    let erratum = erratum_of(variant)?;
    let texts = paper_texts(language);
    let title = texts.get(&erratum.key("title"));
    Some(match erratum.variants {
        [_] => title,
        _ => format!("{title}: {}", texts.get(&reading_key(variant))),
    })
}

fn reading_key(variant: Variant) -> String {
    format!("reading-{}", variant.id().to_ascii_lowercase())
}

/// Texts on the errata in `language`.
pub fn paper_texts(language: Language) -> &'static Texts {
    static TEXTS: Bilingual = Bilingual::new(ENGLISH, GERMAN);
    TEXTS.texts(language)
}

const ENGLISH: &str = include_str!("../../../../assets/texts/en/paper.ftl");
const GERMAN: &str = include_str!("../../../../assets/texts/de/paper.ftl");

/// The errata in the order of their numbers.
pub const ERRATA: [Erratum; 37] = {
    use Severity::{Cosmetic, Misleading, Wrong};
    [
        erratum("B-1", Wrong, &[Variant::B1]),
        erratum("B-2", Wrong, &[Variant::B2, Variant::B2Morton]),
        erratum("B-3", Wrong, &[Variant::B3]),
        erratum("B-4", Misleading, &[Variant::B4]),
        erratum("B-5", Wrong, &[Variant::B5]),
        erratum("B-6", Misleading, &[Variant::B6]),
        erratum("B-7", Wrong, &[Variant::B7]),
        erratum("B-8", Cosmetic, &[]),
        erratum("B-9", Misleading, &[Variant::B9]),
        erratum("B-10", Wrong, &[Variant::B10]),
        erratum("B-11", Misleading, &[Variant::B11]),
        erratum("B-12", Misleading, &[]),
        erratum("B-13", Cosmetic, &[]),
        erratum("B-14", Cosmetic, &[]),
        erratum("B-15", Cosmetic, &[]),
        erratum("B-16", Misleading, &[]),
        erratum("B-17", Cosmetic, &[]),
        erratum("B-18", Wrong, &[Variant::B18]),
        erratum("B-19", Wrong, &[Variant::B19]),
        erratum("B-20", Misleading, &[]),
        erratum("B-21", Misleading, &[Variant::B21]),
        erratum("B-22", Misleading, &[]),
        erratum("B-23", Cosmetic, &[]),
        erratum("B-24", Wrong, &[Variant::B24a, Variant::B24b, Variant::B24c]),
        erratum("B-25", Wrong, &[Variant::B25Leftmost, Variant::B25Rightmost]),
        erratum("B-26", Misleading, &[]),
        erratum("B-27", Wrong, &[]),
        erratum("B-28", Wrong, &[Variant::B28]),
        erratum("B-29", Misleading, &[]),
        erratum("B-30", Misleading, &[]),
        erratum("B-31", Misleading, &[]),
        erratum("B-32", Cosmetic, &[]),
        erratum("B-33", Cosmetic, &[]),
        erratum("B-34", Cosmetic, &[]),
        erratum("B-35", Cosmetic, &[]),
        erratum("B-36", Cosmetic, &[]),
        erratum("B-37", Cosmetic, &[]),
    ]
};

const fn erratum(id: &'static str, severity: Severity, variants: &'static [Variant]) -> Erratum {
    Erratum { id, severity, variants }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn is_one_of_several(variant: Variant) -> bool {
        erratum_of(variant).is_some_and(|erratum| erratum.variants.len() > 1)
    }

    #[test]
    fn every_misprint_has_a_title_of_its_own() {
        for language in Language::ALL {
            let titles = Variant::ALL.map(|variant| misprint_title(variant, language));
            let titles: Vec<String> = titles.into_iter().flatten().collect();
            let different: BTreeSet<&String> = titles.iter().collect();
            assert_eq!(different.len(), titles.len(), "{titles:?}");
        }
    }

    fn keys(source: &str) -> BTreeSet<&str> {
        source.lines().filter_map(|line| line.split_once(" = ")).map(|(key, _)| key).collect()
    }

    #[test]
    fn every_erratum_has_all_texts_in_both_languages_and_no_text_is_left_over() {
        let expected: BTreeSet<String> = ERRATA
            .iter()
            .flat_map(|erratum| ["title", "printed", "right", "why"].map(|part| erratum.key(part)))
            .chain(Variant::ALL.into_iter().filter(|&v| is_one_of_several(v)).map(reading_key))
            .collect();
        let expected: BTreeSet<&str> = expected.iter().map(String::as_str).collect();
        assert_eq!(keys(ENGLISH), expected);
        assert_eq!(keys(GERMAN), expected);
        for language in Language::ALL {
            for key in &expected {
                let text = paper_texts(language).get(key);
                assert!(text.len() > 3 && text != *key, "{key}: {text}");
            }
        }
    }

    #[test]
    fn errata_are_numbered_from_1_to_37() {
        let ids: Vec<String> = ERRATA.iter().map(|erratum| erratum.id.to_owned()).collect();
        assert_eq!(ids, (1..=37).map(|n| format!("B-{n}")).collect::<Vec<_>>());
    }

    #[test]
    fn every_misprint_is_one_of_an_erratum_that_names_it() {
        for variant in Variant::ALL {
            let erratum = erratum_of(variant);
            assert_eq!(erratum.is_some(), variant.is_misprint(), "{variant:?}");
            assert!(erratum.is_none_or(|erratum| variant.id().starts_with(erratum.id)));
        }
    }
}
