//! Which steps are exported.

use octoscope_core::scenario::StepAt;
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;
use thiserror::Error;

/// Most steps in one export.
pub const MOST_STEPS: usize = 5000;

/// The steps of a trace that are exported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// One.
    One(StepAt),
    /// From one to another.
    Range(StepAt, StepAt),
    /// All, from before the first event to after the last.
    All,
}

/// Why steps cannot be exported.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum StepsError {
    /// The trace ends before.
    #[error("there is no step {step}; give one from 0 to {last}, first or last")]
    Missing {
        /// Number of the step.
        step: usize,
        /// Number of the last one that there is.
        last: usize,
    },
    /// The first is behind the last.
    #[error("the steps {first}-{last} run backwards; give the smaller one first")]
    Backwards {
        /// Number of the first.
        first: usize,
        /// Number of the last.
        last: usize,
    },
    /// More than a file holds.
    #[error(
        "these are {n} steps, and a file holds at most {MOST_STEPS}; give some of them, such as \
         {first}-{}",
        first + MOST_STEPS - 1
    )]
    TooMany {
        /// Number of the first.
        first: usize,
        /// How many there are.
        n: usize,
    },
}

impl Steps {
    /// The numbers of the steps in a trace of `n_events`.
    ///
    /// # Errors
    /// Refuses steps that the trace does not have, and too many.
    pub fn numbers(self, n_events: usize) -> Result<RangeInclusive<usize>, StepsError> {
        let (first, last) = match self {
            Self::One(step) => (step, step),
            Self::Range(first, last) => (first, last),
            Self::All => (StepAt::First, StepAt::Last),
        };
        for step in [first, last] {
            if let StepAt::At(step) = step
                && step > n_events
            {
                return Err(StepsError::Missing { step, last: n_events });
            }
        }
        let [first, last] = [first, last].map(|step| step.position(n_events));
        if first > last {
            return Err(StepsError::Backwards { first, last });
        }
        let n = last - first + 1;
        if n > MOST_STEPS {
            return Err(StepsError::TooMany { first, n });
        }
        Ok(first..=last)
    }
}

impl FromStr for Steps {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let step = |text: &str| match text.trim() {
            "first" => Some(StepAt::First),
            "last" => Some(StepAt::Last),
            number => number.parse().ok().map(StepAt::At),
        };
        let steps = match text.split_once('-') {
            _ if text == "all" => Some(Self::All),
            None => step(text).map(Self::One),
            Some((first, last)) => {
                step(first).and_then(|first| Some(Self::Range(first, step(last)?)))
            }
        };
        steps.ok_or_else(|| {
            format!(
                "‘{text}’ is no step; give a number from 0, first, last, a range such as 3-12, \
                 or all"
            )
        })
    }
}

impl fmt::Display for Steps {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let word = |step: &StepAt| match step {
            StepAt::First => "first".to_owned(),
            StepAt::Last => "last".to_owned(),
            StepAt::At(step) => step.to_string(),
        };
        match self {
            Self::All => f.write_str("all"),
            Self::One(step) => f.write_str(&word(step)),
            Self::Range(first, last) => write!(f, "{}-{}", word(first), word(last)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: RangeInclusive<usize>) {
        let steps: Steps = text.parse().unwrap();
        assert_eq!(steps.numbers(20).unwrap(), expected, "{text}");
        assert_eq!(steps.to_string(), text);
    }

    #[test]
    fn steps_are_numbers_words_and_ranges() {
        check("12", 12..=12);
        check("first", 0..=0);
        check("last", 20..=20);
        check("all", 0..=20);
        check("3-12", 3..=12);
        check("5-last", 5..=20);
        for bad in ["-1", "1.5", "", "3-", "a-b", "1-2-3"] {
            assert!(bad.parse::<Steps>().unwrap_err().contains("first, last"), "{bad}");
        }
    }

    #[test]
    fn steps_that_are_not_there_are_refused() {
        let message = |steps: Steps, n| steps.numbers(n).unwrap_err().to_string();
        let range = |a, b| Steps::Range(StepAt::At(a), StepAt::At(b));
        assert!(message(range(3, 21), 20).contains("no step 21; give one from 0 to 20"));
        assert!(message(range(5, 3), 20).contains("backwards"));
        assert!(message(Steps::All, 20_000).contains("0-4999"));
    }
}
