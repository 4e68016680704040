//! Every ray of the gallery is what it is said to be, and every algorithm finds
//! on it what the oracle finds.

use octoscope_core::event::{End, Event};
use octoscope_core::explain::sentence;
use octoscope_core::gallery::Degenerate;
use octoscope_core::geometry::{Axes, Ray};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::text::Language;
use octoscope_core::trace::{Trace, record, rounded_steps};
use octoscope_core::traverse::{Algorithm, Options, Slivers, doubles_suffice, first_difference};
use octoscope_core::tree::{Child, Domain, NodeId, Split, Tree, grow};

#[path = "laws/trees.rs"]
mod trees;

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

/// Whether the coordinate is one of a plane between cells of the finest grid.
fn on_plane<const D: usize>(domain: &Domain<D>, axis: usize, x: f64) -> bool {
    domain.plane(axis, domain.nearest_index(axis, x)) == x
        || domain.plane(axis, domain.nearest_index(axis, x) + 1) == x
}

fn check_kind<const D: usize>(tree: &Tree<D>, kind: Degenerate, ray: &Ray<D>) {
    let domain = tree.domain();
    let bounds = domain.root_box();
    let (origin, direction) = (ray.origin(), ray.direction());
    let oracle = run(tree, ray, Algorithm::Exhaustive);
    let parametric = run(tree, ray, Algorithm::Parametric);
    let (n_leaves, n_touches) = (oracle.leaves().count(), touches(&oracle));
    let n_moving = direction.iter().filter(|d| **d != 0.0).count();
    let resting_on_planes =
        (0..D).filter(|&e| direction[e] == 0.0 && on_plane(domain, e, origin[e])).count();
    let missed = oracle.outcome.end == End::Missed;
    let n_on_planes = (0..D).filter(|&e| on_plane(domain, e, origin[e])).count();

    let holds = match kind {
        Degenerate::AxisParallel => n_moving == 1 && resting_on_planes == 0 && n_leaves > 0,
        Degenerate::FacePlane => resting_on_planes == 1 && n_moving == D - 1 && n_leaves > 0,
        Degenerate::LowerFace => direction[1] == 0.0 && origin[1] == bounds.min[1] && n_leaves > 0,
        Degenerate::UpperFace => {
            direction[1] == 0.0 && origin[1] == bounds.max[1] && missed && n_touches == 0
        }
        Degenerate::Edge => n_moving == 1 && resting_on_planes == 2 && n_leaves > 0,
        Degenerate::Corner | Degenerate::Slow => largest_tie(&parametric) == D && n_touches > 0,
        Degenerate::Centre | Degenerate::Diagonal => {
            let first_step = parametric.events.iter().find_map(|event| match event {
                Event::First { state, .. } => Some(*state),
                _ => None,
            });
            let sign = if kind == Degenerate::Diagonal { -1.0 } else { 1.0 };
            let signs_fit = direction.iter().all(|d| d.signum() == sign);
            first_step == Some(Child(0)) && largest_tie(&parametric) == D && signs_fit
        }
        Degenerate::NegativeZero => {
            let negative = direction.iter().filter(|d| **d == 0.0 && d.is_sign_negative()).count();
            negative == D - 1 && resting_on_planes == 1 && n_leaves > 0
        }
        Degenerate::Tiny => {
            direction[1] > 0.0 && direction[1] == 1e-7 * direction[0] && n_on_planes == 1
        }
        Degenerate::OnFace => {
            // The ray moves down along x: its first leaf lies below the plane.
            let first = oracle.leaves().next().map(|(leaf, _)| tree.node_box(leaf).max[0]);
            n_on_planes == 1 && bounds.owns(origin) && first == Some(origin[0])
        }
        Degenerate::OnCorner => n_on_planes == D && bounds.owns(origin) && n_leaves > 0,
        Degenerate::Inside => n_on_planes == 0 && bounds.owns(origin) && n_leaves > 0,
        Degenerate::Behind => {
            let back = Ray::new(origin, direction.map(|d| -d)).expect("it is turned round");
            let behind = run(tree, &back, Algorithm::Exhaustive).leaves().count();
            missed && n_touches == 0 && behind > 0
        }
        Degenerate::Leaving => missed && n_touches > 0 && bounds.owns(origin),
        Degenerate::Grazing => missed && n_touches > 0 && !bounds.owns(origin),
        Degenerate::Miss => missed && n_touches == 0 && n_moving == D,
        Degenerate::Lattice => {
            let opposed = direction[0] > 0.0 && direction[1] < 0.0;
            largest_tie(&parametric) == 2 && n_moving == D && n_touches > 0 && opposed
        }
        Degenerate::LatticeSpace => largest_tie(&parametric) == 3 && n_touches > 0,
        Degenerate::Thirds => {
            let parted = !rounded_steps(tree, ray, &parametric).is_empty();
            n_moving == D && (parted || domain.root_level() < 2)
        }
        Degenerate::Far => !doubles_suffice(domain, ray) && n_leaves > 0,
    };
    assert!(holds, "{kind:?} {domain:?} {ray:?}");
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

fn check_gallery<const D: usize>() {
    for_trees::<D>(|tree| {
        for kind in Degenerate::ALL {
            let ray = kind.ray(tree);
            assert_eq!(ray.is_some(), kind.exists_in(D), "{kind:?}");
            let Some(ray) = ray else { continue };
            check_kind(tree, kind, &ray);
            check_algorithms(tree, kind, &ray);
        }
    });
}

#[test]
fn every_ray_in_the_plane_is_what_it_is_said_to_be() {
    check_gallery::<2>();
}

#[test]
fn every_ray_in_space_is_what_it_is_said_to_be() {
    check_gallery::<3>();
}

#[test]
fn a_tree_of_one_leaf_has_a_gallery_as_well() {
    let leaf = |depth| {
        grow(Domain::<3>::unit(depth), (), &Progress::default(), |_, ()| Split::Empty).unwrap()
    };
    for tree in [leaf(0), leaf(5)] {
        for kind in Degenerate::ALL {
            check_algorithms(&tree, kind, &kind.ray(&tree).unwrap());
        }
    }
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
        "Child 0 is left through the x and y planes at once: t_y1 = 15 < t_x1 = \
         15.000000000000002, so the x and y bits are set together and the next state is 3. \
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
