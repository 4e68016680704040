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

/// Cells are halved at most this often along each axis; what is still together then
/// is sorted by its distance.
const MOST_LEVELS: u8 = 24;

/// What is drawn next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Painted<const D: usize> {
    /// A half of the box of this number.
    Half(usize, Half),
    /// A part of the flat box of this number.
    Flat(usize, Aabb<D>),
    /// A piece of the line of this number, from one share of its length to another.
    Piece(usize, [f64; 2]),
}

/// Order in which the boxes of one tree over `root`, and straight lines through
/// them, are drawn, the farthest first: each box with both of its halves, each flat
/// one in parts, each line in pieces. Exact for boxes of the tree's nodes and their
/// halves along the axes in turn, nested or apart, whatever their sizes, and for
/// planes between them: beyond the plane that parts two of them lies the one that is
/// not on the eye's side, and lines and flat boxes are cut by these planes. Other
/// boxes are taken for points in their middle. O(n log n) for a tree that is not
/// degenerate.
pub(crate) fn back_to_front<const D: usize>(
    root: &Aabb<D>,
    boxes: &[Aabb<D>],
    lines: &[[[f64; D]; 2]],
    camera: &Camera<D>,
) -> Vec<Painted<D>> {
    let order = Vec::with_capacity(2 * boxes.len() + lines.len());
    let mut painter = Painter { boxes, lines, camera, order };
    let whole = (0..lines.len()).map(|line| Piece { line, between: [0.0, 1.0] });
    let Around { far, inside, near } = painter.around(root, whole.collect());
    let mut content = Content { pieces: inside, ..Content::default() };
    for (index, bounds) in boxes.iter().enumerate() {
        match flat_axis(bounds) {
            Some(axis) => content.flats.push(Flat { index, axis, bounds: *bounds }),
            None => content.boxes.push(index),
        }
    }
    painter.draw_pieces(far);
    painter.sort(root, content, 0);
    painter.draw_pieces(near);
    painter.order
}

/// The axis across which a box is flat.
fn flat_axis<const D: usize>(bounds: &Aabb<D>) -> Option<usize> {
    let size = bounds.size();
    let flat = |axis: &usize| size[*axis] < 1e-6 * length(bounds);
    (0..D).find(flat)
}

struct Painter<'a, const D: usize> {
    boxes: &'a [Aabb<D>],
    lines: &'a [[[f64; D]; 2]],
    camera: &'a Camera<D>,
    order: Vec<Painted<D>>,
}

/// What lies in a cell.
struct Content<const D: usize> {
    boxes: Vec<usize>,
    flats: Vec<Flat<D>>,
    pieces: Vec<Piece>,
}

impl<const D: usize> Default for Content<D> {
    fn default() -> Self {
        Self { boxes: Vec::new(), flats: Vec::new(), pieces: Vec::new() }
    }
}

/// Part of a flat box across `axis`.
#[derive(Clone, Copy, Debug)]
struct Flat<const D: usize> {
    index: usize,
    axis: usize,
    bounds: Aabb<D>,
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
    /// Draws what lies in a cell that was halved `n_cuts` times, along the axes in turn.
    fn sort(&mut self, cell: &Aabb<D>, content: Content<D>, n_cuts: u8) {
        let Content { boxes, flats, pieces } = content;
        if boxes.is_empty() {
            return self.sort_flats(flats, pieces);
        }
        let is_alone = boxes.len() == 1 && flats.is_empty() && pieces.is_empty();
        if is_alone || n_cuts == MOST_LEVELS * D as u8 {
            self.draw_pieces(pieces);
            self.order.extend(flats.iter().map(|flat| Painted::Flat(flat.index, flat.bounds)));
            return self.sort_by_distance(boxes);
        }

        // What is as large as the cell goes around all else.
        let (mut around, boxes): (Vec<usize>, Vec<usize>) =
            boxes.into_iter().partition(|&index| is_as_large(&self.boxes[index], cell));
        // Of equal ones the later lies around the earlier: it is the one to be seen.
        around.sort_by(|&a, &b| {
            length(&self.boxes[b]).total_cmp(&length(&self.boxes[a])).then(b.cmp(&a))
        });
        self.order.extend(around.iter().map(|&index| Painted::Half(index, Half::Behind)));
        // So do planes on its sides.
        let (sides, flats): (Vec<_>, Vec<_>) =
            flats.into_iter().partition(|flat| is_on_side(flat, cell));
        let (near_sides, far_sides): (Vec<_>, Vec<_>) = sides.into_iter().partition(|flat| {
            let is_upper = flat.bounds.min[flat.axis] > cell.centre()[flat.axis];
            self.eye_is_above(flat.axis, flat.bounds.min) == is_upper
        });
        self.draw_flats(&far_sides);

        let axis = usize::from(n_cuts) % D;
        let middle = cell.centre();
        let plane = middle[axis];
        let tolerance = 1e-6 * length(cell);
        let (mut halves, mut between) = ([Content::default(), Content::default()], Vec::new());
        for index in boxes {
            let is_upper = self.boxes[index].centre()[axis] >= plane;
            halves[usize::from(is_upper)].boxes.push(index);
        }
        let [lower, on, upper] = parted(flats, axis, plane, tolerance);
        between.extend(on);
        (halves[0].flats, halves[1].flats) = (lower, upper);
        let [lower, upper] = self.parted_pieces(pieces, axis, plane);
        (halves[0].pieces, halves[1].pieces) = (lower, upper);

        let near_is_upper = self.eye_is_above(axis, middle);
        for is_upper in [!near_is_upper, near_is_upper] {
            if is_upper == near_is_upper {
                self.draw_flats(&between);
            }
            let mut part = *cell;
            let bound = if is_upper { &mut part.min } else { &mut part.max };
            bound[axis] = plane;
            self.sort(&part, std::mem::take(&mut halves[usize::from(is_upper)]), n_cuts + 1);
        }

        // A plane on a side that faces the eye lies before the edges of that.
        self.order.extend(around.iter().rev().map(|&index| Painted::Half(index, Half::Front)));
        self.draw_flats(&near_sides);
    }

    /// Draws flat boxes and pieces among which there is nothing else: the plane of one
    /// of them parts the others. O(n²) for n flat boxes, which are few.
    fn sort_flats(&mut self, flats: Vec<Flat<D>>, pieces: Vec<Piece>) {
        let Some(&Flat { axis, bounds, .. }) = flats.first() else {
            return self.draw_pieces(pieces);
        };
        let plane = bounds.min[axis];
        let [lower, on, upper] = parted(flats, axis, plane, 1e-9 * length(&bounds));
        let [lower_pieces, upper_pieces] = self.parted_pieces(pieces, axis, plane);
        let (far, near) = if self.eye_is_above(axis, bounds.min) {
            ((lower, lower_pieces), (upper, upper_pieces))
        } else {
            ((upper, upper_pieces), (lower, lower_pieces))
        };
        self.sort_flats(far.0, far.1);
        self.draw_flats(&on);
        self.sort_flats(near.0, near.1);
    }

    /// The pieces below and above a plane, cut where they cross it.
    fn parted_pieces(&self, pieces: Vec<Piece>, axis: usize, plane: f64) -> [Vec<Piece>; 2] {
        let cut = pieces.into_iter().flat_map(|piece| self.cut(piece, axis, plane));
        let (upper, lower) = cut.partition(|piece| self.middle(*piece)[axis] >= plane);
        [lower, upper]
    }

    fn draw_flats(&mut self, flats: &[Flat<D>]) {
        self.order.extend(flats.iter().map(|flat| Painted::Flat(flat.index, flat.bounds)));
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

/// Flat boxes below, in and above a plane, cut where they cross it.
fn parted<const D: usize>(
    flats: Vec<Flat<D>>,
    axis: usize,
    plane: f64,
    tolerance: f64,
) -> [Vec<Flat<D>>; 3] {
    let mut parts = [Vec::new(), Vec::new(), Vec::new()];
    for flat in flats {
        let [low, high] = [flat.bounds.min[axis], flat.bounds.max[axis]];
        if flat.axis == axis && (low - plane).abs() <= tolerance {
            parts[1].push(flat);
        } else if low < plane - tolerance && high > plane + tolerance {
            let [mut lower, mut upper] = [flat; 2];
            (lower.bounds.max[axis], upper.bounds.min[axis]) = (plane, plane);
            parts[0].push(lower);
            parts[2].push(upper);
        } else {
            parts[if 0.5 * (low + high) < plane { 0 } else { 2 }].push(flat);
        }
    }
    parts
}

/// Whether a box is about as large as a cell along every axis.
fn is_as_large<const D: usize>(bounds: &Aabb<D>, cell: &Aabb<D>) -> bool {
    let (own, whole) = (bounds.size(), cell.size());
    (0..D).all(|e| own[e] > 0.6 * whole[e])
}

/// Whether a flat box is about as large as a side of a cell, and on it.
fn is_on_side<const D: usize>(flat: &Flat<D>, cell: &Aabb<D>) -> bool {
    let (own, whole) = (flat.bounds.size(), cell.size());
    let at = flat.bounds.min[flat.axis];
    let tolerance = 1e-6 * length(cell);
    let sides = [cell.min[flat.axis], cell.max[flat.axis]];
    sides.iter().any(|side| (side - at).abs() < tolerance)
        && (0..D).all(|e| e == flat.axis || own[e] > 0.6 * whole[e])
}

fn length<const D: usize>(bounds: &Aabb<D>) -> f64 {
    bounds.size().into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
