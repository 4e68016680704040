//! Which children are drawn as ruled out: the same in the picture and in the diagram,
//! and none to which the algorithm comes afterwards, as long as its rules are right.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Options, StopAt, Variant, Variants};
use octoscope_core::tree::{Domain, NodeId, Split, Tree, grow};
use octoscope_figure::{DiagramLens, DiagramOf, Mark, Page, Part, Role, Show, marks, tree_diagram};

/// So wide that nothing is folded for want of room.
const PAGE: Page = Page { width: 6000.0, height: 600.0 };

fn random_tree<const D: usize>(random: &mut Random) -> Tree<D> {
    let mut left = 12;
    let tree = grow(Domain::unit(4), (), &Progress::default(), |cell, ()| {
        let is_inner = cell.level > 0 && left > 0 && (cell.level == 4 || random.below(3) == 0);
        if is_inner {
            left -= 1;
            return Split::Inner(vec![(); 1 << D]);
        }
        if random.below(2) == 0 { Split::Empty } else { Split::Full(vec![]) }
    });
    tree.unwrap()
}

/// A ray from anywhere about the root, often along planes and through corners.
fn random_ray<const D: usize>(random: &mut Random) -> Ray<D> {
    loop {
        let step = if random.below(2) == 0 { 0.125 } else { 1.0 / 1024.0 };
        let mut on_grid = |low: f64, high: f64| (random.between(low, high) / step).round() * step;
        let origin = [(); D].map(|()| on_grid(-0.5, 1.5));
        let direction = [(); D].map(|()| on_grid(-1.0, 1.0));
        if let Ok(ray) = Ray::new(origin, direction) {
            return ray;
        }
    }
}

struct Run<'a, const D: usize> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    query: &'a Query<D>,
    trace: Trace<D>,
}

/// What is drawn as ruled out at a step.
struct Rejected {
    in_picture: Vec<NodeId>,
    in_diagram: Vec<NodeId>,
}

impl<const D: usize> Run<'_, D> {
    fn event(&self, step: usize) -> Option<&Event<D>> {
        step.checked_sub(1).and_then(|index| self.trace.events.get(index))
    }

    fn rejected(&self, step: usize) -> Rejected {
        let &Self { tree, ray, query, .. } = self;
        let (moment, event) = (Moment::after(tree, &self.trace, step), self.event(step));
        let all = marks(tree, ray, query, &moment, event, &Show::at_first::<D>());
        let of_mark = |mark: &Mark<D>| mark.node.filter(|_| mark.role == Role::Rejected);
        let mut in_picture: Vec<_> = all.iter().filter_map(of_mark).collect();
        let of = DiagramOf { tree, ray, query, moment: &moment, event, strayed: &[] };
        let diagram = tree_diagram(&of, &[], None, PAGE, DiagramLens::default());
        let dashed = diagram.figure.drawn.iter();
        let dashed = dashed.filter(|d| d.role == Role::Rejected && d.part == Part::Edge);
        let mut in_diagram: Vec<_> = dashed.filter_map(|drawn| drawn.node).collect();
        in_picture.sort();
        in_diagram.sort();
        Rejected { in_picture, in_diagram }
    }

    /// Checks every step; returns how many nodes were ruled out at all.
    fn check(&self) -> usize {
        let mut n_rejected = 0;
        for step in 0..=self.trace.events.len() {
            let Rejected { in_picture, in_diagram } = self.rejected(step);
            let place = || format!("{:?} {:?} step {step}", self.query, self.ray);
            assert_eq!(in_diagram, in_picture, "{} {:?}", place(), self.event(step));
            for event in &self.trace.events[step..] {
                let Event::Leaf { node, .. } = *event else { continue };
                let within = in_picture.iter().find(|&&out| self.tree.holds(out, node));
                assert_eq!(within, None, "{} {:?}", place(), self.event(step));
            }
            n_rejected += in_picture.len();
        }
        n_rejected
    }
}

fn along<const D: usize>(algorithm: Algorithm) -> Query<D> {
    with(algorithm, Options::default())
}

fn with<const D: usize>(algorithm: Algorithm, options: Options) -> Query<D> {
    Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact }
}

#[test]
fn for_rays_picture_and_diagram_rule_out_the_same_and_nothing_that_is_visited_later() {
    fn check<const D: usize>(seed: u64) -> Vec<usize> {
        let mut random = Random::new(seed);
        let mut n_rejected = vec![0; Algorithm::ALL.len()];
        for _ in 0..40 {
            let tree = random_tree::<D>(&mut random);
            let ray = random_ray(&mut random);
            for (n, algorithm) in Algorithm::ALL.into_iter().enumerate() {
                let query = along(algorithm);
                let trace = record(&tree, &ray, &query);
                let run = Run { tree: &tree, ray: &ray, query: &query, trace };
                n_rejected[n] += run.check();
            }
        }
        n_rejected
    }
    for n_rejected in [check::<2>(31), check::<3>(32)] {
        for (algorithm, n) in Algorithm::ALL.into_iter().zip(n_rejected) {
            // It steps from cell to cell.
            let chooses = algorithm != Algorithm::Dda;
            assert_eq!(n > 0, chooses, "{algorithm:?}: {n}");
        }
    }
}

#[test]
fn where_a_rule_is_another_or_the_run_ends_early_nothing_is_ruled_out_that_is_visited_later() {
    fn check<const D: usize>(seed: u64) -> usize {
        let mut random = Random::new(seed);
        let mut n_rejected = 0;
        for _ in 0..40 {
            let tree = random_tree::<D>(&mut random);
            let ray = random_ray(&mut random);
            for algorithm in Algorithm::ALL {
                let plain = Options::default();
                let mut all = vec![
                    Options { stop_at: StopAt::FirstFull, ..plain },
                    Options { segment_end: Some(0.4), ..plain },
                ];
                if algorithm == Algorithm::ParametricTable {
                    all.push(Options { variants: Variants::NONE.with(Variant::B2Morton), ..plain });
                }
                for query in all.into_iter().map(|options| with(algorithm, options)) {
                    let trace = record(&tree, &ray, &query);
                    n_rejected += Run { tree: &tree, ray: &ray, query: &query, trace }.check();
                }
            }
        }
        n_rejected
    }
    assert!(check::<2>(36) > 100 && check::<3>(37) > 100);
}

#[test]
fn for_points_picture_and_diagram_rule_out_the_same() {
    fn check<const D: usize>(seed: u64) -> usize {
        let mut random = Random::new(seed);
        let mut n_rejected = 0;
        for n in 0..12 {
            let tree = random_tree::<D>(&mut random);
            let ray = Ray::new([0.0; D], [1.0; D]).unwrap();
            let at = [(); D].map(|()| random.unit());
            let method = [PointMethod::Codes, PointMethod::Comparison][n % 2];
            let query = Query::Point { at, method, variants: Variants::NONE };
            let trace = record(&tree, &ray, &query);
            n_rejected += Run { tree: &tree, ray: &ray, query: &query, trace }.check();
        }
        n_rejected
    }
    assert!(check::<2>(33) > 10 && check::<3>(34) > 10);
}

#[test]
fn once_a_node_is_left_every_child_without_a_visited_leaf_is_ruled_out() {
    let mut random = Random::new(35);
    let mut n_left = 0;
    for _ in 0..120 {
        let (tree, ray) = (random_tree::<3>(&mut random), random_ray(&mut random));
        let query = along(Algorithm::Parametric);
        let trace = record(&tree, &ray, &query);
        let run = Run { tree: &tree, ray: &ray, query: &query, trace };
        for step in 1..=run.trace.events.len() {
            if !matches!(run.event(step), Some(Event::Step { next: None, .. })) {
                continue;
            }
            n_left += 1;
            let moment = Moment::after(&tree, &run.trace, step);
            let left = moment.frame().unwrap().node;
            let is_visited =
                |child: NodeId| moment.leaves.iter().any(|leaf| tree.holds(child, leaf.node));
            let children = tree.children(tree.node(left)).map(|node| node.id);
            let unvisited = children.filter(|&child| !is_visited(child)).count();
            // A child that was left without a leaf is the one that is taken still.
            let n_rejected = run.rejected(step).in_picture.len();
            let kept = unvisited.checked_sub(n_rejected);
            assert!(kept.is_some_and(|n| n <= 1), "step {step}: {unvisited} {n_rejected}");
        }
    }
    assert!(n_left > 20, "{n_left}");
}
