//! The question: what tree, what ray, what is asked of it.

mod built_in;
mod fault;
mod fields;
mod place;
mod print;
mod read;
mod source;

pub use built_in::{BUILT_IN, BuiltIn, built_in};
pub use fault::{LEAST, scenario_texts};
pub use read::{Fault, ScenarioError, VERSION};
pub use source::{Parameters, Source, SourceError};

use crate::geometry::Ray;
use crate::progress::Progress;
use crate::query::Query;
use crate::scene::{Content, Cube};
use crate::tree::{BuildError, Domain, DomainError, Recipe, Tree, build};
use thiserror::Error;

/// All that a run depends on. Everything else is derived from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario<const D: usize> {
    /// Cube of the root.
    pub domain: Cube<D>,
    /// What the tree is built from.
    pub source: Source<D>,
    /// How the tree is built.
    pub recipe: Recipe,
    /// The ray; kept with other queries, too.
    pub ray: Ray<D>,
    /// What is asked of the tree.
    pub query: Query<D>,
    /// Where the playhead stands when the scenario is opened.
    pub step: StepAt,
    /// What a program that shows the scenario wants to keep with it.
    pub view: View,
}

/// Why a scenario has no tree.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TreeError {
    /// What it is built from is not there.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// The domain and the depth do not go together.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// No tree can be built from it.
    #[error(transparent)]
    Build(#[from] BuildError),
}

/// Fields of `"view"`, kept as they are.
pub type View = serde_json::Map<String, serde_json::Value>;

/// Position of the playhead.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StepAt {
    /// Before the first event.
    #[default]
    First,
    /// After the last event.
    Last,
    /// After so many events, or after the last if there are fewer.
    At(usize),
}

/// Scenario of either dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyScenario {
    /// In the plane.
    Quadtree(Scenario<2>),
    /// In space.
    Octree(Scenario<3>),
}

impl<const D: usize> Scenario<D> {
    /// Scenario with a fitting domain, a ray that crosses it, and defaults for
    /// the rest. `content` is what `source` stands for.
    pub fn of(source: Source<D>, content: &Content<D>) -> Self {
        Self::with_defaults(source, content.fit())
    }

    /// Scenario in `domain` with a ray that crosses it, and defaults for the rest.
    fn with_defaults(source: Source<D>, domain: Cube<D>) -> Self {
        Self {
            domain,
            source,
            recipe: Recipe::default(),
            ray: default_ray(&domain),
            query: Query::default(),
            step: StepAt::First,
            view: View::new(),
        }
    }

    /// The domain cut into the cells of the recipe's depth.
    ///
    /// # Errors
    /// Refuses what [`Domain::new`] refuses.
    pub fn grid(&self) -> Result<Domain<D>, DomainError> {
        self.domain.cut(self.recipe.depth)
    }

    /// The tree of a scenario that holds all that it is built from; who waits for it
    /// builds it by [`build`], with a progress that tells how far that is.
    ///
    /// # Errors
    /// See [`TreeError`].
    pub fn tree(&self) -> Result<Tree<D>, TreeError> {
        let (content, grid) = (self.source.content()?, self.grid()?);
        Ok(build(&content, grid, &self.recipe, &Progress::default())?)
    }

    /// Fits the domain around the content of a file whose scenario leaves it
    /// open, and with it the ray, if that was left open as well. Does nothing
    /// to other scenarios.
    pub fn fit_to(&mut self, content: &Content<D>) {
        let Source::File { fit, .. } = &mut self.source else {
            return;
        };
        if std::mem::replace(fit, false) {
            let keep_ray = self.ray != default_ray(&self.domain);
            self.domain = content.fit();
            self.ray = if keep_ray { self.ray } else { default_ray(&self.domain) };
        }
    }
}

impl StepAt {
    /// Number of events that have happened, of `n_events`.
    pub fn position(self, n_events: usize) -> usize {
        match self {
            Self::First => 0,
            Self::Last => n_events,
            Self::At(step) => step.min(n_events),
        }
    }
}

/// Ray from outside through the middle part of a domain, in general position.
pub fn default_ray<const D: usize>(domain: &Cube<D>) -> Ray<D> {
    let part = |parts: [f64; 3], e: usize| domain.side * parts[e % 3];
    let origin = std::array::from_fn(|e| domain.min[e] + part([-0.25, 0.1875, 0.3125], e));
    let direction = std::array::from_fn(|e| part([1.0, 0.5, 0.25], e));
    Ray::new(origin, direction).unwrap_or_else(|_| {
        let unit = std::array::from_fn(|e| [1.0, 0.5, 0.25][e % 3]);
        Ray::new([0.0; D], unit).expect("finite and not zero")
    })
}
