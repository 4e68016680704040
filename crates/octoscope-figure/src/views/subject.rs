//! What a view shows.

use octoscope_core::event::Event;
use octoscope_core::explain::Notation;
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::text::{Language, Texts};
use octoscope_core::trace::{Moment, Trace};
use octoscope_core::tree::Tree;

/// A query at one of its moments, and the words for it.
#[derive(Clone, Copy)]
pub struct Subject<'a, const D: usize> {
    /// The tree.
    pub tree: &'a Tree<D>,
    /// The ray; queries of other kinds do not use it.
    pub ray: &'a Ray<D>,
    /// Record of the query.
    pub trace: &'a Trace<D>,
    /// State after some of its events.
    pub moment: &'a Moment<D>,
    /// Texts, those of [`figure_texts`](super::figure_texts) among them.
    pub texts: &'a Texts,
    /// How formulas are written.
    pub notation: Notation,
}

impl<'a, const D: usize> Subject<'a, D> {
    /// What is asked.
    pub fn query(&self) -> &'a Query<D> {
        &self.trace.query
    }

    /// The events that have happened.
    pub fn past(&self) -> &'a [Event<D>] {
        &self.trace.events[..self.moment.step.min(self.trace.events.len())]
    }

    /// The last event that has happened.
    pub fn event(&self) -> Option<&'a Event<D>> {
        self.past().last()
    }

    /// Language of all words.
    pub fn language(&self) -> Language {
        self.texts.language()
    }
}
