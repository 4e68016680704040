//! Queries without a ray against brute force over the leaves, in whole numbers.

use crate::trees::{domain, random_tree};
use octoscope_core::event::{End, Event, Outcome};
use octoscope_core::locate::{
    Direction, Reach, climb, locate_by_codes, locate_by_comparison, locate_region, neighbour,
    neighbour_by_tables,
};
use octoscope_core::random::Random;
use octoscope_core::tree::{Code, Domain, NodeId, Tree};

/// A node as a cube of smallest cells: its first cell and its side.
type Cube<const D: usize> = (NodeId, Code<D>, u32);

fn cubes<const D: usize>(tree: &Tree<D>) -> Vec<Cube<D>> {
    tree.nodes().map(|node| (node.id, tree.code(node.id), 1 << tree.level(node.id))).collect()
}

fn holds<const D: usize>((_, code, side): &Cube<D>, cell: [i64; D]) -> bool {
    (0..D).all(|e| (0..i64::from(*side)).contains(&(cell[e] - i64::from(code[e]))))
}

/// The smallest of `cubes` with at least `side` that holds both cells.
fn smallest<const D: usize>(cubes: &[Cube<D>], side: u32, cells: [[i64; D]; 2]) -> Option<NodeId> {
    let candidates =
        cubes.iter().filter(|cube| cube.2 >= side && cells.iter().all(|&cell| holds(cube, cell)));
    candidates.min_by_key(|cube| cube.2).map(|cube| cube.0)
}

fn outcome(node: Option<NodeId>) -> Outcome {
    node.map_or(Outcome::without_node(End::Outside), |node| Outcome::at(End::Found, node))
}

/// The cell next to the minimum corner of a cube, beyond its side in `direction`.
fn beyond<const D: usize>(cube: &Cube<D>, direction: Direction<D>) -> [i64; D] {
    std::array::from_fn(|e| match direction.components()[e] {
        -1 => i64::from(cube.1[e]) - 1,
        0 => i64::from(cube.1[e]),
        _ => i64::from(cube.1[e]) + i64::from(cube.2),
    })
}

fn for_random_trees<const D: usize>(mut check: impl FnMut(&Tree<D>, &mut Random)) {
    let mut random = Random::new(3);
    for n in 0..40 {
        let tree = random_tree(domain(1 + (n % 10) as u8, n), 30, &mut random);
        check(&tree, &mut random);
    }
}

fn neighbours_of_every_node<const D: usize>() {
    for_random_trees::<D>(|tree, _| {
        let cubes = cubes(tree);
        for cube in &cubes {
            for direction in Direction::all() {
                let cell = beyond(cube, direction);
                for (reach, side) in [(Reach::EqualOrLarger, cube.2), (Reach::Leaf, 1)] {
                    let found = neighbour(tree, cube.0, direction, reach, &mut ());
                    let expected = outcome(smallest(&cubes, side, [cell; 2]));
                    assert_eq!(found, expected, "{cube:?} {direction:?} {reach:?}");
                }
            }
        }
    });
}

/// Leaves that share more than a corner with a side of `node`, or a corner if
/// the direction is that of one: those whose cubes touch it there.
fn leaves_along<const D: usize>(
    tree: &Tree<D>,
    node: NodeId,
    direction: Direction<D>,
) -> Vec<NodeId> {
    let (low, side) = (tree.code(node), 1 << tree.level(node));
    let touches = |leaf: &NodeId| {
        let (code, size) = (tree.code(*leaf), 1 << tree.level(*leaf));
        (0..D).all(|e| match direction.components()[e] {
            0 => code[e] < low[e] + side && low[e] < code[e] + size,
            s if s > 0 => code[e] <= low[e] + side && low[e] + side < code[e] + size,
            _ => code[e] < low[e] && low[e] <= code[e] + size,
        })
    };
    tree.leaves().map(|leaf| leaf.id).filter(touches).collect()
}

fn tables_and_links_find_what_codes_find<const D: usize>() {
    for_random_trees::<D>(|tree, _| {
        for node in tree.nodes() {
            for direction in Direction::all() {
                for reach in [Reach::EqualOrLarger, Reach::Leaf] {
                    let by_codes = neighbour(tree, node.id, direction, reach, &mut ());
                    let by_tables = neighbour_by_tables(tree, node.id, direction, reach, &mut ());
                    assert_eq!(by_tables, by_codes);
                }
                for find in [neighbour::<D>, neighbour_by_tables] {
                    let mut events = Vec::new();
                    find(tree, node.id, direction, Reach::EveryLeaf, &mut events);
                    let found = |event: &Event<D>| match *event {
                        Event::Found { node } => Some(node),
                        _ => None,
                    };
                    let mut found: Vec<_> = events.iter().filter_map(found).collect();
                    found.sort();
                    assert_eq!(found, leaves_along(tree, node.id, direction), "{direction:?}");
                }
            }
            for axis in 0..D {
                for (step, upper) in [(-1, false), (1, true)] {
                    let direction = std::array::from_fn(|e| if e == axis { step } else { 0 });
                    let direction = Direction::new(direction).expect("one step");
                    let reach = Reach::EqualOrLarger;
                    let by_codes = neighbour(tree, node.id, direction, reach, &mut ());
                    assert_eq!(tree.neighbour_across(node.id, axis, upper), by_codes.node);
                }
            }
        }
    });
}

#[test]
fn tables_and_links_find_what_codes_find_in_quadtrees_and_octrees() {
    tables_and_links_find_what_codes_find::<2>();
    tables_and_links_find_what_codes_find::<3>();
}

#[test]
fn neighbours_are_those_of_brute_force_in_quadtrees() {
    neighbours_of_every_node::<2>();
}

#[test]
fn neighbours_are_those_of_brute_force_in_octrees() {
    neighbours_of_every_node::<3>();
}

fn equal_neighbours_point_back<const D: usize>() {
    for_random_trees::<D>(|tree, _| {
        for node in tree.nodes() {
            for direction in Direction::all() {
                let there = neighbour(tree, node.id, direction, Reach::EqualOrLarger, &mut ());
                let Some(there) = there.node.filter(|&n| tree.level(n) == tree.level(node.id))
                else {
                    continue;
                };
                let opposite = Direction::new(direction.components().map(|s| -s))
                    .expect("the opposite is a direction");
                let back = neighbour(tree, there, opposite, Reach::EqualOrLarger, &mut ());
                assert_eq!(back.node, Some(node.id));
            }
        }
    });
}

#[test]
fn neighbours_of_equal_size_are_neighbours_of_each_other() {
    equal_neighbours_point_back::<2>();
    equal_neighbours_point_back::<3>();
}

fn climbing_ends_at_the_common_ancestor<const D: usize>() {
    for_random_trees::<D>(|tree, random| {
        let cubes = cubes(tree);
        let size = u64::from(tree.domain().grid_size());
        for cube in &cubes {
            let to: Code<D> = std::array::from_fn(|_| random.below(size) as u32);
            let (id, from, _) = *cube;
            let (ancestor, level) = climb(tree, tree.node(id), tree.level(id), from, to, &mut ());
            let cells = [from, to].map(|code| code.map(i64::from));
            assert_eq!(Some(ancestor.id), smallest(&cubes, cube.2, cells), "{cube:?} {to:?}");
            assert_eq!(level, tree.level(ancestor.id));
            let is_above = ancestor.id == id || tree.ancestors(id).any(|n| n == ancestor.id);
            assert!(is_above, "{cube:?} {to:?}");
        }
    });
}

#[test]
fn climbing_ends_at_the_smallest_ancestor_that_holds_both() {
    climbing_ends_at_the_common_ancestor::<2>();
    climbing_ends_at_the_common_ancestor::<3>();
}

/// Cell that owns `point`, by comparing it with every plane.
fn owner<const D: usize>(domain: &Domain<D>, point: [f64; D]) -> Option<[i64; D]> {
    let mut cell = [0; D];
    for e in 0..D {
        let passed = (0..=domain.grid_size()).filter(|&n| domain.plane(e, n) <= point[e]).count();
        cell[e] = passed as i64 - 1;
        if passed == 0 || passed > domain.grid_size() as usize {
            return None;
        }
    }
    Some(cell)
}

/// Point near the domain, often on a plane, one unit beside it, or not at all.
fn awkward_point<const D: usize>(domain: &Domain<D>, random: &mut Random) -> [f64; D] {
    std::array::from_fn(|e| {
        let plane = domain.plane(e, random.below(u64::from(domain.grid_size()) + 1) as u32);
        match random.below(40) {
            0 => domain.min()[e] - domain.side(),
            1 => domain.plane(e, domain.grid_size()),
            2 => f64::NAN,
            3 => f64::INFINITY,
            4..12 => plane,
            12..16 => plane.next_up(),
            16..20 => plane.next_down(),
            _ => domain.min()[e] + domain.side() * random.unit(),
        }
    })
}

fn points_lie_in_the_leaf_that_owns_them<const D: usize>() {
    for_random_trees::<D>(|tree, random| {
        let cubes = cubes(tree);
        for _ in 0..200 {
            let point = awkward_point(tree.domain(), random);
            let cell = owner(tree.domain(), point);
            let expected = outcome(cell.and_then(|cell| smallest(&cubes, 1, [cell; 2])));
            assert_eq!(locate_by_codes(tree, point, &mut ()), expected, "{point:?}");
            assert_eq!(locate_by_comparison(tree, point, &mut ()), expected, "{point:?}");
        }
    });
}

#[test]
fn both_ways_locate_points_as_brute_force_does() {
    points_lie_in_the_leaf_that_owns_them::<2>();
    points_lie_in_the_leaf_that_owns_them::<3>();
}

fn regions_lie_in_the_smallest_node<const D: usize>() {
    for_random_trees::<D>(|tree, random| {
        let cubes = cubes(tree);
        for _ in 0..200 {
            let a = awkward_point(tree.domain(), random);
            // Small regions as well, so that small nodes are found.
            let size = tree.domain().side() * 0.5f64.powi(random.below(10) as i32);
            let b = std::array::from_fn(|e| a[e] + size * random.unit());
            let cells = [a, b].map(|point| owner(tree.domain(), point));
            let expected = match cells {
                [Some(a), Some(b)] => smallest(&cubes, 1, [a, b]),
                _ => None,
            };
            assert_eq!(locate_region(tree, a, b, &mut ()), outcome(expected), "{a:?} {b:?}");
        }
    });
}

#[test]
fn regions_lie_in_the_smallest_node_that_holds_both_corners() {
    regions_lie_in_the_smallest_node::<2>();
    regions_lie_in_the_smallest_node::<3>();
}

#[test]
fn places_are_found_at_any_level() {
    for_random_trees::<2>(|tree, _| {
        for node in tree.nodes() {
            let (level, code) = (tree.level(node.id), tree.code(node.id));
            assert_eq!(tree.node_at(level, code), Some(node));
        }
        assert_eq!(tree.node_at(u8::MAX, [0, 0]), Some(tree.root()));
        assert_eq!(tree.node_at(0, [tree.domain().grid_size(), 0]), None);
    });
}
