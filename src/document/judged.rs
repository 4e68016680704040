//! What is found out about a run once it is asked for: all algorithms on its ray, and
//! whether it comes to the right result.

use super::Document;
use crate::comparison::{MOST_TESTED, Run, compare};
use octoscope_core::paper::{Verdict, verdict};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::tree::NodeId;
use std::sync::Arc;

/// Trees of no more leaves than this are searched leaf by leaf in a small part of a
/// frame.
const QUICK_LEAVES: usize = 2000;

/// Runs of no more events than this are compared event by event in a small part of a
/// frame.
const QUICK_EVENTS: usize = 4000;

/// Something about a run that is made when it is asked for.
#[derive(Clone, Debug)]
pub(super) struct Finding<T> {
    /// That of the present run, or of an earlier one as long as it is not there.
    last: Option<Arc<T>>,
    state: State,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    #[default]
    Unknown,
    /// Asked for, but it takes longer than a frame may.
    Wanted,
    /// Of the present run.
    Known,
    /// It was tried without a result.
    Failed,
}

/// What is known about something that was asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Found<T> {
    /// This, about the present run.
    Known(Arc<T>),
    /// It is being made; this is what was found about an earlier run, if anything was.
    Coming(Option<Arc<T>>),
    /// It cannot be known.
    Never,
}

impl<T> Default for Finding<T> {
    fn default() -> Self {
        Self { last: None, state: State::Unknown }
    }
}

impl<T> Finding<T> {
    /// There is another run.
    pub(super) fn outdate(&mut self) {
        self.state = State::Unknown;
    }

    /// Asks for it.
    fn ask(&mut self) {
        if self.state == State::Unknown {
            self.state = State::Wanted;
        }
    }

    fn known(&self) -> Option<&Arc<T>> {
        self.last.as_ref().filter(|_| self.state == State::Known)
    }

    fn found(&self) -> Found<T> {
        match (self.state, &self.last) {
            (State::Known, Some(value)) => Found::Known(Arc::clone(value)),
            (State::Unknown | State::Wanted, last) => Found::Coming(last.clone()),
            (State::Known, None) | (State::Failed, _) => Found::Never,
        }
    }

    fn know(&mut self, value: T) {
        *self = Self { last: Some(Arc::new(value)), state: State::Known };
    }

    /// Takes what `other` has found, about the same run or about an earlier one.
    fn take(&mut self, other: &Self, same_run: bool) {
        let Some(value) = other.known() else { return };
        if same_run {
            (self.last, self.state) = (Some(Arc::clone(value)), State::Known);
        } else if self.state != State::Known {
            self.last = Some(Arc::clone(value));
        }
    }
}

impl<const D: usize> Document<D> {
    /// All algorithms on the ray. Computed once for every ray and tree: at once where
    /// that is quick, else by [`Document::judge`].
    pub fn comparison(&mut self) -> Found<Vec<Run>> {
        self.comparison.ask();
        self.judge_quickly();
        self.comparison.found()
    }

    /// Whether the run comes to the right result, computed as the comparison is; never
    /// where the tree is too large to ask every leaf, or the run was too long to be
    /// traced to its end.
    pub fn verdict(&mut self) -> Found<Verdict> {
        if self.is_judged_never() {
            return Found::Never;
        }
        self.verdict.ask();
        self.judge_quickly();
        self.verdict.found()
    }

    /// The step at which a misprinted rule leads astray first, if one is followed, it
    /// does, and that is known by now.
    pub fn first_wrong_step(&mut self) -> Option<usize> {
        if !self.trace.query.is_misprinted() {
            return None;
        }
        match self.verdict() {
            Found::Known(verdict) => verdict.first_wrong_step,
            Found::Coming(_) | Found::Never => None,
        }
    }

    /// What is known of the verdict on the present run by now.
    pub fn verdict_so_far(&self) -> Found<Verdict> {
        if self.is_judged_never() { Found::Never } else { self.verdict.found() }
    }

    /// Whether the tree is too large to ask every leaf, or the run was too long to be
    /// traced to its end.
    fn is_judged_never(&self) -> bool {
        self.tree.n_leaves() > MOST_TESTED || self.trace.is_cut()
    }

    /// The verdict on the present run, if it was asked for and is known.
    pub fn known_verdict(&self) -> Option<&Verdict> {
        self.verdict.known().map(Arc::as_ref)
    }

    /// What would be right, where a misprint is followed and the verdict is known.
    pub fn right_nodes(&self) -> &[NodeId] {
        match self.known_verdict() {
            Some(verdict) if self.trace.query.is_misprinted() => &verdict.expected,
            Some(_) | None => &[],
        }
    }

    /// What is reported and not right, where a misprint is followed and the verdict is
    /// known, in the order of the numbers.
    pub fn strayed_nodes(&self) -> &[NodeId] {
        match self.known_verdict() {
            Some(verdict) if self.trace.query.is_misprinted() => &verdict.strayed,
            Some(_) | None => &[],
        }
    }

    /// Finds out, however long it takes, what is wrong and what would be right, where a
    /// misprint is followed: figures do not depend on what is known by chance.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] when `progress` is cancelled.
    pub fn find_right_nodes(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        progress.check()?;
        let is_wanted = self.trace.query.is_misprinted() && self.known_verdict().is_none();
        if is_wanted && !self.is_judged_never() {
            self.verdict.know(verdict(&self.tree, &self.traced.0, &self.trace));
        }
        progress.check()
    }

    /// Whether a misprint is followed, but it cannot be known what is right.
    pub fn is_unjudged(&self) -> bool {
        self.trace.query.is_misprinted() && self.is_judged_never()
    }

    fn is_quick(&self) -> bool {
        self.tree.n_leaves() <= QUICK_LEAVES && self.trace.events.len() <= QUICK_EVENTS
    }

    /// Whether something was asked for that takes longer than a frame may.
    pub fn wants_judging(&self) -> bool {
        self.comparison.state == State::Wanted || self.verdict.state == State::Wanted
    }

    /// Finds out what was asked for, however long it takes.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] when `progress` is cancelled.
    pub fn judge(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        let (tree, ray, trace) = (&self.tree, &self.traced.0, &self.trace);
        if self.comparison.state == State::Wanted {
            self.comparison.know(compare(tree, ray, &self.traced.1, progress)?);
        }
        if self.verdict.state == State::Wanted {
            self.verdict.know(verdict(tree, ray, trace));
        }
        Ok(())
    }

    /// Takes what was found out about `other`, an earlier state of this document. About
    /// another run it is shown until that of the present one is there.
    pub fn take_judged(&mut self, other: &Self) {
        if Arc::ptr_eq(&self.tree, &other.tree) {
            let same_run = Arc::ptr_eq(&self.trace, &other.trace);
            self.comparison.take(&other.comparison, same_run);
            self.verdict.take(&other.verdict, same_run);
        }
    }

    /// Does without what was asked for.
    pub fn give_up_judging(&mut self) {
        for state in [&mut self.comparison.state, &mut self.verdict.state] {
            if *state == State::Wanted {
                *state = State::Failed;
            }
        }
    }

    fn judge_quickly(&mut self) {
        if self.is_quick() && self.wants_judging() {
            // Nobody cancels it.
            let _ = self.judge(&Progress::default());
        }
    }
}
