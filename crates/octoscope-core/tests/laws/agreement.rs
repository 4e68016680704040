//! What every algorithm owes to the oracle on a ray.

use octoscope_core::event::{End, Event, Observer, Outcome};
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::traverse::{
    Algorithm, Options, Slivers, StopAt, doubles_suffice, first_difference,
};
use octoscope_core::tree::{NodeId, Tree};

/// What a run has found.
#[derive(Debug, Default)]
pub struct Found {
    /// The visited leaves, in order.
    pub leaves: Vec<NodeId>,
    /// Where the ray is in each.
    pub intervals: Vec<[f64; 2]>,
    /// The touches that are told.
    pub touches: Vec<NodeId>,
    /// Number of children visited so far of every node on the stack.
    visited: Vec<usize>,
    /// Most children visited of one node.
    most_visited: usize,
    clip: Option<[f64; 2]>,
}

impl<const D: usize> Observer<D> for Found {
    fn observe(&mut self, event: Event<D>) {
        match event {
            Event::Leaf { node, enter, exit, .. } => {
                self.leaves.push(node);
                self.intervals.push([enter, exit]);
            }
            Event::Touch { node, .. } => self.touches.push(node),
            Event::Visit { .. } | Event::Enter { .. } => {
                if let Some(visited) = self.visited.last_mut() {
                    *visited += 1;
                    self.most_visited = self.most_visited.max(*visited);
                }
                self.visited.push(0);
            }
            Event::Up { .. } => {
                self.visited.pop();
            }
            Event::Clip { enter, exit, .. } => self.clip = Some([enter.max(0.0), exit]),
            _ => {}
        }
    }
}

fn run<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithm: Algorithm,
    arithmetic: Arithmetic,
    stop_at: StopAt,
) -> (Found, Outcome) {
    let options = Options { stop_at, ..Options::default() };
    run_with(tree, ray, Query::Ray { algorithm, options, arithmetic })
}

pub fn run_with<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, query: Query<D>) -> (Found, Outcome) {
    let mut found = Found::default();
    let outcome = query.run(tree, ray, &mut found);
    (found, outcome)
}

/// What the oracle finds on a ray.
pub fn oracle<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> (Found, Outcome) {
    run(tree, ray, Algorithm::Exhaustive, Arithmetic::Exact, StopAt::End)
}

/// Compares a run of `algorithm` with the oracle: its leaves, their intervals, its
/// touches and how it ends.
///
/// # Errors
/// Says what is not as it should be.
pub fn compare<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    (expected, end): &(Found, Outcome),
    algorithm: Algorithm,
    arithmetic: Arithmetic,
) -> Result<(), String> {
    let slivers = match arithmetic {
        Arithmetic::Exact => Slivers::Count,
        Arithmetic::Doubles => Slivers::Ignore,
    };
    let holds = |fact: &str, holds: bool| match holds {
        true => Ok(()),
        false => Err(format!("{fact}: {algorithm:?}, {arithmetic:?}, {ray:?}")),
    };
    let (found, outcome) = run(tree, ray, algorithm, arithmetic, StopAt::End);
    let difference = first_difference(tree, ray, &expected.leaves, &found.leaves, slivers);
    if let Some(difference) = difference {
        holds(&format!("{difference:?}"), false)?;
    }
    let rounding = match arithmetic {
        Arithmetic::Doubles if doubles_suffice(tree.domain(), ray) => 0.0,
        Arithmetic::Doubles | Arithmetic::Exact => 4.0 * f64::EPSILON,
    };
    holds("the intervals have a gap or no length", intervals_follow(&found, rounding))?;
    match (algorithm, arithmetic) {
        (Algorithm::ParametricTable, Arithmetic::Exact) => {
            let known = |touch| expected.touches.contains(touch);
            holds("a touch is none", found.touches.iter().all(known))?;
        }
        (Algorithm::ParametricTable, Arithmetic::Doubles) => {}
        _ => {
            holds("too many children are visited", found.most_visited <= D + 1)?;
            holds("a touch is reported", found.touches.is_empty())?;
        }
    }
    if arithmetic == Arithmetic::Exact {
        holds("it ends otherwise", outcome == *end)?;
        let (_, outcome) = run(tree, ray, algorithm, arithmetic, StopAt::FirstFull);
        let expected = first_full(tree, &expected.leaves, *end);
        holds("it stops at another full leaf", outcome == expected)?;
    }
    Ok(())
}

/// How a run ends that stops at the first full one of `leaves`.
fn first_full<const D: usize>(tree: &Tree<D>, leaves: &[NodeId], otherwise: Outcome) -> Outcome {
    let full = leaves.iter().find(|&&leaf| tree.node(leaf).is_full());
    full.map_or(otherwise, |&leaf| Outcome::at(End::FirstFull, leaf))
}

/// Whether the intervals follow each other without gap from the first to the last
/// plane of the root. Exactly equal parameters of two planes may be shown as doubles
/// that differ by `rounding`, relative to them.
fn intervals_follow(found: &Found, rounding: f64) -> bool {
    let same = |a: f64, b: f64| a == b || (a - b).abs() <= rounding * a.abs();
    let (Some(first), Some(last)) = (found.intervals.first(), found.intervals.last()) else {
        return true;
    };
    let clip = found.clip.expect("every fast algorithm begins with a clip");
    let has_length =
        |&[enter, exit]: &[f64; 2]| enter < exit || (rounding > 0.0 && same(enter, exit));
    same(clip[0], first[0])
        && same(clip[1], last[1])
        && found.intervals.iter().all(has_length)
        && found.intervals.windows(2).all(|pair| same(pair[0][1], pair[1][0]))
}
