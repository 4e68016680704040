//! One line that says what has just happened, and goes away by itself.

/// The line, and until when it is shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Notice {
    text: String,
    /// When it was first seen, in seconds since the program was started.
    since: Option<f64>,
    /// The step at which it was first seen in the place of the sentence.
    step: Option<usize>,
    /// Number of lines so far, this one included.
    number: u64,
}

impl Notice {
    /// Time to find a line, in seconds, and to read one of its characters slowly.
    const SECS: f64 = 4.0;
    const SECS_PER_CHARACTER: f64 = 0.08;
    /// Time in which it fades at the end.
    const FADING: f64 = 0.5;

    /// Says something instead of what was said before.
    pub fn say(&mut self, text: impl Into<String>) {
        *self = Self { text: text.into(), number: self.number + 1, ..Self::default() };
    }

    /// Takes it away.
    pub fn clear(&mut self) {
        self.text.clear();
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// What is said.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Makes it one of this step, unless it has been seen at another.
    pub fn seen_at(&mut self, step: usize) {
        self.step.get_or_insert(step);
    }

    /// Whether it is said of this step.
    pub fn is_of(&self, step: usize) -> bool {
        !self.is_empty() && self.step == Some(step)
    }

    /// Tells one line from another of the same words.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// How strongly it is shown at `now`, from 0 to 1, and for how many seconds
    /// that holds; it takes itself away when its time is over.
    pub fn strength(&mut self, now: f64) -> (f32, f64) {
        let since = *self.since.get_or_insert(now);
        let length = Self::SECS + Self::SECS_PER_CHARACTER * self.text.chars().count() as f64;
        let left = since + length - now;
        if left <= 0.0 {
            self.clear();
        }
        let strength = (left / Self::FADING).clamp(0.0, 1.0) as f32;
        let frame = 1.0 / 30.0;
        (strength, if strength < 1.0 { frame } else { (left - Self::FADING).max(frame) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_longer_line_stays_longer_and_fades_at_its_end() {
        let lasts = |text: &str| {
            let mut notice = Notice::default();
            notice.say(text);
            let mut now = 100.0;
            assert_eq!(notice.strength(now).0, 1.0);
            while !notice.is_empty() {
                now += notice.strength(now).1;
            }
            now - 100.0
        };
        let (short, long) = (lasts("Saved"), lasts(&"word ".repeat(30)));
        assert!((4.0..6.0).contains(&short), "{short}");
        assert!((14.0..20.0).contains(&long), "{long}");
    }

    #[test]
    fn a_line_belongs_to_the_step_at_which_it_was_said() {
        let mut notice = Notice::default();
        assert!(!notice.is_of(3));
        notice.say("Saved");
        let mut is_of = |step| {
            notice.seen_at(step);
            notice.is_of(step)
        };
        assert_eq!([3, 4, 3].map(&mut is_of), [true, false, true]);
        notice.say("Saved");
        notice.seen_at(4);
        assert!(notice.is_of(4));
    }

    #[test]
    fn the_same_words_said_again_are_another_line() {
        let mut notice = Notice::default();
        notice.say("Saved");
        let first = notice.number();
        notice.strength(0.0);
        notice.say("Saved");
        assert_ne!(notice.number(), first);
        assert_eq!(notice.strength(1000.0).0, 1.0);
    }
}
