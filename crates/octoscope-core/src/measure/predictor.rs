//! How processors predict which way a branch goes.

/// A counter of two bits: 0 and 1 predict that a branch is not taken, 2 and 3 that it
/// is. It takes two surprises to change its mind [Smith 1981].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TwoBit(u8);

impl Default for TwoBit {
    /// Weakly not taken.
    fn default() -> Self {
        Self(1)
    }
}

impl TwoBit {
    /// What it predicts.
    pub fn predicts(self) -> bool {
        self.0 >= 2
    }

    /// Learns which way the branch went; whether that was predicted.
    pub fn meets(&mut self, taken: bool) -> bool {
        let predicted = self.predicts();
        self.0 = if taken { (self.0 + 1).min(3) } else { self.0.saturating_sub(1) };
        predicted == taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(branches: &[bool], right: &[bool]) {
        let mut counter = TwoBit::default();
        let found: Vec<bool> = branches.iter().map(|&taken| counter.meets(taken)).collect();
        assert_eq!(found, right, "{branches:?}");
    }

    #[test]
    fn one_surprise_does_not_change_its_mind() {
        let (t, f) = (true, false);
        // Weakly not taken, weakly taken, strongly; the loop's end is missed, not its
        // next beginning.
        check(&[t, t, t, f, t, t], &[f, t, t, f, t, t]);
        check(&[f, f, t, f, f], &[t, t, f, t, t]);
        // Alternating is predicted wrongly for ever from here.
        check(&[t, f, t, f], &[f, f, f, f]);
    }
}
