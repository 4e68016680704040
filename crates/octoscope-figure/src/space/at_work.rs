//! What keeps a small node at work from being hidden by what is written and drawn at it.

use super::inset::longest_side;
use super::{distance, drawn_box};
use crate::camera::corners;
use crate::{Camera, Mark, Page, Role, Shape};
use octoscope_core::geometry::Aabb;

/// Nodes that reach less far than this, in page units, have their number outside: in the
/// plane, and in space, where what is seen of a box is smaller than its extent.
const SMALL: [f64; 2] = [34.0, 44.0];

/// Middle and half extents on the page of the box of a node at work, if it is so small
/// that an order number would hide it.
pub(super) fn small_area<const D: usize>(
    mark: &Mark<D>,
    camera: &Camera<D>,
    page: Page,
) -> Option<[[f64; 2]; 2]> {
    let Shape::Box(bounds) = mark.shape else { return None };
    if !matches!(mark.role, Role::Current | Role::Missed | Role::Found) {
        return None;
    }
    let area = on_page(&drawn_box(mark.role, &bounds, camera.unit(page)), camera, page)?;
    let is_small = |side: f64| side < SMALL[usize::from(D == 3)];
    area.size().into_iter().all(is_small).then(|| middle_and_half(&area))
}

/// Nodes that reach less far than this, in page units, in the plane and in space, bear no
/// order numbers while their children and mid planes are looked at.
const LOOKED_AT: [f64; 2] = [90.0, 70.0];

/// Middle and half extents on the page of a node whose children and mid planes are looked
/// at, if it is so small that order numbers would hide these.
pub(super) fn looked_at<'a, const D: usize>(
    marks: impl Iterator<Item = &'a Mark<D>> + Clone,
    camera: &Camera<D>,
    page: Page,
) -> Option<[[f64; 2]; 2]> {
    let is_within =
        |mark: &Mark<D>| matches!(mark.role, Role::Taken | Role::Rejected | Role::MidPlane(_));
    if !marks.clone().any(is_within) {
        return None;
    }
    let part = |mark: &Mark<D>| match (mark.role, mark.shape) {
        (Role::Current | Role::Missed | Role::Found, Shape::Box(bounds)) => Some(bounds),
        (_, Shape::Box(bounds) | Shape::Plane { bounds, .. }) if is_within(mark) => Some(bounds),
        _ => None,
    };
    let ends = marks.filter_map(part).flat_map(|bounds| [bounds.min, bounds.max]);
    let area = on_page(&Aabb::around(ends)?, camera, page)?;
    let is_small = |side: f64| side < LOOKED_AT[usize::from(D == 3)];
    area.size().into_iter().all(is_small).then(|| middle_and_half(&area))
}

fn on_page<const D: usize>(bounds: &Aabb<D>, camera: &Camera<D>, page: Page) -> Option<Aabb<2>> {
    let places = corners(bounds).filter_map(|corner| camera.project(page, corner));
    Aabb::around(places.map(|place| place.at))
}

fn middle_and_half(area: &Aabb<2>) -> [[f64; 2]; 2] {
    [area.centre(), area.size().map(|side| 0.5 * side)]
}

/// How far points where the ray enters and leaves reach at most: a third of the side of
/// the smallest node or cell at work is their width, and half the part of the ray in it.
pub(super) fn most_of_dots<'a, const D: usize>(
    marks: impl Iterator<Item = &'a Mark<D>> + Clone,
    camera: &Camera<D>,
    page: Page,
) -> f64 {
    const LEAST: f64 = 2.0;
    let sides = marks.clone().filter_map(|mark| match (mark.role, mark.shape) {
        (Role::Current | Role::Missed | Role::Found | Role::GridCell, Shape::Box(bounds)) => {
            Some(longest_side(&bounds, camera.unit(page)))
        }
        _ => None,
    });
    let side = sides.fold(f64::INFINITY, f64::min);
    (side / 6.0).min(0.25 * chord_length(marks, camera, page)).max(LEAST)
}

/// Length on the page of the part of the ray in the node, +∞ without one.
fn chord_length<'a, const D: usize>(
    marks: impl Iterator<Item = &'a Mark<D>> + Clone,
    camera: &Camera<D>,
    page: Page,
) -> f64 {
    let end = |role: Role| {
        let mark = marks.clone().filter(|mark| mark.role == role).last()?;
        let Shape::Point(point) = mark.shape else { return None };
        Some(camera.project(page, point)?.at)
    };
    match [Role::EntryPoint, Role::ExitPoint].map(end) {
        [Some(enter), Some(exit)] => distance(enter, exit),
        [_, _] => f64::INFINITY,
    }
}
