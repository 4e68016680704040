//! Figures of steps, each made once.

use super::write::FigureOf;
use octoscope_figure::{Figure, Page};
use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

/// Figures of the steps of one run on one page, which are kept from when they are
/// measured to when they are drawn.
pub(super) struct Made<'a> {
    make: FigureOf<'a>,
    page: Page,
    kept: Mutex<Kept>,
}

#[derive(Default)]
struct Kept {
    figures: HashMap<usize, Figure>,
    /// Number of shapes in all of them.
    n_shapes: usize,
}

/// Most shapes that are kept, some 100 MB; what more there is, is made again.
const MOST_SHAPES: usize = 500_000;

impl<'a> Made<'a> {
    /// None yet of what `make` makes for `page`.
    pub fn new(make: FigureOf<'a>, page: Page) -> Self {
        Self { make, page, kept: Mutex::default() }
    }

    /// Page on which they are laid out.
    pub fn page(&self) -> Page {
        self.page
    }

    /// Looks at the figure of a step, which will be needed again.
    pub fn look<T>(&self, step: usize, at: impl FnOnce(&Figure) -> T) -> anyhow::Result<T> {
        let figure = self.take(step)?;
        let seen = at(&figure);
        self.keep(step, figure);
        Ok(seen)
    }

    /// The figure of a step, which is not needed any more.
    pub fn take(&self, step: usize) -> anyhow::Result<Figure> {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        let figure = kept.figures.remove(&step);
        kept.n_shapes -= figure.as_ref().map_or(0, |figure| figure.drawn.len());
        drop(kept);
        figure.map_or_else(|| (self.make)(self.page, step), Ok)
    }

    fn keep(&self, step: usize, figure: Figure) {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.n_shapes + figure.drawn.len() <= MOST_SHAPES {
            kept.n_shapes += figure.drawn.len();
            kept.figures.insert(step, figure);
        }
    }
}
