//! Names of algorithms, queries, ends and counters.

use crate::event::End;
use crate::query::Query;
use crate::text::{Bilingual, Language, Texts};
use crate::trace::Counter;
use crate::traverse::Algorithm;

/// Sources of the texts on steps, by language.
pub(super) const ENGLISH: &str = include_str!("../../../../assets/texts/en/steps.ftl");
pub(super) const GERMAN: &str = include_str!("../../../../assets/texts/de/steps.ftl");

/// Texts on steps in `language`.
pub fn step_texts(language: Language) -> &'static Texts {
    static TEXTS: Bilingual = Bilingual::new(ENGLISH, GERMAN);
    TEXTS.texts(language)
}

/// Who has published an algorithm, between commas; nobody for what is told everywhere.
pub fn algorithm_authors(algorithm: Algorithm) -> &'static str {
    match algorithm {
        Algorithm::Parametric | Algorithm::ParametricTable => "Revelles, Ureña, Lastra",
        Algorithm::Esvo => "Laine, Karras",
        Algorithm::Hero => "Agate, Grimsdale, Lister",
        Algorithm::Gargantini => "Gargantini, Atkinson",
        Algorithm::Bsp => "Sung, Shirley",
        Algorithm::Codes => "Frisken, Perry",
        Algorithm::Samet => "Samet",
        Algorithm::SametCorner | Algorithm::SametNet => "Samet, Endl, Sommer",
        Algorithm::Glassner => "Glassner",
        Algorithm::Dda | Algorithm::DdaOctree => "Amanatides, Woo",
        Algorithm::AllChildren | Algorithm::Exhaustive => "",
    }
}

/// Name of an algorithm.
pub fn algorithm_name(algorithm: Algorithm, language: Language) -> String {
    step_texts(language).get(&format!("algorithm-{}", algorithm.id()))
}

/// Name of a counter.
pub fn counter_name(counter: Counter, language: Language) -> String {
    step_texts(language).get(&format!("counter-{}", counter.id()))
}

/// How a run ended, in a few words.
pub fn end_name(end: End, language: Language) -> String {
    step_texts(language).get(match end {
        End::Missed => "ended-missed",
        End::LeftRoot => "ended-left-root",
        End::FirstFull => "ended-first-full",
        End::SegmentEnd => "ended-segment-end",
        End::Looped => "ended-looped",
        End::Cut => "ended-cut",
        End::Found => "ended-found",
        End::Outside => "ended-outside",
    })
}

/// Name of what is asked.
pub fn query_name<const D: usize>(query: &Query<D>, language: Language) -> String {
    step_texts(language).get(match query {
        Query::Ray { .. } => "query-ray",
        Query::Point { .. } => "query-point",
        Query::Region { .. } => "query-region",
        Query::Neighbour { .. } => "query-neighbour",
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// Arguments of every key.
    fn keys(source: &str) -> BTreeMap<String, BTreeSet<String>> {
        let mut keys: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let mut key = String::new();
        for line in source.lines().filter(|line| !line.starts_with('#')) {
            if !line.starts_with([' ', '}']) && line.contains(" = ") {
                key = line.split(" = ").next().unwrap().to_owned();
                assert!(keys.insert(key.clone(), BTreeSet::new()).is_none(), "twice: {key}");
            }
            for part in line.split('$').skip(1) {
                let name = part.chars().take_while(|c| c.is_alphanumeric()).collect();
                keys.get_mut(&key).unwrap().insert(name);
            }
        }
        keys
    }

    #[test]
    fn both_languages_have_the_same_keys_and_arguments() {
        assert_eq!(keys(ENGLISH), keys(GERMAN));
    }

    #[test]
    fn every_key_can_be_read_and_every_name_is_there() {
        for language in Language::ALL {
            for key in keys(ENGLISH).keys() {
                assert!(step_texts(language).has(key), "{key}");
            }
            for algorithm in Algorithm::ALL {
                assert!(!algorithm_name(algorithm, language).starts_with("algorithm-"));
            }
            for counter in Counter::ALL {
                assert!(!counter_name(counter, language).starts_with("counter-"));
            }
        }
    }
}
