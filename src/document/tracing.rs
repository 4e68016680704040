//! Runs the query of now, and keeps the step and the way back to the ray meanwhile.

use super::Document;
use crate::traced::{MOST_EVENTS, Traced};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use std::mem::discriminant;
use std::sync::Arc;

impl<const D: usize> Document<D> {
    /// Whether the trace is not yet that of the ray and the query.
    pub fn needs_tracing(&self) -> bool {
        self.traced != (self.scenario.ray, self.scenario.query)
    }

    /// The ray of the trace.
    pub fn traced_ray(&self) -> &Ray<D> {
        &self.traced.0
    }

    /// Runs the query again if it or the ray has changed and this is quick. Returns
    /// where the playhead, now at `step`, belongs.
    pub fn refresh(&mut self, step: usize) -> usize {
        let (ray, query) = (self.scenario.ray, self.scenario.query);
        if !self.needs_tracing() {
            return step;
        }
        match Traced::quickly(&self.tree, ray, query) {
            Some(traced) => self.take(traced, step),
            None => step,
        }
    }

    /// Runs the query of now as far as the window keeps it, however long it takes.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] when `progress` is cancelled.
    pub fn trace_anew(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        let (ray, query) = (self.scenario.ray, self.scenario.query);
        let traced = Traced::within(MOST_EVENTS, &self.tree, ray, query, progress)?;
        self.take(traced, 0);
        Ok(())
    }

    /// Runs the query of now and keeps the whole trace, however long it is.
    pub fn trace_whole(&mut self) {
        self.trace_whole_within(&Progress::default()).expect("nobody cancels it");
    }

    /// The same, until `progress` is cancelled.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] then; the document stays as it was.
    pub fn trace_whole_within(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        let (ray, query) = (self.scenario.ray, self.scenario.query);
        if self.needs_tracing() || self.trace.is_cut() {
            let whole = Traced::within(usize::MAX, &self.tree, ray, query, progress)?;
            self.take(whole, 0);
        }
        Ok(())
    }

    /// Takes over the trace of `other`, made meanwhile from an earlier state of this
    /// document; not if that had another tree. Returns where the playhead, now at
    /// `step`, belongs.
    pub fn take_trace(&mut self, other: &Self, step: usize) -> usize {
        if !Arc::ptr_eq(&self.tree, &other.tree) {
            return step;
        }
        self.take(other.as_traced(), step)
    }

    pub(super) fn as_traced(&self) -> Traced<D> {
        let (ray, query) = self.traced;
        let (trace, rounded) = (Arc::clone(&self.trace), Arc::clone(&self.rounded));
        Traced { ray, query, trace, total: self.total.clone(), rounded }
    }

    /// Takes a trace in the present tree. Returns where the playhead, now at `step`,
    /// belongs: at the end it stays at the end; a point, region or neighbour that is first
    /// asked about in the picture shows its answer at once, and one that is asked about by
    /// [`Self::ask`] its first step; a ray that is gone back to, the step where it was left.
    pub(super) fn take(&mut self, traced: Traced<D>, step: usize) -> usize {
        let Traced { ray, query, trace, total, rounded } = traced;
        if is_of_ray(&self.traced.1) && !is_of_ray(&query) {
            self.left_ray = Some((self.traced.1, step));
        }
        let was_at_end = step > 0 && step >= self.trace.events.len();
        let is_new = discriminant(&self.traced.1) != discriminant(&query) && !is_of_ray(&query);
        self.trace = trace;
        self.total = total;
        self.rounded = rounded;
        self.comparison.outdate();
        self.verdict.outdate();
        self.traced = (ray, query);
        match self.resumed.take().filter(|(resumed, _)| *resumed == query) {
            Some((_, left_at)) => left_at,
            None if was_at_end || is_new => self.trace.events.len(),
            None => step,
        }
    }

    /// Asks for another query, which begins at its first step.
    pub fn ask(&mut self, query: Query<D>) {
        self.scenario.query = query;
        self.resumed = Some((query, 0));
    }

    /// Goes back from another query to the one along the ray that was left for it,
    /// and to the step of it.
    pub fn back_to_ray(&mut self) {
        let (query, step) = self.left_ray.take().unwrap_or_default();
        self.scenario.query = query;
        self.resumed = Some((query, step));
    }

    /// Goes back to the ray and the query of the trace there is, because the one
    /// that is wanted was given up.
    pub fn keep_trace(&mut self) {
        (self.scenario.ray, self.scenario.query) = self.traced;
        // A way back that was not gone is found once more.
        let of_ray = self.resumed.take().filter(|(query, _)| is_of_ray(query));
        self.left_ray = of_ray.or(self.left_ray);
    }
}

fn is_of_ray<const D: usize>(query: &Query<D>) -> bool {
    matches!(query, Query::Ray { .. })
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::traverse::Algorithm;

    #[test]
    fn a_long_trace_is_cut_off_and_is_whole_where_it_is_asked_for() {
        let Some(AnyScenario::Quadtree(mut scenario)) = built_in("quadtree-82") else { panic!() };
        scenario.recipe.depth = 16;
        if let Query::Ray { algorithm, .. } = &mut scenario.query {
            *algorithm = Algorithm::Dda;
        }
        let content = Arc::new(scenario.source.content().unwrap());
        let mut document = Document::new(scenario, content, &Progress::default()).unwrap();
        assert!(document.trace.is_cut());
        document.trace_whole();
        assert!(!document.trace.is_cut() && document.trace.events.len() > MOST_EVENTS);
    }

    #[test]
    fn a_whole_trace_can_be_given_up() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let content = Arc::new(scenario.source.content().unwrap());
        let mut document = Document::new(scenario, content, &Progress::default()).unwrap();
        document.reverse_ray();
        let progress = Progress::default();
        progress.cancel();
        assert_eq!(document.trace_whole_within(&progress), Err(Cancelled));
        assert!(document.needs_tracing());
    }
}
