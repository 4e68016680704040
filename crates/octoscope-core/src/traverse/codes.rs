//! Traversal by location codes, bottom-up and without a stack [Frisken, Perry
//! 2002, §6].
//!
//! From a leaf the ray's exit gives the codes of the cell just beyond it. XOR of
//! both codes tells how far up their common ancestor is; from there the bits of
//! the new codes lead down to the next leaf. O(visited leaves × distance to the
//! common ancestor), D divisions a leaf, no look-up tables.
//!
//! The report only sketches this walk; `beyond` tells how what it leaves open is
//! settled.

use super::algorithm::Options;
use super::beyond::{Reached, beyond, enter, exit_of};
use super::report::{Report, finish, missed};
use crate::event::{Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::locate::{climb, descend};
use crate::tree::Tree;
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Enter: the codes of the place where the ray comes in, and their leaf.
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

        // New codes: of the cell beyond those planes, if there is one.
        let Some(next) = beyond(domain, ray, level, corner, &exit, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Climb: up to the common ancestor.
        let (ancestor, level) = climb(tree, leaf, level, corner, next, observe);

        // Descend: one bit of every code a level.
        let (leaf, level) = descend(tree, ancestor, level, next, 0, observe);
        reached = Reached { leaf, level, entry: exit.at };
    }
}
