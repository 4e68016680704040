//! Laws of trees that are built from content.

use octoscope_core::event::End;
use octoscope_core::geometry::Aabb;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::random::Random;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, Scenario, built_in};
use octoscope_core::scene::{Content, Image, Sphere, leaf_colours, made, pixels_of};
use octoscope_core::tree::{
    BuildError, Child, Code, Domain, Fill, Merge, NodeId, Recipe, Tree, build, build_on,
};
use std::collections::BTreeSet;
use std::num::NonZeroUsize;

fn tree<const D: usize>(content: &Content<D>, recipe: Recipe) -> Tree<D> {
    build(content, Domain::unit(recipe.depth), &recipe, &Progress::default())
        .expect("the content fits")
}

/// Codes of the smallest cells in full leaves; all leaves tile the root.
fn full_cells<const D: usize>(tree: &Tree<D>) -> BTreeSet<Code<D>> {
    let mut covered = 0u64;
    let mut full = BTreeSet::new();
    for leaf in tree.leaves() {
        let (level, code) = (tree.level(leaf.id), tree.code(leaf.id));
        let count = 1u64 << (u32::from(level) * D as u32);
        covered += count;
        if leaf.is_full() {
            full.extend((0..count).map(|n| -> Code<D> {
                let part = |e: usize| n >> (e * usize::from(level)) & ((1 << level) - 1);
                std::array::from_fn(|e| code[e] + part(e) as u32)
            }));
        }
    }
    assert_eq!(covered, u64::from(tree.domain().grid_size()).pow(D as u32));
    full
}

fn every_leaf_is_as_large_as_it_can_be<const D: usize>(tree: &Tree<D>) {
    for node in tree.nodes().filter(|node| !node.is_leaf()) {
        let kinds = tree.children(node).map(|c| (c.is_leaf(), c.is_full()));
        let kinds: Vec<_> = kinds.collect();
        assert_ne!(kinds, vec![(true, true); Child::<D>::COUNT]);
        assert_ne!(kinds, vec![(true, false); Child::<D>::COUNT]);
    }
}

fn region_laws<const D: usize>(seed: u64) {
    let mut random = Random::new(seed);
    for round in 0..40 {
        let count = random.below(1 << (D * 3)) as usize;
        let cells = (0..count).map(|_| [(); D].map(|()| random.below(8) as u32));
        let cells: Vec<Code<D>> = cells.collect();
        let recipe = Recipe { depth: 3, ..Recipe::default() };
        let content = Content::Cells(cells.clone());
        let whole = tree(&content, recipe);
        let set = BTreeSet::from_iter(cells);
        assert_eq!(full_cells(&whole), set, "round {round}");
        every_leaf_is_as_large_as_it_can_be(&whole);
        let kept = tree(&content, Recipe { merge: Merge::Kept, ..recipe });
        assert_eq!(full_cells(&kept), set);
        assert!(kept.leaves().all(|leaf| !leaf.is_full() || kept.level(leaf.id) == 0));
    }
}

#[test]
fn cells_make_the_region_tree_of_exactly_these_cells() {
    region_laws::<2>(1);
    region_laws::<3>(2);
}

#[test]
fn the_order_of_points_does_not_matter() {
    let Content::Points(mut points) = made::clustered_points::<3>(4, 500) else { panic!() };
    let recipe = Recipe { depth: 7, capacity: 2, ..Recipe::default() };
    let first = tree(&Content::Points(points.clone()), recipe);
    points.reverse();
    let second = tree(&Content::Points(points), recipe);
    assert_eq!(first.n_nodes(), second.n_nodes());
    for (a, b) in first.nodes().zip(second.nodes()) {
        assert_eq!(a, b);
        let mirrored: Vec<u32> = second.items(b.id).iter().rev().map(|i| 499 - i).collect();
        assert_eq!(first.items(a.id), mirrored);
    }
}

#[test]
fn a_bucket_is_split_only_when_it_overflows() {
    let recipe = Recipe { depth: 6, capacity: 4, ..Recipe::default() };
    let tree = tree(&made::clustered_points::<2>(9, 800), recipe);
    let below = |id: NodeId| -> usize {
        let inside = tree.leaves().filter(|l| l.id == id || tree.ancestors(l.id).any(|a| a == id));
        inside.map(|leaf| tree.items(leaf.id).len()).sum()
    };
    assert!(tree.nodes().filter(|node| !node.is_leaf()).all(|node| below(node.id) > 4));
}

/// Distances in eighths of a cell between cell corners and centres.
#[test]
fn spheres_occupy_the_cells_that_integers_say() {
    let mut random = Random::new(11);
    for fill in [Fill::Surface, Fill::Solid] {
        let (centre, radius): ([i64; 3], i64) =
            ([(); 3].map(|()| random.below(65) as i64), 9 + random.below(30) as i64);
        let eighths = |x: i64| x as f64 / 64.0;
        let sphere = Sphere { centre: centre.map(eighths), radius: eighths(radius) };
        let recipe = Recipe { depth: 3, fill, ..Recipe::default() };
        let tree = tree(&Content::Spheres(vec![sphere]), recipe);
        every_leaf_is_as_large_as_it_can_be(&tree);
        let mut expected = BTreeSet::new();
        for n in 0..512u32 {
            let code: Code<3> = [n >> 6, n >> 3 & 7, n & 7];
            let gaps = |e: usize| {
                [i64::from(code[e]) * 8 - centre[e], i64::from(code[e]) * 8 + 8 - centre[e]]
            };
            let near = (0..3).map(|e| gaps(e)[0].max(-gaps(e)[1]).max(0).pow(2)).sum::<i64>();
            let far = (0..3).map(|e| gaps(e)[0].pow(2).max(gaps(e)[1].pow(2))).sum::<i64>();
            let square = radius * radius;
            if near <= square && (fill == Fill::Solid || square <= far) {
                expected.insert(code);
            }
        }
        assert_eq!(full_cells(&tree), expected);
    }
}

#[test]
fn boxes_and_plane_triangles_fill_what_they_cover() {
    let solid = Aabb { min: [0.25, 0.0], max: [0.75, 0.5] };
    let recipe = Recipe { depth: 3, ..Recipe::default() };
    let boxes = tree(&Content::Boxes(vec![solid]), recipe);
    let cells = (0..64u32).map(|n| [n / 8, n % 8]);
    let expected = cells.clone().filter(|c| (2..6).contains(&c[0]) && c[1] < 4);
    assert_eq!(full_cells(&boxes), expected.collect());

    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let triangles = tree(&Content::Triangles(vec![triangle]), recipe);
    let expected = cells.filter(|c| c[0] + c[1] <= 8);
    assert_eq!(full_cells(&triangles), expected.collect());
    every_leaf_is_as_large_as_it_can_be(&triangles);
}

#[test]
fn leaves_of_a_picture_are_even_and_have_its_colours() {
    let mut random = Random::new(3);
    for (width, height, depth) in [(13, 7, 4), (16, 16, 3), (5, 9, 6), (1, 1, 0), (0, 0, 2)] {
        let mut grey = || random.below(3) as u8 * 20;
        let pixels: Vec<_> = (0..width * height).map(|_| [grey(), 0, grey()]).collect();
        let image = Image { width, height, pixels };
        let recipe = Recipe { depth, threshold: 25, ..Recipe::default() };
        let tree = tree(&Content::Image(image.clone()), recipe);
        let colours = leaf_colours(&image, &tree);
        for leaf in tree.leaves() {
            let (level, code) = (tree.level(leaf.id), tree.code(leaf.id));
            let [columns, rows] = pixels_of(&image, depth, level, code);
            let inside: Vec<_> = rows.flat_map(|r| columns.clone().map(move |c| (c, r))).collect();
            assert_eq!(leaf.is_full(), !inside.is_empty());
            assert_eq!(leaf.is_full(), colours[leaf.id.index()].is_some());
            let reds = inside.iter().map(|&(c, r)| image.pixel_from_below(c, r)[0]);
            if let (Some(low), Some(high)) = (reds.clone().min(), reds.max()) {
                assert!(high - low <= 25 || level == 0);
                let mean = colours[leaf.id.index()].unwrap()[0];
                assert!((low..=high).contains(&mean));
            }
        }
    }
}

/// The tree of one thread is that of any other number, with all its contents.
fn threads_make_no_difference<const D: usize>(content: &Content<D>, recipe: Recipe) {
    let on = |threads: usize| {
        let (threads, domain) =
            (NonZeroUsize::new(threads).expect("not 0"), Domain::unit(recipe.depth));
        build_on(threads, content, domain, &recipe, &Progress::default())
    };
    let one = on(1);
    for threads in [2, 3, 7, 64] {
        // Not printed: it is large.
        assert!(on(threads) == one, "{threads} threads, {recipe:?}");
    }
    let many = one.as_ref().map_or(0, Tree::n_nodes);
    assert!(one == build(content, Domain::unit(recipe.depth), &recipe, &Progress::default()));
    assert!(many > 1000, "{many} nodes");
}

#[test]
fn any_number_of_threads_builds_the_same_tree() {
    let mut random = Random::new(5);
    let merges = [Merge::Whole, Merge::Kept];
    let recipe = |depth| Recipe { depth, capacity: 1, ..Recipe::default() };
    // Many points, some of them equal, and most in one corner.
    let Content::Points(mut points) = made::clustered_points::<3>(3, 70_000) else { panic!() };
    points.extend_from_within(..9_000);
    points.extend((0..90_000).map(|n| [f64::from(n) * 1e-9; 3]));
    threads_make_no_difference(&Content::Points(points.clone()), recipe(9));
    threads_make_no_difference(&Content::Points(points.clone()), recipe(20));
    let flat = points.iter().map(|&[x, y, _]| [x, y]).collect();
    threads_make_no_difference::<2>(&Content::Points(flat), recipe(12));
    let cells = (0..120_000).map(|_| [(); 3].map(|()| random.below(128) as u32));
    let cells = Content::Cells(cells.collect());
    for merge in merges {
        threads_make_no_difference(&cells, Recipe { merge, ..recipe(7) });
        for fill in [Fill::Surface, Fill::Solid] {
            let recipe = Recipe { merge, fill, ..recipe(6) };
            threads_make_no_difference(&made::cloud::<3>(1, 300), recipe);
            threads_make_no_difference(&made::sphere_grid::<3>(2), recipe);
        }
    }
    let mut corner = || [(); 3].map(|()| random.between(-0.1, 1.1));
    let triangles: Vec<_> = (0..60).map(|_| [(); 3].map(|()| corner())).collect();
    let boxes = triangles.iter().map(|[a, b, _]| Aabb::<3> {
        min: std::array::from_fn(|e| a[e].min(b[e])),
        max: std::array::from_fn(|e| a[e].max(b[e])),
    });
    threads_make_no_difference(&Content::Boxes(boxes.take(5).collect()), recipe(6));
    let flat = triangles.iter().map(|corners| corners.map(|[x, y, _]| [x, y])).take(3);
    threads_make_no_difference::<2>(&Content::Triangles(flat.collect()), recipe(9));
    threads_make_no_difference(&Content::Triangles(triangles), recipe(6));
    let pixels = (0..300 * 200).map(|_| [random.below(3) as u8 * 20; 3]).collect();
    let image = Image { width: 300, height: 200, pixels };
    threads_make_no_difference::<2>(&Content::Image(image), recipe(9));
}

#[test]
fn any_number_of_threads_says_what_is_wrong_and_can_be_stopped() {
    let mut points = vec![[0.25, 0.5]; 100_000];
    (points[40_123], points[80_000]) = ([1.0, 0.5], [0.5, -1.0]);
    let full = Content::Boxes(vec![Aabb { min: [0.0; 3], max: [1.0; 3] }]);
    let kept = Recipe { depth: 10, merge: Merge::Kept, ..Recipe::default() };
    for threads in [1, 2, 5] {
        let threads = NonZeroUsize::new(threads).expect("not 0");
        let (recipe, progress) = (Recipe::default(), Progress::default());
        let content = Content::Points(points.clone());
        let outside = build_on(threads, &content, Domain::unit(6), &recipe, &progress);
        assert_eq!(outside, Err(BuildError::Outside { count: 2, first: 40_123 }));
        progress.cancel();
        let cancelled = build_on(threads, &full, Domain::unit(10), &kept, &progress);
        assert!(cancelled == Err(BuildError::Cancelled(Cancelled)));
    }
}

fn builds<const D: usize>(id: &str, scenario: &Scenario<D>) {
    let tree = scenario.tree().expect(id);
    assert!(tree.leaves().any(|leaf| leaf.is_full()), "{id}");
    let outcome = scenario.query.run(&tree, &scenario.ray, &mut ());
    assert!(matches!(outcome.end, End::LeftRoot | End::Found), "{id}: {outcome:?}");
}

#[test]
fn every_built_in_scenario_builds_and_its_query_finds_something() {
    for entry in BUILT_IN {
        match built_in(entry.id).unwrap() {
            AnyScenario::Quadtree(scenario) => builds(entry.id, &scenario),
            AnyScenario::Octree(scenario) => builds(entry.id, &scenario),
        }
    }
}

#[test]
fn figure_1_shows_the_cells_of_the_binary_tree_along_its_axis() {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("figure-1") else { panic!() };
    let content = scenario.source.content().unwrap();
    let tree = tree(&content, scenario.recipe);
    let bottom = tree.leaves().filter(|leaf| tree.code(leaf.id)[1] == 0);
    let mut cells: Vec<_> = bottom.map(|l| (tree.code(l.id)[0], tree.level(l.id))).collect();
    cells.sort_unstable();
    assert_eq!(cells, [(0, 3), (8, 3), (16, 2), (20, 1), (22, 0), (23, 0), (24, 3)]);
}
