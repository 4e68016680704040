//! The numbers that are placed, and what they may not cover: by squares of the page, so
//! that a place is compared with what is near alone.

use super::{Kept, Stand, Taken, between, do_cross, square, square_between, square_to_segment};
use crate::camera::clipped;

/// Room between two discs.
pub(super) const BETWEEN: f64 = 1.0;
/// Side of a square of the page: about that of two discs.
const SQUARE: f64 = 32.0;

/// What numbers may not cover, and those that have their places.
pub(super) struct Crowd<'a> {
    kept: Kept<'a>,
    squares: Squares,
    placed: Vec<Stand>,
}

impl<'a> Crowd<'a> {
    pub(super) fn new(kept: Kept<'a>) -> Self {
        let mut squares = Squares::of(kept.page);
        for (index, [middle, reach]) in kept.taken.iter().enumerate() {
            squares.add([-1.0, 1.0].map(|sign| moved(*middle, sign, *reach)), |square| {
                square.taken.push(index);
            });
        }
        Self { kept, squares, placed: Vec::new() }
    }

    /// From now on this place is taken.
    pub(super) fn place(&mut self, stand: Stand) {
        let index = self.placed.len();
        self.placed.push(stand);
        self.squares.add(stand.extent(), |square| square.placed.push(index));
    }

    pub(super) fn has_room(&self, stand: &Stand) -> bool {
        let mut near = self.squares.near(stand.extent());
        let meets = |other: &usize| collide(stand, &self.placed[*other]);
        self.is_on_page(stand)
            && self.is_free(stand)
            && !near.any(|square| square.placed.iter().any(meets))
    }

    /// Whether the disc lies on the page.
    pub(super) fn is_on_page(&self, &Stand { at, radius, .. }: &Stand) -> bool {
        (0..2).all(|e| (radius..=self.kept.page[e] - radius).contains(&at[e]))
    }

    /// Whether neither the disc nor its line covers anything that must be seen.
    pub(super) fn is_free(&self, stand: &Stand) -> bool {
        let Kept { taken, lines, .. } = self.kept;
        let Stand { at, radius, leader } = *stand;
        let covers = |index: &usize| {
            let area = taken[*index];
            meets_disc(area, at, radius) || leader.is_some_and(|line| is_struck(area, line))
        };
        let mut near = self.squares.near(stand.extent());
        !near.any(|square| square.taken.iter().any(covers))
            && !lines.iter().any(|line| square_to_segment(at, *line) < radius * radius)
    }

    /// Whether the line of a number crosses one that discs may not cover, but for the one on
    /// which it begins.
    pub(super) fn is_crossed(&self, stand: &Stand) -> bool {
        const ON_IT: f64 = 1.0;
        let Some(leader) = stand.leader else { return false };
        let crosses = |line: &[[f64; 2]; 2]| {
            do_cross(leader, *line) && square_to_segment(leader[0], *line) > ON_IT * ON_IT
        };
        self.kept.lines.iter().any(crosses)
    }
}

impl Stand {
    /// Least and largest corner of the disc with its line, and the room around it.
    pub(super) fn extent(&self) -> [[f64; 2]; 2] {
        let reach = [self.radius + BETWEEN; 2];
        let [mut min, mut max] = [-1.0, 1.0].map(|sign| moved(self.at, sign, reach));
        for end in self.leader.iter().flatten() {
            min = std::array::from_fn(|e| min[e].min(end[e]));
            max = std::array::from_fn(|e| max[e].max(end[e]));
        }
        [min, max]
    }
}

fn moved(at: [f64; 2], sign: f64, reach: [f64; 2]) -> [f64; 2] {
    std::array::from_fn(|e| at[e] + sign * reach[e])
}

/// The page in squares; those at its borders hold what lies beyond, too.
struct Squares {
    across: usize,
    down: usize,
    squares: Vec<Square>,
}

/// What lies in a square, by index.
#[derive(Clone, Default)]
struct Square {
    taken: Vec<usize>,
    placed: Vec<usize>,
}

impl Squares {
    fn of(page: [f64; 2]) -> Self {
        let [across, down] = page.map(|side| (side / SQUARE) as usize + 1);
        Self { across, down, squares: vec![Square::default(); across * down] }
    }

    /// Indices of the squares between two corners.
    fn between(&self, [min, max]: [[f64; 2]; 2]) -> impl Iterator<Item = usize> + use<> {
        let index = |at: f64, most: usize| ((at / SQUARE).max(0.0) as usize).min(most - 1);
        let [left, right] = [min, max].map(|end| index(end[0], self.across));
        let [top, bottom] = [min, max].map(|end| index(end[1], self.down));
        let across = self.across;
        (top..=bottom).flat_map(move |y| (left..=right).map(move |x| y * across + x))
    }

    fn add(&mut self, corners: [[f64; 2]; 2], push: impl Fn(&mut Square)) {
        for index in self.between(corners) {
            push(&mut self.squares[index]);
        }
    }

    fn near(&self, corners: [[f64; 2]; 2]) -> impl Iterator<Item = &Square> {
        self.between(corners).map(|index| &self.squares[index])
    }
}

fn meets_disc([middle, reach]: Taken, at: [f64; 2], radius: f64) -> bool {
    let beyond: [f64; 2] = std::array::from_fn(|e| ((at[e] - middle[e]).abs() - reach[e]).max(0.0));
    square(beyond) < radius * radius
}

/// Whether the half of a line that ends at a number strikes what is taken. The half at its
/// foot is not asked, nor a line whose foot lies in it: there is no other way.
fn is_struck([middle, reach]: Taken, [foot, rim]: [[f64; 2]; 2]) -> bool {
    let area = [-1.0, 1.0].map(|sign| std::array::from_fn(|e| middle[e] + sign * reach[e]));
    let is_at_foot = (0..2).all(|e| (area[0][e]..=area[1][e]).contains(&foot[e]));
    !is_at_foot && clipped([between([foot, rim], 0.5), rim], area).is_some()
}

/// Whether two numbers, or the line of one and the disc or line of the other, meet.
pub(super) fn collide(a: &Stand, b: &Stand) -> bool {
    let crosses = |line: Option<[[f64; 2]; 2]>, other: &Stand| {
        let reach = other.radius + BETWEEN;
        line.is_some_and(|line| square_to_segment(other.at, line) < reach * reach)
    };
    square_between(a.at, b.at) < (a.radius + b.radius + BETWEEN).powi(2)
        || crosses(a.leader, b)
        || crosses(b.leader, a)
        || matches!((a.leader, b.leader), (Some(a), Some(b)) if do_cross(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::random::Random;

    #[test]
    fn what_is_near_is_all_that_can_be_met() {
        let mut random = Random::new(5);
        let page = [300.0, 200.0];
        let mut at = |beyond: f64| page.map(|side| random.between(-beyond, side + beyond));
        let taken: Vec<Taken> = (0..12).map(|n| [at(30.0), [f64::from(n) * 2.0, 3.0]]).collect();
        let mut stand = |n: u32| {
            let at_disc = at(0.0);
            let foot = at(0.0).map(|x| 0.2 * x);
            let foot = std::array::from_fn(|e| at_disc[e] + foot[e] - 25.0);
            let radius = 3.0 + f64::from(n % 7);
            Stand { at: at_disc, radius, leader: n.is_multiple_of(3).then_some([foot, at_disc]) }
        };
        let mut crowd = Crowd::new(Kept { taken: &taken, lines: &[], page });
        let (mut n_free, mut n_met) = (0, 0);
        for n in 0..3000 {
            let stand = stand(n);
            let covers = |area: &Taken| {
                meets_disc(*area, stand.at, stand.radius)
                    || stand.leader.is_some_and(|line| is_struck(*area, line))
            };
            let is_free = !taken.iter().any(covers);
            let is_met = || crowd.placed.iter().any(|other| collide(&stand, other));
            let has_room = is_free && crowd.is_on_page(&stand) && !is_met();
            assert_eq!(crowd.is_free(&stand), is_free, "{stand:?}");
            assert_eq!(crowd.has_room(&stand), has_room, "{stand:?}");
            n_free += usize::from(is_free);
            n_met += usize::from(is_free && crowd.is_on_page(&stand) && is_met());
            if n < 40 && crowd.is_on_page(&stand) {
                crowd.place(stand);
            }
        }
        assert!(n_free > 500 && n_met > 100 && n_met < n_free, "{n_free} {n_met}");
    }
}
