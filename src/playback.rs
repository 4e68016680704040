//! The playhead and how it moves by itself.

use serde::{Deserialize, Serialize};

/// Where the user is in a trace, and whether it plays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Playback {
    /// Number of events that have happened; at most the length of the trace.
    pub step: usize,
    /// Whether it advances by itself.
    #[serde(skip)]
    pub playing: bool,
    /// Steps per second while playing.
    pub speed: f64,
    /// Part of a step that has passed since the last one, in steps.
    #[serde(skip)]
    elapsed: f64,
    /// Whether the number of the step is to be typed, from the next frame on.
    #[serde(skip)]
    is_asked: bool,
}

impl Default for Playback {
    fn default() -> Self {
        Self { step: 0, playing: false, speed: 2.0, elapsed: 0.0, is_asked: false }
    }
}

impl Playback {
    /// Slowest and fastest speed, in steps per second.
    pub const SPEEDS: [f64; 2] = [0.25, 64.0];

    /// Moves to `step`, or to the end of a trace of `length` events.
    pub fn go_to(&mut self, step: usize, length: usize) {
        self.step = step.min(length);
        self.elapsed = 0.0;
    }

    /// Has the number of the step typed; it does not go on meanwhile.
    pub fn ask_for_number(&mut self) {
        (self.playing, self.is_asked) = (false, true);
    }

    /// Whether the number is to be typed from now on, which is told once.
    pub fn take_question(&mut self) -> bool {
        std::mem::take(&mut self.is_asked)
    }

    /// Starts playing, from the beginning if the trace is at its end; or stops.
    pub fn toggle(&mut self, length: usize) {
        self.playing = !self.playing;
        if self.playing && self.step >= length {
            self.go_to(0, length);
        }
    }

    /// Twice as fast, or half as fast, within the limits.
    pub fn change_speed(&mut self, factor: f64) {
        self.speed = (self.speed * factor).clamp(Self::SPEEDS[0], Self::SPEEDS[1]);
    }

    /// Lets `dt_secs` pass; stops at the end of a trace of `length` events.
    pub fn advance(&mut self, dt_secs: f64, length: usize) {
        self.step = self.step.min(length);
        if !self.playing {
            return;
        }
        self.elapsed += dt_secs * self.speed;
        let steps = self.elapsed.floor();
        self.elapsed -= steps;
        self.step = (self.step + steps as usize).min(length);
        self.playing = self.step < length;
    }

    /// Time until the next step while playing, in seconds.
    pub fn secs_to_next(&self) -> Option<f64> {
        self.playing.then(|| (1.0 - self.elapsed) / self.speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn playing_stops_at_the_end_and_starts_over_from_there() {
        let mut playback = Playback { speed: 10.0, ..Playback::default() };
        playback.toggle(5);
        playback.advance(0.25, 5);
        assert_eq!((playback.step, playback.playing), (2, true));
        playback.advance(9.0, 5);
        assert_eq!((playback.step, playback.playing), (5, false));
        playback.toggle(5);
        assert_eq!((playback.step, playback.playing), (0, true));
    }

    #[test]
    fn parts_of_a_step_add_up() {
        let mut playback = Playback { speed: 1.0, playing: true, ..Playback::default() };
        for _ in 0..8 {
            playback.advance(0.25, 9);
        }
        assert_eq!(playback.step, 2);
    }

    #[test]
    fn a_shorter_trace_takes_the_playhead_along() {
        let mut playback = Playback { step: 9, ..Playback::default() };
        playback.advance(0.0, 4);
        assert_eq!(playback.step, 4);
    }
}
