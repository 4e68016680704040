//! The moments of a storyboard.

use crate::document::Document;
use octoscope_core::event::Event;
use std::fmt::{Display, Formatter};
use std::str::FromStr;

/// Which moments a storyboard shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Moments {
    /// So many, from the first step to the last at even distances.
    Even(usize),
    /// Those at which a leaf is reported, at most so many.
    Leaves(usize),
    /// After these numbers of events.
    At(Vec<usize>),
}

impl Default for Moments {
    fn default() -> Self {
        Self::Even(6)
    }
}

impl Moments {
    /// Most panels of a storyboard: more would be too small or too many to read.
    pub const MOST: usize = 24;

    /// The first step among them that a run of `n_events` does not have, if there is one.
    pub fn missing(&self, n_events: usize) -> Option<usize> {
        match self {
            Self::Even(_) | Self::Leaves(_) => None,
            Self::At(steps) => steps.iter().copied().find(|step| *step > n_events),
        }
    }

    /// The steps in a run of `document`.
    pub(super) fn steps<const D: usize>(&self, document: &Document<D>) -> Vec<usize> {
        let n_steps = document.trace.events.len();
        match self {
            Self::Even(n) => evenly(*n, &(1..=n_steps).collect::<Vec<_>>()),
            Self::Leaves(n) => {
                let events = document.trace.events.iter().enumerate();
                let is_leaf = |(index, event): (usize, &Event<D>)| {
                    matches!(event, Event::Leaf { .. } | Event::Found { .. }).then_some(index + 1)
                };
                evenly(*n, &events.filter_map(is_leaf).collect::<Vec<_>>())
            }
            Self::At(steps) => steps.clone(),
        }
    }
}

impl FromStr for Moments {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let few = |n: &str| n.parse().ok().filter(|n| (1..=Self::MOST).contains(n));
        let parsed = match text.split_once(':') {
            Some(("even", n)) => few(n).map(Self::Even),
            Some(("leaves", n)) => few(n).map(Self::Leaves),
            Some(_) => None,
            None => {
                let steps: Result<Vec<usize>, _> =
                    text.split(',').map(|n| n.trim().parse()).collect();
                steps.ok().filter(|steps| steps.len() <= Self::MOST).map(Self::At)
            }
        };
        parsed.ok_or_else(|| {
            format!("give even:N, leaves:N or a list as 3,7,12, of at most {} steps", Self::MOST)
        })
    }
}

impl Display for Moments {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Even(n) => write!(f, "even:{n}"),
            Self::Leaves(n) => write!(f, "leaves:{n}"),
            Self::At(steps) => {
                let steps: Vec<_> = steps.iter().map(usize::to_string).collect();
                f.write_str(&steps.join(","))
            }
        }
    }
}

/// At most `n` of some numbers, at even distances, the first and the last among them.
fn evenly(n: usize, all: &[usize]) -> Vec<usize> {
    if all.len() <= n || n < 2 {
        return all.iter().copied().take(n.max(1)).collect();
    }
    (0..n).map(|index| all[index * (all.len() - 1) / (n - 1)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_read_as_they_are_written() {
        for text in ["even:6", "leaves:24", "3,7,12"] {
            assert_eq!(text.parse::<Moments>().map(|moments| moments.to_string()), Ok(text.into()));
        }
        for bad in ["even", "even:0", "leaves:25", "some:3", "", "1,x"] {
            assert!(bad.parse::<Moments>().is_err(), "{bad}");
        }
        assert_eq!(Moments::At(vec![3, 9]).missing(9), None);
        assert_eq!(Moments::At(vec![3, 9]).missing(8), Some(9));
    }

    #[test]
    fn an_even_choice_has_the_first_and_the_last() {
        let all: Vec<usize> = (1..=100).collect();
        assert_eq!(evenly(4, &all), [1, 34, 67, 100]);
        assert_eq!(evenly(6, &[3, 5]), [3, 5]);
        assert_eq!(evenly(1, &all), [1]);
        assert_eq!(evenly(3, &[]), [0; 0]);
    }
}
