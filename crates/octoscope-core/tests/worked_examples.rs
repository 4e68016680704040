//! The worked examples of the papers, and rays on which the rules as they were
//! once printed go wrong, as cases.

use octoscope_core::event::{End, Event, Search};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{
    Direction, Reach, climb, locate_by_codes, locate_by_comparison, locate_region, neighbour,
};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::trace::{Trace, record};
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::{Child, Code, Domain, NodeId, Split, Tree, grow};

/// Tree in which a cell of this level and code is divided if `divide` says so.
fn tree<const D: usize>(domain: Domain<D>, divide: impl Fn(u8, Code<D>) -> bool) -> Tree<D> {
    grow(domain, (), &Progress::default(), |cell, ()| {
        if cell.level > 0 && divide(cell.level, cell.code) {
            Split::Inner(vec![(); Child::<D>::COUNT])
        } else {
            Split::Empty
        }
    })
    .expect("nobody cancels")
}

fn full<const D: usize>(root_level: u8) -> Tree<D> {
    tree(Domain::unit(root_level), |_, _| true)
}

/// Level and code of a node that was found.
fn place<const D: usize>(tree: &Tree<D>, node: Option<NodeId>) -> (u8, Code<D>) {
    let node = node.expect("a node is found");
    (tree.level(node), tree.code(node))
}

fn run<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, algorithm: Algorithm) -> Trace<D> {
    let options = Options::default();
    record(tree, ray, &Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles })
}

fn ray<const D: usize>(origin: [f64; D], direction: [f64; D]) -> Ray<D> {
    Ray::new(origin, direction).expect("the numbers make a ray")
}

/// The leaves along a ray through a root with one level of children, as child
/// indices: all algorithms must find `expected`.
fn check_in<const D: usize>(
    domain: Domain<D>,
    origin: [f64; D],
    direction: [f64; D],
    expected: &[u8],
) {
    let tree = tree(domain, |_, _| true);
    let ray = ray(origin, direction);
    for algorithm in Algorithm::ALL {
        let children: Vec<u8> = run(&tree, &ray, algorithm)
            .leaves()
            .map(|(leaf, _)| tree.child_index(leaf).expect("the root is divided").0)
            .collect();
        assert_eq!(children, expected, "{algorithm:?} {ray:?}");
    }
}

fn check<const D: usize>(origin: [f64; D], direction: [f64; D], expected: &[u8]) {
    check_in(Domain::unit(1), origin, direction, expected);
}

/// States in which a parametric algorithm visits the children of the root.
fn states<const D: usize>(origin: [f64; D], direction: [f64; D], algorithm: Algorithm) -> Vec<u8> {
    let trace = run(&full(1), &ray(origin, direction), algorithm);
    let state_of = |event: &Event<D>| match event {
        Event::Visit { state, .. } => state.map(|state| state.0),
        _ => None,
    };
    trace.events.iter().filter_map(state_of).collect()
}

fn touched<const D: usize>(origin: [f64; D], direction: [f64; D], algorithm: Algorithm) -> Vec<u8> {
    let tree = full(1);
    let trace = run(&tree, &ray(origin, direction), algorithm);
    let touch = |event: &Event<D>| match *event {
        Event::Touch { node, .. } => tree.child_index(node).map(|child| child.0),
        _ => None,
    };
    trace.events.iter().filter_map(touch).collect()
}

// Point location.

#[test]
fn the_point_0_55_goes_right_left_left() {
    // Divided where needed only, so that [0.5, 0.625) is a leaf of level 2.
    let tree = tree(Domain::<1>::unit(5), |level, [code]| {
        level > 2 && code <= 17 && 17 < code + (1 << level)
    });
    let mut events = Vec::new();
    let outcome = locate_by_codes(&tree, [0.55], &mut events);
    assert_eq!(place(&tree, outcome.node), (2, [0b01_0000]));
    let (point, code, search) = ([0.55], [0b01_0001], Search::NONE);
    assert!(events.contains(&Event::Encode { point, code, after: None, search }));
    let turns: Vec<_> = events
        .iter()
        .filter_map(|event| match event {
            Event::Follow { level, child, .. } => Some((*level, child.0)),
            _ => None,
        })
        .collect();
    assert_eq!(turns, [(5, 1), (4, 0), (3, 0)]);
    assert_eq!(locate_by_comparison(&tree, [0.55], &mut ()), outcome);
}

#[test]
fn the_upper_face_and_what_is_no_number_are_outside() {
    let tree = full::<2>(3);
    for x in [1.0, -0.1, f64::NAN, f64::INFINITY] {
        for point in [[x, 0.5], [0.5, x]] {
            assert_eq!(locate_by_codes(&tree, point, &mut ()).end, End::Outside);
            assert_eq!(locate_by_comparison(&tree, point, &mut ()).end, End::Outside);
        }
    }
    assert_eq!(locate_by_codes(&tree, [-0.0, 0.5], &mut ()).end, End::Found);
}

#[test]
fn coordinates_below_zero_are_not_truncated_towards_zero() {
    let tree = tree(Domain::new([-1.0, -1.0], 2.0, 1).unwrap(), |_, _| true);
    let outcome = locate_by_codes(&tree, [-0.25, 0.25], &mut ());
    assert_eq!(place(&tree, outcome.node), (0, [0, 1]));
}

// Region location.

fn check_region<const D: usize>(
    root_level: u8,
    min: [f64; D],
    max: [f64; D],
    expected_xor: Code<D>,
    expected: (u8, Code<D>),
) {
    let tree = full::<D>(root_level);
    let mut events = Vec::new();
    let outcome = locate_region(&tree, min, max, &mut events);
    assert_eq!(place(&tree, outcome.node), expected);
    let shows_xor = |event: &Event<D>| {
        matches!(event, Event::Difference { xor, level, .. }
            if *xor == expected_xor && *level == expected.0)
    };
    assert!(events.iter().any(shows_xor), "{events:?}");
}

#[test]
fn regions_end_one_level_above_the_highest_different_bit() {
    let sixteenths = |[x, y]: [u32; 2]| [f64::from(x) / 16.0, f64::from(y) / 16.0];
    let (min, max) = (sixteenths([0b0101, 0b1001]), sixteenths([0b0110, 0b1010]));
    check_region(4, min, max, [0b0011, 0b0011], (2, [4, 8]));
}

#[test]
fn regions_of_the_report_have_the_right_codes() {
    check_region(5, [0.31], [0.65], [0b01_1101], (5, [0]));
    check_region(5, [0.31], [0.36], [0b00_0010], (2, [0b00_1000]));
}

#[test]
fn a_region_within_a_smallest_cell_ends_at_level_0() {
    check_region(4, [0.32, 0.57], [0.33, 0.58], [0, 0], (0, [5, 9]));
}

#[test]
fn a_region_that_ends_on_a_border_counts_into_the_next_cell() {
    check_region(1, [0.0, 0.0], [0.5, 0.25], [1, 0], (1, [0, 0]));
}

// Neighbours and common ancestors.

#[test]
fn climbing_goes_on_while_the_bit_at_the_level_differs() {
    let tree = full::<1>(5);
    let level_reached = |from: u32, to: u32| {
        let node = tree.node_at(3, [from]).unwrap();
        climb(&tree, node, 3, [from], [to], &mut ()).1
    };
    assert_eq!(level_reached(0b00_1000, 0b01_0000), 5);
    assert_eq!(level_reached(0b01_1000, 0b01_0111), 4);
}

#[test]
fn the_low_side_is_left_by_one_smallest_cell() {
    // Everything divided but the cell (10, 6) of level 1.
    let tree = tree(Domain::<2>::unit(4), |level, code| (level, code) != (1, [10, 6]));
    let cell = tree.node_at(1, [10, 6]).unwrap().id;
    let left = Direction::new([-1, 0]).unwrap();
    let leaf = neighbour(&tree, cell, left, Reach::Leaf, &mut ());
    assert_eq!(place(&tree, leaf.node), (0, [9, 6]));
    let equal = neighbour(&tree, cell, left, Reach::EqualOrLarger, &mut ());
    assert_eq!(place(&tree, equal.node), (1, [8, 6]));
}

#[test]
fn there_is_no_neighbour_beyond_the_border() {
    let tree = full::<2>(3);
    for (code, direction) in [([7, 3], [1, 0]), ([0, 3], [-1, 0]), ([7, 7], [1, 1])] {
        let cell = tree.node_at(0, code).unwrap().id;
        let direction = Direction::new(direction).unwrap();
        for reach in [Reach::EqualOrLarger, Reach::Leaf] {
            assert_eq!(neighbour(&tree, cell, direction, reach, &mut ()).end, End::Outside);
        }
    }
}

// Rays in the plane.

#[test]
fn a_ray_is_inside_where_it_is_in_all_slabs() {
    check([-2.0, 0.0], [1.0, 1.0], &[]);
}

#[test]
fn the_mid_plane_that_comes_first_decides() {
    check([-1.0, 0.1], [1.0, 0.1], &[0, 2]);
    check([0.1, -1.0], [0.1, 1.0], &[0, 1]);
}

#[test]
fn a_ray_through_the_centre_visits_the_first_and_the_last_child() {
    check([-1.0, -1.0], [1.0, 1.0], &[0, 3]);
    check([2.0, -1.0], [-1.0, 1.0], &[2, 1]);
}

#[test]
fn a_ray_in_a_plane_belongs_to_the_upper_side() {
    for zero in [0.0, -0.0] {
        check([0.0, -1.0], [zero, 1.0], &[0, 1]);
        check([0.5, -1.0], [zero, 1.0], &[2, 3]);
        check([1.0, -1.0], [zero, 1.0], &[]);
        check([-1e-11, -1.0], [zero, 1.0], &[]);
        check([-0.0, -1.0], [zero, 1.0], &[0, 1]);
    }
}

#[test]
fn a_root_away_from_zero_is_mirrored_about_its_own_centre() {
    let domain = Domain::new([1.0, 1.0], 2.0, 1).unwrap();
    check_in(domain, [4.0, 1.25], [-1.0, 0.5], &[2, 3, 1]);
}

#[test]
fn touching_a_corner_of_the_root_is_a_miss() {
    check([0.0, 2.0], [1.0, -1.0], &[]);
    check([2.0, 0.0, 0.5], [-1.0, 1.0, 0.0], &[]);
    check([-1.0, 2.0, 0.5], [1.0, 0.0, 0.0], &[]);
}

// Rays in space.

#[test]
fn the_first_child_has_x_as_its_highest_bit() {
    check([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0], &[4, 5]);
    for algorithm in [Algorithm::Parametric, Algorithm::ParametricTable] {
        assert_eq!(states([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0], algorithm), [4, 5]);
    }
}

#[test]
fn the_mirrored_ray_of_figure_7_visits_4_6_2() {
    let (origin, direction) = ([1.5, 0.125, 0.25], [-1.0, 0.5, 0.0625]);
    check(origin, direction, &[4, 6, 2]);
    for algorithm in [Algorithm::Parametric, Algorithm::ParametricTable] {
        assert_eq!(states(origin, direction, algorithm), [0, 2, 6]);
    }
}

#[test]
fn the_tables_touch_what_the_uniform_rule_jumps_over() {
    let (origin, direction) = ([-1.0; 3], [1.0; 3]);
    check(origin, direction, &[0, 7]);
    assert_eq!(states(origin, direction, Algorithm::Parametric), [0, 7]);
    assert_eq!(states(origin, direction, Algorithm::ParametricTable), [0, 1, 3, 7]);
    assert_eq!(touched(origin, direction, Algorithm::ParametricTable), [1, 3]);
}

#[test]
fn a_ray_along_an_axis_stays_on_its_side_of_the_mid_planes() {
    check([0.75, 0.75, -1.0], [0.0, 0.0, 1.0], &[6, 7]);
    check([0.49, 0.49, 0.0], [0.0, 0.0, 2.0], &[0, 1]);
    check([0.49, 0.51, 2.0], [-0.0, 0.0, -2.0], &[3, 2]);
}

#[test]
fn what_lies_behind_the_origin_is_not_visited() {
    check([2.0, 2.0, 2.0], [1.0, 1.0, 1.0], &[]);

    // The tables walk from the near planes on, but report only what is ahead.
    let (origin, direction) = ([0.75, 0.75, 0.328_125], [1.0, 0.5, 0.0625]);
    check(origin, direction, &[6]);
    assert_eq!(states(origin, direction, Algorithm::ParametricTable), [0, 2, 6]);
    assert_eq!(states(origin, direction, Algorithm::Parametric), [6]);
}

#[test]
fn the_last_child_comes_first_if_the_ray_begins_in_it() {
    let (origin, direction) = ([0.75; 3], [1.0; 3]);
    check(origin, direction, &[7]);
    assert_eq!(states(origin, direction, Algorithm::Parametric), [7]);
    assert_eq!(states(origin, direction, Algorithm::ParametricTable), [0, 1, 3, 7]);
}

#[test]
fn a_ray_that_begins_on_a_plane_visits_only_where_it_goes() {
    check([0.5, 0.25, 0.25], [-1.0, 0.0, 0.0], &[0]);
    check([0.5, 0.25, 0.25], [1.0, 0.0, 0.0], &[4]);
    check([0.0, 0.0, 0.5], [1.0, 0.0, -0.5], &[0, 4]);
    check([1.0, 0.25, 0.25], [-1.0, 0.0, 0.0], &[4, 0]);
    check([1.0, 0.25, 0.25], [1.0, 0.0, 0.0], &[]);
}

#[test]
fn all_eight_signs_of_a_direction_are_traversed() {
    for bits in 0..8u8 {
        let sign = |axis: usize| if bits >> (2 - axis) & 1 == 1 { -1.0 } else { 1.0 };
        let direction = [sign(0), 0.75 * sign(1), 0.5 * sign(2)];
        let origin = std::array::from_fn(|e| 0.5 - 2.0 * direction[e]);
        // All mid planes are met in the centre at once.
        check(origin, direction, &[bits, bits ^ 7]);
    }
}
