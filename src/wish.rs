//! What a panel wishes the window to do, beside what it changes itself.

use octoscope_core::traverse::Variant;

/// What a panel wishes the window to do, beside what it changes itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Open the built-in scene of this identifier.
    Scene(&'static str),
    /// Open the counterexample of a misprint.
    Counterexample(Variant),
    /// Look for another question on which the rules go wrong.
    OtherQuestion,
    /// Move the playhead.
    Step(usize),
}
