//! A document of either dimension.

use super::Document;
use crate::history::{Shared, Weighed};
use octoscope_core::scenario::{AnyScenario, StepAt};

/// Document of either dimension.
#[derive(Clone, Debug)]
pub enum AnyDocument {
    /// A quadtree.
    Plane(Box<Document<2>>),
    /// An octree.
    Space(Box<Document<3>>),
}

/// Runs the same code on the document of either dimension.
#[macro_export]
macro_rules! with_document {
    ($any:expr, $document:ident => $body:expr) => {
        match $any {
            $crate::document::AnyDocument::Plane($document) => $body,
            $crate::document::AnyDocument::Space($document) => $body,
        }
    };
}

impl AnyDocument {
    /// The scenario, for saving.
    pub fn scenario(&self) -> AnyScenario {
        match self {
            Self::Plane(document) => AnyScenario::Quadtree(document.whole_scenario()),
            Self::Space(document) => AnyScenario::Octree(document.whole_scenario()),
        }
    }

    /// The scenario with the playhead after `step` events.
    pub fn scenario_at(&self, step: usize) -> AnyScenario {
        let mut scenario = self.scenario();
        match &mut scenario {
            AnyScenario::Quadtree(scenario) => scenario.step = StepAt::At(step),
            AnyScenario::Octree(scenario) => scenario.step = StepAt::At(step),
        }
        scenario
    }

    /// Takes `opened` for the scenario as it was opened, see [`Document`]; not if it
    /// is of the other dimension.
    pub fn opened_as(&mut self, opened: AnyScenario) {
        match (self, opened) {
            (Self::Plane(now), AnyScenario::Quadtree(opened)) => now.opened_as(opened),
            (Self::Space(now), AnyScenario::Octree(opened)) => now.opened_as(opened),
            (Self::Plane(_), AnyScenario::Octree(_))
            | (Self::Space(_), AnyScenario::Quadtree(_)) => {}
        }
    }

    /// The document as it was opened; its tree and trace are still those of now.
    pub fn as_opened(&self) -> Self {
        let mut document = self.clone();
        with_document!(&mut document, document => document.ask_as_opened());
        document
    }

    /// Asks for the query of `other`, along its ray; not if that is of the other dimension.
    pub fn ask_as(&mut self, other: &Self) {
        match (self, other) {
            (Self::Plane(now), Self::Plane(other)) => now.ask_as(other),
            (Self::Space(now), Self::Space(other)) => now.ask_as(other),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => {}
        }
    }

    /// Takes the file of `other` over, if both are states of one opened scenario.
    pub fn keep_file(&mut self, other: &Self) {
        match (self, other) {
            (Self::Plane(now), Self::Plane(other)) => now.keep_file(other),
            (Self::Space(now), Self::Space(other)) => now.keep_file(other),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => {}
        }
    }

    /// Whether both are states of one opened scenario.
    pub fn is_of_same_opened(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Plane(a), Self::Plane(b)) => a.is_of_same_opened(b),
            (Self::Space(a), Self::Space(b)) => a.is_of_same_opened(b),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => false,
        }
    }

    /// The scenario without changes, where `saved` is what was saved last.
    pub fn unchanged(&self, saved: &Self) -> AnyScenario {
        match (self, saved) {
            (Self::Plane(now), Self::Plane(saved)) => AnyScenario::Quadtree(now.unchanged(saved)),
            (Self::Space(now), Self::Space(saved)) => AnyScenario::Octree(now.unchanged(saved)),
            (Self::Plane(now), Self::Space(_)) => AnyScenario::Quadtree(now.opened().clone()),
            (Self::Space(now), Self::Plane(_)) => AnyScenario::Octree(now.opened().clone()),
        }
    }

    /// Takes over the tree of `rebuilt` and the trace in it, see [`Document::adopt`].
    pub fn adopt(&mut self, rebuilt: &Self, step: usize) -> usize {
        match (self, rebuilt) {
            (Self::Plane(now), Self::Plane(rebuilt)) => now.adopt(rebuilt, step),
            (Self::Space(now), Self::Space(rebuilt)) => now.adopt(rebuilt, step),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => step,
        }
    }

    /// Takes over the trace of `other`, see [`Document::take_trace`].
    pub fn take_trace(&mut self, other: &Self, step: usize) -> usize {
        match (self, other) {
            (Self::Plane(now), Self::Plane(other)) => now.take_trace(other, step),
            (Self::Space(now), Self::Space(other)) => now.take_trace(other, step),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => step,
        }
    }

    /// Takes what was found out about `other`, see [`Document::take_judged`].
    pub fn take_judged(&mut self, other: &Self) {
        match (self, other) {
            (Self::Plane(now), Self::Plane(other)) => now.take_judged(other),
            (Self::Space(now), Self::Space(other)) => now.take_judged(other),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => {}
        }
    }

    /// Number of events in the trace.
    pub fn n_events(&self) -> usize {
        with_document!(self, document => document.trace.events.len())
    }

    /// Whether both show the same scenario of the same tree.
    pub fn is_same_state(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Plane(a), Self::Plane(b)) => a.is_same_state(b),
            (Self::Space(a), Self::Space(b)) => a.is_same_state(b),
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => false,
        }
    }

    /// Whether both lie in the same cube of the same dimension.
    pub fn is_same_place(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Plane(a), Self::Plane(b)) => a.scenario.domain == b.scenario.domain,
            (Self::Space(a), Self::Space(b)) => a.scenario.domain == b.scenario.domain,
            (Self::Plane(_), Self::Space(_)) | (Self::Space(_), Self::Plane(_)) => false,
        }
    }
}

impl Weighed for AnyDocument {
    fn shared(&self) -> Vec<Shared> {
        with_document!(self, document => document.shared())
    }
}
