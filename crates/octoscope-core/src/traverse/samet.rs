//! Bottom-up by neighbour finding with tables [Samet 1989].
//!
//! Where the ray leaves a leaf, through a face, an edge or a corner, the
//! neighbour in that direction is found from the leaf itself: up to the nearest
//! common ancestor by tables, down mirrored, and where the neighbour is divided,
//! down to the exit point. O(visited leaves × distance to the common ancestor),
//! D divisions a leaf.
//!
//! Differences from the original, with reasons: instead of moving the exit point
//! by some ε, all planes that are met at once make the direction, and a point on a
//! plane belongs to the cell into which the ray moves (`beyond`), so that
//! directions and tables cannot contradict each other.

use super::algorithm::Options;
use super::beyond::{Reached, enter, exit_of, locate_below};
use super::report::{Report, finish, missed};
use crate::event::{Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::locate::ascend_and_mirror;
use crate::tree::Tree;
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
        // Exit kind: one plane is a face, two are an edge, three a corner.
        let Reached { leaf, level, entry } = reached;
        let corner = tree.code(leaf.id);
        let exit = exit_of::<D, P>(domain, ray, level, corner);
        let reported = report.leaf(leaf, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));
        let direction = std::array::from_fn(|e| match exit.axes.contains(e) {
            true if ray.direction()[e] > 0.0 => 1,
            true => -1,
            false => 0,
        });

        // Climb by table, mirror down; beyond the root there is nothing.
        let Some(neighbour) = ascend_and_mirror(tree, leaf.id, direction, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Locate below: the leaf in which the ray goes on.
        reached = locate_below(tree, ray, neighbour, (level, corner), &exit, observe);
    }
}
