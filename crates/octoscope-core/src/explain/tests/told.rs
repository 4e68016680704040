//! What is said of single steps.

use super::*;

#[test]
fn the_sign_of_a_zero_is_told_of_a_direction_alone() {
    let ray = Ray::new([1.0, 0.125], [-1.0, -0.0]).unwrap();
    let check =
        |english, german| check_words(&ray, &along(Algorithm::Parametric), [english, german]);
    check(
        "A ray from (1, 0.125) along (−1, −0) is followed through the quadtree by the parametric algorithm.",
        "Ein Strahl von (1, 0.125) in Richtung (−1, −0) wird mit dem parametrischen Verfahren durch den Quadtree verfolgt.",
    );
    // (1 − 1) / −1
    check(
        "The ray starts inside the root: the last near plane does not come after t = 0, the first far plane does, t_x0 = 0 ≤ 0 < t_x1 = 1. Its direction is negative along x, so state i stands for child f(i) = i xor 2.",
        "Der Strahl beginnt innerhalb der Wurzel: Die letzte nahe Ebene kommt nicht nach t = 0, die erste ferne wohl, t_x0 = 0 ≤ 0 < t_x1 = 1. Entlang x ist seine Richtung negativ; Zustand i steht daher für Kind f(i) = i xor 2.",
    );
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
        "Child 0 is left at the x plane: t_xm = 0.625 < t_ym = 1, so the x bit is set: state 2.",
        "Kind 0 wird an der x-Ebene verlassen: t_xm = 0.625 < t_ym = 1, also wird das x-Bit 1: Zustand 2.",
    );
    check(
        "Child 0 is left at the x and y planes at once: t_xm = 0.5 = t_ym = 0.5, so their bits are set: state 3.",
        "Kind 0 wird an den Ebenen von x und y zugleich verlassen: t_xm = 0.5 = t_ym = 0.5, also werden ihre Bits 1: Zustand 3.",
    );
    check(
        "Child 2 is left at the x plane: t_x1 = 0.75 < t_ym = 1. In x it is the upper half, so the parent is done, too.",
        "Kind 2 wird an der x-Ebene verlassen: t_x1 = 0.75 < t_ym = 1. In x ist es die obere Hälfte: Auch der Elternknoten ist erledigt.",
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
            "State 2 is child 0, as f(2) = 2 xor 2 = 0; it is visited: the node (0, 0) of level 2.",
            "Zustand 2 ist Kind 0, denn f(2) = 2 xor 2 = 0; es wird besucht: Knoten (0, 0) auf Stufe 2.",
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
            "Die Codes unterscheiden sich zuerst in Bit 2, also liegt der gemeinsame Vorfahr auf Stufe 3.",
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

#[test]
fn a_child_that_is_touched_is_told_as_that() {
    let ray = Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::AllChildren),
        [
            "Leaf (0, 4) of level 2 is met in one point only, at t = 0.75.",
            "Blatt (0, 4) auf Stufe 2 wird nur in einem Punkt getroffen, bei t = 0.75.",
        ],
    );
}

#[test]
fn the_last_step_out_of_the_grid_leads_to_no_cell() {
    let ray = Ray::new([-0.25, 0.3125], [1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::Dda),
        [
            "t_xMax = 1.25 < t_yMax = ∞, so the ray crosses the x plane and leaves the grid.",
            "t_xMax = 1.25 < t_yMax = ∞, also kreuzt der Strahl die x-Ebene und verlässt das Raster.",
        ],
    );
}

#[test]
fn only_algorithms_with_states_speak_of_them() {
    let ray = Ray::new([1.25, 0.125], [-1.0, 0.0625]).unwrap();
    for algorithm in Algorithm::ALL {
        let tree = tree(3);
        let trace = record(&tree, &ray, &along(algorithm));
        let visits = trace.events.iter().any(|event| matches!(event, Event::Visit { .. }));
        for (language, word) in Language::ALL.into_iter().zip(["state", "Zustand"]) {
            let mut told = sentence::sentences(&tree, &ray, &trace, language);
            let speaks = told.any(|text| text.plain().contains(word));
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
            "Blatt (0, 4) auf Stufe 2 wird nur berührt, in einem Punkt bei t = 0.75.",
        ],
    );
}

#[test]
fn a_miss_is_told_by_its_reason() {
    let query = |segment_end| Query::Ray {
        algorithm: Algorithm::Parametric,
        options: Options { segment_end, ..Options::default() },
        arithmetic: Arithmetic::Doubles,
    };
    let check = |origin, direction, segment_end, expected| {
        check_words::<2>(&Ray::new(origin, direction).unwrap(), &query(segment_end), expected);
    };
    // No part of the line is in the root, although its first far plane is behind.
    check(
        [-1.0, 2.0],
        [1.0, 1.0],
        None,
        [
            "The ray misses the root: it meets a far plane no later than the last near plane, t_y1 = −1 < t_x0 = 1.",
            "Der Strahl verfehlt die Wurzel: Er trifft eine ferne Ebene nicht später als die letzte nahe, t_y1 = −1 < t_x0 = 1.",
        ],
    );
    check(
        [2.0, 1.75],
        [1.0, 1.0],
        None,
        [
            "The ray misses the root, which lies behind its origin: even the first far plane has t_x1 = −1 ≤ 0.",
            "Der Strahl verfehlt die Wurzel, die hinter seinem Startpunkt liegt: Schon für die erste ferne Ebene gilt t_x1 = −1 ≤ 0.",
        ],
    );
    check(
        [-1.0, 0.25],
        [1.0, 0.25],
        Some(0.5),
        [
            "The ray ends before it meets the root, whose last near plane has t_x0 = 1.",
            "Der Strahl endet, bevor er die Wurzel trifft, deren letzte nahe Ebene bei t_x0 = 1 liegt.",
        ],
    );
    check(
        [0.25, 0.25],
        [1.0, 0.25],
        Some(0.0),
        [
            "The ray misses the root: it ends at t = 0, no later than it begins.",
            "Der Strahl verfehlt die Wurzel: Er endet bei t = 0, nicht später, als er beginnt.",
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
            "Die Suche endet: Gefunden ist Knoten (4, 0) auf Stufe 2, ein Blatt.",
        ],
    );
    check(
        Query::Region { min: [0.1, 0.1], max: [0.3, 0.3], variants: Variants::NONE },
        [
            "The search ends: it has found the node (0, 0) of level 2, which has children.",
            "Die Suche endet: Gefunden ist Knoten (0, 0) auf Stufe 2, der Kinder hat.",
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
            "Die Suche endet: Gefunden ist Knoten (4, 0) auf Stufe 2, ein Blatt.",
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
fn a_point_is_told_in_short_with_its_digits_behind_it() {
    let third = 1.0 / 3.0;
    let ray = Ray::new([-0.25, third], [1.0, 0.0]).unwrap();
    let tree = tree(3);
    let trace = record(&tree, &ray, &along(Algorithm::Codes));
    let mut told = sentence::sentences(&tree, &ray, &trace, Language::English);
    let encoded = told.find(|text| text.plain().contains("near (")).unwrap();
    assert!(encoded.plain().contains("near (0, 0.3333), the ray"), "{}", encoded.plain());
    let whole: Vec<_> = encoded.0.iter().filter_map(|span| span.whole.clone()).collect();
    assert_eq!(whole, ["0.3333333333333333"]);
}

#[test]
fn a_cell_that_spans_the_next_side_is_told_to_need_no_link() {
    // Through the corner (0.5, 0.25), beyond which a large cell lies.
    let ray = Ray::new([0.375, 0.125], [0.25, 0.25]).unwrap();
    check_words(
        &ray,
        &along(Algorithm::SametNet),
        [
            "The link through the x side leads to the node (4, 0) of level 2. It spans what lies beyond the y side as well, so no other link is followed there.",
            "Der Verweis durch die x-Seite führt zu Knoten (4, 0) auf Stufe 2. Dieser reicht auch über die y-Seite hinaus, deshalb wird dort keinem weiteren Verweis gefolgt.",
        ],
    );
}

#[test]
fn the_child_that_is_done_is_the_one_that_was_gone_down_to() {
    fn check<const D: usize>() {
        let mut n_checked = BTreeMap::new();
        for_all_runs(|tree: &Tree<D>, ray, _, query| {
            let Query::Ray { algorithm, .. } = query else { return };
            let trace = record(tree, ray, query);
            let sentences = sentence::sentences(tree, ray, &trace, Language::English);
            let mut inside = Vec::new();
            // The first sentence is that before all events.
            for (event, told) in trace.events.iter().zip(sentences.skip(1)) {
                match *event {
                    Event::Visit { node, .. } | Event::Enter { node, .. } => inside.push(node),
                    Event::Up { node } => {
                        let done = inside.pop().unwrap();
                        let Some(child) = node.and_then(|_| tree.child_index(done)) else {
                            continue;
                        };
                        let told = told.plain();
                        let begins = told.starts_with(&format!("Child {} is ", child.0));
                        assert!(begins, "{query:?} {ray:?}: {child:?}, {told}");
                        *n_checked.entry(algorithm.id()).or_insert(0) += 1;
                    }
                    _ => {}
                }
            }
        });
        assert!(n_checked["all-children"] > 20, "{n_checked:?}");
        assert!(n_checked["parametric"] > 20, "{n_checked:?}");
    }
    check::<2>();
    check::<3>();
}
