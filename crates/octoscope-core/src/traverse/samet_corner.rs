//! Bottom-up by the corner in which the exit planes meet: a reconstruction of
//! "SametCorner" [Endl, Sommer 1994], of which only the name is known here.
//!
//! For a ray of fixed direction the far planes of every cell meet in the same one
//! of its corners, given by the signs of the direction. Keeping that corner, a
//! leaf is left where the first of the corner's parameters says; and a parent is
//! left as well as long as the child's bits agree with the signs along the crossed
//! axes. So neither faces nor tables are looked at. O(visited leaves × distance to
//! the common ancestor), D divisions a leaf.

use super::algorithm::Options;
use super::beyond::{Reached, enter, exit_of, locate_below};
use super::report::{Report, finish, missed};
use crate::event::{Event, Lookup, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
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
    let signs = Axes::where_true(ray.direction().map(|d| d > 0.0));

    loop {
        // Corner: the first of its planes to be met.
        let Reached { leaf, level, entry } = reached;
        let low = tree.code(leaf.id);
        let exit = exit_of::<D, P>(domain, ray, level, low);
        let reported = report.leaf(leaf, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));

        // Climb: while the ray leaves the parent through the same planes.
        let Some(ancestor) = climb_by_signs(tree, leaf, exit.axes, signs, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Down again, to where the ray goes on.
        reached = locate_below(tree, ray, ancestor, (level, low), &exit, observe);
    }
}

/// The smallest ancestor of `node` that is not left through any plane of `axes`,
/// in the direction of `signs`; `None` if the ray leaves the root.
fn climb_by_signs<const D: usize>(
    tree: &Tree<D>,
    mut node: Node,
    mut axes: Axes<D>,
    signs: Axes<D>,
    observe: &mut impl Observer<D>,
) -> Option<Node> {
    let towards = |axes: Axes<D>| {
        std::array::from_fn(|e| match (axes.contains(e), signs.contains(e)) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => -1,
        })
    };
    while !axes.is_empty() {
        let parent = tree.parent(node.id)?;
        let child = tree.child_index(node.id)?;
        let common = Axes(axes.0 & !(child.0 ^ signs.0));
        observe.observe(Event::Parent {
            node: parent,
            child,
            direction: towards(axes),
            common: towards(common),
            lookup: Lookup::Bits,
        });
        (node, axes) = (tree.node(parent), common);
    }
    Some(node)
}
