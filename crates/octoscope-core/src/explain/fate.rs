//! What has become of a node, and what rules it out, in words.

use super::number::{approx, distinct};
use super::rich::{RichText, on_axis, strong};
use super::words::{Words, equation, relation, t};
use crate::geometry::AXIS_NAMES;
use crate::text::Language;
use crate::trace::{Crossing, Fate, ParentPlane, Reason};
use crate::tree::{NodeId, Tree};

/// How a node is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// As a child, where its parent is known.
    ByIndex,
    /// By its code and level.
    ByCode,
}

/// One sentence about a node.
pub fn fate_sentence<const D: usize>(
    tree: &Tree<D>,
    node: NodeId,
    fate: Fate,
    naming: Naming,
    language: Language,
) -> RichText {
    let words = Words::new(tree, language);
    let who = match (naming, tree.child_index(node)) {
        (Naming::ByIndex, Some(child)) => {
            words.say("fate-child", &[("child", strong(&child.0.to_string()))])
        }
        (Naming::ByIndex, None) => words.texts.get("fate-root"),
        (Naming::ByCode, _) => words.node_first(node),
    };
    RichText::parse(&sentence(&words, &who, fate))
}

/// The comparison alone, or the interval in which the ray is in the node.
pub fn fate_numbers(fate: Fate) -> RichText {
    RichText::parse(&match fate {
        Fate::Visited(interval) | Fate::Entered(interval) | Fate::Ahead(interval) => {
            interval.map_or_else(String::new, numbers)
        }
        Fate::PassedBy(interval) => numbers(interval),
        Fate::RuledOut(reason) | Fate::Strayed(reason) => comparison(reason),
    })
}

/// What has become of it, in a word or two.
pub fn fate_name(fate: Fate, language: Language) -> String {
    super::step_texts(language).get(match fate {
        Fate::Visited(_) => "fate-name-visited",
        Fate::Entered(_) => "fate-name-entered",
        Fate::Ahead(_) => "fate-name-ahead",
        Fate::PassedBy(_) => "fate-name-passed",
        Fate::Strayed(_) => "fate-name-strayed",
        Fate::RuledOut(reason) => match reason {
            Reason::Beside { .. } => "fate-name-beside",
            Reason::Missed { .. } => "fate-name-missed",
            Reason::Touched { .. } => "fate-name-touched",
            Reason::Behind { .. } => "fate-name-behind",
            Reason::BeyondEnd { .. } => "fate-name-end",
            Reason::AfterFull { .. } => "fate-name-full",
            Reason::Elsewhere { .. } => "fate-name-elsewhere",
        },
    })
}

fn sentence<const D: usize>(words: &Words<D>, who: &str, fate: Fate) -> String {
    let who = || ("who", who.to_owned());
    let with = |key: &str, interval: Option<[f64; 2]>| match interval {
        None => words.say(&format!("{key}-point"), &[who()]),
        Some(interval) => {
            let [enter, exit] = ends(interval);
            words.say(&format!("{key}-ray"), &[who(), ("enter", enter), ("exit", exit)])
        }
    };
    match fate {
        Fate::Visited(interval) => with("fate-visited", interval),
        Fate::Entered(interval) => with("fate-entered", interval),
        Fate::Ahead(interval) => with("fate-ahead", interval),
        Fate::PassedBy(interval) => with("fate-passed", Some(interval)),
        Fate::RuledOut(reason) => why(words, who(), reason),
        Fate::Strayed(reason) => words.say("fate-strayed", &[("why", why(words, who(), reason))]),
    }
}

fn why<const D: usize>(words: &Words<D>, who: (&str, String), reason: Reason) -> String {
    let axis = |axis: usize| on_axis(axis, AXIS_NAMES[axis]);
    let told = ("comparison", comparison(reason));
    match reason {
        Reason::Beside { axis: still, .. } => {
            words.say("why-beside", &[who, told, ("axis", axis(still))])
        }
        Reason::Missed { enter, exit } => {
            let planes = [("enter", axis(enter.axis)), ("exit", axis(exit.axis))];
            words.say("why-missed", &[&[who, told], &planes[..]].concat())
        }
        Reason::Touched { enter: Some(_), .. } => words.say("why-touched", &[who, told]),
        Reason::Touched { enter: None, .. } => words.say("why-touched-origin", &[who, told]),
        Reason::Behind { .. } => words.say("why-behind", &[who, told]),
        Reason::BeyondEnd { .. } => words.say("why-end", &[who, told]),
        Reason::AfterFull { .. } => words.say("why-full", &[who, told]),
        Reason::Elsewhere { .. } => words.say("why-elsewhere", &[who, told]),
    }
}

/// The two numbers that leave no room between them.
fn comparison(reason: Reason) -> String {
    match reason {
        Reason::Beside { axis, origin, sides } => {
            let side = if origin < sides[0] { sides[0] } else { sides[1] };
            coordinate(axis, origin, side, origin >= side)
        }
        Reason::Missed { enter, exit } => two(enter, ">", exit),
        Reason::Touched { enter: Some(enter), exit } => two(enter, "=", exit),
        Reason::Touched { enter: None, exit } => equation(&name(exit), "0"),
        Reason::Behind { exit } => {
            format!("{} < 0", equation(&name(exit), &approx(exit.t)))
        }
        Reason::BeyondEnd { enter, end } => {
            let start = enter.map_or(0.0, |enter| enter.t);
            let texts = distinct(&[start, end]);
            let name = enter.map_or_else(|| "t".to_owned(), name);
            format!("{} ≥ {}", equation(&name, &texts[0]), strong(&texts[1]))
        }
        Reason::AfterFull { enter, full } => {
            let texts = distinct(&[enter, full]);
            let sign = relation(enter, full);
            format!("{} {sign} {}", equation("t", &texts[0]), strong(&texts[1]))
        }
        Reason::Elsewhere { axis, place, side, above } => coordinate(axis, place, side, above),
    }
}

/// "t_xm = 0.41 > t_y1 = 0.34".
fn two(a: Crossing, sign: &str, b: Crossing) -> String {
    let texts = distinct(&[a.t, b.t]);
    format!("{} {sign} {}", equation(&name(a), &texts[0]), equation(&name(b), &texts[1]))
}

/// "x = 0.25 < 0.5".
fn coordinate(axis: usize, place: f64, side: f64, above: bool) -> String {
    let texts = distinct(&[place, side]);
    let sign = if above { "≥" } else { "<" };
    let name = on_axis(axis, AXIS_NAMES[axis]);
    format!("{} {sign} {}", equation(&name, &texts[0]), strong(&texts[1]))
}

fn name(crossing: Crossing) -> String {
    let plane = match crossing.plane {
        ParentPlane::Near => "0",
        ParentPlane::Mid => "m",
        ParentPlane::Far => "1",
    };
    t(crossing.axis, plane)
}

fn ends(interval: [f64; 2]) -> [String; 2] {
    let texts = distinct(&interval);
    [strong(&texts[0]), strong(&texts[1])]
}

/// "t = 0.1 – 0.25".
fn numbers(interval: [f64; 2]) -> String {
    let [enter, exit] = ends(interval);
    format!("t = {enter} – {exit}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::Tree;
    use crate::{progress::Progress, tree::Domain, tree::Split, tree::grow};

    fn tree() -> Tree<2> {
        grow(Domain::unit(1), (), &Progress::default(), |cell, ()| match cell.level {
            0 => Split::Empty,
            _ => Split::Inner(vec![(); 4]),
        })
        .unwrap()
    }

    #[track_caller]
    fn check(fate: Fate, language: Language, expected: &str) {
        let sentence = fate_sentence(&tree(), NodeId(3), fate, Naming::ByIndex, language);
        assert_eq!(sentence.plain(), expected);
    }

    const ENTER: Crossing = Crossing { axis: 0, plane: ParentPlane::Mid, t: 0.75 };
    const EXIT: Crossing = Crossing { axis: 1, plane: ParentPlane::Far, t: 0.5 };

    #[test]
    fn a_missed_child_is_told_with_its_planes() {
        let fate = Fate::RuledOut(Reason::Missed { enter: ENTER, exit: EXIT });
        check(
            fate,
            Language::English,
            "Child 2 is not met: t_xm = 0.75 > t_y1 = 0.5, so the ray would leave it through y \
             before it enters it through x.",
        );
        check(
            fate,
            Language::German,
            "Kind 2 wird verfehlt: t_xm = 0.75 > t_y1 = 0.5, der Austritt durch y käme also vor \
             dem Eintritt durch x.",
        );
        assert_eq!(fate_numbers(fate).plain(), "t_xm = 0.75 > t_y1 = 0.5");
    }

    #[test]
    fn what_is_behind_beside_or_beyond_is_told_with_one_number() {
        let told = |reason| fate_numbers(Fate::RuledOut(reason)).plain();
        let behind = Crossing { t: -0.25, ..EXIT };
        assert_eq!(told(Reason::Behind { exit: behind }), "t_y1 = −0.25 < 0");
        let beside = |origin| Reason::Beside { axis: 1, origin, sides: [0.5, 1.0] };
        assert_eq!(told(beside(0.25)), "y = 0.25 < 0.5");
        assert_eq!(told(beside(1.0)), "y = 1 ≥ 1");
        let end = Reason::BeyondEnd { enter: Some(ENTER), end: 0.7 };
        assert_eq!(told(end), "t_xm = 0.75 ≥ 0.7");
    }

    #[test]
    fn every_fate_has_a_name_and_a_sentence_in_both_languages() {
        let interval = [0.25, 0.5];
        let reasons = [
            Reason::Beside { axis: 0, origin: 0.25, sides: [0.5, 1.0] },
            Reason::Missed { enter: ENTER, exit: EXIT },
            Reason::Touched { enter: Some(EXIT), exit: EXIT },
            Reason::Touched { enter: None, exit: EXIT },
            Reason::Behind { exit: EXIT },
            Reason::BeyondEnd { enter: None, end: 0.0 },
            Reason::AfterFull { enter: 0.5, full: 0.25 },
            Reason::Elsewhere { axis: 1, place: 0.5, side: 0.5, above: true },
        ];
        let turns = [None, Some(interval)].into_iter().flat_map(|interval| {
            [Fate::Visited(interval), Fate::Entered(interval), Fate::Ahead(interval)]
        });
        let ruled_out = reasons.into_iter().flat_map(|r| [Fate::RuledOut(r), Fate::Strayed(r)]);
        for fate in turns.chain(ruled_out).chain([Fate::PassedBy(interval)]) {
            for language in Language::ALL {
                for naming in [Naming::ByIndex, Naming::ByCode] {
                    let text = fate_sentence(&tree(), NodeId(3), fate, naming, language).plain();
                    assert!(text.ends_with('.') && text.contains(' '), "{text}");
                    assert!(!text.contains("fate-") && !text.contains("why-"), "{text}");
                }
                let name = fate_name(fate, language);
                assert!(!name.starts_with("fate-") && name.len() < 16, "{name}");
            }
        }
    }
}
