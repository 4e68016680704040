//! The root's box and its grid of smallest cells.

use super::{Code, MAX_ROOT_LEVEL};
use crate::geometry::{Aabb, Axes};
use thiserror::Error;

/// Cube that the root covers, with the grid of its smallest cells.
///
/// The planes of the grid *are* the doubles that [`Domain::plane`] returns, so
/// that a cell has one exact extent on which all algorithms agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    min: [f64; D],
    side: f64,
    root_level: u8,
    cell: f64,
}

/// Why numbers do not make a domain.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum DomainError {
    /// The side is not a positive finite number, or a corner is not finite.
    #[error("the domain needs finite corners and a side above 0")]
    NotABox,
    /// More levels than codes have bits.
    #[error("the depth {0} is too large; at most 20 is possible")]
    TooDeep(u8),
    /// The side is so small against its coordinates that planes coincide.
    #[error(
        "cells of this size cannot be told apart so far from 0; use fewer levels or move the domain"
    )]
    TooFine,
}

impl<const D: usize> Domain<D> {
    /// Cube with minimum corner `min` and edge length `side`, in world units,
    /// cut into 2^`root_level` smallest cells per axis.
    ///
    /// # Errors
    /// Refuses what is no box, too deep, or finer than doubles can tell apart.
    pub fn new(min: [f64; D], side: f64, root_level: u8) -> Result<Self, DomainError> {
        let is_box = side > 0.0 && min.iter().all(|x| x.is_finite() && (x + side).is_finite());
        if !is_box {
            return Err(DomainError::NotABox);
        }
        if root_level > MAX_ROOT_LEVEL {
            return Err(DomainError::TooDeep(root_level));
        }
        let cell = side / f64::from(1u32 << root_level);
        let largest = min.iter().fold(side, |m, x| m.max(x.abs()).max((x + side).abs()));
        if !(cell.is_normal() && cell > 2.0 * f64::EPSILON * largest) {
            return Err(DomainError::TooFine);
        }
        Ok(Self { min, side, root_level, cell })
    }

    /// The unit cube with `root_level` levels below the root, at most 20.
    ///
    /// # Panics
    /// Panics above [`MAX_ROOT_LEVEL`].
    pub fn unit(root_level: u8) -> Self {
        Self::new([0.0; D], 1.0, root_level).expect("the unit cube is a domain up to level 20")
    }

    /// Minimum corner, in world units.
    pub fn min(&self) -> [f64; D] {
        self.min
    }

    /// Edge length of the root, in world units.
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Level of the root, R; 2^R is the number of smallest cells per axis.
    #[inline]
    pub fn root_level(&self) -> u8 {
        self.root_level
    }

    /// Number of smallest cells per axis, 2^R; valid codes lie below it.
    #[inline]
    pub fn grid_size(&self) -> u32 {
        1 << self.root_level
    }

    /// Edge length of a cell of `level`, in world units.
    pub fn cell_side(&self, level: u8) -> f64 {
        self.cell * f64::from(1u32 << level)
    }

    /// World coordinate of grid plane `index`, 0 … 2^R, across `axis`.
    #[inline]
    pub fn plane(&self, axis: usize, index: u32) -> f64 {
        self.min[axis] + f64::from(index) * self.cell
    }

    /// Box of the cell with this level and code.
    pub fn cell_box(&self, level: u8, code: Code<D>) -> Aabb<D> {
        Aabb {
            min: std::array::from_fn(|e| self.plane(e, code[e])),
            max: std::array::from_fn(|e| self.plane(e, code[e] + (1 << level))),
        }
    }

    /// Box of the root.
    pub fn root_box(&self) -> Aabb<D> {
        self.cell_box(self.root_level, [0; D])
    }

    /// Index of the smallest cell that owns coordinate `x` on `axis`, or `None`
    /// outside the domain, whose upper face is outside. NaN is outside.
    pub fn encode(&self, axis: usize, x: f64) -> Option<u32> {
        let inside = self.plane(axis, 0) <= x && x < self.plane(axis, self.grid_size());
        inside.then(|| self.settle(axis, x, |plane| plane <= x))
    }

    /// Like [`Domain::encode`], for a point about to move down the axis: a
    /// coordinate on a plane belongs to the cell below it (ceil − 1).
    pub fn encode_below(&self, axis: usize, x: f64) -> Option<u32> {
        let inside = self.plane(axis, 0) < x && x <= self.plane(axis, self.grid_size());
        inside.then(|| self.settle(axis, x, |plane| plane < x))
    }

    /// Code of the smallest cell that owns `point`, or `None` outside.
    pub fn encode_point(&self, point: [f64; D]) -> Option<Code<D>> {
        let mut code = [0; D];
        for axis in 0..D {
            code[axis] = self.encode(axis, point[axis])?;
        }
        Some(code)
    }

    /// Index of the smallest cell near `x`, off by rounding at most; a first
    /// guess for [`last_where`]. Coordinates outside give the nearest cell.
    #[inline]
    pub fn nearest_index(&self, axis: usize, x: f64) -> u32 {
        let guess = (x - self.min[axis]) / self.cell;
        guess.clamp(0.0, f64::from(self.grid_size() - 1)) as u32
    }

    /// The codes of a cell of level 0, unless it lies outside the domain.
    pub fn code_inside(&self, cell: [i64; D]) -> Option<Code<D>> {
        let is_inside = cell.iter().all(|c| (0..i64::from(self.grid_size())).contains(c));
        is_inside.then(|| cell.map(|c| c as u32))
    }

    /// Axes of `crossed` along which `code` lies outside the domain: −1 or 2^R.
    #[inline]
    pub fn outside(&self, code: [i64; D], crossed: Axes<D>) -> Axes<D> {
        let is_outside = |e: usize| !(0..i64::from(self.grid_size())).contains(&code[e]);
        Axes::of(|e| crossed.contains(e) && is_outside(e))
    }

    fn settle(&self, axis: usize, x: f64, passed: impl Fn(f64) -> bool) -> u32 {
        let range = [0, self.grid_size() - 1];
        last_where(range, self.nearest_index(axis, x), |index| passed(self.plane(axis, index)))
    }
}

/// Largest index in `first..=last` for which `holds`, which is true at `first`
/// and, once false, stays false. Looks near `guess` first: O(log distance).
#[inline]
pub fn last_where([first, last]: [u32; 2], guess: u32, holds: impl Fn(u32) -> bool) -> u32 {
    let guess = guess.clamp(first, last);

    // Gallop away from the guess until the answer is enclosed.
    let (mut yes, mut no) = (first, last + 1);
    let mut step = 1;
    if guess == first || holds(guess) {
        yes = guess;
        while yes + step < no {
            if !holds(yes + step) {
                no = yes + step;
                break;
            }
            yes += step;
            step *= 2;
        }
    } else {
        no = guess;
        while no > first + step {
            if holds(no - step) {
                yes = no - step;
                break;
            }
            no -= step;
            step *= 2;
        }
    }

    // Bisect what is left.
    while no - yes > 1 {
        let middle = yes + (no - yes) / 2;
        if holds(middle) { yes = middle } else { no = middle }
    }
    yes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn worked_example_of_the_report() {
        let domain = Domain::<1>::unit(5);
        assert_eq!(domain.encode(0, 0.55), Some(0b01_0001));
    }

    #[test]
    fn planes_belong_to_the_upper_cell_and_the_last_to_none() {
        let domain = Domain::<1>::unit(2);
        assert_eq!(domain.encode(0, 0.5), Some(2));
        assert_eq!(domain.encode(0, 1.0), None);
        assert_eq!(domain.encode(0, -0.0), Some(0));
        assert_eq!(domain.encode(0, f64::NAN), None);
        assert_eq!(domain.encode_below(0, 0.5), Some(1));
        assert_eq!(domain.encode_below(0, 1.0), Some(3));
        assert_eq!(domain.encode_below(0, 0.0), None);
    }

    #[test]
    fn encoding_agrees_with_the_planes_where_division_rounds() {
        let domain = Domain::<1>::new([0.1], 0.7, 10).unwrap();
        for index in 0..=domain.grid_size() {
            let plane = domain.plane(0, index);
            let owner = (index < domain.grid_size()).then_some(index);
            assert_eq!(domain.encode(0, plane), owner);
            assert_eq!(domain.encode_below(0, plane), index.checked_sub(1));
        }
    }

    #[test]
    fn refuses_what_is_no_domain() {
        assert_eq!(Domain::new([0.0], 0.0, 3), Err(DomainError::NotABox));
        assert_eq!(Domain::new([f64::NAN], 1.0, 3), Err(DomainError::NotABox));
        assert_eq!(Domain::new([0.0], 1.0, 21), Err(DomainError::TooDeep(21)));
        assert_eq!(Domain::new([1e15], 1.0, 8), Err(DomainError::TooFine));
    }

    #[test]
    fn last_where_finds_the_border_from_any_guess() {
        for last in 3..20 {
            for border in 3..=last {
                for guess in 0..30 {
                    assert_eq!(last_where([3, last], guess, |n| n <= border), border);
                }
            }
        }
    }
}
