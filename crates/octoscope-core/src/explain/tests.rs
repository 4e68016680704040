//! Laws and expectations of what is said.

use super::*;
use crate::event::Event;
use crate::geometry::Ray;
use crate::locate::{Direction, NeighbourMethod, Reach};
use crate::paper::counterexample;
use crate::progress::Progress;
use crate::query::{Arithmetic, PointMethod, Query};
use crate::random::Random;
use crate::scenario::{AnyScenario, Scenario};
use crate::text::Language;
use crate::trace::{Moment, record};
use crate::traverse::{Algorithm, Options, StopAt, Variant, Variants};
use crate::tree::{Cell, Domain, Split, Tree, build, grow};
use std::collections::{BTreeMap, BTreeSet};

/// Divides the cells along one diagonal; the last of them is full.
fn tree<const D: usize>(levels: u8) -> Tree<D> {
    let split = |cell: Cell<D>, ()| match cell.level {
        0 if cell.code == [2; D] => Split::Full(vec![0]),
        0 => Split::Empty,
        level if cell.code.iter().all(|c| c >> level == 2 >> level) => {
            Split::Inner(vec![(); 1 << D])
        }
        _ => Split::Empty,
    };
    grow(Domain::unit(levels), (), &Progress::default(), split).unwrap()
}

/// Rays that meet the corners of the tree's cells, miss it, or do neither.
fn rays<const D: usize>() -> Vec<Ray<D>> {
    let mut rays = vec![
        ([-0.25; D], [1.0; D]),
        ([1.25; D], [-1.0; D]),
        ([0.3; D], [1.0; D]),
        ([2.0; D], [1.0; D]),
        (std::array::from_fn(|e| 0.3 * e as f64 + 0.1), std::array::from_fn(|e| (e == 0).into())),
        ([-1.0; D], std::array::from_fn(|e| (e == 0).into())),
        (std::array::from_fn(|e| e as f64 - 0.5), std::array::from_fn(|e| 1.0 - e as f64 * 0.9)),
        // Meets the centre, from where an exit point pushed along one axis returns.
        (
            std::array::from_fn(|e| [1.875, 1.627, 0.55][e]),
            std::array::from_fn(|e| [-1.375, -1.127, 0.0][e]),
        ),
        // Touches a corner of the tree's cells, from outside their diagonal.
        (
            std::array::from_fn(|e| if e == 0 { 0.0 } else { 0.5 }),
            std::array::from_fn(|e| if e == 0 { 1.0 } else { -1.0 }),
        ),
    ];
    let mut random = Random::new(5);
    for _ in 0..24 {
        let origin = std::array::from_fn(|_| random.between(-0.5, 1.5));
        let direction = std::array::from_fn(|_| random.between(-1.0, 1.0));
        rays.push((origin, direction));
    }
    rays.into_iter().map(|(origin, direction)| Ray::new(origin, direction).unwrap()).collect()
}

/// Queries of every kind, by the name of their listing.
fn queries<const D: usize>() -> Vec<(&'static str, Query<D>)> {
    let mut queries = Vec::new();
    for algorithm in Algorithm::ALL {
        let own = |variant: &Variant| variant.belongs_to(algorithm);
        let variants = Variant::ALL.into_iter().filter(own).collect();
        for (stop_at, segment_end, variants) in [
            (StopAt::End, None, Variants::NONE),
            (StopAt::End, None, variants),
            (StopAt::End, Some(0.6), Variants::NONE),
            (StopAt::FirstFull, None, Variants::NONE),
        ] {
            let arithmetic = Arithmetic::Exact;
            let options = Options { stop_at, segment_end, variants };
            queries.push((algorithm.id(), Query::Ray { algorithm, options, arithmetic }));
        }
        for variant in Variant::ALL.into_iter().filter(own) {
            let options =
                Options { variants: [variant].into_iter().collect(), ..Options::default() };
            let arithmetic = Arithmetic::Doubles;
            queries.push((algorithm.id(), Query::Ray { algorithm, options, arithmetic }));
        }
    }
    for at in [[0.3; D], [0.5; D], [1.0; D]] {
        let point = |method, variants| Query::Point { at, method, variants };
        queries.push(("point-comparison", point(PointMethod::Comparison, Variants::NONE)));
        for variants in sets(&point(PointMethod::Codes, Variants::NONE)) {
            queries.push(("point-codes", point(PointMethod::Codes, variants)));
        }
    }
    for max in [0.3, 0.55, 0.9, 1.0] {
        let region = |variants| Query::Region { min: [0.26; D], max: [max; D], variants };
        for variants in sets(&region(Variants::NONE)) {
            queries.push(("region", region(variants)));
        }
    }
    for direction in Direction::all() {
        for reach in [Reach::EqualOrLarger, Reach::Leaf, Reach::EveryLeaf] {
            for (name, method) in [
                ("neighbour", NeighbourMethod::Codes),
                ("neighbour-tables", NeighbourMethod::Tables),
            ] {
                for (level, code) in [(0, [2; D]), (1, [2; D]), (2, [4; D])] {
                    let neighbour = |variants| Query::Neighbour {
                        level,
                        code,
                        direction,
                        reach,
                        method,
                        variants,
                    };
                    for variants in sets(&neighbour(Variants::NONE)) {
                        queries.push((name, neighbour(variants)));
                    }
                }
            }
        }
    }
    queries
}

/// No variant, every single one that the query takes, and all of them.
fn sets<const D: usize>(query: &Query<D>) -> Vec<Variants> {
    let own: Vec<Variant> = Variant::ALL.into_iter().filter(|&v| query.takes(v)).collect();
    let mut sets = vec![Variants::NONE, own.iter().copied().collect()];
    sets.extend(own.into_iter().map(|variant| Variants::NONE.with(variant)));
    sets
}

/// Calls `check` for every run of every query on sample trees.
fn for_all_runs<const D: usize>(mut check: impl FnMut(&Tree<D>, &Ray<D>, &str, &Query<D>)) {
    for levels in [0, 1, 3] {
        let tree = tree(levels);
        for (name, query) in queries() {
            let along_ray = matches!(query, Query::Ray { .. });
            for ray in rays().iter().take(if along_ray { usize::MAX } else { 1 }) {
                check(&tree, ray, name, &query);
            }
        }
    }
}

fn check_sentences<const D: usize>() {
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for language in Language::ALL {
            for step in 0..=trace.events.len() {
                let text = sentence(tree, ray, &trace, step, language).plain();
                let whole = text.ends_with('.') && text.len() > 10;
                let placed = !text.contains(['{', '}', '$', '\n']) && !text.contains("  ");
                let marks = text.chars().any(|c| ('\u{E000}'..='\u{E0FF}').contains(&c));
                assert!(whole && placed && !marks, "{query:?}, step {step}: {text}");
            }
        }
    });
}

#[test]
fn every_step_has_a_whole_sentence_in_both_languages() {
    check_sentences::<2>();
    check_sentences::<3>();
}

#[test]
fn every_event_has_a_line_and_every_line_an_event() {
    let mut reached: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    fn run<const D: usize>(reached: &mut BTreeMap<String, BTreeSet<&'static str>>) {
        for_all_runs::<D>(|tree, ray, name, query| {
            let labels = record(tree, ray, query).events.iter().map(label).collect::<Vec<_>>();
            reached.entry(name.to_owned()).or_default().extend(labels);
        });
    }
    run::<2>(&mut reached);
    run::<3>(&mut reached);
    for (name, query) in queries::<2>() {
        let lines = listing(&query, Language::English).lines;
        let labels: BTreeSet<&str> =
            lines.iter().map(|line| line.label).filter(|label| !label.is_empty()).collect();
        assert_eq!(labels, reached[name], "{name}");
    }
}

#[test]
fn listings_fit_their_panel_and_are_commented_in_both_languages() {
    for (name, query) in queries::<2>() {
        let [english, german] = Language::ALL.map(|language| listing(&query, language).lines);
        for (line, translated) in english.iter().zip(&german) {
            let width = line.code.chars().count() + 2 * usize::from(line.indent);
            assert!(width <= 44, "{name}: {}", line.code);
            assert_eq!(line.comment.is_empty(), translated.comment.is_empty(), "{}", line.code);
        }
    }
}

fn check_variables<const D: usize>() {
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for step in 0..=trace.events.len() {
            let variables = variables(tree, &Moment::after(tree, &trace, step));
            let names: BTreeSet<String> = variables.iter().map(|v| v.name.plain()).collect();
            assert_eq!(names.len(), variables.len(), "{query:?}, step {step}: {variables:?}");
            assert!(variables.iter().all(|v| !v.value.plain().is_empty()));
        }
    });
}

#[test]
fn variables_have_a_name_of_their_own_and_a_value() {
    check_variables::<2>();
    check_variables::<3>();
}

/// Checks that a run is told with these words, in English and in German.
fn check_words<const D: usize>(ray: &Ray<D>, query: &Query<D>, expected: [&str; 2]) {
    let tree = tree(3);
    let trace = record(&tree, ray, query);
    for (language, expected) in Language::ALL.into_iter().zip(expected) {
        let told: Vec<String> = (0..=trace.events.len())
            .map(|step| sentence(&tree, ray, &trace, step, language).plain())
            .collect();
        assert!(told.iter().any(|text| text == expected), "{}", told.join("\n"));
    }
}

fn along(algorithm: Algorithm) -> Query<2> {
    let (options, arithmetic) = (Options::default(), Arithmetic::Doubles);
    Query::Ray { algorithm, options, arithmetic }
}

#[test]
fn a_ray_is_told_with_its_numbers() {
    let ray = Ray::new([-0.25, 0.125], [1.0, 0.25]).unwrap();
    let check =
        |english, german| check_words(&ray, &along(Algorithm::Parametric), [english, german]);
    check(
        "A ray from (−0.25, 0.125) along (1, 0.25) is followed through the quadtree by the parametric algorithm.",
        "Ein Strahl von (−0.25, 0.125) in Richtung (1, 0.25) wird mit dem parametrischen Verfahren durch den Quadtree verfolgt.",
    );
    check(
        "Child 0 is left through the x plane: t_x1 = 0.625 < t_y1 = 1, so the x bit is set and the next state is 2.",
        "Kind 0 wird durch die x-Ebene verlassen: t_x1 = 0.625 < t_y1 = 1, also wird das x-Bit gesetzt, und der nächste Zustand ist 2.",
    );
    check(
        "Child 0 is left through the x and y planes at once: t_x1 = 0.5 = t_y1 = 0.5, so the x and y bits are set together and the next state is 3.",
        "Kind 0 wird durch die Ebenen von x und y zugleich verlassen: t_x1 = 0.5 = t_y1 = 0.5, also werden die Bits von x und y zusammen gesetzt, und der nächste Zustand ist 3.",
    );
    check(
        "Child 2 is left through the x plane: t_x1 = 0.75 < t_y1 = 1. In x that is the upper half already, so the ray leaves the parent, too.",
        "Kind 2 wird durch die x-Ebene verlassen: t_x1 = 0.75 < t_y1 = 1. In x ist das schon die obere Hälfte, also verlässt der Strahl auch den Elternknoten.",
    );
    check(
        "The ray has left the root: the traversal ends after 4 leaves.",
        "Der Strahl hat die Wurzel verlassen: Die Traversierung endet nach 4 Blättern.",
    );
}

#[test]
fn an_entry_past_a_mid_plane_is_told_by_its_bit() {
    // The ray meets x = 0.5 at t = 0.375, but z = 0 only at t = 1.
    let ray = Ray::new([0.3125, 0.0, -1.0], [0.5, 0.25, 1.0]).unwrap();
    let query = Query::Ray {
        algorithm: Algorithm::Parametric,
        options: Options::default(),
        arithmetic: Arithmetic::Doubles,
    };
    check_words(
        &ray,
        &query,
        [
            "t_xm = 0.375 < t_z0 = 1, so the x bit is 1: the ray enters in the upper x half, in state 4.",
            "t_xm = 0.375 < t_z0 = 1, also ist das x-Bit 1: Der Strahl tritt in der oberen x-Hälfte ein, im Zustand 4.",
        ],
    );
}

#[test]
fn a_mirrored_state_is_told_with_its_child() {
    let ray = Ray::new([1.25, 0.125], [-1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::Parametric),
        [
            "State 2 is child 0 of the tree, as f(2) = 2 xor 2; it is visited: the node (0, 0) of level 2.",
            "Zustand 2 ist Kind 0 des Baumes, denn f(2) = 2 xor 2; es wird besucht: Knoten (0, 0) auf Ebene 2.",
        ],
    );
}

#[test]
fn codes_are_told_by_their_bits() {
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::Codes),
        [
            "The codes differ first in bit 2, so the common ancestor has level 3.",
            "Die Codes unterscheiden sich zuerst in Bit 2, also liegt der gemeinsame Vorfahr auf Ebene 3.",
        ],
    );
}

#[test]
fn the_codes_of_a_ray_are_those_of_the_cell_that_it_goes_on_into() {
    // The ray comes in from above: the point itself lies outside the domain.
    let ray = Ray::new([0.25, 1.25], [0.125, -1.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::Codes),
        [
            "Just after t = 0.25, near (0.28125, 1), the ray is in the smallest cell with the location codes (010, 111) in binary.",
            "Unmittelbar nach t = 0.25, nahe (0.28125, 1), ist der Strahl in der kleinsten Zelle mit den Ortscodes (010, 111), binär geschrieben.",
        ],
    );
    let query =
        Query::Point { at: [0.3, 0.9], method: PointMethod::Codes, variants: Variants::NONE };
    check_words(
        &ray,
        &query,
        [
            "The point (0.3, 0.9) has the location codes (010, 111) in binary.",
            "Der Punkt (0.3, 0.9) hat binär die Ortscodes (010, 111).",
        ],
    );
}

fn with(algorithm: Algorithm, variant: Variant) -> Query<2> {
    let options = Options { variants: Variants::NONE.with(variant), ..Options::default() };
    Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles }
}

#[test]
fn the_gem_is_told_by_what_it_compared() {
    let gem = with(Algorithm::Bsp, Variant::Gem);
    let check = |origin, direction, expected| {
        check_words(&Ray::new(origin, direction).unwrap(), &gem, expected);
    };
    // In the plane, along it: 0/0.
    check(
        [0.5, -0.25],
        [0.0, 1.0],
        [
            "t_xm = NaN is no number, so that no comparison with 1.25, 0 or 0.25 holds: the gem takes both halves, first the lower x half; the other one waits on the stack.",
            "t_xm = NaN ist keine Zahl, sodass kein Vergleich mit 1.25, 0 oder 0.25 zutrifft: Das Gem nimmt beide Hälften, zuerst die untere x-Hälfte; die andere wartet auf dem Stapel.",
        ],
    );
    // From the plane, away from it: −0 is not less than 0.
    check(
        [0.5, 0.25],
        [-1.0, 0.0],
        [
            "t_xm = −0 is neither greater than 0.5 nor less than 0 or 0: the gem takes both halves, first the lower x half; the other one waits on the stack.",
            "t_xm = −0 ist weder größer als 0.5 noch kleiner als 0 oder 0: Das Gem nimmt beide Hälften, zuerst die untere x-Hälfte; die andere wartet auf dem Stapel.",
        ],
    );
    check(
        [0.75, 0.25],
        [1.0, 0.0],
        [
            "t_xm = −0.25 < 0: the gem takes the half on the side of the origin alone, the upper x half.",
            "t_xm = −0.25 < 0: Das Gem nimmt nur die Hälfte auf der Seite des Startpunkts, die obere x-Hälfte.",
        ],
    );
}

#[test]
fn the_first_sentence_names_the_rules_in_another_form() {
    let ray = Ray::new([0.1, 0.2], [1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &with(Algorithm::Bsp, Variant::Gem),
        [
            "A ray from (0.1, 0.2) along (1, 0) is followed through the quadtree by binary space partition. Rules in another form: gem.",
            "Ein Strahl von (0.1, 0.2) in Richtung (1, 0) wird mit binärer Raumteilung durch den Quadtree verfolgt. Regeln in anderer Form: gem.",
        ],
    );
}

#[test]
fn of_planes_met_at_once_the_one_that_counts_is_told() {
    let ray = Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap();
    check_words(
        &ray,
        &with(Algorithm::Dda, Variant::OneByOne),
        [
            "t_xmax = 0.375 = t_ymax = 0.375, so the ray crosses the x plane: on to cell (1, 0). Of equal parameters the first axis counts.",
            "t_xmax = 0.375 = t_ymax = 0.375, also kreuzt der Strahl die x-Ebene: weiter zu Zelle (1, 0). Von gleichen Parametern zählt die erste Achse.",
        ],
    );
    check_words(
        &ray,
        &along(Algorithm::ParametricTable),
        [
            "Child 0 is left through the y plane: t_y1 = 0.75 = t_x1 = 0.75, so the y bit is set and the next state is 1. Of equal parameters the last axis counts.",
            "Kind 0 wird durch die y-Ebene verlassen: t_y1 = 0.75 = t_x1 = 0.75, also wird das y-Bit gesetzt, und der nächste Zustand ist 1. Von gleichen Parametern zählt die letzte Achse.",
        ],
    );
}

#[test]
fn a_child_that_is_touched_is_told_as_that() {
    let ray = Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::AllChildren),
        [
            "Leaf (0, 4) of level 2 is met in one point only, at t = 0.75.",
            "Blatt (0, 4) auf Ebene 2 wird nur in einem Punkt getroffen, bei t = 0.75.",
        ],
    );
}

#[test]
fn an_exit_point_is_pushed_then_encoded_then_compared_with_the_border() {
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.0]).unwrap();
    let trace = record(&tree(3), &ray, &with(Algorithm::Glassner, Variant::Push));
    let labels: Vec<_> = trace.events.iter().map(label).collect();
    let at: Vec<usize> = (0..labels.len()).filter(|&n| labels[n] == "push").collect();
    let (last, others) = at.split_last().unwrap();
    assert!(others.iter().all(|&n| labels[n + 1..].starts_with(&["encode", "border", "begin"])));
    assert_eq!(labels[last + 1..], ["border", "end"]);
}

#[test]
fn the_listing_of_the_octree_grid_follows_its_events() {
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.1]).unwrap();
    let query = along(Algorithm::DdaOctree);
    let trace = record(&tree(3), &ray, &query);
    let lines = listing(&query, Language::English).lines;
    // Lines of the loop and behind it, in order, each label once.
    let mut order: Vec<&str> = lines.iter().map(|line| line.label).collect();
    order.retain(|label| !label.is_empty());
    order.dedup();
    assert_eq!(
        order,
        [
            "clip",
            "missed",
            "grid",
            "begin",
            "follow",
            "leaf",
            "touch",
            "stop",
            "segment-end",
            "cross",
            "leaf",
            "end"
        ]
    );
    let mut labels: Vec<_> = trace.events.iter().map(label).collect();
    labels.dedup();
    assert_eq!(labels[..5], ["clip", "grid", "begin", "follow", "cross"]);
    assert_eq!(labels[labels.len() - 3..], ["cross", "leaf", "end"]);
}

#[test]
fn the_last_step_out_of_the_grid_leads_to_no_cell() {
    let ray = Ray::new([-0.25, 0.3125], [1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::Dda),
        [
            "t_xmax = 1.25 < t_ymax = ∞, so the ray crosses the x plane and leaves the grid.",
            "t_xmax = 1.25 < t_ymax = ∞, also kreuzt der Strahl die x-Ebene und verlässt das Raster.",
        ],
    );
}

#[test]
fn what_is_reconstructed_is_listed_as_that() {
    for algorithm in Algorithm::ALL {
        let lines = listing(&along(algorithm), Language::English).lines;
        let says_so = lines.iter().any(|line| line.code.contains("a reconstruction"));
        let is_one = matches!(algorithm, Algorithm::SametCorner | Algorithm::SametNet);
        assert_eq!(says_so, is_one, "{algorithm:?}");
    }
}

#[test]
fn mid_planes_that_are_means_are_told_as_that() {
    check_words(
        &Ray::new([-0.25, 0.125], [1.0, 0.25]).unwrap(),
        &with(Algorithm::ParametricTable, Variant::Averaged),
        [
            "The ray meets the mid planes of the node at t_xm = 0.75 and t_ym = 1.5. These are the means of the parameters of the near and far planes.",
            "Der Strahl trifft die Mittelebenen des Knotens bei t_xm = 0.75 und t_ym = 1.5. Das sind die Mittel der Parameter der nahen und fernen Ebenen.",
        ],
    );
}

#[test]
fn only_algorithms_with_states_speak_of_them() {
    let ray = Ray::new([1.25, 0.125], [-1.0, 0.0625]).unwrap();
    for algorithm in Algorithm::ALL {
        let trace = record(&tree(3), &ray, &along(algorithm));
        let visits = trace.events.iter().any(|event| matches!(event, Event::Visit { .. }));
        for (language, word) in Language::ALL.into_iter().zip(["state", "Zustand"]) {
            let told = sentence::sentences(&tree(3), &ray, &trace, language);
            let speaks = told.iter().any(|text| text.plain().contains(word));
            assert_eq!(speaks, visits, "{algorithm:?}");
        }
    }
    check_words(
        &ray,
        &along(Algorithm::Codes),
        [
            "The ray crosses the root: it meets the last near plane before the first far plane, t_x0 = 0.25 < t_x1 = 1.25. Its direction is negative along x, so the far planes there are the lower ones.",
            "Der Strahl durchquert die Wurzel: Er trifft die letzte nahe Ebene vor der ersten fernen, t_x0 = 0.25 < t_x1 = 1.25. Entlang x ist seine Richtung negativ; dort sind daher die unteren Ebenen die fernen.",
        ],
    );
    check_words(
        &ray,
        &along(Algorithm::Hero),
        [
            "The ray crosses the root: it meets the last near plane before the first far plane, t_x0 = 0.25 < t_x1 = 1.25. Its direction is negative along x, so the upper half comes first there: the mask is 2.",
            "Der Strahl durchquert die Wurzel: Er trifft die letzte nahe Ebene vor der ersten fernen, t_x0 = 0.25 < t_x1 = 1.25. Entlang x ist seine Richtung negativ; dort kommt daher die obere Hälfte zuerst: Die Maske ist 2.",
        ],
    );
}

#[test]
fn a_miss_beside_the_root_and_a_touch_are_told() {
    let beside = Ray::new([0.0, 2.0], [1.0, 0.0]).unwrap();
    check_words(
        &beside,
        &along(Algorithm::Parametric),
        [
            "The ray misses the root: it does not move along y, and its origin lies outside there.",
            "Der Strahl verfehlt die Wurzel: Entlang y bewegt er sich nicht, und sein Startpunkt liegt dort außerhalb.",
        ],
    );
    let diagonal = Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap();
    check_words(
        &diagonal,
        &along(Algorithm::ParametricTable),
        [
            "Leaf (0, 4) of level 2 is only touched, in one point at t = 0.75.",
            "Blatt (0, 4) auf Ebene 2 wird nur berührt, in einem Punkt bei t = 0.75.",
        ],
    );
}

#[test]
fn the_end_of_a_search_names_what_was_found() {
    let ray = Ray::new([0.0, 0.0], [1.0, 0.0]).unwrap();
    let check = |query, expected| check_words::<2>(&ray, &query, expected);
    check(
        Query::Point { at: [0.9, 0.1], method: PointMethod::Codes, variants: Variants::NONE },
        [
            "The search ends: it has found the node (4, 0) of level 2, a leaf.",
            "Die Suche endet: Gefunden ist Knoten (4, 0) auf Ebene 2, ein Blatt.",
        ],
    );
    check(
        Query::Region { min: [0.1, 0.1], max: [0.3, 0.3], variants: Variants::NONE },
        [
            "The search ends: it has found the node (0, 0) of level 2, which has children.",
            "Die Suche endet: Gefunden ist Knoten (0, 0) auf Ebene 2, der Kinder hat.",
        ],
    );
    let beyond = |code, direction| Query::Neighbour {
        level: 2,
        code,
        direction: Direction::new(direction).unwrap(),
        reach: Reach::EqualOrLarger,
        method: NeighbourMethod::Codes,
        variants: Variants::NONE,
    };
    check(
        beyond([0, 0], [1, 0]),
        [
            "The search ends: it has found the node (4, 0) of level 2, a leaf.",
            "Die Suche endet: Gefunden ist Knoten (4, 0) auf Ebene 2, ein Blatt.",
        ],
    );
    check(
        beyond([4, 0], [1, -1]),
        [
            "The search ends: along x and y the neighbour would lie outside the domain, so there is none.",
            "Die Suche endet: Entlang x und y läge der Nachbar außerhalb des Gebiets, es gibt also keinen.",
        ],
    );
}

#[test]
fn the_first_sentence_tells_no_key_of_the_window() {
    for_all_runs::<2>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for language in Language::ALL {
            let text = sentence(tree, ray, &trace, 0, language).plain();
            assert!(!text.contains('→'), "{text}");
        }
    });
}

/// The sentences of the counterexample of a variant, in English.
fn printed(variant: Variant) -> Vec<String> {
    fn of<const D: usize>(scenario: &Scenario<D>) -> Vec<String> {
        let (content, domain) = (scenario.source.content().unwrap(), scenario.grid().unwrap());
        let tree = build(&content, domain, &scenario.recipe, &Progress::default()).unwrap();
        let trace = record(&tree, &scenario.ray, &scenario.query);
        let sentences = sentence::sentences(&tree, &scenario.ray, &trace, Language::English);
        sentences.iter().map(RichText::plain).collect()
    }
    match counterexample(variant) {
        AnyScenario::Quadtree(scenario) => of(&scenario),
        AnyScenario::Octree(scenario) => of(&scenario),
    }
}

#[test]
fn steps_by_a_printed_rule_say_so() {
    for (variant, expected) in [
        (Variant::B1, "By the printed rule, B-1, the root is hit, from t = 0 to t = 3."),
        (Variant::B2, "By the printed rule, B-2, the ray enters in state 1."),
        (Variant::B3, "By the printed rule, B-3, the ray enters in state 0."),
        (Variant::B24b, "So says the printed rule, B-24b."),
        (Variant::B28, "So says the printed rule, B-28."),
    ] {
        let sentences = printed(variant);
        assert!(sentences.iter().any(|text| text.ends_with(expected)), "{sentences:#?}");
    }
    for variant in Variant::ALL.into_iter().filter(|variant| variant.is_misprint()) {
        let named = format!("printed rule, {}", variant.id());
        assert!(printed(variant).iter().any(|text| text.contains(&named)), "{named}");
    }
}
