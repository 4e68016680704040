//! The numbers of an axis in the plane: evenly spaced, but for those that the ray crosses,
//! and apart from each other.

use super::Canvas;
use crate::figure::text_reach;
use crate::{Mark, Role, Shape};
use octoscope_core::geometry::AXIS_NAMES;

/// Room between two numbers of an axis.
const GAP: f64 = 5.0;

/// A number that looks for its place.
struct Tick<'a, const D: usize> {
    mark: &'a Mark<D>,
    text: &'a str,
    at: [f64; 2],
    reach: [f64; 2],
}

/// Whether a mark is the number of an axis in the plane, or its name there.
pub(super) fn is_tick<const D: usize>(mark: &Mark<D>) -> bool {
    let is_label = matches!((mark.role, mark.shape), (Role::AxisLabel(_), Shape::Label(_)));
    D == 2 && is_label
}

impl<const D: usize> Canvas<'_, D> {
    /// Writes the numbers of all axes, and their names.
    pub(super) fn write_ticks(&mut self, marks: &[Mark<D>]) {
        for axis in 0..D {
            let own = marks.iter().filter(|mark| mark.role == Role::AxisLabel(axis));
            let own = own.filter(|mark| is_tick(mark));
            let is_name = |mark: &&Mark<D>| mark.text.as_deref() == Some(AXIS_NAMES[axis]);
            let (names, numbers): (Vec<&Mark<D>>, Vec<_>) = own.partition(is_name);
            for marks in [numbers, names] {
                let ticks: Vec<_> = marks.iter().map(|mark| self.tick(axis, mark)).collect();
                for tick in evenly(&ticks, axis, |tick| self.has_room(tick)) {
                    self.taken.push([tick.at, tick.reach]);
                    self.text(tick.mark, tick.at, tick.text);
                }
            }
        }
    }

    /// A number, if its place is before the eye.
    fn tick<'m>(&self, axis: usize, mark: &'m Mark<D>) -> Option<Tick<'m, D>> {
        let Shape::Label(at) = mark.shape else { return None };
        let text = mark.text.as_deref()?;
        let reach = text_reach(mark.role, text);
        let at = self.camera.project(self.page, at)?.at;
        Some(Tick { mark, text, at: self.outside(axis, at, reach), reach })
    }

    /// Whether a number covers nothing and the ray does not cross it. Digits are low.
    fn has_room(&self, tick: &Tick<'_, D>) -> bool {
        let digits = [tick.reach[0], 0.45 * tick.reach[1]];
        self.n_covered(tick.at, digits) == 0 && self.is_free(tick.at, tick.reach)
    }

    /// Where a label stands beside the tick `at` of its axis: below the x axis,
    /// left of the y axis, on the page if the tick is.
    fn outside(&self, axis: usize, [x, y]: [f64; 2], reach: [f64; 2]) -> [f64; 2] {
        const AWAY: f64 = 10.0;
        let page = [self.page.width, self.page.height];
        let beside = if axis == 0 { [x, y + reach[1] + AWAY] } else { [x - reach[0] - AWAY, y] };
        let is_on_page = (0..2).all(|e| (0.0..=page[e]).contains(&[x, y][e]));
        if !is_on_page {
            return beside;
        }
        std::array::from_fn(|e| beside[e].min(page[e] - reach[e]).max(reach[e]))
    }
}

/// Those of the ticks along an axis that are written: every one or every second one and so
/// on, so that they are apart; of such rows the one with the most that have room, and among
/// as many the one that spans the most. A number that has no room is left out alone.
fn evenly<'t, 'm, const D: usize>(
    ticks: &'t [Option<Tick<'m, D>>],
    axis: usize,
    has_room: impl Fn(&Tick<'m, D>) -> bool,
) -> Vec<&'t Tick<'m, D>> {
    let free: Vec<bool> = ticks.iter().map(|tick| tick.as_ref().is_some_and(&has_room)).collect();
    let are_apart = |a: &Tick<'_, D>, b: &Tick<'_, D>| {
        (a.at[axis] - b.at[axis]).abs() >= a.reach[axis] + b.reach[axis] + GAP
    };
    let n = ticks.len();
    let rows = (1..=n.max(1)).flat_map(|step| (0..n).map(move |first| (step, first)));
    let rows = rows.map(|(step, first)| {
        let (mut row, mut last): (Vec<&Tick<'_, D>>, Option<&Tick<'_, D>>) = (Vec::new(), None);
        let own = ticks.iter().zip(&free).skip(first).step_by(step);
        for (tick, is_free) in own.map_while(|(tick, is_free)| Some((tick.as_ref()?, is_free))) {
            if last.is_some_and(|last| !are_apart(last, tick)) {
                break;
            }
            last = Some(tick);
            row.extend(is_free.then_some(tick));
        }
        (row.len(), row.len() * step, row)
    });
    // Of equal ones the first.
    let best = rows.reduce(|best, row| if (row.0, row.1) > (best.0, best.1) { row } else { best });
    best.map_or_else(Vec::new, |(_, _, row)| row)
}
