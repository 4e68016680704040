//! The painter's order: what is farther from the eye is drawn first.

use crate::Camera;
use octoscope_core::geometry::Aabb;

/// When a part of a box is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Half {
    /// The sides turned away from the eye, before what lies in the box.
    Behind,
    /// The sides that face the eye, after what lies in the box.
    Front,
}

/// Cells are halved at most this often; what is still together then is sorted
/// by its distance.
const MOST_LEVELS: u8 = 24;

/// Order in which the boxes of one tree over `root` are drawn, the farthest
/// first, each with both of its halves. Exact for boxes of the tree's nodes,
/// nested or apart, whatever their sizes: beyond the plane that parts two of
/// them lies the one that is not on the eye's side. Other boxes are taken for
/// points in their middle, and flat ones for a part of the plane in which they
/// lie. O(n log n) for a tree that is not degenerate.
pub(crate) fn back_to_front<const D: usize>(
    root: &Aabb<D>,
    boxes: &[Aabb<D>],
    camera: &Camera<D>,
) -> Vec<(usize, Half)> {
    let mut painter = Painter { boxes, camera, order: Vec::with_capacity(2 * boxes.len()) };
    painter.sort(root, (0..boxes.len()).collect(), 0);
    painter.order
}

struct Painter<'a, const D: usize> {
    boxes: &'a [Aabb<D>],
    camera: &'a Camera<D>,
    order: Vec<(usize, Half)>,
}

impl<const D: usize> Painter<'_, D> {
    fn sort(&mut self, cell: &Aabb<D>, boxes: Vec<usize>, depth: u8) {
        if boxes.len() <= 1 || depth == MOST_LEVELS {
            self.sort_by_distance(boxes);
            return;
        }
        let middle = cell.centre();
        let side = length(cell);

        // What is as large as the cell goes around all else, or between halves.
        let (mut around, mut far, mut between, mut near) = (vec![], vec![], vec![], vec![]);
        let mut octants = vec![Vec::new(); 1 << D];
        for index in boxes {
            let bounds = &self.boxes[index];
            if length(bounds) > 0.6 * side {
                let flat = (0..D).find(|&e| bounds.max[e] - bounds.min[e] < 1e-6 * side);
                let off_middle = |axis: usize| bounds.min[axis] - middle[axis];
                match flat {
                    None => around.push(index),
                    Some(axis) if off_middle(axis).abs() < 0.2 * side => {
                        between.push((axis, index))
                    }
                    Some(axis) if self.eye_is_above(axis, middle) == (off_middle(axis) > 0.0) => {
                        near.push(index);
                    }
                    Some(_) => far.push(index),
                }
            } else {
                let centre = bounds.centre();
                let octant =
                    (0..D).map(|e| usize::from(centre[e] >= middle[e]) << e).sum::<usize>();
                octants[octant].push(index);
            }
        }

        around.sort_by(|&a, &b| length(&self.boxes[b]).total_cmp(&length(&self.boxes[a])));
        self.order.extend(around.iter().map(|&index| (index, Half::Behind)));
        self.sort_by_distance(far);

        // The halves across the first plane between them are the outermost choice.
        let first = between.first().map_or(0, |&(axis, _)| axis);
        let axes: Vec<usize> = (0..D).map(|i| (first + i) % D).collect();
        let eye: Vec<bool> = (0..D).map(|axis| self.eye_is_above(axis, middle)).collect();
        for choice in 0..1usize << D {
            if choice == 1 << (D - 1) {
                self.sort_by_distance(between.iter().map(|&(_, index)| index).collect());
            }
            let mut octant = 0;
            let mut part = *cell;
            for (place, &axis) in axes.iter().enumerate() {
                let is_near = choice >> (D - 1 - place) & 1 == 1;
                let is_upper = is_near == eye[axis];
                octant |= usize::from(is_upper) << axis;
                let bound = if is_upper { &mut part.min } else { &mut part.max };
                bound[axis] = middle[axis];
            }
            self.sort(&part, std::mem::take(&mut octants[octant]), depth + 1);
        }

        self.sort_by_distance(near);
        self.order.extend(around.iter().rev().map(|&index| (index, Half::Front)));
    }

    fn sort_by_distance(&mut self, mut boxes: Vec<usize>) {
        let distance = |index: &usize| {
            let way = self.camera.towards_eye(self.boxes[*index].centre());
            way.iter().map(|x| x * x).sum::<f64>()
        };
        let depth = |index: &usize| self.camera.depth(self.boxes[*index].centre());
        boxes.sort_by(|a, b| {
            distance(b).total_cmp(&distance(a)).then(depth(b).total_cmp(&depth(a)))
        });
        self.order.extend(boxes.into_iter().flat_map(|i| [(i, Half::Behind), (i, Half::Front)]));
    }

    fn eye_is_above(&self, axis: usize, plane: [f64; D]) -> bool {
        self.camera.towards_eye(plane)[axis] > 0.0
    }
}

fn length<const D: usize>(bounds: &Aabb<D>) -> f64 {
    bounds.size().into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Lens, Page};
    use octoscope_core::random::Random;

    const ROOT: Aabb<3> = Aabb { min: [0.0; 3], max: [1.0; 3] };
    const PAGE: Page = Page { width: 800.0, height: 600.0 };

    /// Leaves of a random octree.
    fn leaves(random: &mut Random, cell: Aabb<3>, depth: u8, into: &mut Vec<Aabb<3>>) {
        if depth == 0 || random.between(0.0, 1.0) < 0.4 {
            into.push(cell);
            return;
        }
        let middle = cell.centre();
        for octant in 0..8 {
            let upper = |e: usize| octant >> e & 1 == 1;
            let part = Aabb {
                min: std::array::from_fn(|e| if upper(e) { middle[e] } else { cell.min[e] }),
                max: std::array::from_fn(|e| if upper(e) { cell.max[e] } else { middle[e] }),
            };
            leaves(random, part, depth - 1, into);
        }
    }

    /// Whether a line of sight can meet `a` before `b`: no plane that parts them
    /// has `b` on the eye's side.
    fn may_hide(camera: &Camera<3>, a: &Aabb<3>, b: &Aabb<3>) -> bool {
        (0..3).all(|e| {
            let above = |plane: f64| camera.towards_eye([plane; 3])[e] > 0.0;
            let parted_below = a.max[e] <= b.min[e] && above(a.max[e]);
            let parted_above = b.max[e] <= a.min[e] && !above(a.min[e]);
            !(parted_below || parted_above)
        })
    }

    #[test]
    fn no_box_is_drawn_over_one_that_hides_it() {
        let mut random = Random::new(3);
        for _ in 0..20 {
            let mut boxes = Vec::new();
            leaves(&mut random, ROOT, 3, &mut boxes);
            let mut camera = Camera::framing(&ROOT, PAGE);
            camera.yaw = random.between(0.0, 6.3);
            camera.pitch = random.between(-1.5, 1.5);
            camera.height = random.between(0.1, 3.0);
            if random.between(0.0, 1.0) < 0.5 {
                camera.lens = Lens::Orthographic;
            }
            let order = back_to_front(&ROOT, &boxes, &camera);
            assert_eq!(order.len(), 2 * boxes.len());
            let order: Vec<usize> = order
                .into_iter()
                .filter(|(_, half)| *half == Half::Front)
                .map(|(i, _)| i)
                .collect();
            for (place, &late) in order.iter().enumerate() {
                for &early in &order[..place] {
                    let [early, late] = [&boxes[early], &boxes[late]];
                    let wrong = may_hide(&camera, early, late) && !may_hide(&camera, late, early);
                    assert!(!wrong, "{early:?} is covered by {late:?}");
                }
            }
        }
    }

    #[test]
    fn a_box_is_drawn_around_what_lies_in_it_and_a_plane_between_its_halves() {
        let half = |e: usize, upper: bool| {
            let mut part = Aabb { min: [0.0; 3], max: [0.5; 3] };
            if upper {
                (part.min[e], part.max[e]) = (0.5, 1.0);
            }
            part
        };
        let plane = Aabb { min: [0.5, 0.0, 0.0], max: [0.5, 1.0, 1.0] };
        let boxes = [half(0, true), plane, ROOT, half(0, false)];
        let camera = Camera { yaw: 0.0, pitch: 0.0, ..Camera::framing(&ROOT, PAGE) };
        let order = back_to_front(&ROOT, &boxes, &camera);
        let fronts: Vec<_> =
            order.iter().filter(|(_, half)| *half == Half::Front).map(|(i, _)| *i).collect();
        assert_eq!(order[0], (2, Half::Behind));
        assert_eq!(fronts, [3, 1, 0, 2]);
    }
}
