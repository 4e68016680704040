//! Bottom-up along links between the nodes: a reconstruction of "SametNet" [Endl,
//! Sommer 1994], of which only the name is known here.
//!
//! Every node is linked once to its neighbour of the same size or larger across
//! each of its sides. A step then follows one link and locates below its end: the
//! fewest node touches of all bottom-up walks, paid with 2D links a node. An edge
//! or a corner takes two or three links, one after the other, unless a cell on
//! the way spans the goal already. O(visited leaves) links, D divisions a leaf.

use super::algorithm::Options;
use super::beyond::{code_of_entry, encoded, exit_of, target_of};
use super::clip::{Clip, clip};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::locate::descend;
use crate::tree::{Node, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let domain = tree.domain();
    let (clip, event) = clip::<D, P>(domain, ray, options);
    observe.observe(event);
    let Some(Clip { enter: mut entry, .. }) = clip else {
        return missed(observe);
    };
    let report = Report::of(options);

    // Entry point: its leaf is located from the root.
    let code = code_of_entry(domain, ray, entry);
    observe.observe(encoded(ray, entry, code));
    observe.observe(Event::Begin { node: tree.root().id });
    let (mut leaf, mut level) = descend(tree, tree.root(), domain.root_level(), code, 0, observe);

    loop {
        // Exit planes: the far planes of the leaf, and the first of them.
        let corner = tree.code(leaf.id);
        let exit = exit_of::<D, P>(domain, ray, level, corner);
        let reported = report.leaf(leaf, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));

        // Links: one through every plane that is met.
        let target = target_of(domain, ray, level, corner, &exit);
        let Some(neighbour) = follow_links(tree, ray, leaf, exit.axes, target, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Locate below: the leaf in which the ray goes on.
        let target = target.map(|c| c as u32);
        level = tree.level(neighbour.id);
        if !neighbour.is_leaf() {
            observe.observe(encoded(ray, exit.at, target));
        }
        (leaf, level) = descend(tree, neighbour, level, target, 0, observe);
        entry = exit.at;
    }
}

/// The node, a leaf or not, beyond the planes of `axes` that spans `target`
/// along these axes; `None` if the ray leaves the root.
fn follow_links<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    mut node: Node,
    axes: Axes<D>,
    target: [i64; D],
    observe: &mut impl Observer<D>,
) -> Option<Node> {
    for axis in axes.iter() {
        let (level, code) = (tree.level(node.id), tree.code(node.id)[axis]);
        if target[axis] >> level == i64::from(code >> level) {
            continue;
        }
        let upper = ray.direction()[axis] > 0.0;
        let next = tree.neighbour_across(node.id, axis, upper);
        observe.observe(Event::Rope { axis: axis as u8, node: next });
        node = tree.node(next?);
    }
    Some(node)
}
