//! The classic sequential traversal: from every exit point down from the root
//! [Glassner 1984].
//!
//! The leaf of the entry point is located; where the ray leaves it, a point that
//! is certainly in the next leaf is located from the root again, and so on.
//! O(visited leaves × depth) [Arvo 1988], where bottom-up walks climb only as far
//! as the common ancestor. D divisions a leaf.
//!
//! Difference from the original, with its reason: the next cell is given by
//! codes, in which only those of the crossed axes change (`beyond`). The variant
//! `push` moves the exit point half a smallest cell along the normal of the exit
//! face instead. Near an edge it can happen that the pushed point lies in a leaf
//! diagonally opposite, whose exit point is pushed back again: the ray goes round
//! in circles [Haines 1989], which is noticed by its getting no further.

use super::algorithm::Options;
use super::beyond::{Exit, Reached, beyond, enter, exit_of};
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{End, Event, Observer, Outcome, Search};
use crate::geometry::{Axes, Parameter, Ray};
use crate::locate::descend;
use crate::tree::{Code, Domain, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let domain = tree.domain();
    let Some(mut reached) = enter::<D, P>(tree, ray, options, observe) else {
        return missed(observe);
    };
    let report = Report::of(options);
    let push = options.variants.has(Variant::Push);
    let (mut farthest, mut leaves_without_progress) = (reached.entry, 0);

    loop {
        // Exit point: on the first of the leaf's far planes.
        let Reached { leaf, level, entry } = reached;
        let corner = tree.code(leaf.id);
        let exit = exit_of::<D, P>(domain, ray, level, corner);
        let reported = report.leaf(leaf, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));

        // No further? At most 2^D leaves meet in a point.
        leaves_without_progress =
            if farthest.before(exit.at) { 0 } else { leaves_without_progress + 1 };
        farthest = farthest.later(exit.at);
        if leaves_without_progress > 2 << D {
            return finish(ControlFlow::Break(Outcome::without_node(End::Looped)), observe);
        }

        // Push: out of the leaf, into the next one.
        let next = if push {
            pushed(domain, ray, &exit, observe)
        } else {
            beyond(domain, ray, level, corner, &exit, observe)
        };
        let Some(next) = next else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Locate from the root.
        let root = tree.root();
        observe.observe(Event::Begin { node: root.id });
        let (leaf, level) = descend(tree, root, domain.root_level(), next, 0, observe);
        reached = Reached { leaf, level, entry: exit.at };
    }
}

/// Codes of the exit point, moved half a smallest cell along the normal of one
/// exit face; `None` if that is outside the domain.
fn pushed<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    exit: &Exit<D, P>,
    observe: &mut impl Observer<D>,
) -> Option<Code<D>> {
    let axis = exit.axes.iter().next().expect("some plane is met first");
    let from = ray.at(exit.at.value());
    let mut to = from;
    to[axis] += 0.5 * domain.cell_side(0) * ray.direction()[axis].signum();
    observe.observe(Event::Push { from, to, axis: axis as u8 });
    let code = domain.encode_point(to);
    if let Some(code) = code {
        observe.observe(Event::Encode { point: to, code, after: None, search: Search::NONE });
    }
    let outside = Axes::where_true(std::array::from_fn(|e| domain.encode(e, to[e]).is_none()));
    observe.observe(Event::Border { tested: Axes::where_true([true; D]), outside });
    code
}
