//! Bottom-up along links between the nodes: a reconstruction of "SametNet" [Endl,
//! Sommer 1994], of which only the name is known here.
//!
//! Every node is linked once to its neighbour of the same size or larger across
//! each of its sides. A step then follows one link and locates below its end: the
//! fewest node touches of all bottom-up walks, paid with 2D links a node. An edge
//! or a corner takes two or three links, one after the other, unless a cell on
//! the way spans the goal already. O(visited leaves) links, D divisions a leaf.

use super::algorithm::Options;
use super::beyond::{Exit, Reached, enter, exit_of, locate_below};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::tree::{Node, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Entry point: its leaf is located from the root.
    let domain = tree.domain();
    let Some(mut reached) = enter::<D, P>(tree, ray, options, observe) else {
        return missed(observe);
    };
    let report = Report::of(options);

    loop {
        // Exit planes: the far planes of the leaf, and the first of them.
        let Reached { leaf, level, entry } = reached;
        let corner = tree.code(leaf.id);
        let exit = exit_of::<D, P>(domain, ray, level, corner);
        let reported = report.leaf(leaf, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));

        // Links: one through every plane that is met.
        let Some(neighbour) = follow_links(tree, ray, leaf, &exit, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Locate below: the leaf in which the ray goes on.
        reached = locate_below(tree, ray, neighbour, (level, corner), &exit, observe);
    }
}

/// The node, a leaf or not, beyond all planes of `exit` that are met first;
/// `None` if the ray leaves the root.
fn follow_links<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    mut node: Node,
    exit: &Exit<D, P>,
    observe: &mut impl Observer<D>,
) -> Option<Node> {
    for axis in exit.axes.iter() {
        // A cell on the way may span what is beyond this plane already.
        let upper = ray.direction()[axis] > 0.0;
        let goal = i64::from(exit.planes[axis]) - i64::from(!upper);
        let (level, code) = (tree.level(node.id), tree.code(node.id)[axis]);
        if goal >> level == i64::from(code >> level) {
            continue;
        }
        let next = tree.neighbour_across(node.id, axis, upper);
        observe.observe(Event::Rope { axis: axis as u8, node: next });
        node = tree.node(next?);
    }
    Some(node)
}
