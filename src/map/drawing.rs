//! The map that is shown and the one that is being made, on other threads.

use super::asked::Asked;
use super::measure::rows;
use crate::job::{Job, Poll, Title};
use eframe::egui::Context;
use octoscope_core::progress::{Cancelled, Progress};
use std::any::Any;
use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, ScopedJoinHandle};

/// Rows that a thread takes at once.
const BLOCK: usize = 8;

/// A first map has so many times fewer columns and rows.
const COARSE: usize = 4;

/// A value for every cell of a grid, row after row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    /// Columns and rows.
    pub size: [usize; 2],
    /// The values.
    pub values: Vec<u32>,
}

/// The maps of quadtrees and octrees.
#[derive(Default)]
pub struct Maps {
    plane: Drawing<2>,
    space: Drawing<3>,
}

impl Maps {
    /// That of trees of dimension D.
    pub fn of<const D: usize>(&mut self) -> &mut Drawing<D> {
        let any: &mut dyn Any = if D == 2 { &mut self.plane } else { &mut self.space };
        any.downcast_mut().expect("trees have two or three dimensions")
    }

    /// Gives up what no panel has asked for since this was called last.
    pub fn give_up_unwanted(&mut self) {
        self.plane.give_up_unwanted();
        self.space.give_up_unwanted();
    }

    /// Waits until the maps that are asked for are there.
    pub fn finish_work(&mut self) {
        self.plane.conclude(true);
        self.space.conclude(true);
    }
}

/// A map, and the next one.
pub struct Drawing<const D: usize> {
    /// What is there, and what it shows.
    pub done: Option<(Asked<D>, Arc<Raster>)>,
    job: Option<(Asked<D>, Job<Result<Raster, Cancelled>>)>,
    /// What could not be made, and is not tried again.
    broken: Option<Asked<D>>,
    is_wanted: bool,
}

impl<const D: usize> Default for Drawing<D> {
    fn default() -> Self {
        Self { done: None, job: None, broken: None, is_wanted: false }
    }
}

impl<const D: usize> Drawing<D> {
    /// Sees to it that there will be a map of what is asked: a coarse one first, the
    /// whole one after it.
    pub fn want(&mut self, context: &Context, asked: &Asked<D>) {
        self.is_wanted = true;
        self.conclude(false);
        let shown = self.done.as_ref().map(|(done, _)| done);
        let is_shown = shown.is_some_and(|done| done.shows_the_same(asked));
        if is_shown && shown.is_some_and(|done| done.size == asked.size) {
            return;
        }
        let is_coming = self.job.as_ref().is_some_and(|(made, _)| made.shows_the_same(asked));
        if is_coming || self.is_broken(asked) {
            return;
        }
        let next = if is_shown { asked.clone() } else { asked.coarser(COARSE) };
        let made = next.clone();
        let work = move |progress: &Progress| raster(&made, progress);
        self.job = Some((next, Job::start(Title::Silent, context, work)));
    }

    /// Whether what is asked could not be made.
    pub fn is_broken(&self, asked: &Asked<D>) -> bool {
        self.broken.as_ref().is_some_and(|broken| broken.shows_the_same(asked))
    }

    /// Part of the present work that is done, 0 to 1, if there is work that takes long.
    pub fn progress(&self) -> Option<f64> {
        let (_, job) = self.job.as_ref()?;
        job.is_shown().then(|| job.progress.fraction().unwrap_or(0.0))
    }

    fn conclude(&mut self, waits: bool) {
        let Some((asked, job)) = &self.job else { return };
        match if waits { job.wait() } else { job.poll() } {
            Poll::Running => return,
            Poll::Done(Ok(raster)) => self.done = Some((asked.clone(), Arc::new(raster))),
            Poll::Done(Err(Cancelled)) => {}
            Poll::Broken => self.broken = Some(asked.clone()),
        }
        self.job = None;
    }

    fn give_up_unwanted(&mut self) {
        if !std::mem::take(&mut self.is_wanted) {
            self.job = None;
        }
    }
}

/// Makes a map with all threads but the one that the window needs.
fn raster<const D: usize>(asked: &Asked<D>, progress: &Progress) -> Result<Raster, Cancelled> {
    let [width, height] = asked.size;
    let n_blocks = height.div_ceil(BLOCK);
    progress.start(n_blocks as u64);
    let next = AtomicUsize::new(0);
    let values = Mutex::new(vec![0; width * height]);
    let work = || -> Result<(), Cancelled> {
        loop {
            let first = BLOCK * next.fetch_add(1, Ordering::Relaxed);
            if first >= height {
                return Ok(());
            }
            let range = first..(first + BLOCK).min(height);
            let found = rows(asked, range.clone(), progress)?;
            let mut values = values.lock().unwrap_or_else(PoisonError::into_inner);
            values[width * range.start..width * range.end].copy_from_slice(&found);
            drop(values);
            progress.advance(1)?;
        }
    };
    let n_threads = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    thread::scope(|scope| {
        let others: Vec<_> = (2..n_threads).map(|_| scope.spawn(work)).collect();
        let own = work();
        // What breaks a worker breaks the job.
        let join =
            |other: ScopedJoinHandle<_>| other.join().unwrap_or_else(|why| resume_unwind(why));
        let others = others.into_iter().map(join);
        others.fold(own, Result::and)
    })?;
    let values = values.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(Raster { size: asked.size, values })
}

#[cfg(test)]
mod tests {
    use super::super::asked::{Colouring, Rays};
    use super::super::measure::{NOTHING, RIGHT, WRONG};
    use super::*;
    use crate::counted::{Counted, counted};
    use octoscope_core::family::Family;
    use octoscope_core::geometry::Ray;
    use octoscope_core::query::{Arithmetic, Query};
    use octoscope_core::traverse::{Algorithm, Options, Variant, Variants};
    use octoscope_core::tree::{Domain, NodeId, Split, Tree, grow};

    fn asked(colouring: Colouring, algorithm: Algorithm, variants: Variants) -> Asked<2> {
        let tree: Tree<2> = grow(Domain::unit(3), (), &Progress::default(), |cell, ()| {
            let is_inner = cell.level > 0 && cell.code[0] == 0;
            if is_inner { Split::Inner(vec![(); 4]) } else { Split::Empty }
        })
        .unwrap();
        let options = Options { variants, ..Options::default() };
        Asked {
            tree: Arc::new(tree),
            rays: Rays::Family(Family::lines([0.0; 2], 1.0)),
            colouring,
            query: Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact },
            size: [37, 21],
        }
    }

    fn count(asked: &Asked<2>, ray: &Ray<2>) -> Counted {
        counted(&asked.tree, ray, &asked.query, &Progress::default()).unwrap()
    }

    fn leaves_of(asked: &Asked<2>, ray: &Ray<2>) -> Vec<NodeId> {
        count(asked, ray).leaves
    }

    #[test]
    fn every_value_is_that_of_its_ray() {
        let right = Variants::NONE;
        let leaves = asked(Colouring::Leaves, Algorithm::Parametric, right);
        let steps = asked(Colouring::Steps, Algorithm::Hero, right);
        let [n_leaves, n_steps] =
            [&leaves, &steps].map(|asked| raster(asked, &Progress::default()).unwrap().values);
        for row in 0..21 {
            for column in 0..37 {
                let at = row * 37 + column;
                let ray = leaves.ray_of(column, row).unwrap();
                let found = leaves_of(&leaves, &ray).len();
                assert_eq!(n_leaves[at] as usize, found);
                let made = count(&steps, &ray).n_steps;
                assert_eq!(n_steps[at] as usize, made);
            }
        }
    }

    #[test]
    fn right_rules_never_differ_and_printed_ones_do() {
        let right = asked(Colouring::Differences, Algorithm::Codes, Variants::NONE);
        let values = raster(&right, &Progress::default()).unwrap().values;
        assert!(values.iter().all(|&value| value == NOTHING || value == RIGHT));
        assert!(values.contains(&RIGHT));
        let printed = [Variant::B3].into_iter().collect();
        let wrong = asked(Colouring::Differences, Algorithm::Parametric, printed);
        assert!(raster(&wrong, &Progress::default()).unwrap().values.contains(&WRONG));
    }

    #[test]
    fn equal_sequences_have_equal_values() {
        let asked = asked(Colouring::Sequence, Algorithm::Parametric, Variants::NONE);
        let values = raster(&asked, &Progress::default()).unwrap().values;
        let mut names = std::collections::HashMap::new();
        for (at, &value) in values.iter().enumerate() {
            let ray = asked.ray_of(at % 37, at / 37).unwrap();
            let leaves = leaves_of(&asked, &ray);
            assert_eq!(value == NOTHING, leaves.is_empty());
            assert_eq!(names.entry(value).or_insert_with(|| leaves.clone()), &leaves);
        }
        assert!(names.len() > 10);
    }

    #[test]
    fn a_cancelled_map_stops() {
        let progress = Progress::default();
        progress.cancel();
        let asked = asked(Colouring::Leaves, Algorithm::Parametric, Variants::NONE);
        assert_eq!(raster(&asked, &progress), Err(Cancelled));
    }
}
