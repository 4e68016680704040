//! Where the ray is in what the algorithm looks at.

use super::{Scene, interval};
use crate::{Mark, Role, Shape};
use octoscope_core::geometry::Aabb;
use octoscope_core::query::Query;
use octoscope_core::trace::Extent;

impl<const D: usize> Scene<'_, D> {
    /// Where the ray enters and leaves the current node, which has these bounds; in a walk
    /// through the grid, the cell in which the algorithm is.
    pub(super) fn passage(&self, bounds: &Aabb<D>, marks: &mut Vec<Mark<D>>) {
        if !matches!(self.query, Query::Ray { .. }) {
            return;
        }
        let in_grid = self.moment.grid.filter(|grid| grid.cell.is_some());
        let ends = match in_grid {
            Some(grid) => Some([grid.enter, grid.next.into_iter().fold(f64::INFINITY, f64::min)]),
            None => interval(self.ray, bounds).filter(|[_, exit]| *exit >= 0.0),
        };
        let Some([enter, exit]) = ends.filter(|ends| self.is_told(*ends)) else { return };
        for (t, role) in [(enter.max(0.0), Role::EntryPoint), (exit, Role::ExitPoint)] {
            let mark = Mark::new(Shape::Point(self.ray.at(t)), role);
            marks.push(Mark { node: self.moment.current, ..mark });
        }
    }

    /// Whether the algorithm takes the ray to be there as well: a misprint may not.
    fn is_told(&self, [enter, exit]: [f64; 2]) -> bool {
        const NEAR: f64 = 1e-6;
        let frame = self.moment.frame().filter(|frame| Some(frame.node) == self.moment.current);
        let Some(Extent::Planes { near, far }) = frame.map(|frame| frame.extent) else {
            return true;
        };
        let told = [
            near.into_iter().fold(f64::NEG_INFINITY, f64::max),
            far.into_iter().fold(f64::INFINITY, f64::min),
        ];
        let is_near = |a: f64, b: f64| (a - b).abs() <= NEAR * (1.0 + a.abs());
        !self.query.is_misprinted() || is_near(enter, told[0]) && is_near(exit, told[1])
    }
}
