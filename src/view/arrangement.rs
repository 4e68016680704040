//! How the user has arranged the panels of a preset.

use super::PanelKind;
use serde::{Deserialize, Serialize};

/// What the user has changed about the panels of one preset. What is not said
/// here is as the preset and the query have it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Arrangement {
    /// Panels in the order they were moved to; others follow the preset's order.
    order: Vec<PanelKind>,
    /// Panels that are shown whatever the preset says.
    added: Vec<PanelKind>,
    /// Panels that are not shown whatever the preset says.
    closed: Vec<PanelKind>,
    /// Panels of which only the heading is shown.
    folded: Vec<PanelKind>,
    /// Panels of which all is shown, whatever the preset says.
    unfolded: Vec<PanelKind>,
    /// How often it was restored. Another number is another side of the window
    /// for the toolkit, which then has its first width again.
    n_restored: u32,
}

/// Something that can be done to a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PanelChange {
    /// Leave only its heading.
    Fold,
    /// Show all of it again.
    Unfold,
    /// Exchange it with the panel before it.
    MoveUp,
    /// Exchange it with the panel after it.
    MoveDown,
    /// Show it no more.
    Close,
}

impl Arrangement {
    /// The panels to be shown where the preset shows `automatic`.
    pub fn shown(&self, automatic: &[PanelKind]) -> Vec<PanelKind> {
        let is_shown = |kind: &PanelKind| {
            !self.closed.contains(kind) && (automatic.contains(kind) || self.added.contains(kind))
        };
        let mut shown: Vec<_> = self.order.iter().copied().filter(is_shown).collect();
        for (n, kind) in automatic.iter().enumerate().filter(|(_, kind)| is_shown(kind)) {
            if !shown.contains(kind) {
                // After the one that it follows in the preset.
                let place = |before: &PanelKind| shown.iter().position(|other| other == before);
                let before = automatic[..n].iter().rev().find_map(place);
                shown.insert(before.map_or(0, |index| index + 1), *kind);
            }
        }
        for kind in self.added.iter().filter(|kind| is_shown(kind)) {
            if !shown.contains(kind) {
                shown.push(*kind);
            }
        }
        shown
    }

    /// Whether only the heading of a panel is shown where the preset has those of
    /// `automatic` folded.
    pub fn is_folded(&self, kind: PanelKind, automatic: &[PanelKind]) -> bool {
        let is_automatic = automatic.contains(&kind) && !self.unfolded.contains(&kind);
        is_automatic || self.folded.contains(&kind)
    }

    /// Whether a panel is shown whatever the preset says.
    pub fn is_added(&self, kind: PanelKind) -> bool {
        self.added.contains(&kind)
    }

    /// Shows all of a panel.
    pub fn unfold(&mut self, kind: PanelKind) {
        self.folded.retain(|&other| other != kind);
        if !self.unfolded.contains(&kind) {
            self.unfolded.push(kind);
        }
    }

    /// Changes a panel of those that are `shown`.
    pub fn change(&mut self, kind: PanelKind, change: PanelChange, shown: &[PanelKind]) {
        match change {
            PanelChange::Fold => {
                self.unfolded.retain(|&other| other != kind);
                self.folded.push(kind);
            }
            PanelChange::Unfold => self.unfold(kind),
            PanelChange::MoveUp => self.exchange(shown, kind, |index| index.checked_sub(1)),
            PanelChange::MoveDown => self.exchange(shown, kind, |index| Some(index + 1)),
            PanelChange::Close => {
                self.added.retain(|&other| other != kind);
                self.closed.push(kind);
            }
        }
    }

    /// Shows a panel, whatever the preset says; the last one if it is new.
    pub fn add(&mut self, kind: PanelKind) {
        self.closed.retain(|&other| other != kind);
        self.unfold(kind);
        if !self.added.contains(&kind) {
            self.added.push(kind);
        }
    }

    /// Forgets all changes.
    pub fn restore(&mut self) {
        *self = Self { n_restored: self.n_restored.wrapping_add(1), ..Self::default() };
    }

    /// A number that changes when the side is to have its first width again.
    pub fn width_key(&self) -> u32 {
        self.n_restored
    }

    fn exchange(
        &mut self,
        shown: &[PanelKind],
        kind: PanelKind,
        other: impl FnOnce(usize) -> Option<usize>,
    ) {
        let Some(index) = shown.iter().position(|&other| other == kind) else { return };
        let Some(other) = other(index).filter(|&other| other < shown.len()) else { return };
        let mut order = shown.to_vec();
        order.swap(index, other);
        self.order.retain(|kind| !order.contains(kind));
        order.append(&mut self.order);
        self.order = order;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use PanelKind::{Automaton, Codes, Counters, Neighbour, Rail, Region};

    const PRESET: [PanelKind; 3] = [Rail, Automaton, Counters];

    fn changed(changes: &[(PanelKind, PanelChange)]) -> Arrangement {
        let mut arrangement = Arrangement::default();
        for &(kind, change) in changes {
            let shown = arrangement.shown(&PRESET);
            arrangement.change(kind, change, &shown);
        }
        arrangement
    }

    #[test]
    fn without_changes_the_preset_is_shown() {
        assert_eq!(Arrangement::default().shown(&PRESET), PRESET);
    }

    #[test]
    fn panels_move_but_not_beyond_both_ends() {
        let up = changed(&[(Counters, PanelChange::MoveUp), (Counters, PanelChange::MoveUp)]);
        assert_eq!(up.shown(&PRESET), [Counters, Rail, Automaton]);
        let ends = changed(&[(Rail, PanelChange::MoveUp), (Counters, PanelChange::MoveDown)]);
        assert_eq!(ends.shown(&PRESET), PRESET);
    }

    #[test]
    fn a_closed_panel_stays_closed_until_it_is_added() {
        let mut arrangement = changed(&[(Automaton, PanelChange::Close)]);
        assert_eq!(arrangement.shown(&PRESET), [Rail, Counters]);
        arrangement.add(Automaton);
        assert_eq!(arrangement.shown(&PRESET), PRESET);
    }

    #[test]
    fn an_added_panel_is_shown_for_every_query_until_it_is_closed() {
        let mut arrangement = Arrangement::default();
        arrangement.add(Codes);
        assert_eq!(arrangement.shown(&PRESET), [Rail, Automaton, Counters, Codes]);
        assert_eq!(arrangement.shown(&[Region]), [Region, Codes]);
        arrangement.change(Codes, PanelChange::Close, &[Region, Codes]);
        assert_eq!(arrangement.shown(&PRESET), PRESET);
    }

    #[test]
    fn another_querys_panel_comes_where_the_preset_has_it() {
        let moved = changed(&[(Counters, PanelChange::MoveUp)]);
        let automatic = [Rail, Neighbour, Automaton, Counters];
        assert_eq!(moved.shown(&automatic), [Rail, Neighbour, Counters, Automaton]);
    }

    #[test]
    fn a_panel_that_the_preset_folds_is_unfolded_and_folded_again() {
        let is_folded = |changes: &[PanelChange]| {
            let all: Vec<_> = changes.iter().map(|&change| (Automaton, change)).collect();
            changed(&all).is_folded(Automaton, &[Automaton])
        };
        let (fold, unfold) = (PanelChange::Fold, PanelChange::Unfold);
        let folded = [is_folded(&[]), is_folded(&[unfold]), is_folded(&[unfold, fold])];
        assert_eq!(folded, [true, false, true]);
    }

    #[test]
    fn restoring_forgets_everything_but_that_it_was_restored() {
        let mut arrangement = changed(&[(Rail, PanelChange::Fold), (Counters, PanelChange::Close)]);
        arrangement.add(Codes);
        let key = arrangement.width_key();
        arrangement.restore();
        assert_eq!(arrangement.shown(&PRESET), PRESET);
        assert!(!arrangement.is_folded(Rail, &[]));
        assert_ne!(arrangement.width_key(), key);
    }
}
