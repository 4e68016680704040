//! From one camera to another.

use crate::Camera;
use std::f64::consts::PI;

impl<const D: usize> Camera<D> {
    /// The camera on the way to another one: this one at share 0, the other at 1.
    /// Heights grow by equal factors in equal times, turns go the shorter way.
    pub fn towards(&self, goal: &Self, share: f64) -> Self {
        if share >= 1.0 {
            return *goal;
        }
        let mix = |a: f64, b: f64| a + share * (b - a);
        let height = self.height * (goal.height / self.height).powf(share);
        // What the middle of the page shows moves as the heights do, so that a
        // camera that comes nearer does not leave its goal on the way.
        let change = goal.height - self.height;
        let along =
            if change.abs() > 1e-9 * self.height { (height - self.height) / change } else { share };
        let turn = (goal.yaw - self.yaw + PI).rem_euclid(2.0 * PI) - PI;
        Self {
            target: std::array::from_fn(|e| {
                self.target[e] + along * (goal.target[e] - self.target[e])
            }),
            height,
            yaw: (self.yaw + share * turn).rem_euclid(2.0 * PI),
            pitch: mix(self.pitch, goal.pitch),
            lens: goal.lens,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Lens;

    #[test]
    fn a_flight_begins_and_ends_where_its_cameras_are() {
        let lens = Lens::Perspective;
        let from = Camera { target: [0.0; 3], height: 8.0, yaw: 0.1, pitch: 0.0, lens };
        let to = Camera { target: [1.0; 3], height: 2.0, yaw: 6.2, pitch: 1.0, lens };
        assert_eq!(from.towards(&to, 1.0), to);
        let start = from.towards(&to, 0.0);
        assert_eq!((start.target, start.height, start.pitch), ([0.0; 3], 8.0, 0.0));
        let middle = from.towards(&to, 0.5);
        assert!((middle.height - 4.0).abs() < 1e-12);
        // Over yaw 0, not all the way round.
        let off = (middle.yaw - 0.1 + PI).rem_euclid(2.0 * PI) - PI;
        assert!(off < 0.0 && off > -0.2, "{off}");
        // The goal stays in sight, and comes no nearer to the border.
        for share in [0.2, 0.5, 0.9] {
            let camera = from.towards(&to, share);
            assert!((1.0 - camera.target[0]) / camera.height <= 1.0 / 8.0 + 1e-12);
        }
    }
}
