//! What lies along the sides of a map: round values at their places.

use super::Rays;
use octoscope_core::explain::approx;
use octoscope_core::family::Family;

/// Most values along a side.
const MOST: f64 = 5.0;
/// Steps between angles, in degrees; smaller ones are as those between lengths.
const ANGLES: [f64; 8] = [10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 180.0];

/// A side of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Key of what it is, with its unit, in the language files.
    pub title: &'static str,
    /// The values at both ends; of angles in degrees.
    pub range: [f64; 2],
    /// What is measured along it.
    pub measures: Measures,
}

/// What is measured along a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measures {
    /// Angles, in degrees.
    Angle,
    /// Lengths, in those of the scene.
    Length,
}

/// A round value of a side.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where it lies between both ends, 0 to 1.
    pub share: f64,
    /// The value with its unit.
    pub text: String,
}

impl<const D: usize> Rays<D> {
    /// The sides to the right and upwards; `None` of the lines of sight, whose places are
    /// those of the picture.
    pub fn axes(&self) -> Option<[Axis; 2]> {
        let angle = |title, range| Axis { title, range, measures: Measures::Angle };
        match *self {
            Self::Family(Family::Lines { radius, .. }) => {
                let (title, range) = ("map-axis-offset", [-radius, radius]);
                let offset = Axis { title, range, measures: Measures::Length };
                Some([angle("map-axis-angle", [0.0, 360.0]), offset])
            }
            Self::Family(Family::Sight { spread, .. }) => {
                let [turn, rise] = spread.map(|angle| [-angle.to_degrees(), angle.to_degrees()]);
                Some([angle("map-axis-turn", turn), angle("map-axis-rise", rise)])
            }
            Self::Picture(..) => None,
        }
    }
}

impl Axis {
    /// Few round values between both ends, the smallest first; none where the ends are no
    /// numbers apart from each other.
    pub fn ticks(&self) -> Vec<Tick> {
        let [low, high] = self.range;
        if !(high > low && (high - low).is_finite()) {
            return Vec::new();
        }
        let step = self.step();
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let tick = |n: i64| {
            let value = n as f64 * step;
            let unit = match self.measures {
                Measures::Angle => "°",
                Measures::Length => "",
            };
            let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
            Tick { share, text: format!("{}{unit}", approx(value)) }
        };
        (first..=last).map(tick).collect()
    }

    /// The smallest round step that leaves few enough values.
    fn step(&self) -> f64 {
        let least = (self.range[1] - self.range[0]) / (MOST - 1.0) * (1.0 - 1e-9);
        let angle = ANGLES.into_iter().find(|step| *step >= least);
        if let Some(angle) = angle.filter(|_| self.measures == Measures::Angle && least > 5.0) {
            return angle;
        }
        let power = 10.0_f64.powf(least.log10().floor());
        let round = [1.0, 2.0, 2.5, 5.0].map(|factor| factor * power);
        round.into_iter().find(|step| *step >= least).unwrap_or(10.0 * power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(range: [f64; 2], measures: Measures) -> Vec<String> {
        let ticks = Axis { title: "", range, measures }.ticks();
        ticks.into_iter().map(|tick| tick.text).collect()
    }

    #[test]
    fn few_round_values_lie_along_a_side() {
        let full = told([0.0, 360.0], Measures::Angle);
        assert_eq!(full, ["0°", "90°", "180°", "270°", "360°"]);
        assert_eq!(told([-37.2, 37.2], Measures::Angle), ["−20°", "0°", "20°"]);
        assert_eq!(told([-7.0, 7.0], Measures::Angle), ["−5°", "0°", "5°"]);
        assert_eq!(told([-0.6, 0.6], Measures::Length), ["−0.5", "0", "0.5"]);
        assert_eq!(told([-141.4, 141.4], Measures::Length), ["−100", "0", "100"]);
    }

    #[test]
    fn a_side_without_a_length_has_no_values() {
        for range in [[0.0, 0.0], [-f64::MAX, f64::MAX], [0.0, f64::INFINITY], [f64::NAN, 1.0]] {
            assert_eq!(told(range, Measures::Length), Vec::<String>::new(), "{range:?}");
        }
        for reach in [1e-300, 1e300] {
            assert!(told([-reach, reach], Measures::Length).len() >= 2, "{reach}");
        }
    }

    #[test]
    fn every_side_has_two_values_at_their_places() {
        for exponent in -40..40 {
            let reach = 1.37_f64.powi(exponent);
            for measures in [Measures::Angle, Measures::Length] {
                let ticks = Axis { title: "", range: [-reach, reach], measures }.ticks();
                assert!((2..=5).contains(&ticks.len()), "{reach} {ticks:?}");
                assert!(ticks.windows(2).all(|two| two[0].share < two[1].share), "{ticks:?}");
                let middle = ticks.iter().find(|tick| tick.text.trim_end_matches('°') == "0");
                assert!((middle.unwrap().share - 0.5).abs() < 1e-9, "{ticks:?}");
            }
        }
    }
}
