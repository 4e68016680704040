//! Search over everything that has a name: commands, scenes, algorithms, errata.

use crate::command::{COMMANDS, Command};
use crate::query_kind::QueryKind;
use crate::text::texts;
use octoscope_core::explain::{algorithm_authors, algorithm_name};
use octoscope_core::paper::{ERRATA, Erratum, misprint_title, paper_texts};
use octoscope_core::scenario::BUILT_IN;
use octoscope_core::text::{Language, Texts};
use octoscope_core::traverse::{Algorithm, Variant};
use octoscope_figure::Theme;

/// Something that can be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A command of the window.
    Command(Command),
    /// A built-in scene, by its identifier.
    Scene(&'static str),
    /// Colours.
    Theme(Theme),
    /// What is asked of the tree.
    Query(QueryKind),
    /// An algorithm of the ray.
    Algorithm(Algorithm),
    /// An error of the paper.
    Erratum(&'static Erratum),
    /// One of several rules that an error of the paper may be read as.
    Reading(Variant),
}

/// A target that matches, with its name in the language of the window.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// What was found.
    pub target: Target,
    /// Its name.
    pub name: String,
    /// What matches instead: a name in the other language, people who have found it, or
    /// what it is looked for as well.
    pub other: Option<String>,
}

impl Target {
    /// Everything that can be found, in the order of the menus.
    pub fn all() -> impl Iterator<Item = Self> {
        let commands = COMMANDS.iter().map(|row| row.command);
        let commands = commands.filter(|&command| command != Command::Find).map(Self::Command);
        let scenes = BUILT_IN.iter().map(|scene| Self::Scene(scene.id));
        let queries = QueryKind::ALL.into_iter().map(Self::Query);
        let algorithms = Algorithm::ALL.into_iter().map(Self::Algorithm);
        let named = |variant: &Variant| ERRATA.iter().any(|erratum| erratum.id == variant.id());
        let errata = ERRATA.iter().flat_map(move |erratum| {
            let readings = erratum.variants.iter().copied().filter(move |v| !named(v));
            std::iter::once(Self::Erratum(erratum)).chain(readings.map(Self::Reading))
        });
        let themes = Theme::ALL.into_iter().map(Self::Theme);
        commands.chain(themes).chain(queries).chain(algorithms).chain(scenes).chain(errata)
    }

    /// Key of the heading under which it is listed.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Command(Command::Panel(_)) => "find-panel",
            Self::Command(_) | Self::Theme(_) => "find-command",
            Self::Scene(_) => "find-scene",
            Self::Query(_) => "find-query",
            Self::Algorithm(_) => "find-algorithm",
            Self::Erratum(_) | Self::Reading(_) => "find-erratum",
        }
    }

    /// The identifier that files and the command line know, if there is one.
    fn id(self) -> &'static str {
        match self {
            Self::Command(_) | Self::Theme(_) | Self::Query(_) => "",
            Self::Scene(id) => id,
            Self::Algorithm(algorithm) => algorithm.id(),
            Self::Erratum(erratum) => erratum.id,
            Self::Reading(variant) => variant.id(),
        }
    }

    fn name(self, texts: &Texts, paper: &Texts) -> String {
        match self {
            Self::Command(command) => texts.get(command.row().id),
            Self::Scene(id) => texts.get(&format!("scene-{id}")),
            Self::Theme(theme) => {
                let theme = texts.get(&format!("theme-{}", theme.id()));
                texts.format("find-theme", &[("theme", theme.into())])
            }
            Self::Query(kind) => texts.get(&format!("find-{}", kind.key())),
            Self::Algorithm(algorithm) => algorithm_name(algorithm, texts.language()),
            Self::Erratum(erratum) => {
                format!("{} · {}", erratum.id, paper.get(&erratum.key("title")))
            }
            Self::Reading(variant) => {
                let title = misprint_title(variant, texts.language()).unwrap_or_default();
                format!("{} · {title}", variant.id())
            }
        }
    }
}

impl Target {
    /// Other words by which it is looked for, between commas.
    fn also(self, texts: &Texts) -> String {
        let key = match self {
            Self::Command(command) => format!("also-{}", command.row().id),
            Self::Theme(theme) => format!("also-theme-{}", theme.id()),
            Self::Algorithm(algorithm) => return algorithm_authors(algorithm).to_owned(),
            Self::Scene(_) | Self::Query(_) | Self::Erratum(_) | Self::Reading(_) => {
                return String::new();
            }
        };
        if texts.has(&key) { texts.get(&key) } else { String::new() }
    }
}

/// How much further down is listed what has no such name but is looked for by it, and what
/// only another language knows.
const ALSO: u8 = 6;
const FOREIGN: u8 = 12;

/// What matches all words of `wanted` by its name in either language, by its identifier or
/// by what else it is looked for, best first; everything if nothing is wanted. Names are in
/// `language`.
pub fn find(wanted: &str, language: Language) -> Vec<Hit> {
    let all_texts = Language::ALL.map(|each| (each, texts(each), paper_texts(each)));
    let wanted = folded(wanted);
    let words: Vec<&str> = wanted.split_whitespace().collect();
    let mut hits: Vec<(u8, Hit)> = Vec::new();
    for target in Target::all() {
        let mut best = closeness(&folded(target.id()), &words).map(|rank| rank + 1);
        let mut shown = String::new();
        let mut others: Vec<(u8, String)> = Vec::new();
        for (each, texts, paper) in &all_texts {
            let name = target.name(texts, paper);
            let rank = closeness(&folded(&name), &words);
            let foreign = if *each == language { 0 } else { FOREIGN };
            if let Some((rank, found)) = by_other_words(&name, &target.also(texts), &words) {
                others.push((rank + ALSO + foreign, found));
            }
            if *each == language {
                best = [best, rank].into_iter().flatten().min();
                shown = name;
            } else {
                others.extend(rank.map(|rank| (rank + foreign, name)));
            }
        }
        // Other words are asked only where its own name is not what is wanted.
        let other = others.into_iter().min_by_key(|(rank, _)| *rank).filter(|_| best.is_none());
        let rank = best.or(other.as_ref().map(|(rank, _)| *rank));
        if let Some(rank) = rank {
            let other = other.map(|(_, name)| name);
            hits.push((rank, Hit { target, name: shown, other }));
        }
    }
    // Stable: equals stay in the order of the menus.
    hits.sort_by_key(|(rank, _)| *rank);
    hits.into_iter().map(|(_, hit)| hit).collect()
}

/// How well the words are found in a name and what else it is looked for by, and those of
/// these that have one of the words.
fn by_other_words(name: &str, also: &str, words: &[&str]) -> Option<(u8, String)> {
    let has_one = |part: &&str| words.iter().any(|word| folded(part).contains(word));
    let found: Vec<&str> = also.split(", ").filter(has_one).collect();
    let rank = closeness(&folded(&format!("{also}, {name}")), words)?;
    (!found.is_empty()).then(|| (rank, found.join(", ")))
}

/// How well the words are found in a name, 0 is best; `None` if one is missing.
fn closeness(name: &str, words: &[&str]) -> Option<u8> {
    let begins = |word: &str| {
        let parts = name.split(|c: char| !c.is_alphanumeric());
        parts.into_iter().any(|part| part.starts_with(word)) || name.starts_with(word)
    };
    if !words.iter().all(|word| name.contains(word)) {
        None
    } else if words.first().is_none_or(|word| name.starts_with(word)) {
        Some(0)
    } else if words.iter().all(|word| begins(word)) {
        Some(2)
    } else {
        Some(4)
    }
}

/// In small letters, umlauts as their vowels, so that either keyboard finds them.
fn folded(text: &str) -> String {
    let mut folded = String::with_capacity(text.len());
    for letter in text.chars().flat_map(char::to_lowercase) {
        match letter {
            'ä' => folded.push('a'),
            'ö' => folded.push('o'),
            'ü' => folded.push('u'),
            'ñ' => folded.push('n'),
            'ß' => folded.push_str("ss"),
            other => folded.push(other),
        }
    }
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(wanted: &str, first: Target) {
        for language in Language::ALL {
            let hits = find(wanted, language);
            assert_eq!(hits.first().map(|hit| hit.target), Some(first), "{wanted} {language:?}");
        }
    }

    #[test]
    fn either_language_finds_the_same() {
        check("step forward", Target::Command(Command::StepForward));
        check("schritt vor", Target::Command(Command::StepForward));
        check("point: in", Target::Query(QueryKind::Point));
        check("nachbarn", Target::Query(QueryKind::Neighbour));
        check("hero", Target::Algorithm(Algorithm::Hero));
        check("sphere-grid", Target::Scene("sphere-grid"));
        check("b-25", Target::Erratum(ERRATA.iter().find(|e| e.id == "B-25").unwrap()));
        check("b-2-morton", Target::Reading(Variant::B2Morton));
        check("24b", Target::Reading(Variant::B24b));
        check("b-24a", Target::Reading(Variant::B24a));
    }

    #[test]
    fn people_and_other_words_find_what_they_stand_for() {
        let lecture = Target::Command(Command::Preset(5));
        for word in ["vortrag", "präsentation", "presentation", "lecture", "vorlesung"] {
            check(word, lecture);
        }
        check("revelles", Target::Algorithm(Algorithm::Parametric));
        check("lastra table", Target::Algorithm(Algorithm::ParametricTable));
        check("urena tabelle", Target::Algorithm(Algorithm::ParametricTable));
        check("frisken", Target::Algorithm(Algorithm::Codes));
        check("amanatides", Target::Algorithm(Algorithm::Dda));
        check("projector", Target::Theme(Theme::Projector));
        check("projektor", Target::Theme(Theme::Projector));
        check("dark", Target::Theme(Theme::Dark));
        check("dunkel", Target::Theme(Theme::Dark));
        let found = |wanted, language| find(wanted, language)[0].other.clone();
        let people = Some("Ureña".to_owned());
        assert_eq!(found("ureña", Language::English), people);
        assert_eq!(found("vortrag", Language::English).as_deref(), Some("Vortrag"));
    }

    #[test]
    fn other_words_belong_to_something_in_both_languages() {
        let source = include_str!("../assets/texts/en/window.ftl");
        let keys = source.lines().filter_map(|line| line.strip_prefix("also-"));
        let keys: Vec<&str> = keys.filter_map(|line| line.split_once(" = ")).map(|l| l.0).collect();
        assert!(keys.len() > 5, "{keys:?}");
        for key in keys {
            let is_command = COMMANDS.iter().any(|row| row.id == key);
            let is_theme = Theme::ALL.into_iter().any(|one| key == format!("theme-{}", one.id()));
            assert!(is_command || is_theme, "{key}");
        }
    }

    #[test]
    fn umlauts_are_found_by_their_vowels() {
        let with = find("Öffnen", Language::German);
        assert!(with.iter().any(|hit| hit.target == Target::Command(Command::Open)));
        assert_eq!(with, find("offnen", Language::German));
    }

    #[test]
    fn names_of_the_shown_language_come_first_and_others_are_told() {
        let hits = find("eb", Language::English);
        let foreign: Vec<bool> = hits.iter().map(|hit| hit.other.is_some()).collect();
        assert!(foreign.is_sorted() && foreign.contains(&true), "{hits:?}");
        let named = hits.iter().filter_map(|hit| hit.other.as_ref());
        assert!(named.into_iter().all(|name| folded(name).contains("eb")), "{hits:?}");
    }

    #[test]
    fn nothing_wanted_is_everything_and_nonsense_is_nothing() {
        assert_eq!(find(" ", Language::English).len(), Target::all().count());
        assert_eq!(find("xyzzy", Language::German), []);
    }

    #[test]
    fn every_target_has_a_name_in_every_language() {
        for language in Language::ALL {
            for hit in find("", language) {
                assert!(!hit.name.is_empty() && !hit.name.contains("algorithm-"), "{hit:?}");
            }
        }
    }
}
