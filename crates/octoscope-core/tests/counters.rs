//! What algorithms cost: counted by hand on a small ray, and compared with counts
//! made by others on generic rays.

use octoscope_core::event::{Event, Search};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::scene::{Content, Sphere, made};
use octoscope_core::trace::{Counter, Counters, record};
use octoscope_core::traverse::{Algorithm, Options, Variant, Variants};
use octoscope_core::tree::{Domain, Recipe, Split, Tree, build, grow};

/// Cost of a run; without that of finding codes where `codes` says so.
fn cost<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithm: Algorithm,
    variants: Variants,
    codes: Codes,
) -> Counters {
    let options = Options { variants, ..Options::default() };
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles };
    let mut counters = Counters::default();
    for mut event in record(tree, ray, &query).events {
        match &mut event {
            Event::Encode { search, .. } | Event::Target { search, .. } if codes == Codes::Free => {
                *search = Search::NONE;
            }
            _ => {}
        }
        counters.add(&event);
    }
    counters
}

/// Whether finding the codes of a place on the ray costs anything.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Codes {
    Counted,
    Free,
}

/// Four leaves; the ray is in leaf 0 for 0.5 ≤ t < 1, in leaf 2 until 1.5.
fn small() -> (Tree<2>, Ray<2>) {
    let tree = grow(Domain::unit(1), (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 4]),
    });
    let ray = Ray::new([-0.5, 0.25], [1.0, 0.125]);
    (tree.expect("four leaves fit"), ray.expect("the direction is not zero"))
}

fn check(algorithm: Algorithm, expected: &[(Counter, u64)]) {
    let (tree, ray) = small();
    let counters = cost(&tree, &ray, algorithm, Variants::NONE, Codes::Counted);
    for &(counter, n) in expected {
        assert_eq!(counters.get(counter), n, "{algorithm:?}, {counter:?}");
    }
    assert_eq!(counters.get(Counter::Leaves), 2);
}

/// Cutting the root: 2 + 1 comparisons and 2 with the origin, 4 divisions.
#[test]
fn top_down_walks_cost_what_is_counted_by_hand() {
    use Counter::{
        Additions, Calls, Divisions, EntryComparisons, ExitComparisons, NodeTouches,
        RangeComparisons, SortComparisons, TableLookups, Transitions,
    };
    // Two leaves; no link leads to the root. First: 1 for the near plane, 1 with the
    // origin, 2 with the mid planes. Two steps with 1 each.
    check(
        Algorithm::Parametric,
        &[
            (NodeTouches, 2),
            (Calls, 3),
            (EntryComparisons, 2 + 4),
            (ExitComparisons, 1 + 2),
            (RangeComparisons, 2),
            (Divisions, 4 + 2),
            (Transitions, 2),
        ],
    );
    // First: 1 for the near plane, 1 by Table 2. Skipping: 1 + 1 in every node.
    check(
        Algorithm::ParametricTable,
        &[
            (NodeTouches, 2),
            (Calls, 3),
            (EntryComparisons, 2 + 2),
            (ExitComparisons, 1 + 2 + 3),
            (RangeComparisons, 2 + 3),
            (Divisions, 4 + 2),
        ],
    );
    // No mid plane is passed at the entry: both are compared with the exit.
    check(
        Algorithm::Hero,
        &[
            (NodeTouches, 2),
            (Calls, 3),
            (EntryComparisons, 2 + 2),
            (ExitComparisons, 1),
            (RangeComparisons, 2 + 2),
            (SortComparisons, 1),
            (Divisions, 4 + 2),
        ],
    );
    // The same, and two pieces are classified.
    check(
        Algorithm::Gargantini,
        &[
            (NodeTouches, 2),
            (Calls, 3),
            (EntryComparisons, 2 + 4),
            (RangeComparisons, 2 + 4),
            (SortComparisons, 1),
            (Divisions, 4 + 2),
        ],
    );
    // Four children are tested, the two on the ray are visited.
    check(
        Algorithm::AllChildren,
        &[
            (NodeTouches, 2),
            (EntryComparisons, 2 + 4 * 2),
            (ExitComparisons, 1 + 4),
            (RangeComparisons, 2 + 4),
            (Divisions, 4 + 4 * 4),
        ],
    );
    // No call, no addition of doubles for the codes; one border test a leaf.
    check(
        Algorithm::Esvo,
        &[
            (NodeTouches, 2),
            (Calls, 0),
            (EntryComparisons, 2 + 2),
            (ExitComparisons, 1 + 2),
            (RangeComparisons, 2 + 2),
            (Additions, 4 + 2),
            (Divisions, 4 + 2),
        ],
    );
    // The binary tree: both halves of the root, in each of them a quarter.
    check(
        Algorithm::Bsp,
        &[(NodeTouches, 4), (Divisions, 4 + 3), (RangeComparisons, 2 + 3 * 3), (TableLookups, 0)],
    );
}

#[test]
fn bottom_up_walks_cost_what_is_counted_by_hand() {
    use Counter::{
        CodeComparisons, Divisions, ExitComparisons, NodeTouches, PointLocations, RangeComparisons,
        TableLookups,
    };
    // Down to leaf 0, up to the root, down to leaf 2. Two leaves are left: 1 for
    // the first far plane, 1 border test each. Of the two codes at the entry that
    // of x is the first anyway and compares plane 1, that of y compares 1. The
    // codes of y beyond the leaves can only be 0: no plane is compared.
    check(
        Algorithm::Codes,
        &[
            (NodeTouches, 3),
            (ExitComparisons, 1 + 2),
            (RangeComparisons, 2 + 2),
            (CodeComparisons, 2),
            (Divisions, 4 + 2 * 2 + (2 + 2) + 2),
            (PointLocations, 1),
        ],
    );
    // Down from the root for each leaf.
    check(Algorithm::Glassner, &[(NodeTouches, 2), (PointLocations, 2)]);
    // Down, up with one look-up, mirrored down with one, up with one: the root has
    // no parent.
    check(Algorithm::Samet, &[(NodeTouches, 4), (TableLookups, 3), (CodeComparisons, 2)]);
    check(Algorithm::SametCorner, &[(NodeTouches, 4), (TableLookups, 0)]);
    // Down, and through one link; the other one leads out.
    check(Algorithm::SametNet, &[(NodeTouches, 2), (CodeComparisons, 2)]);
}

#[test]
fn the_way_out_of_the_grid_is_no_cell() {
    check(Algorithm::Dda, &[(Counter::GridCells, 2), (Counter::PointLocations, 0)]);
    check(Algorithm::DdaOctree, &[(Counter::GridCells, 2), (Counter::PointLocations, 2)]);
}

#[test]
fn means_take_no_division() {
    let (tree, ray) = small();
    let averaged = Variants::NONE.with(Variant::Averaged);
    for algorithm in [Algorithm::Parametric, Algorithm::ParametricTable] {
        let counters = cost(&tree, &ray, algorithm, averaged, Codes::Counted);
        assert_eq!(counters.get(Counter::Divisions), 4);
    }
}

#[test]
fn axes_without_motion_take_no_division() {
    let tree = grow(Domain::unit(1), (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 8]),
    });
    let tree: Tree<3> = tree.expect("eight leaves fit");
    let ray = Ray::new([-1.0, 0.25, 0.25], [1.0, 0.0, 0.0]).expect("it moves along x");
    // Two for the root. Then one for the mid planes, one a binary node whose plane
    // lies across x, two a tested child, one a leaf left or a cell.
    for (algorithm, divisions) in [
        (Algorithm::Parametric, 2 + 1),
        (Algorithm::Bsp, 2 + 1),
        (Algorithm::AllChildren, 2 + 8 * 2),
        (Algorithm::Glassner, 2 + 2),
        // By multiplying crosswise.
        (Algorithm::Exhaustive, 0),
    ] {
        let counters = free(&tree, &ray, algorithm);
        assert_eq!(counters.get(Counter::Divisions), divisions, "{algorithm:?}");
    }

    // But the gem divides at every binary node: across x once, across y and z twice.
    let gem = cost(&tree, &ray, Algorithm::Bsp, Variants::NONE.with(Variant::Gem), Codes::Free);
    assert_eq!(gem.get(Counter::Divisions), 2 + 5);
}

#[test]
fn a_point_in_an_octree_of_eight_levels_takes_eight_leaf_tests() {
    let tree = grow(Domain::unit(7), (), &Progress::default(), |cell, ()| {
        let on_path = cell.code == [0; 3] && cell.level > 0;
        if on_path { Split::Inner(vec![(); 8]) } else { Split::Empty }
    });
    let tree: Tree<3> = tree.expect("one path fits");
    let ray = Ray::new([0.0; 3], [1.0; 3]).expect("the direction is not zero");
    for (method, comparisons) in [(PointMethod::Comparison, 21), (PointMethod::Codes, 0)] {
        let query = Query::Point { at: [0.001; 3], method, variants: Variants::NONE };
        let mut counters = Counters::default();
        record(&tree, &ray, &query).events.iter().for_each(|event| counters.add(event));
        assert_eq!(counters.comparisons(), comparisons, "{method:?}");
        assert_eq!(counters.get(Counter::LeafTests), 8, "{method:?}");
    }
}

/// A scene of our own counts, with 60 generic rays.
fn scene(content: &Content<3>, depth: u8) -> (Tree<3>, Vec<Ray<3>>) {
    let recipe = Recipe { depth, ..Recipe::default() };
    let tree = build(content, Domain::unit(depth), &recipe, &Progress::default());
    let mut random = Random::new(7);
    let mut ray = || {
        let goal: [f64; 3] = std::array::from_fn(|_| random.unit());
        let around: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let length = around.iter().map(|x| x * x).sum::<f64>().sqrt();
        let origin = around.map(|x| 0.5 + 2.0 * x / length);
        let direction = std::array::from_fn(|e| goal[e] - origin[e]);
        Ray::new(origin, direction).expect("the origin lies outside, the goal inside")
    };
    let rays = (0..60).map(|_| ray()).collect();
    (tree.expect("the content lies in the unit cube"), rays)
}

/// Spheres of radius 0.012 anywhere in the unit cube.
fn spheres(n: usize) -> Content<3> {
    let mut random = Random::new(1);
    let radius = 0.012;
    let mut sphere =
        || Sphere { centre: std::array::from_fn(|_| random.between(radius, 1.0 - radius)), radius };
    Content::Spheres((0..n).map(|_| sphere()).collect())
}

fn scenes() -> [(Tree<3>, Vec<Ray<3>>); 4] {
    let (cloud, grid) = (spheres(1890), made::sphere_grid(3));
    [scene(&cloud, 5), scene(&cloud, 6), scene(&grid, 5), scene(&spheres(200), 6)]
}

/// Cost where codes are free: truncating a point, as the literature does, takes no
/// comparison.
fn free<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, algorithm: Algorithm) -> Counters {
    cost(tree, ray, algorithm, Variants::NONE, Codes::Free)
}

#[test]
fn walks_of_one_kind_touch_the_same_nodes() {
    use Algorithm::{
        AllChildren, Bsp, Codes as ByCodes, Dda, DdaOctree, Esvo, Gargantini, Glassner, Hero,
        Parametric, ParametricTable, Samet, SametCorner, SametNet,
    };
    for (tree, rays) in scenes() {
        for ray in rays {
            let of = |algorithm, counter| free(&tree, &ray, algorithm).get(counter);
            let touches = |algorithm| of(algorithm, Counter::NodeTouches);
            let (nodes, leaves) = (touches(Parametric), of(Parametric, Counter::Leaves));
            for algorithm in [ParametricTable, Hero, Gargantini, Esvo, AllChildren] {
                assert_eq!(touches(algorithm), nodes, "{algorithm:?}");
            }
            assert!(touches(Bsp) >= nodes);
            for algorithm in [ByCodes, Glassner, Samet, SametCorner] {
                assert!(touches(SametNet) <= touches(algorithm), "{algorithm:?}");
            }
            assert_eq!(of(Esvo, Counter::Calls), 0);
            assert_eq!(of(DdaOctree, Counter::GridCells), of(DdaOctree, Counter::PointLocations));
            assert_eq!(of(Dda, Counter::GridCells), of(DdaOctree, Counter::GridCells));

            // Divisions, on top of 6 for the root: none for means, 3 a leaf left,
            // 1 an inner node of the binary tree, 6 a tested box.
            let divisions = |algorithm| of(algorithm, Counter::Divisions);
            let means = Variants::NONE.with(Variant::Averaged);
            let averaged = cost(&tree, &ray, ParametricTable, means, Codes::Free);
            assert_eq!(averaged.get(Counter::Divisions), 6);
            for algorithm in [ByCodes, Glassner, Samet, SametCorner, SametNet] {
                assert_eq!(divisions(algorithm), 6 + 3 * leaves, "{algorithm:?}");
            }
            // Of the root and what is reached, all but the leaves are inner nodes.
            assert_eq!(divisions(Bsp), 6 + 1 + touches(Bsp) - leaves);
            assert_eq!(divisions(AllChildren), 6 + 6 * 8 * (1 + nodes - leaves));
        }
    }
}

/// Touches as others count them: in a bottom-up walk a leaf that is left is touched
/// once more, for the link to its parent or its neighbours.
fn touches_and_leaves(counters: &Counters) -> f64 {
    (counters.get(Counter::NodeTouches) + counters.get(Counter::Leaves)) as f64
}

fn touches(counters: &Counters) -> f64 {
    counters.get(Counter::NodeTouches) as f64
}

fn comparisons(counters: &Counters) -> f64 {
    counters.comparisons() as f64
}

/// What is made of counters.
type Count = fn(&Counters) -> f64;

/// Counts that go up in each scene.
fn check_order(costs: &[(Algorithm, Count)]) {
    for (tree, rays) in scenes() {
        let mean = |(algorithm, count): &(Algorithm, Count)| {
            rays.iter().map(|ray| count(&free(&tree, ray, *algorithm))).sum::<f64>()
        };
        let means: Vec<f64> = costs.iter().map(mean).collect();
        assert!(means.is_sorted_by(|a, b| a < b), "{means:?}");
    }
}

#[test]
fn algorithms_are_in_the_known_order_of_their_costs() {
    use Algorithm::{
        AllChildren, Bsp, Codes as ByCodes, Gargantini, Hero, Parametric, ParametricTable, SametNet,
    };
    check_order(&[
        (Parametric, touches),
        (SametNet, touches_and_leaves),
        (ByCodes, touches_and_leaves),
        (Bsp, touches),
    ]);
    check_order(&[
        (ByCodes, comparisons),
        (Hero, comparisons),
        (Bsp, comparisons),
        (Gargantini, comparisons),
        (ParametricTable, comparisons),
        (AllChildren, comparisons),
    ]);
}
