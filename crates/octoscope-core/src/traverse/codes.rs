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
use super::beyond::{beyond, code_of_entry, encoded, exit_of};
use super::clip::{Clip, clip};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome};
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
    // Enter: the codes of the point where the ray comes in, and their leaf.
    let domain = tree.domain();
    let (clip, event) = clip::<D, P>(domain, ray, options);
    observe.observe(event);
    let Some(Clip { enter: mut entry, .. }) = clip else {
        return missed(observe);
    };
    let report = Report::of(options);
    let mut code = code_of_entry(domain, ray, entry);
    observe.observe(encoded(ray, entry, code));
    let mut node = tree.root();
    let mut level = domain.root_level();
    observe.observe(Event::Begin { node: node.id });

    loop {
        // Descend: one bit of every code a level.
        (node, level) = descend(tree, node, level, code, 0, observe);
        let corner = tree.code(node.id);

        // Exit planes: the far planes of the leaf, and the first of them.
        let exit = exit_of::<D, P>(domain, ray, level, corner);
        let reported = report.leaf(node, entry, exit.at, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(exit.event(domain));

        // New codes: of the cell beyond those planes, if there is one.
        let Some(next) = beyond(domain, ray, level, corner, &exit, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Climb: up to the common ancestor.
        (node, level) = climb(tree, node, level, corner, next, observe);
        code = next;
        entry = exit.at;
    }
}
