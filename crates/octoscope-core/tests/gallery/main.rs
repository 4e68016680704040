//! Every ray of the gallery is what it is said to be, and every algorithm finds
//! on it what the oracle finds.

use octoscope_core::event::{End, Event};
use octoscope_core::explain::sentence;
use octoscope_core::gallery::Degenerate;
use octoscope_core::geometry::{Aabb, Axes, Ray};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::text::Language;
use octoscope_core::trace::{Trace, record, rounded_steps};
use octoscope_core::traverse::{Algorithm, Options, Slivers, first_difference};
use octoscope_core::tree::{Domain, NodeId, Split, Tree, grow};

mod line;
#[path = "../laws/trees.rs"]
mod trees;

use line::{At, between, is_as_far, passes};

/// Trees of several depths in domains at 0 and elsewhere, with exact and with
/// rounded planes.
fn for_trees<const D: usize>(mut check: impl FnMut(&Tree<D>)) {
    let mut random = Random::new(7);
    for n in 0..40 {
        check(&trees::random_tree(trees::domain::<D>(1 + (n % 10) as u8, n / 10), 30, &mut random));
    }
}

fn run<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, algorithm: Algorithm) -> Trace<D> {
    let options = Options::default();
    record(tree, ray, &Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact })
}

fn touches<const D: usize>(trace: &Trace<D>) -> usize {
    trace.events.iter().filter(|event| matches!(event, Event::Touch { .. })).count()
}

/// Most axes whose planes are crossed at once.
fn largest_tie<const D: usize>(trace: &Trace<D>) -> usize {
    let ties = trace.events.iter().map(|event| match event {
        Event::Step { axes, .. } => axes.count(),
        _ => 0,
    });
    ties.max().unwrap_or(0)
}

/// Whether the coordinate is one of a plane of the finest grid.
fn on_plane<const D: usize>(domain: &Domain<D>, axis: usize, x: f64) -> bool {
    domain.plane(axis, domain.nearest_index(axis, x)) == x
        || domain.plane(axis, domain.nearest_index(axis, x) + 1) == x
}

/// Whether every coordinate is a multiple of `step` from the root's lower planes.
fn on_lattice<const D: usize>(domain: &Domain<D>, point: [f64; D], step: f64) -> bool {
    (0..D).all(|e| ((point[e] - domain.min()[e]) / step).fract() == 0.0)
}

/// Number of leaves of the smallest size of which `point` is a corner.
fn n_smallest_at<const D: usize>(tree: &Tree<D>, point: [f64; D]) -> usize {
    let boxes = smallest(tree).map(|leaf| tree.node_box(leaf));
    let has_corner =
        |bounds: &Aabb<D>| (0..D).all(|e| point[e] == bounds.min[e] || point[e] == bounds.max[e]);
    boxes.filter(has_corner).count()
}

/// The leaves of the smallest size.
fn smallest<const D: usize>(tree: &Tree<D>) -> impl Iterator<Item = NodeId> {
    let least = tree.leaves().map(|leaf| tree.level(leaf.id)).min();
    tree.leaves().map(|leaf| leaf.id).filter(move |&id| Some(tree.level(id)) == least)
}

/// What makes a ray one of its kind, as exact arithmetic finds it.
fn holds<const D: usize>(tree: &Tree<D>, kind: Degenerate, ray: &Ray<D>) -> bool {
    let domain = tree.domain();
    let bounds = domain.root_box();
    let (origin, direction) = (ray.origin(), ray.direction());
    let oracle = run(tree, ray, Algorithm::Exhaustive);
    let parametric = run(tree, ray, Algorithm::Parametric);
    let n_leaves = oracle.leaves().count();
    let missed = oracle.outcome.end == End::Missed;
    let n_moving = direction.iter().filter(|d| **d != 0.0).count();
    let n_on_planes = (0..D).filter(|&e| on_plane(domain, e, origin[e])).count();
    let of_root = between(ray, bounds);
    let exact_planes = domain.side().log2().fract() == 0.0;

    // Leaves of the smallest size with another one below them along these axes, whose
    // lower planes there are those of the origin.
    let beside_faces = |axes: &[usize]| {
        let is_beside = |leaf: &NodeId| {
            let lower = tree.node_box(*leaf).min;
            axes.iter().all(|&e| lower[e] == origin[e] && lower[e] > bounds.min[e])
        };
        let mut small = smallest(tree).filter(is_beside);
        small.any(|small| oracle.leaves().any(|(leaf, _)| leaf == small))
    };
    let root_centre = || {
        let half = domain.grid_size() / 2;
        let middle = bounds.centre();
        let mid_plane = |e| if half > 0 { domain.plane(e, half) } else { middle[e] };
        std::array::from_fn(mid_plane)
    };
    let comes_to_corner = || {
        let lower = smallest(tree).map(|leaf| tree.node_box(leaf).min);
        let mut corners = lower.filter(|&corner| n_smallest_at(tree, corner) == 1 << D);
        corners.any(|corner| passes(ray, corner))
    };
    let equal = |sign: f64| direction.iter().all(|d| d.signum() == sign && *d == direction[0]);
    let tie_of = |n: usize| n_moving == D && largest_tie(&parametric) == n;
    // On the lattice of the smallest cells, if it has exact coordinates.
    let to_lattice = || {
        let tip = std::array::from_fn(|e| origin[e] + direction[e]);
        let step = domain.cell_side(0);
        !exact_planes || [origin, tip].iter().all(|&point| on_lattice(domain, point, step))
    };

    match kind {
        Degenerate::AxisParallel => n_moving == 1 && n_on_planes == 0 && n_leaves > 0,
        Degenerate::FacePlane => direction[1] == 0.0 && n_moving == D - 1 && beside_faces(&[1]),
        Degenerate::LowerFace => direction[1] == 0.0 && origin[1] == bounds.min[1] && n_leaves > 0,
        Degenerate::UpperFace => {
            let along_it = of_root.is_some_and(|[enter, exit]| enter < exit);
            let untouched = missed && touches(&oracle) == 0;
            direction[1] == 0.0 && origin[1] == bounds.max[1] && along_it && untouched
        }
        Degenerate::Edge => n_moving == 1 && direction[0] != 0.0 && beside_faces(&[1, 2]),
        Degenerate::Corner => tie_of(D) && comes_to_corner(),
        Degenerate::Slow => {
            let [enter, exit] = of_root.expect("it moves along every axis");
            let fast = Ray::new(origin, direction.map(|d| d * 1e300)).expect("so are these");
            let [_, later] = between(&fast, bounds).expect("it moves along every axis");
            let near_one = |at: At| at > At::ratio(1, 100) && at < At::ratio(100, 1);
            enter < exit && near_one(later) && n_leaves > 0
        }
        Degenerate::Centre | Degenerate::Diagonal => {
            let sign = if kind == Degenerate::Diagonal { -1.0 } else { 1.0 };
            let corners = [bounds.min, bounds.max];
            let to_corners = !exact_planes || corners.iter().all(|&corner| passes(ray, corner));
            equal(sign) && passes(ray, root_centre()) && to_corners
        }
        Degenerate::NegativeZero => {
            let negative = direction.iter().filter(|d| **d == 0.0 && d.is_sign_negative()).count();
            negative == D - 1 && beside_faces(&[1])
        }
        Degenerate::Tiny => {
            let slow = direction[1] > 0.0 && direction[1] == 1e-7 * direction[0];
            slow && n_moving == D && n_on_planes == 1 && beside_faces(&[1])
        }
        Degenerate::OnFace => {
            // The ray moves down along x: its first leaf lies below the plane.
            let first = oracle.leaves().next().map(|(leaf, _)| leaf);
            let below = smallest(tree).find(|&leaf| Some(leaf) == first);
            let code = domain.encode_point(origin).expect("the origin is inside");
            let owner = tree.node_at(0, code).expect("every cell is in a leaf").id;
            n_on_planes == 1
                && below.is_some_and(|leaf| tree.node_box(leaf).max[0] == origin[0])
                && tree.node_box(owner).min[0] == origin[0]
        }
        Degenerate::OnCorner => n_smallest_at(tree, origin) == 1 << D && n_leaves > 0,
        Degenerate::Inside => n_on_planes == 0 && bounds.owns(origin) && n_leaves > 0,
        Degenerate::Behind => {
            let [enter, exit] = of_root.expect("it moves along every axis");
            missed && touches(&oracle) == 0 && enter < exit && exit < At::origin()
        }
        Degenerate::Leaving => {
            let [enter, exit] = of_root.expect("it moves along every axis");
            bounds.owns(origin) && missed && enter < exit && exit == At::origin()
        }
        Degenerate::Grazing => {
            let [enter, exit] = of_root.expect("it moves along every axis");
            missed && touches(&oracle) > 0 && enter == exit && exit > At::origin()
        }
        Degenerate::Miss => {
            let [enter, exit] = of_root.expect("it moves along every axis");
            missed && touches(&oracle) == 0 && enter > exit && exit > At::origin()
        }
        Degenerate::Lattice => {
            let opposed = direction[0] > 0.0 && direction[1] < 0.0;
            tie_of(2) && opposed && touches(&oracle) > 0 && to_lattice()
        }
        Degenerate::LatticeSpace => {
            let [x, y, z] = [0, 1, 2].map(|e| direction[e].abs());
            tie_of(3) && x != y && y != z && z != x && comes_to_corner() && to_lattice()
        }
        Degenerate::Thirds => {
            let step = domain.side() / 16.0;
            let third = |d: f64| (3.0 * d / step).round() * step / 3.0 == d;
            let thirds = on_lattice(domain, origin, step) && direction.iter().all(|&d| third(d));
            let parted = !rounded_steps(tree, ray, &parametric).is_empty();
            n_moving == D && parted && (thirds || !exact_planes)
        }
        Degenerate::Far => {
            let nearest = std::array::from_fn(|e| origin[e].clamp(bounds.min[e], bounds.max[e]));
            is_as_far(origin, nearest, 1e6 * domain.side()) && n_leaves > 0
        }
    }
}

/// Every algorithm on the ray, exactly and in doubles, against the oracle.
fn check_algorithms<const D: usize>(tree: &Tree<D>, kind: Degenerate, ray: &Ray<D>) {
    let ids = |trace: &Trace<D>| trace.leaves().map(|(id, _)| id).collect::<Vec<NodeId>>();
    let oracle = run(tree, ray, Algorithm::Exhaustive);
    for algorithm in Algorithm::ALL {
        let exact = run(tree, ray, algorithm);
        assert_eq!(ids(&exact), ids(&oracle), "{algorithm:?} {kind:?} {ray:?}");
        assert_eq!(exact.outcome, oracle.outcome, "{algorithm:?} {kind:?} {ray:?}");
        let (options, arithmetic) = (Options::default(), Arithmetic::Doubles);
        let doubles = record(tree, ray, &Query::Ray { algorithm, options, arithmetic });
        let (expected, found) = (ids(&oracle), ids(&doubles));
        let difference = first_difference(tree, ray, &expected, &found, Slivers::Ignore);
        assert_eq!(difference, None, "{algorithm:?} {kind:?} {ray:?}");
    }
}

/// The whole gallery of a tree; which rays it has.
fn check_gallery<const D: usize>(tree: &Tree<D>) -> Vec<Degenerate> {
    let mut found = Vec::new();
    for kind in Degenerate::ALL {
        let ray = kind.ray(tree);
        assert_eq!(ray.is_some(), kind.exists_in(tree), "{kind:?} {:?}", tree.domain());
        let Some(ray) = ray else { continue };
        assert!(holds(tree, kind, &ray), "{kind:?} {:?} {ray:?}", tree.domain());
        check_algorithms(tree, kind, &ray);
        found.push(kind);
    }
    found
}

#[test]
fn every_ray_in_the_plane_is_what_it_is_said_to_be() {
    let all: Vec<_> = Degenerate::ALL.into_iter().filter(|kind| !kind.is_of_space()).collect();
    for_trees::<2>(|tree| assert_eq!(check_gallery(tree), all));
}

#[test]
fn every_ray_in_space_is_what_it_is_said_to_be() {
    for_trees::<3>(|tree| assert_eq!(check_gallery(tree), Degenerate::ALL));
}

#[test]
fn a_tree_of_one_leaf_has_the_rays_that_need_no_division() {
    fn check<const D: usize>() {
        for depth in [0, 1, 5] {
            for kind in 0..4 {
                let domain = trees::domain::<D>(depth, kind);
                let leaf = grow(domain, (), &Progress::default(), |_, ()| Split::Empty);
                assert_eq!(check_gallery(&leaf.expect("nobody cancels")).len(), 11);
            }
        }
    }
    check::<2>();
    check::<3>();
}

#[test]
fn the_deepest_tree_has_a_gallery_as_well() {
    fn check<const D: usize>() {
        for kind in 0..2 {
            let tree: Tree<D> =
                trees::random_tree(trees::domain(20, kind), 30, &mut Random::new(3));
            for kind in Degenerate::ALL {
                let ray = kind.ray(&tree);
                assert_eq!(ray.is_some(), kind.exists_in(&tree), "{kind:?}");
                assert!(ray.is_none_or(|ray| holds(&tree, kind, &ray)), "{kind:?} {ray:?}");
            }
        }
    }
    check::<2>();
    check::<3>();
}

/// The sentences of an exact run on the thirds that say that doubles err.
fn thirds_are_told<const D: usize>(algorithm: Algorithm, language: Language) -> Vec<String> {
    let mut told = Vec::new();
    for_trees::<D>(|tree| {
        let ray = Degenerate::Thirds.ray(tree).expect("thirds are everywhere");
        let trace = run(tree, &ray, algorithm);
        let steps = rounded_steps(tree, &ray, &trace);
        let said = (0..=trace.events.len())
            .map(|step| sentence(tree, &ray, &trace, step, language).plain())
            .filter(|text| text.contains(" would err here") || text.contains(" würden hier irren"));
        let before = told.len();
        told.extend(said);
        assert_eq!(told.len() - before, steps.len());
    });
    told
}

#[test]
fn a_tie_that_doubles_break_is_told_with_its_ulps() {
    // Both mid planes are met at t = 15; in doubles x comes an ulp too late.
    let direction = [0.030_000_000_000_000_054, 0.03125];
    let ray = Ray::new([0.049_999_999_999_999_184, 0.031_25], direction).unwrap();
    let tree = grow(Domain::<2>::unit(1), (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 4]),
    });
    let tree = tree.unwrap();
    let trace = run(&tree, &ray, Algorithm::Parametric);
    let [(step, disagreement)] = rounded_steps(&tree, &ray, &trace)[..] else {
        panic!("one step alone")
    };
    assert_eq!((disagreement.axes, disagreement.ulps), (Axes::one(0), 1));
    assert_eq!(
        sentence(&tree, &ray, &trace, step, Language::English).plain(),
        "Child 0 is left at the x and y planes at once: t_ym = 15 < t_xm = \
         15.000000000000002, so their bits are set: state 3. \
         Doubles would err here: they put the parameters 1 ulp apart."
    );
}

#[test]
fn thirds_are_rays_on_which_doubles_decide_otherwise_and_it_is_said() {
    let english = thirds_are_told::<2>(Algorithm::Parametric, Language::English);
    assert!(english.len() > 20, "{}", english.len());
    let ending = " Doubles would err here: both parameters round to the same number.";
    assert!(english.iter().any(|text| text.ends_with(ending)), "{english:#?}");
    let german = thirds_are_told::<3>(Algorithm::Bsp, Language::German);
    let ending = " Gleitkommazahlen würden hier irren: Beide Parameter werden auf dieselbe Zahl \
                  gerundet.";
    assert!(german.iter().any(|text| text.ends_with(ending)), "{german:#?}");
}
