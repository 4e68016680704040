//! The question of now against the scenario as it was opened.

use super::{Document, Question};
use octoscope_core::scenario::Scenario;
use std::sync::Arc;

impl<const D: usize> Document<D> {
    /// The scenario as it was opened: with its source, but an earlier question.
    pub fn opened(&self) -> &Scenario<D> {
        &self.opened
    }

    /// The scenario as it is now.
    pub fn whole_scenario(&self) -> Scenario<D> {
        let Question { domain, recipe, ray, query } = self.scenario;
        Scenario { domain, recipe, ray, query, ..(*self.opened).clone() }
    }

    /// Takes `opened`, an earlier question of the same source, for the scenario as
    /// it was opened; the playhead begins where that of this document does.
    pub(super) fn opened_as(&mut self, opened: Scenario<D>) {
        self.opened = Arc::new(Scenario { step: self.opened.step, ..opened });
    }

    /// Asks what was asked when the scenario was opened.
    pub(super) fn ask_as_opened(&mut self) {
        let Scenario { domain, recipe, ray, query, .. } = *self.opened;
        self.scenario = Question { domain, recipe, ray, query };
    }

    /// Asks for the query of `other`, along its ray, in the present tree.
    pub(super) fn ask_as(&mut self, other: &Self) {
        (self.scenario.ray, self.scenario.query) = (other.scenario.ray, other.scenario.query);
    }

    /// Whether both are states of one opened scenario.
    pub(super) fn is_of_same_opened(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.opened, &other.opened)
    }

    /// Takes the file of `other` over, if both are states of one opened scenario:
    /// where it is saved to is undone by nothing.
    pub(super) fn keep_file(&mut self, other: &Self) {
        if self.is_of_same_opened(other) {
            self.path.clone_from(&other.path);
        }
    }

    /// The question that no longer counts as changed: that of `saved`, if it is of the
    /// same opened scenario, else the opened one.
    pub(super) fn unchanged(&self, saved: &Self) -> Scenario<D> {
        if self.is_of_same_opened(saved) { saved.whole_scenario() } else { (*self.opened).clone() }
    }

    /// Whether both ask the same question of the same source.
    pub(super) fn is_same_state(&self, other: &Self) -> bool {
        self.scenario == other.scenario
            && (self.is_of_same_opened(other) || self.opened == other.opened)
    }

    /// Whether the question is another one than in `saved`, if that is of the same
    /// opened scenario; else, than it was when it was opened.
    pub fn differs_from(&self, saved: &Self) -> bool {
        if self.is_of_same_opened(saved) {
            return self.scenario != saved.scenario;
        }
        self.differs_from_opened()
    }

    /// Whether the question is another one than when the scenario was opened.
    pub fn differs_from_opened(&self) -> bool {
        let Scenario { domain, recipe, ray, query, .. } = *self.opened;
        self.scenario != Question { domain, recipe, ray, query }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Progress;
    use octoscope_core::scenario::{AnyScenario, BUILT_IN, built_in};

    #[test]
    fn the_whole_scenario_is_the_opened_one_with_the_question_of_now() {
        let Some(AnyScenario::Quadtree(opened)) = built_in(BUILT_IN[0].id) else { panic!() };
        let content = Arc::new(opened.source.content().unwrap());
        let mut document = Document::new(opened.clone(), content, &Progress::default()).unwrap();
        assert_eq!(document.whole_scenario(), opened);
        document.scenario.recipe.depth = 3;
        let document = document.rebuilt(&Progress::default()).unwrap();
        assert_eq!(document.whole_scenario().recipe.depth, 3);
        assert_eq!(document.whole_scenario().source, opened.source);
        assert_eq!(document.tree.domain().root_level(), 3);
    }
}
