//! Bugs that others have had to mend in their traversals, each as a fact about ours.

use octoscope_core::event::{End, Event, Outcome};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{
    Direction, Reach, climb, locate_by_codes, locate_by_comparison, neighbour, neighbour_by_tables,
};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scene::Content;
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::{
    Child, Code, Domain, NodeId, Recipe, Split, Tree, branch, build, common_level, grow, morton,
};

/// Tree in which every cell above level 0 is divided.
fn full<const D: usize>(domain: Domain<D>) -> Tree<D> {
    grow(domain, (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 1 << D]),
    })
    .expect("nobody cancels")
}

fn ray<const D: usize>(origin: [f64; D], direction: [f64; D]) -> Ray<D> {
    Ray::new(origin, direction).expect("the numbers make a ray")
}

fn run<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithm: Algorithm,
    arithmetic: Arithmetic,
) -> Trace<D> {
    record(tree, ray, &Query::Ray { algorithm, options: Options::default(), arithmetic })
}

/// Every algorithm visits the leaves with these codes, in this order, exactly and in
/// doubles.
fn check<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, expected: &[Code<D>]) {
    for algorithm in Algorithm::ALL {
        for arithmetic in [Arithmetic::Exact, Arithmetic::Doubles] {
            let trace = run(tree, ray, algorithm, arithmetic);
            let codes: Vec<_> = trace.leaves().map(|(leaf, _)| tree.code(leaf)).collect();
            assert_eq!(codes, expected, "{algorithm:?} {arithmetic:?} {ray:?}");
        }
    }
}

/// The code of every leaf that a walk along x meets in a full tree.
fn row<const D: usize>(xs: impl IntoIterator<Item = u32>, rest: Code<D>) -> Vec<Code<D>> {
    xs.into_iter().map(|x| std::array::from_fn(|e| if e == 0 { x } else { rest[e] })).collect()
}

#[test]
fn mirroring_does_not_need_a_root_at_zero() {
    for min in [[0.0; 2], [1.0; 2], [-1.0; 2], [1000.5, -7.25]] {
        let tree = full(Domain::new(min, 2.0, 1).expect("the numbers make a domain"));
        let origin = [min[0] + 3.0, min[1] + 0.25];
        check(&tree, &ray(origin, [-1.0, 0.5]), &[[1, 0], [1, 1], [0, 1]]);
    }
}

#[test]
fn a_direction_of_zero_components_takes_the_children_that_hold_the_origin() {
    let tree = full(Domain::<3>::unit(1));
    check(&tree, &ray([0.49, 0.49, 0.0], [0.0, 0.0, 2.0]), &[[0, 0, 0], [0, 0, 1]]);
    check(&tree, &ray([0.51, 0.49, 1.0], [0.0, 0.0, -2.0]), &[[1, 0, 1], [1, 0, 0]]);
}

#[test]
fn zero_is_not_replaced_by_a_small_number() {
    // With 10^-15 instead of 0 this ray would creep into the root after a while.
    let tree = full(Domain::<2>::unit(1));
    check(&tree, &ray([-1e-16, -1e6], [0.0, 1.0]), &[]);
    let trace =
        run(&tree, &ray([0.25, -1.0], [0.0, 1.0]), Algorithm::Parametric, Default::default());
    let Event::Clip { near, far, .. } = trace.events[0] else {
        panic!("a walk begins with a clip")
    };
    assert_eq!((near[0], far[0]), (f64::NEG_INFINITY, f64::INFINITY));
}

#[test]
fn rays_along_edges_and_beside_the_grid_are_in_or_out_by_their_slab() {
    let tree = full(Domain::<3>::unit(1));
    check(&tree, &ray([-1.0, 0.5, 0.5], [1.0, 0.0, -0.0]), &row([0, 1], [0, 1, 1]));
    check(&tree, &ray([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), &row([0, 1], [0, 0, 0]));
    check(&tree, &ray([-1.0, 1.0, 0.5], [1.0, 0.0, 0.0]), &[]);
    check(&tree, &ray([-1.0, -0.5, 0.5], [1.0, -0.0, -0.0]), &[]);
}

#[test]
fn an_end_that_is_no_finite_number_ends_nothing() {
    let tree = full(Domain::<2>::unit(2));
    let ray = ray([-0.5, 0.125], [1.0, 0.25]);
    for algorithm in Algorithm::ALL {
        for arithmetic in [Arithmetic::Doubles, Arithmetic::Exact] {
            let run = |segment_end| {
                let options = Options { segment_end, ..Options::default() };
                record(&tree, &ray, &Query::Ray { algorithm, options, arithmetic }).events
            };
            for end in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
                assert_eq!(run(Some(end)), run(None), "{algorithm:?} {end}");
            }
        }
    }
}

#[test]
fn minus_zero_is_zero() {
    let tree = full(Domain::<2>::unit(2));
    for zero in [0.0, -0.0] {
        check(&tree, &ray([-1.0, 0.5], [1.0, zero]), &row(0..4, [0, 2]));
        check(&tree, &ray([0.5, 2.0], [zero, -1.0]), &[[2, 3], [2, 2], [2, 1], [2, 0]]);
        // The origin may have one as well.
        check(&tree, &ray([zero, zero], [1.0, 1.0]), &[[0, 0], [1, 1], [2, 2], [3, 3]]);
    }
}

#[test]
fn no_parameter_is_ever_not_a_number() {
    let tree = full(Domain::<3>::unit(2));
    for origin in [[0.0; 3], [0.5; 3], [1.0; 3], [-1.0, 0.0, 0.25]] {
        for direction in [[1.0, 0.0, 0.0], [0.0, -1.0, -0.0], [0.0, 0.0, 1.0]] {
            for algorithm in Algorithm::ALL {
                let ray = ray(origin, direction);
                let trace = run(&tree, &ray, algorithm, Arithmetic::Doubles);
                let shown = format!("{:?}", trace.events);
                assert!(!shown.contains("NaN"), "{algorithm:?} {ray:?}");
            }
        }
    }
}

#[test]
fn every_step_gets_further_or_crosses_a_plane() {
    // Through the corners, where a step through no plane would be an endless loop.
    let tree = full(Domain::<3>::unit(3));
    let ray = ray([-0.125; 3], [1.0; 3]);
    for algorithm in Algorithm::ALL {
        for event in run(&tree, &ray, algorithm, Arithmetic::Doubles).events {
            match event {
                Event::Step { axes, .. }
                | Event::Exits { axes, .. }
                | Event::Cross { axes, .. } => {
                    assert!(!axes.is_empty(), "{algorithm:?}");
                }
                Event::Leaf { enter, exit, .. } => assert!(enter < exit, "{algorithm:?}"),
                _ => {}
            }
        }
    }
}

#[test]
fn a_miss_ends_at_once() {
    let tree = full(Domain::<3>::unit(3));
    for ray in [ray([2.0; 3], [1.0; 3]), ray([-1.0, 2.0, 0.5], [1.0, 0.0, 0.0])] {
        for algorithm in Algorithm::ALL.into_iter().filter(|&a| a != Algorithm::Exhaustive) {
            let trace = run(&tree, &ray, algorithm, Arithmetic::Doubles);
            assert_eq!(trace.outcome, Outcome::without_node(End::Missed), "{algorithm:?}");
            assert_eq!(trace.events.len(), 2, "{algorithm:?}: the clip and the end");
        }
    }
}

#[test]
fn parallel_rays_from_a_plane_before_the_root_all_end() {
    // As a parallel projection sends them, those that hit edges and miss among them.
    let tree = full(Domain::<3>::unit(2));
    for n in 0..=20 {
        let y = f64::from(n) / 10.0 - 0.5;
        for z in [0.0, 0.25, 0.3, 1.0] {
            let inside = (0.0..1.0).contains(&y) && z < 1.0;
            let [j, k] = [y, z].map(|x| (x * 4.0) as u32);
            let expected = if inside { row(0..4, [0, j, k]) } else { vec![] };
            check(&tree, &ray([-3.0, y, z], [2.0, 0.0, 0.0]), &expected);
        }
    }
}

#[test]
fn a_ray_has_a_direction_and_numbers() {
    for bad in [[0.0, 0.0], [0.0, -0.0], [f64::NAN, 1.0], [f64::INFINITY, 0.0]] {
        assert!(Ray::new([0.0; 2], bad).is_err(), "{bad:?}");
        assert!(Ray::new(bad, [1.0, 0.0]).is_ok() == bad.iter().all(|x| x.is_finite()));
    }
    // The shortest direction there is leads as far as any.
    let tree = full(Domain::<2>::unit(2));
    check(&tree, &ray([0.125, 0.25], [f64::from_bits(1), 0.0]), &row(0..4, [0, 1]));
    check(&tree, &ray([0.125, 0.25], [-f64::from_bits(1), 0.0]), &row([0], [0, 1]));
}

#[test]
fn downwards_the_first_cell_lies_below_the_origin_and_none_is_left_out() {
    let tree = full(Domain::<2>::unit(2));
    check(&tree, &ray([0.5, 0.125], [-1.0, 0.0]), &row([1, 0], [0, 0]));
    check(&tree, &ray([0.5, 0.125], [1.0, 0.0]), &row([2, 3], [0, 0]));
    check(&tree, &ray([0.5, 0.5], [-1.0, -1.0]), &[[1, 1], [0, 0]]);
    check(&tree, &ray([2.0, 0.125], [-1.0, 0.0]), &row([3, 2, 1, 0], [0, 0]));
}

#[test]
fn negative_coordinates_are_rounded_down() {
    let domain = Domain::new([-2.0; 2], 4.0, 2).expect("the numbers make a domain");
    assert_eq!(domain.encode_point([-0.5, -1.5]), Some([1, 0]));
    assert_eq!(domain.encode_point([-2.5, 0.0]), None);
    let tree = full(domain);
    for locate in [locate_by_codes::<2>, locate_by_comparison] {
        let leaf = locate(&tree, [-0.5, -1.5], &mut ()).node.expect("it lies inside");
        assert_eq!(tree.code(leaf), [1, 0]);
    }
    check(&tree, &ray([-0.5, -1.5], [-1.0, 0.0]), &row([1, 0], [0, 0]));
}

#[test]
fn bits_go_and_come_back_in_the_same_order() {
    let last = (1 << 20) - 1;
    for code in [[0, 0, 0], [last, 0, 0], [0, last, 0], [0, 0, last], [1, 2, 4], [last; 3]] {
        let mixed = morton::<3>(code);
        let back = std::array::from_fn(|e| {
            (0..20).fold(0, |bits, n| bits | u32::from(mixed >> (3 * n + e) & 1 == 1) << n)
        });
        assert_eq!(code, back);
        // The path down the tree is the same number, three bits a level.
        let path = (1..=20u8)
            .rev()
            .fold(0, |path, level| path << 3 | u64::from(branch::<3>(code, level).morton_index()));
        assert_eq!(mixed, path);
    }
    assert_eq!(morton::<2>([0b11, 0b00]), 0b0101);
    assert_eq!(Child::<3>(4).morton_index(), 1);
}

#[test]
fn equal_codes_meet_at_the_level_of_the_leaf() {
    assert_eq!(common_level::<3>([5, 6, 7], [5, 6, 7]), 0);
    assert_eq!(common_level::<2>([4, 9], [5, 9]), 1);
    assert_eq!(common_level::<2>([0, 0], [1 << 19, 0]), 20);
    let tree = full(Domain::<2>::unit(3));
    let leaf = tree.node_at(0, [5, 6]).expect("it lies inside");
    let (ancestor, level) = climb(&tree, leaf, 0, [5, 6], [5, 6], &mut ());
    assert_eq!((ancestor.id, level), (leaf.id, 0));
}

#[test]
fn beyond_the_border_there_is_no_neighbour() {
    let tree = full(Domain::<3>::unit(3));
    for leaf in tree.leaves() {
        let code = tree.code(leaf.id);
        for direction in Direction::all() {
            let steps = direction.components();
            let inside =
                (0..3).all(|e| (0..8).contains(&(i64::from(code[e]) + i64::from(steps[e]))));
            for find in [neighbour::<3>, neighbour_by_tables] {
                let found = find(&tree, leaf.id, direction, Reach::Leaf, &mut ()).node;
                assert_eq!(found.is_some(), inside, "{code:?} {steps:?}");
            }
        }
    }
}

#[test]
fn neighbours_are_those_that_a_search_of_all_leaves_finds() {
    // Leaves of three sizes: the lower half of x is divided further down the corner.
    let tree = grow(Domain::<2>::unit(3), (), &Progress::default(), |cell, ()| {
        let divided = cell.level == 3 || (cell.level > 0 && cell.code == [0, 0]);
        if divided { Split::Inner(vec![(); 4]) } else { Split::Empty }
    })
    .expect("nobody cancels");
    for leaf in tree.leaves() {
        for direction in Direction::all() {
            let target: [i64; 2] = std::array::from_fn(|e| {
                let side = 1i64 << tree.level(leaf.id);
                let low = i64::from(tree.code(leaf.id)[e]);
                match direction.components()[e] {
                    -1 => low - 1,
                    0 => low,
                    _ => low + side,
                }
            });
            let holds = |id: NodeId| {
                (0..2).all(|e| {
                    let low = i64::from(tree.code(id)[e]);
                    (low..low + (1 << tree.level(id))).contains(&target[e])
                })
            };
            let expected = tree.leaves().map(|leaf| leaf.id).find(|&id| holds(id));
            for find in [neighbour::<2>, neighbour_by_tables] {
                let found = find(&tree, leaf.id, direction, Reach::Leaf, &mut ()).node;
                assert_eq!(found, expected, "{:?} {direction:?}", tree.code(leaf.id));
            }
        }
    }
}

#[test]
fn a_node_is_found_by_level_and_code_and_not_by_code_and_level() {
    let tree = full(Domain::<2>::unit(3));
    let node = tree.node_at(1, [2, 4]).expect("it lies inside");
    assert_eq!((tree.level(node.id), tree.code(node.id)), (1, [2, 4]));
    let other = tree.node_at(2, [0, 4]).expect("it lies inside");
    assert_eq!((tree.level(other.id), tree.code(other.id)), (2, [0, 4]));
}

#[test]
fn the_stack_holds_whatever_waits_and_equal_points_end_the_division() {
    // A path as deep as can be, and on every level of it all that can wait.
    let tree = grow(Domain::<3>::unit(20), (), &Progress::default(), |cell, ()| {
        let on_path = cell.code == [0; 3] && cell.level > 0;
        if on_path { Split::Inner(vec![(); 8]) } else { Split::Empty }
    })
    .expect("nobody cancels");
    let diagonal = ray([-1e-7, -2e-7, -3e-7], [1.0, 1.0, 1.0]);
    let oracle = run(&tree, &diagonal, Algorithm::Exhaustive, Arithmetic::Exact);
    assert!(oracle.leaves().count() > 40);
    // The finest grid has a million cells along the diagonal.
    let in_tree = |a: &Algorithm| !matches!(a, Algorithm::Dda | Algorithm::DdaOctree);
    for algorithm in Algorithm::ALL.into_iter().filter(in_tree) {
        let trace = run(&tree, &diagonal, algorithm, Arithmetic::Exact);
        let ids = trace.leaves().map(|(id, _)| id);
        assert!(ids.eq(oracle.leaves().map(|(id, _)| id)), "{algorithm:?}");
        let end = Moment::after(&tree, &trace, usize::MAX);
        assert!(end.pending.is_empty(), "{algorithm:?}");
    }

    // More equal points than a leaf may hold: the depth ends the division.
    let points = Content::Points(vec![[0.3, 0.3]; 9]);
    let recipe = Recipe { depth: 6, capacity: 1, ..Recipe::default() };
    let tree = build(&points, Domain::<2>::unit(6), &recipe, &Progress::default());
    let tree = tree.expect("equal points are points");
    let leaf = locate_by_codes(&tree, [0.3, 0.3], &mut ()).node.expect("it lies inside");
    assert_eq!((tree.level(leaf), tree.items(leaf).len()), (0, 9));
}

#[test]
fn the_oracle_shares_no_arithmetic_with_what_it_checks() {
    let source = include_str!("../src/traverse/exhaustive.rs");
    let code: String = source
        .split("#[cfg(test)]")
        .next()
        .into_iter()
        .flat_map(str::lines)
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect();
    let words: Vec<&str> = code.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
    for shared in [
        "Parameter",
        "Exact",
        "Scaled",
        "Short",
        "clip",
        "Clip",
        "slabs",
        "latest",
        "earliest",
        "at_planes",
        "beyond",
        "exit_of",
        "code_at",
        "owns",
        "locate",
        "descend",
        "Report",
    ] {
        assert!(!words.contains(&shared), "the oracle names {shared}");
    }
    // What it does use: leaves, their boxes, the ray, events.
    for used in ["Aabb", "Ray", "Event", "Tree", "BigInt"] {
        assert!(words.contains(&used), "the oracle no longer names {used}");
    }
}
