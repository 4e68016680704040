//! Rays that can be followed by hand.

use octoscope_core::event::{End, Event};
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::random::Random;
use octoscope_core::trace::{Trace, record};
use octoscope_core::tree::{NodeId, Tree};
use thiserror::Error;

/// A ray through a tree, and what the parametric algorithm makes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Exercise<const D: usize> {
    /// Number of the exercise, if it is one of many.
    pub number: Option<u64>,
    /// The ray.
    pub ray: Ray<D>,
    /// Its traversal.
    pub(super) trace: Trace<D>,
}

/// Why a ray is no exercise.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum ExerciseError {
    /// It misses the tree.
    #[error("the ray misses the tree; give another one, or --seed for one that fits")]
    Missed,
    /// It is too long for paper.
    #[error(
        "the ray enters {0} inner nodes, but a worksheet has room for {MOST_NODES}; take a tree \
         of 2 to 4 levels or a shorter ray, or give --seed for one that fits"
    )]
    TooLong(usize),
    /// No ray fits.
    #[error(
        "no ray through this tree can be followed by hand with profit; take a tree of 2 to 4 \
         levels, such as scene:figure-1 or assets/scenes/exercise.octo"
    )]
    NoRay,
}

/// What is filled in for an inner node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NodeAnswer<const D: usize> {
    pub node: NodeId,
    pub near: [f64; D],
    pub mid: [f64; D],
    pub far: [f64; D],
}

/// So many inner nodes have room on a page.
const MOST_NODES: usize = 12;
/// What is asked of a ray that is chosen: so many inner nodes at most, and so many
/// leaves at least and at most.
const NODES: usize = 6;
const LEAVES: [usize; 2] = [3, 8];

impl<const D: usize> Exercise<D> {
    /// The exercise of a ray.
    ///
    /// # Errors
    /// Refuses rays that miss the tree or are too long.
    pub fn of(tree: &Tree<D>, ray: &Ray<D>, number: Option<u64>) -> Result<Self, ExerciseError> {
        let trace = record(tree, ray, &Query::default());
        let exercise = Self { number, ray: *ray, trace };
        match exercise.nodes().len() {
            0 if exercise.trace.leaves().next().is_none() => Err(ExerciseError::Missed),
            n if n > MOST_NODES => Err(ExerciseError::TooLong(n)),
            _ => Ok(exercise),
        }
    }

    /// The ray of the exercise of this number, the same on every machine. All
    /// parameters are short decimals in a domain with such.
    ///
    /// # Errors
    /// Says that no ray is short enough, because the tree is too deep, or long
    /// enough.
    pub fn ray_of(tree: &Tree<D>, number: u64) -> Result<Ray<D>, ExerciseError> {
        const TRIES: usize = 4000;
        let mut random = Random::new(number);
        let found = (0..TRIES).find_map(|_| {
            let ray = random_ray(tree, &mut random)?;
            is_fit(&record(tree, &ray, &Query::default())).then_some(ray)
        });
        found.ok_or(ExerciseError::NoRay)
    }

    /// The inner nodes in the order in which the ray enters them.
    pub(super) fn nodes(&self) -> Vec<NodeAnswer<D>> {
        let mut nodes = Vec::new();
        let mut entered = None;
        for event in &self.trace.events {
            if let Event::Visit { node, near, far, .. } = *event {
                entered = Some((node, near, far));
            }
            if let (&Event::Halve { mid, .. }, Some((node, near, far))) = (event, entered) {
                nodes.push(NodeAnswer { node, near, mid, far });
            }
        }
        nodes
    }
}

/// Origin outside the domain in twentieths of its side, off all planes between
/// cells; direction of short decimals.
fn random_ray<const D: usize>(tree: &Tree<D>, random: &mut Random) -> Option<Ray<D>> {
    const STEPS: [f64; 5] = [0.25, 0.4, 0.5, 1.0, 1.25];
    let (min, side) = (tree.domain().min(), tree.domain().side());
    let outside = random.below(D as u64) as usize;
    let mut towards = [1.0; D];
    let mut shares = [0.0; D];
    for axis in 0..D {
        towards[axis] = if random.below(2) == 0 { 1.0 } else { -1.0 };
        let twentieth = if axis == outside {
            let before = 1 + random.below(4);
            if towards[axis] > 0.0 { -(before as f64) } else { 20.0 + before as f64 }
        } else {
            // 0.05, 0.25 and the like are where planes are.
            (1 + random.below(4) + 5 * random.below(4)) as f64
        };
        shares[axis] = twentieth / 20.0;
    }
    let origin = std::array::from_fn(|e| min[e] + side * shares[e]);
    let direction = std::array::from_fn(|e| side * towards[e] * STEPS[random.below(5) as usize]);
    Ray::new(origin, direction).ok()
}

/// Whether a person can follow a traversal: not too long, and never undecided.
fn is_fit<const D: usize>(trace: &Trace<D>) -> bool {
    let n_leaves = trace.leaves().count();
    let n_nodes = trace.events.iter().filter(|e| matches!(e, Event::Halve { .. })).count();
    let mut entry_planes = [0.0; D];
    let is_clear = trace.events.iter().all(|event| match event {
        Event::Touch { .. } => false,
        Event::Step { axes, .. } => axes.count() == 1,
        Event::Halve { mid, .. } => {
            entry_planes = *mid;
            true
        }
        Event::First { entry, .. } => !entry_planes.contains(entry),
        Event::End(end) => *end == End::LeftRoot,
        Event::Clip { .. }
        | Event::Test { .. }
        | Event::Sort { .. }
        | Event::Visit { .. }
        | Event::Skip { .. }
        | Event::Up { .. }
        | Event::Enter { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Pop { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Push { .. }
        | Event::Begin { .. }
        | Event::Encode { .. }
        | Event::Compare { .. }
        | Event::Follow { .. }
        | Event::Exits { .. }
        | Event::Target { .. }
        | Event::Border { .. }
        | Event::Difference { .. }
        | Event::Leave { .. }
        | Event::Resume { .. }
        | Event::Climb { .. }
        | Event::Corners { .. }
        | Event::Leaf { .. }
        | Event::Found { .. } => true,
    });
    is_clear && n_nodes <= NODES && (LEAVES[0]..=LEAVES[1]).contains(&n_leaves)
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Progress;
    use octoscope_core::tree::{Cell, Domain, Split, grow};
    use std::collections::HashSet;

    /// Every second node is divided, to three levels.
    fn tree<const D: usize>() -> Tree<D> {
        grow(Domain::unit(3), (), &Progress::default(), |cell: Cell<D>, ()| {
            let odd = cell.code.iter().map(|c| c >> cell.level).sum::<u32>() % 2 == 1;
            match cell.level {
                0 => Split::Full(Vec::new()),
                1 | 2 if odd => Split::Empty,
                _ => Split::Inner(vec![(); 1 << D]),
            }
        })
        .expect("nobody cancels")
    }

    fn check<const D: usize>() {
        let tree = tree::<D>();
        let mut rays = HashSet::new();
        for number in 0..60 {
            let ray = Exercise::ray_of(&tree, number).unwrap();
            assert_eq!(Exercise::ray_of(&tree, number), Ok(ray), "the same again");
            let exercise = Exercise::of(&tree, &ray, Some(number)).unwrap();
            assert!(is_fit(&exercise.trace) && exercise.nodes().len() <= NODES);
            for NodeAnswer { near, mid, far, .. } in exercise.nodes() {
                for t in [near, mid, far].concat() {
                    let scaled = t * 1e4;
                    assert!((scaled - scaled.round()).abs() < 1e-6, "{t} is long");
                }
            }
            rays.insert(format!("{ray:?}"));
        }
        assert!(rays.len() > 50, "{} of 60 differ", rays.len());
    }

    #[test]
    fn every_number_has_its_ray_with_short_parameters() {
        check::<2>();
        check::<3>();
    }

    #[test]
    fn a_ray_that_is_too_long_or_misses_is_refused_in_words() {
        let grid: Tree<2> = grow(Domain::unit(5), (), &Progress::default(), |cell, ()| {
            if cell.level == 0 { Split::Empty } else { Split::Inner(vec![(); 4]) }
        })
        .expect("nobody cancels");
        let long = Ray::new([-0.1, 0.01], [1.0, 0.9]).unwrap();
        let error = Exercise::of(&grid, &long, None).unwrap_err();
        assert!(error.to_string().contains("room for 12"), "{error}");
        let beside = Ray::new([-0.1, 2.0], [1.0, 0.0]).unwrap();
        assert_eq!(Exercise::of(&grid, &beside, None), Err(ExerciseError::Missed));
        let leaf: Tree<2> = grow(Domain::unit(1), (), &Progress::default(), |_, ()| Split::Empty)
            .expect("as above");
        assert_eq!(Exercise::ray_of(&leaf, 1), Err(ExerciseError::NoRay), "nothing to follow");
    }
}
