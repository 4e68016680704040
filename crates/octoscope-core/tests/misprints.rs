//! Every rule as once printed fails on its counterexample as described, and
//! right rules do not.

use octoscope_core::event::{End, Event};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{Direction, Reach, locate_by_codes_as_printed, neighbour_as_printed};
use octoscope_core::paper::counterexample;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scenario::AnyScenario;
use octoscope_core::trace::{Trace, record};
use octoscope_core::traverse::{Algorithm, Method, Options, Variant, Variants};
use octoscope_core::tree::{Child, Domain, Split, Tree, grow};

/// Tree that is divided down to level 0.
fn full<const D: usize>(root_level: u8) -> Tree<D> {
    divided(Domain::unit(root_level))
}

/// The same over `domain`.
fn divided<const D: usize>(domain: Domain<D>) -> Tree<D> {
    grow(domain, (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); Child::<D>::COUNT]),
    })
    .expect("nobody cancels")
}

fn run<const D: usize>(
    tree: &Tree<D>,
    origin: [f64; D],
    direction: [f64; D],
    id: &str,
) -> Trace<D> {
    let Method { algorithm, variants } = id.parse().expect(id);
    let ray = Ray::new(origin, direction).expect("the numbers make a ray");
    let options = Options { variants, ..Options::default() };
    record(tree, &ray, &Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles })
}

/// Runs misprint `id` and the right rules in the children of the unit cube;
/// the visited children must be these.
#[track_caller]
fn check<const D: usize>(
    id: &str,
    origin: [f64; D],
    direction: [f64; D],
    [printed, right]: [&[u8]; 2],
) {
    check_in(Domain::unit(1), id, origin, direction, [printed, right]);
}

#[track_caller]
fn check_in<const D: usize>(
    domain: Domain<D>,
    id: &str,
    origin: [f64; D],
    direction: [f64; D],
    [printed, right]: [&[u8]; 2],
) {
    let tree = divided(domain);
    let children = |id: &str| -> Vec<u8> {
        let trace = run(&tree, origin, direction, id);
        trace
            .leaves()
            .map(|(leaf, _)| tree.child_index(leaf).expect("the root is divided").0)
            .collect()
    };
    assert_eq!(children(id), printed, "{id}");
    let (algorithm, _) = id.split_once('@').expect(id);
    assert_eq!(children(algorithm), right, "{algorithm}");
    assert_eq!(children("exhaustive"), right);
}

/// States in which the children of the root are visited.
fn states<const D: usize>(origin: [f64; D], direction: [f64; D], id: &str) -> Vec<u8> {
    let trace = run(&divided(Domain::unit(1)), origin, direction, id);
    let state_of = |event: &Event<D>| match event {
        Event::Visit { state, .. } => state.map(|state| state.0),
        _ => None,
    };
    trace.events.iter().filter_map(state_of).collect()
}

const BOTH: [&str; 2] = ["parametric", "parametric-table"];

#[test]
fn b_1_calls_every_miss_a_hit() {
    for base in BOTH {
        check(&format!("{base}@B-1"), [-2.0, 0.0], [1.0, 1.0], [&[1], &[]]);
    }
    let trace = run(&divided(Domain::unit(1)), [-2.0, 0.0], [1.0, 1.0], "parametric@B-1");
    assert!(matches!(trace.events[0], Event::Clip { enter: 0.0, exit: 3.0, hit: true, .. }));
}

#[test]
fn b_2_takes_a_wrong_first_child_and_loses_a_leaf() {
    let (origin, direction) = ([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0]);
    for base in BOTH {
        let id = format!("{base}@B-2");
        check(&id, origin, direction, [&[5], &[4, 5]]);
        assert_eq!(states(origin, direction, &id), [1, 5]);
    }
}

#[test]
fn b_2_in_morton_order_enters_rightly_and_goes_on_wrongly() {
    let (origin, direction) = ([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0]);
    for base in BOTH {
        let id = format!("{base}@B-2-morton");
        // State 1 is read as x = 1; Table 3 takes its bit for that of z and ends.
        check(&id, origin, direction, [&[4], &[4, 5]]);
        assert_eq!(states(origin, direction, &id), [1]);
        // From state 0 Table 3 leads through the z plane to 1, which is read as x = 1:
        // a child that is entered long after it is left.
        let up = ([0.25, 0.25, -1.0], [0.0625, 0.0625, 1.0]);
        check(&id, up.0, up.1, [&[0], &[0, 1]]);
        assert_eq!(states(up.0, up.1, &id), [0, 1]);
        // The mask has x as its highest bit, but is read likewise: 4 is z = 1.
        let down = ([0.75, 0.25, -1.0], [-0.0625, 0.0625, 1.0]);
        check(&id, down.0, down.1, [&[1], &[4, 5]]);
        assert_eq!(states(down.0, down.1, &id), [0, 1]);
        // There is no Table 2 in the plane.
        let of_base = format!("{base}@B-2-morton");
        check(&of_base, [-1.0, 0.1], [1.0, 0.1], [&[0, 2], &[0, 2]]);
    }
}

#[test]
fn b_3_selects_the_wrong_children_and_none_along_the_diagonal() {
    for base in BOTH {
        let id = format!("{base}@B-3");
        check(&id, [-1.0, 0.1], [1.0, 0.1], [&[0, 1, 3], &[0, 2]]);
        check(&id, [-1.0, -1.0], [1.0, 1.0], [&[], &[0, 3]]);
    }
}

#[test]
fn b_4_puts_the_mid_plane_on_the_near_plane() {
    for base in BOTH {
        let id = format!("{base}@B-4");
        check(&id, [-1.0, 0.1], [1.0, 0.1], [&[3], &[0, 2]]);
    }
}

#[test]
fn b_5_hits_the_root_from_its_upper_face() {
    for base in BOTH {
        let id = format!("{base}@B-5");
        check(&id, [1.0, 0.25, -1.0], [0.0, 0.0, 1.0], [&[4, 5], &[]]);
        check(&id, [0.5, 0.25, -1.0], [0.0, 0.0, 1.0], [&[0, 1], &[4, 5]]);
    }
}

/// Parameters of the root's planes across x, near and far, for rays along z.
fn clip_along_x(x: f64, id: &str) -> [f64; 2] {
    let trace = run(&divided(Domain::unit(1)), [x, 0.25, -1.0], [0.0, 0.0, 1.0], id);
    let Event::Clip { near, far, .. } = trace.events[0] else { panic!("a walk begins with it") };
    [near[0], far[0]]
}

#[test]
fn b_5_leaves_0_by_0_open_where_half_open_cells_settle_it() {
    let infinity = f64::INFINITY;
    for base in BOTH {
        // The origin on the lower face, in the middle, on the upper face of the root.
        assert_eq!(clip_along_x(0.0, base), [-infinity, infinity]);
        assert_eq!(clip_along_x(0.5, base), [-infinity, infinity]);
        // The far plane of the upper face is passed already.
        assert_eq!(clip_along_x(1.0, base), [-infinity, -infinity]);
        let printed = format!("{base}@B-5");
        let [near, far] = clip_along_x(0.0, &printed);
        assert!(near.is_nan() && far == infinity);
        assert_eq!(clip_along_x(0.5, &printed), [-infinity, infinity]);
        let [near, far] = clip_along_x(1.0, &printed);
        assert!(near == -infinity && far.is_nan());
        check(&printed, [0.0, 0.25, -1.0], [0.0, 0.0, 1.0], [&[0, 1], &[0, 1]]);
    }
}

#[test]
fn b_6_finds_no_number_for_the_mid_plane_of_an_axis_at_rest() {
    for base in BOTH {
        let mids = |id: &str| {
            let tree = divided(Domain::unit(1));
            let trace = run(&tree, [0.75, 0.75, -1.0], [0.0, 0.0, 1.0], id);
            let mid = trace.events.iter().find_map(|event| match event {
                Event::Halve { mid, .. } => Some(*mid),
                _ => None,
            });
            mid.expect("the root is halved")
        };
        assert_eq!(mids(base), [f64::NEG_INFINITY, f64::NEG_INFINITY, 1.5]);
        let [x, y, z] = mids(&format!("{base}@B-6"));
        assert!(x.is_nan() && y.is_nan() && z == 1.5);
        // In motion along every axis eq. 13 is right.
        let (origin, direction) = ([-1.0, 0.125, 0.25], [1.0, 0.125, 0.0625]);
        let printed = format!("{base}@B-6");
        check(&printed, origin, direction, [&[0, 4], &[0, 4]]);
    }
}

#[test]
fn b_6_puts_rays_along_an_axis_into_the_lower_halves() {
    for base in BOTH {
        let id = format!("{base}@B-6");
        check(&id, [0.75, 0.75, -1.0], [0.0, 0.0, 1.0], [&[0, 1], &[6, 7]]);
    }
}

#[test]
fn b_7_mirrors_a_root_away_from_zero_to_another_place() {
    let domain = || Domain::new([1.0, 1.0], 2.0, 1).unwrap();
    for base in BOTH {
        let id = format!("{base}@B-7");
        check_in(domain(), &id, [4.0, 1.25], [-1.0, 0.5], [&[3], &[2, 3, 1]]);
        // A root at 0 is mirrored about its centre all the same.
        check(&id, [1.5, 0.125], [-1.0, 0.5], [&[2, 3, 1], &[2, 3, 1]]);
    }
}

#[test]
fn b_9_walks_to_the_last_child_from_the_first() {
    let (origin, direction) = ([0.625, 0.75, 0.875], [1.0; 3]);
    check("parametric@B-9", origin, direction, [&[7], &[7]]);
    assert_eq!(states(origin, direction, "parametric@B-9"), [0, 1, 3, 7]);
    assert_eq!(states(origin, direction, "parametric"), [7]);
    assert_eq!(states(origin, direction, "parametric-table"), [0, 1, 3, 7]);
    assert_eq!(states([0.75; 3], [1.0; 3], "parametric@B-9,one-by-one"), [0, 4, 6, 7]);
    assert!("parametric-table@B-9".parse::<Method>().is_err());
}

#[test]
fn what_mid_planes_are_compared_with_has_the_name_of_its_value() {
    let (origin, direction) = ([0.625, 0.75, 0.875], [1.0; 3]);
    for id in ["parametric", "parametric@B-9", "parametric@B-10", "parametric-table"] {
        let trace = run(&full(1), origin, direction, id);
        let first = trace.events.iter().find_map(|event| match *event {
            Event::First { entry, entry_axis, .. } => Some((entry, entry_axis)),
            _ => None,
        });
        // The near plane of x is the last one; only by the right rules it begins at 0.
        let expected = if id == "parametric" { (0.0, None) } else { (-origin[0], Some(0)) };
        assert_eq!(first, Some(expected), "{id}");
    }
}

#[test]
fn b_10_reports_what_lies_behind_the_origin() {
    for base in BOTH {
        let id = format!("{base}@B-10");
        check(&id, [2.0; 3], [1.0; 3], [&[0, 7], &[]]);
        let (origin, direction) = ([0.75, 0.75, 0.328_125], [1.0, 0.5, 0.0625]);
        check(&id, origin, direction, [&[0, 2, 6], &[6]]);
    }
}

#[test]
fn b_11_takes_touching_for_crossing() {
    for base in BOTH {
        let id = format!("{base}@B-11");
        check(&id, [0.0, 2.0], [1.0, -1.0], [&[3], &[]]);
        check(&id, [1.0, -1.0], [0.0, 1.0], [&[2, 3], &[]]);
    }
    check("parametric-table@B-11", [-1.0; 3], [1.0; 3], [&[0, 1, 3, 7], &[0, 7]]);
}

#[test]
fn misprints_are_named_in_capitals_or_not() {
    assert_eq!("parametric@b-2,b-10".parse::<Method>().unwrap().to_string(), "parametric@B-2,B-10");
    assert!("hero@B-2".parse::<Method>().is_err());
}

#[test]
fn variants_of_other_rules_do_nothing() {
    let tree = full::<3>(2);
    for origin in [[-0.25, 0.1, 0.3], [-1e9, -1e9 + 0.1, -1e9 + 0.2]] {
        let ray = Ray::new(origin, [1.0, 1.0, 1.0]).expect("the numbers make a ray");
        for algorithm in Algorithm::ALL {
            for arithmetic in [Arithmetic::Doubles, Arithmetic::Exact] {
                let options = Options::default();
                let query = Query::Ray { algorithm, options, arithmetic };
                let right = record(&tree, &ray, &query);
                for variant in Variant::ALL.into_iter().filter(|&v| !query.takes(v)) {
                    let query = query.with_variants(Variants::NONE.with(variant));
                    let trace = record(&tree, &ray, &query);
                    assert_eq!(trace.events, right.events, "{algorithm:?} {variant:?}");
                }
            }
        }
    }
}

#[test]
fn misprints_mirror_a_root_away_from_zero_as_the_right_rules_do() {
    let domain = || Domain::new([1.0; 3], 2.0, 1).unwrap();
    check_in(domain(), "parametric@B-10", [0.0; 3], [-1.0; 3], [&[7, 0], &[]]);
    let (origin, direction) = ([1.5, 1.5, -1.0], [-0.0625, 0.0625, 1.0]);
    check_in(domain(), "parametric-table@B-2", origin, direction, [&[1], &[0, 1]]);
}

// Queries without a ray.

/// Level and code of what `variant` finds in its counterexample, and of what
/// the right rules find.
fn found(id: &str) -> [Option<(u8, [u32; 2])>; 2] {
    let variant: Variant = id.parse().expect(id);
    let AnyScenario::Quadtree(scenario) = counterexample(variant) else { panic!("{id}") };
    let tree = scenario.tree().expect("few cells");
    [scenario.query, scenario.query.corrected()].map(|query| {
        let node = query.run(&tree, &scenario.ray, &mut ()).node?;
        Some((tree.level(node), tree.code(node)))
    })
}

#[test]
fn b_18_reads_the_code_of_another_cell() {
    assert_eq!(found("B-18"), [Some((0, [0, 0])), Some((0, [1, 1]))]);
    // 001000 read from the right is 000100.
    let tree = full::<1>(5);
    let variants = Variants::NONE.with(Variant::B18);
    let outcome = locate_by_codes_as_printed(&tree, [0.25], variants, &mut ());
    assert_eq!(tree.code(outcome.node.expect("inside")), [0b00_0100]);
}

#[test]
fn b_19_reads_the_bit_above() {
    assert_eq!(found("B-19"), [Some((0, [0, 0])), Some((0, [1, 1]))]);
}

#[test]
fn b_21_puts_the_upper_face_into_the_leftmost_cell() {
    assert_eq!(found("B-21"), [Some((0, [0, 0])), None]);
}

#[test]
fn b_24_misses_the_level_or_the_place_of_a_region() {
    let right = Some((2, [4, 8]));
    assert_eq!(found("B-24a"), [Some((1, [4, 8])), right]);
    assert_eq!(found("B-24b"), [Some((0, [5, 9])), right]);
    let [printed, corrected] = found("B-24c");
    assert_eq!(printed.map(|(_, code)| code), Some([0, 0]));
    assert_eq!(corrected, right);
}

#[test]
fn b_25_stays_at_the_cell() {
    for id in ["B-25-leftmost", "B-25-rightmost"] {
        let [printed, right] = found(id);
        assert!(printed.is_some_and(|(_, [x, _])| x < 2), "{id}: {printed:?}");
        assert_eq!(right, Some((1, [2, 0])), "{id}");
    }
}

/// How often of all face neighbours of a full tree with 5 levels below the root
/// `variant` finds no or another ancestor.
fn wrong_climbs(variant: Variant) -> [usize; 2] {
    let tree = full::<1>(5);
    let (mut wrong, mut all) = (0, 0);
    for node in tree.nodes() {
        for direction in Direction::all() {
            let climbs = |variants| {
                let mut events = Vec::new();
                neighbour_as_printed(
                    &tree,
                    node.id,
                    direction,
                    Reach::EqualOrLarger,
                    variants,
                    &mut events,
                );
                let outside = events.iter().any(|event| matches!(event, Event::End(End::Outside)));
                let climb = |event: &&Event<1>| matches!(event, Event::Climb { .. });
                (!outside).then(|| events.iter().filter(climb).count())
            };
            let (right, printed) = (climbs(Variants::NONE), climbs(Variants::NONE.with(variant)));
            all += usize::from(right.is_some());
            wrong += usize::from(right != printed);
        }
    }
    [wrong, all]
}

#[test]
fn b_25_is_wrong_nearly_always() {
    assert_eq!(wrong_climbs(Variant::B25Leftmost), [114, 114]);
    assert_eq!(wrong_climbs(Variant::B25Rightmost), [108, 114]);
}

#[test]
fn b_28_jumps_over_smaller_neighbours() {
    assert_eq!(found("B-28"), [Some((0, [0, 0])), Some((0, [1, 0]))]);
}
