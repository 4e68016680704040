//! The formula of every kind of event in every notation, as it is spoken: read
//! `formulas.txt` from top to bottom and you have heard all of them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::event::Event;
use octoscope_core::explain::{Notation, Statement, formulas, spoken};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::text::Language;
use octoscope_core::trace::record;
use octoscope_core::traverse::{Algorithm, Options, Variant, Variants};
use octoscope_core::tree::{Cell, Domain, Split, Tree, grow};
use std::collections::{BTreeMap, BTreeSet};

fn tree() -> Tree<3> {
    let split = |cell: Cell<3>, ()| match cell.level {
        0 => Split::Full(vec![0]),
        level if cell.code.iter().all(|c| c >> level == 2 >> level) => Split::Inner(vec![(); 8]),
        _ => Split::Empty,
    };
    grow(Domain::unit(3), (), &Progress::default(), split).unwrap()
}

/// Queries of every kind, right and with every rule in another form.
fn queries() -> Vec<Query<3>> {
    let variants = Variants::NONE;
    let options = Options::default();
    let arithmetic = Arithmetic::Doubles;
    let ray = |algorithm| Query::Ray { algorithm, options, arithmetic };
    let mut right: Vec<Query<3>> = Algorithm::ALL.into_iter().map(ray).collect();
    for method in [PointMethod::Codes, PointMethod::Comparison] {
        right.push(Query::Point { at: [0.3, 0.4, 0.26], method, variants });
    }
    right.push(Query::Region { min: [0.26; 3], max: [0.3, 0.45, 0.3], variants });
    let reach = Reach::EqualOrLarger;
    for method in [NeighbourMethod::Codes, NeighbourMethod::Tables] {
        for sign in [-1, 1] {
            let direction = Direction::new([sign, 0, 0]).unwrap();
            right.push(Query::Neighbour {
                level: 0,
                code: [3; 3],
                direction,
                reach,
                method,
                variants,
            });
        }
    }
    let others = right.iter().flat_map(|query| {
        let own = Variant::ALL.into_iter().filter(|&variant| query.takes(variant));
        own.map(|variant| query.with_variants(Variants::NONE.with(variant)))
    });
    let others: Vec<Query<3>> = others.collect();
    right.into_iter().chain(others).collect()
}

/// Name of an event with what makes its formula another one.
fn name(event: &Event<3>, query: &Query<3>) -> String {
    let kind: String = format!("{event:?}").chars().take_while(|c| c.is_alphanumeric()).collect();
    let variants: Vec<&str> = query.variants().iter().map(Variant::id).collect();
    if variants.is_empty() { kind } else { format!("{kind} @{}", variants.join(",")) }
}

#[test]
fn every_kind_of_event_is_spoken_as_written_down() {
    let tree = tree();
    let rays = [([-0.1, 0.2, 0.3], [1.0, 0.25, -0.05]), ([1.25, 0.3, 0.3], [-1.0, 0.05, 0.0])];
    let mut heard: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut known = BTreeSet::new();
    for query in queries() {
        for (origin, direction) in rays {
            let ray = Ray::new(origin, direction).unwrap();
            let trace = record(&tree, &ray, &query);
            for (index, event) in trace.events.iter().enumerate() {
                let told = |notation| -> Vec<Statement> {
                    formulas(&tree, &ray, &trace, index + 1, notation, Language::English)
                };
                let name = name(event, &query);
                let is_printed = name.contains('@');
                // A misprint is written down where its formula is another one.
                let symbols: Vec<Statement> = told(Notation::Seed)
                    .into_iter()
                    .map(|statement| Statement { numbers: None, ..statement })
                    .collect();
                let kind = name.split(' ').next().unwrap_or_default().to_owned();
                let is_new = known.insert((kind, spoken(&symbols, Language::English)));
                let same = is_printed && !is_new;
                if told(Notation::Seed).is_empty() || heard.contains_key(&name) || same {
                    continue;
                }
                let notations = if is_printed { &Notation::ALL[..1] } else { &Notation::ALL[..] };
                let mut lines: Vec<String> = notations
                    .iter()
                    .map(|&notation| {
                        format!("{notation}: {}", spoken(&told(notation), Language::English))
                    })
                    .collect();
                let german =
                    formulas(&tree, &ray, &trace, index + 1, Notation::Seed, Language::German);
                lines.push(format!("de: {}", spoken(&german, Language::German)));
                heard.insert(name, lines);
            }
        }
    }
    let text: String = heard
        .into_iter()
        .map(|(name, lines)| format!("{name}\n    {}\n", lines.join("\n    ")))
        .collect();
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/formulas.txt");
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap();
    for (line, (found, expected)) in text.lines().zip(expected.lines()).enumerate() {
        assert_eq!(found, expected, "line {}", line + 1);
    }
    assert_eq!(text.len(), expected.len());
}
