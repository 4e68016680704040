//! Places at the frame of a small child, outside of it, for what has no room within, and what
//! points into it from there.

use super::{Canvas, distance};
use crate::Extent;
use crate::camera::clipped;
use crate::numbers::{Area, Convex, between};
use crate::sides::sides_to_eye;
use octoscope_core::geometry::Aabb;
use std::f64::consts::{PI, TAU};

/// Half the width of what points from a tag at its broad end, in the middle of the tag, in
/// page units.
const BROAD: f64 = 7.0;
/// Half the side of the square around its tip that nothing else may cover.
pub(super) const POINT: f64 = 3.5;

impl<const D: usize> Canvas<'_, D> {
    /// Middles of squares of `half` a side on the page that touch the frame of a child, and
    /// neither it nor one of its siblings, all around it.
    pub(super) fn at_frame(
        &self,
        child: &Aabb<D>,
        siblings: &[Aabb<D>],
        half: f64,
    ) -> Vec<[f64; 2]> {
        /// Half the line of the frame.
        const FRAME: f64 = 1.7;
        let Some(own) = self.seen_of(child) else { return Vec::new() };
        let others = siblings.iter().filter(|sibling| *sibling != child);
        let others: Vec<Seen> = others.filter_map(|sibling| self.seen_of(sibling)).collect();
        let at = directions().filter_map(|along| own.beside(along, half + FRAME));
        at.filter(|at| {
            self.is_on_page(*at, [half; 2]) && !others.iter().any(|other| other.meets(*at, half))
        })
        .collect()
    }

    /// What a box covers on the page.
    pub(super) fn seen_of(&self, bounds: &Aabb<D>) -> Option<Seen> {
        let sides: Vec<Vec<[f64; 2]>> = if D == 2 {
            vec![self.outline(bounds)]
        } else {
            let seen = sides_to_eye(self.camera, self.page, bounds).into_iter();
            seen.map(|side| side.polygon.iter().map(|p| p.at).collect()).collect()
        };
        let own = sides.iter().cloned().filter_map(Convex::new).collect();
        let middle = self.camera.project(self.page, bounds.centre())?.at;
        Some(Seen { sides, area: Area { own, before: Vec::new() }, middle })
    }
}

/// What is seen of a box.
pub(super) struct Seen {
    sides: Vec<Vec<[f64; 2]>>,
    area: Area,
    /// The middle of the box.
    pub middle: [f64; 2],
}

impl Seen {
    /// The nearest place that way where a square of `half` a side lies beside it.
    fn beside(&self, along: [f64; 2], half: f64) -> Option<[f64; 2]> {
        const STEP: f64 = 0.5;
        const STEPS: u32 = 400;
        let place =
            |n: u32| std::array::from_fn(|e| self.middle[e] + STEP * f64::from(n) * along[e]);
        (1..STEPS).map(place).find(|at| !self.meets(*at, half))
    }

    /// Least and largest corner of it.
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let all = Extent::around(self.sides.iter().flatten().copied());
        all.map_or([self.middle; 2], |all| [all.min, all.max])
    }

    /// Whether it is what is seen at a point.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        self.area.holds(at)
    }

    /// Where a tag that stands outside of it points: so far `within` it, in page units.
    pub fn pointed_at<const N: usize>(
        &self,
        tag: [f64; 2],
        within: [f64; N],
    ) -> Option<[[f64; 2]; N]> {
        const STEP: f64 = 0.5;
        /// What of the way from its rim to its middle, at most.
        const MOST: f64 = 0.6;
        let length = distance(tag, self.middle);
        let at = |away: f64| between([tag, self.middle], away / length);
        let mut steps = (0..).map(|n| STEP * f64::from(n)).take_while(|away| *away < length);
        let rim = steps.find(|away| self.holds(at(*away)))?;
        (rim > 0.0).then(|| within.map(|within| at(rim + within.min(MOST * (length - rim)))))
    }

    /// Whether a square lies on it.
    pub fn meets(&self, at: [f64; 2], half: f64) -> bool {
        let square = [-half, half].map(|by| at.map(|x| x + by));
        let is_struck = |side: &Vec<[f64; 2]>| {
            let next = side.iter().cycle().skip(1);
            side.iter().zip(next).any(|(a, b)| clipped([*a, *b], square).is_some())
        };
        self.area.holds(at) || self.sides.iter().any(is_struck)
    }
}

/// Corners of what points from the middle of a tag to `tip`; the tag lies on its broad end.
pub(super) fn pointer(at: [f64; 2], tip: [f64; 2]) -> [[f64; 2]; 3] {
    let length = distance(at, tip);
    let aside = |by: f64| {
        let across = [at[1] - tip[1], tip[0] - at[0]];
        std::array::from_fn(|e| at[e] + by * across[e] / length)
    };
    [aside(BROAD), tip, aside(-BROAD)]
}

/// Ways to all sides, those along the page first, and none from corner to corner.
fn directions() -> impl Iterator<Item = [f64; 2]> {
    [0.0, 1.0, -1.0, 2.0, -2.0].into_iter().flat_map(|off| {
        [0.0, 0.25, 0.5, 0.75].map(|turn| {
            let (sin, cos) = (TAU * turn + off * PI / 12.0).sin_cos();
            [cos, sin]
        })
    })
}
