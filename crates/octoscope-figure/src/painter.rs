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

/// What is drawn next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Painted {
    /// A half of the box of this number.
    Half(usize, Half),
    /// A piece of the line of this number, from one share of its length to another.
    Piece(usize, [f64; 2]),
}

/// Order in which the boxes of one tree over `root`, and straight lines through
/// them, are drawn, the farthest first: each box with both of its halves, each line
/// in pieces. Exact for boxes of the tree's nodes, nested or apart, whatever their
/// sizes: beyond the plane that parts two of them lies the one that is not on the
/// eye's side, and lines are cut by these planes. Other boxes are taken for points
/// in their middle, and flat ones for a part of the plane in which they lie.
/// O(n log n) for a tree that is not degenerate.
pub(crate) fn back_to_front<const D: usize>(
    root: &Aabb<D>,
    boxes: &[Aabb<D>],
    lines: &[[[f64; D]; 2]],
    camera: &Camera<D>,
) -> Vec<Painted> {
    let order = Vec::with_capacity(2 * boxes.len() + lines.len());
    let mut painter = Painter { boxes, lines, camera, order };
    let whole = (0..lines.len()).map(|line| Piece { line, between: [0.0, 1.0] });
    let Around { far, inside, near } = painter.around(root, whole.collect());
    painter.draw_pieces(far);
    painter.sort(root, (0..boxes.len()).collect(), inside, 0);
    painter.draw_pieces(near);
    painter.order
}

struct Painter<'a, const D: usize> {
    boxes: &'a [Aabb<D>],
    lines: &'a [[[f64; D]; 2]],
    camera: &'a Camera<D>,
    order: Vec<Painted>,
}

/// Piece of a line between two shares of its length.
#[derive(Clone, Copy, Debug)]
struct Piece {
    line: usize,
    between: [f64; 2],
}

/// Pieces beyond a box for the eye, in it, and before it.
#[derive(Default)]
struct Around {
    far: Vec<Piece>,
    inside: Vec<Piece>,
    near: Vec<Piece>,
}

impl<const D: usize> Painter<'_, D> {
    fn sort(&mut self, cell: &Aabb<D>, boxes: Vec<usize>, pieces: Vec<Piece>, depth: u8) {
        if boxes.is_empty() {
            return self.draw_pieces(pieces);
        }
        if boxes.len() == 1 && pieces.is_empty() || depth == MOST_LEVELS {
            self.draw_pieces(pieces);
            return self.sort_by_distance(boxes);
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
                octants[octant(bounds.centre(), middle)].push(index);
            }
        }
        let mut pieces_in = vec![Vec::new(); 1 << D];
        for piece in self.cut_at(pieces, middle) {
            pieces_in[octant(self.middle(piece), middle)].push(piece);
        }

        // Of equal ones the later lies around the earlier: it is the one to be seen.
        around.sort_by(|&a, &b| {
            length(&self.boxes[b]).total_cmp(&length(&self.boxes[a])).then(b.cmp(&a))
        });
        self.order.extend(around.iter().map(|&index| Painted::Half(index, Half::Behind)));
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
            let boxes = std::mem::take(&mut octants[octant]);
            let pieces = std::mem::take(&mut pieces_in[octant]);
            self.sort(&part, boxes, pieces, depth + 1);
        }

        self.sort_by_distance(near);
        self.order.extend(around.iter().rev().map(|&index| Painted::Half(index, Half::Front)));
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
        let halves = |index| [Half::Behind, Half::Front].map(|half| Painted::Half(index, half));
        self.order.extend(boxes.into_iter().flat_map(halves));
    }

    /// Draws pieces between which nothing lies; those that touch become one.
    fn draw_pieces(&mut self, pieces: Vec<Piece>) {
        for Piece { line, between: [from, to] } in pieces {
            if let Some(Painted::Piece(other, [start, end])) = self.order.last_mut()
                && *other == line
                && (*end == from || *start == to)
            {
                (*start, *end) = (start.min(from), end.max(to));
            } else {
                self.order.push(Painted::Piece(line, [from, to]));
            }
        }
    }

    /// The pieces, cut by the planes across all axes through a point.
    fn cut_at(&self, mut pieces: Vec<Piece>, through: [f64; D]) -> Vec<Piece> {
        for axis in 0..D {
            pieces = pieces.into_iter().flat_map(|p| self.cut(p, axis, through[axis])).collect();
        }
        pieces
    }

    /// A piece, cut by a plane if it crosses that.
    fn cut(&self, piece: Piece, axis: usize, plane: f64) -> Vec<Piece> {
        let [from, to] = self.lines[piece.line].map(|end| end[axis]);
        let at = (plane - from) / (to - from);
        let [start, end] = piece.between;
        if at > start && at < end {
            vec![Piece { between: [start, at], ..piece }, Piece { between: [at, end], ..piece }]
        } else {
            vec![piece]
        }
    }

    /// The pieces, cut by the sides of a box.
    fn around(&self, bounds: &Aabb<D>, pieces: Vec<Piece>) -> Around {
        let cut = self.cut_at(self.cut_at(pieces, bounds.min), bounds.max);
        let mut around = Around::default();
        for piece in cut {
            let middle = self.middle(piece);
            // One of the planes that part it from the box tells which is nearer.
            let parting = (0..D).find_map(|axis| {
                if middle[axis] < bounds.min[axis] {
                    Some(!self.eye_is_above(axis, bounds.min))
                } else if middle[axis] > bounds.max[axis] {
                    Some(self.eye_is_above(axis, bounds.max))
                } else {
                    None
                }
            });
            match parting {
                None => around.inside.push(piece),
                Some(true) => around.near.push(piece),
                Some(false) => around.far.push(piece),
            }
        }
        around
    }

    fn middle(&self, piece: Piece) -> [f64; D] {
        let share = 0.5 * (piece.between[0] + piece.between[1]);
        at_share(self.lines[piece.line], share)
    }

    fn eye_is_above(&self, axis: usize, plane: [f64; D]) -> bool {
        self.camera.towards_eye(plane)[axis] > 0.0
    }
}

/// The point at a share of the way from one end to the other.
pub(crate) fn at_share<const D: usize>([from, to]: [[f64; D]; 2], share: f64) -> [f64; D] {
    std::array::from_fn(|e| from[e] * (1.0 - share) + to[e] * share)
}

/// Number of the part around `middle` in which a point lies.
fn octant<const D: usize>(point: [f64; D], middle: [f64; D]) -> usize {
    (0..D).map(|e| usize::from(point[e] >= middle[e]) << e).sum()
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

    fn front(painted: Painted) -> Option<usize> {
        match painted {
            Painted::Half(index, Half::Front) => Some(index),
            Painted::Half(_, Half::Behind) | Painted::Piece(..) => None,
        }
    }

    /// Where the line of sight to `point` is in a box: distances from the eye in
    /// units of that to the point.
    fn sight_through(camera: &Camera<3>, point: [f64; 3], bounds: &Aabb<3>) -> Option<[f64; 2]> {
        let back = camera.towards_eye(point);
        let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
        for e in 0..3 {
            let [a, b] = [bounds.min[e], bounds.max[e]].map(|x| 1.0 - (x - point[e]) / back[e]);
            (enter, exit) = (enter.max(a.min(b)), exit.min(a.max(b)));
        }
        (enter < exit && exit > 0.0).then_some([enter, exit])
    }

    #[test]
    fn a_line_is_drawn_after_what_it_hides_and_before_what_hides_it() {
        let mut random = Random::new(11);
        let (mut n_before, mut n_inside, mut n_after) = (0, 0, 0);
        for _ in 0..60 {
            let mut boxes = vec![ROOT];
            leaves(&mut random, ROOT, 3, &mut boxes);
            // Ancestors of some of them, as nodes on a stack.
            boxes.extend([0.5, 0.25].map(|side| Aabb { min: [0.0; 3], max: [side; 3] }));
            let mut point = || std::array::from_fn(|_| random.between(-0.5, 1.5));
            let lines = [[point(), point()], [point(), point()]];
            let mut camera = Camera::framing(&ROOT, PAGE);
            camera.yaw = random.between(0.0, 6.3);
            camera.pitch = random.between(-1.5, 1.5);
            if random.between(0.0, 1.0) < 0.5 {
                camera.lens = Lens::Orthographic;
            }
            let order = back_to_front(&ROOT, &boxes, &lines, &camera);
            let place = |wanted| order.iter().position(|p| *p == wanted).unwrap();
            let mut lengths = [0.0; 2];
            for (at, painted) in order.iter().enumerate() {
                let Painted::Piece(line, [from, to]) = *painted else { continue };
                lengths[line] += to - from;
                for share in [0.03, 0.3, 0.5, 0.7, 0.97] {
                    let point = at_share(lines[line], from + share * (to - from));
                    for (index, bounds) in boxes.iter().enumerate() {
                        let Some([enter, exit]) = sight_through(&camera, point, bounds) else {
                            continue;
                        };
                        let [behind, front] = [Half::Behind, Half::Front]
                            .map(|half| place(Painted::Half(index, half)));
                        if exit < 1.0 - 1e-9 {
                            assert!(at < behind, "{painted:?} lies beyond {bounds:?}");
                            n_after += 1;
                        } else if enter > 1.0 + 1e-9 {
                            assert!(at > front, "{painted:?} lies before {bounds:?}");
                            n_before += 1;
                        } else if enter < 1.0 - 1e-9 && exit > 1.0 + 1e-9 {
                            assert!(behind < at && at < front, "{painted:?} is in {bounds:?}");
                            n_inside += 1;
                        }
                    }
                }
            }
            assert!(lengths.iter().all(|length| (length - 1.0).abs() < 1e-9), "{lengths:?}");
        }
        assert!(n_before > 1000 && n_inside > 1000 && n_after > 1000);
    }

    #[test]
    fn of_equal_boxes_the_later_one_is_drawn_last() {
        let camera = Camera::framing(&ROOT, PAGE);
        let order = back_to_front(&ROOT, &[ROOT, ROOT], &[[[0.1; 3], [0.9; 3]]], &camera);
        let whole = Painted::Piece(0, [0.0, 1.0]);
        let half = Painted::Half;
        let wanted = [half(1, Half::Behind), half(0, Half::Behind), whole];
        assert_eq!(order[..3], wanted);
        assert_eq!(order[3..], [half(0, Half::Front), half(1, Half::Front)]);
    }

    #[test]
    fn a_line_through_nested_boxes_is_cut_where_it_enters_and_leaves_them() {
        let nested = [1.0, 0.5, 0.25].map(|side| Aabb { min: [0.0; 3], max: [side; 3] });
        let camera = Camera { yaw: 0.3, pitch: 0.4, ..Camera::framing(&ROOT, PAGE) };
        let line = [[0.9, 0.15, 0.2], [-0.6, 0.1, 0.1]];
        let order = back_to_front(&ROOT, &nested, &[line], &camera);
        let pieces = order.iter().filter(|p| matches!(p, Painted::Piece(..))).count();
        // Beyond, in the smallest, in the middle one, in the largest.
        assert_eq!(pieces, 4, "{order:?}");
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
            let order = back_to_front(&ROOT, &boxes, &[], &camera);
            assert_eq!(order.len(), 2 * boxes.len());
            let order: Vec<usize> = order.into_iter().filter_map(front).collect();
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
        let order = back_to_front(&ROOT, &boxes, &[], &camera);
        let fronts: Vec<_> = order.iter().copied().filter_map(front).collect();
        assert_eq!(order[0], Painted::Half(2, Half::Behind));
        assert_eq!(fronts, [3, 1, 0, 2]);
    }
}
