//! What lies in space, in the order of its depth.

use super::InSpace;
use crate::painter::{Half, Painted, at_share, back_to_front};
use crate::parts::{Arrow, part_of_plane};
use crate::{Camera, Drawn, Page};
use octoscope_core::geometry::Aabb;

/// What lies in space, the farthest first.
pub(super) fn painted<const D: usize>(
    mut in_space: Vec<InSpace<D>>,
    arrows: &[Arrow<D>],
    root: Option<&Aabb<D>>,
    camera: &Camera<D>,
    page: Page,
) -> Vec<Drawn> {
    let boxes: Vec<Aabb<D>> = in_space.iter().map(|item| item.bounds).collect();
    let lines: Vec<[[f64; D]; 2]> = arrows.iter().map(|arrow| arrow.ends).collect();
    // Without a root, around the boxes: one alone is its own.
    let ends = boxes.iter().flat_map(|b| [b.min, b.max]);
    let all = if boxes.is_empty() {
        Aabb::around(lines.iter().flatten().copied())
    } else {
        Aabb::around(ends)
    };
    let Some(root) = root.copied().or(all) else {
        return Vec::new();
    };
    let mut drawn = Vec::new();
    for next in back_to_front(&root, &boxes, &lines, camera) {
        match next {
            Painted::Half(index, Half::Behind) => drawn.append(&mut in_space[index].behind),
            Painted::Half(index, Half::Front) => drawn.append(&mut in_space[index].front),
            Painted::Flat(index, part) => {
                let item = &mut in_space[index];
                if part == item.bounds {
                    drawn.append(&mut item.front);
                } else if let Some(whole) = item.front.last() {
                    drawn.extend(part_of_plane(camera, page, whole, &item.bounds, &part));
                }
            }
            Painted::Piece(index, between) => {
                let arrow = &arrows[index];
                let ends = between.map(|share| at_share(arrow.ends, share));
                drawn.extend(arrow.piece(camera.visible_segment(page, ends)));
            }
        }
    }
    drawn
}
