//! The open scenario with all that is derived from it.

mod any;
mod judged;
mod opened;
mod tracing;

use crate::comparison::Run;
use crate::history::Shared;
use crate::traced::{MOST_EVENTS, Traced};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::paper::Verdict;
use octoscope_core::progress::Progress;
use octoscope_core::query::Query;
use octoscope_core::scenario::{Scenario, Source};
use octoscope_core::scene::{Content, Cube, leaf_colours};
use octoscope_core::trace::{Counters, Moment, Trace};
use octoscope_core::tree::{BuildError, Recipe, Tree, build};
use octoscope_figure::{Camera, DiagramOf, Page};
use std::any::Any;
use std::path::PathBuf;
use std::sync::Arc;

pub use any::AnyDocument;
use judged::Finding;
pub use judged::Found;

/// What panels and handles change of a scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question<const D: usize> {
    /// Cube of the root.
    pub domain: Cube<D>,
    /// How the tree is built.
    pub recipe: Recipe,
    /// The ray; kept with other queries, too.
    pub ray: Ray<D>,
    /// What is asked of the tree.
    pub query: Query<D>,
}

/// A scenario, its content, the tree built from it and the trace of its query.
#[derive(Clone, Debug)]
pub struct Document<const D: usize> {
    /// The question; panels and handles change it.
    pub scenario: Question<D>,
    /// The scenario as it was opened: its source, which nobody changes, may
    /// hold all points of a cloud, and so all states share it.
    opened: Arc<Scenario<D>>,
    /// What the tree is built from.
    pub content: Arc<Content<D>>,
    /// The tree; of an earlier recipe while a new one is being built.
    pub tree: Arc<Tree<D>>,
    /// Record of the query; of an earlier one while a long run is being made.
    pub trace: Arc<Trace<D>>,
    /// The scenario's file, if it has one.
    pub path: Option<PathBuf>,
    /// Folder from which the data file is named.
    pub folder: PathBuf,
    /// What the run costs, as far as it is traced.
    pub total: Counters,
    /// Steps of the trace, from 1, in which doubles would have decided otherwise.
    pub rounded: Arc<[usize]>,
    /// All algorithms on the ray, once they are asked for.
    comparison: Finding<Vec<Run>>,
    /// Whether the run comes to the right result, once that is asked for.
    verdict: Finding<Verdict>,
    traced: (Ray<D>, Query<D>),
    /// The query along the ray before the present one, and the playhead in it.
    left_ray: Option<(Query<D>, usize)>,
    /// A query that is gone back to, and where the playhead was in it.
    resumed: Option<(Query<D>, usize)>,
    built: (Cube<D>, Recipe),
}

/// Upper estimate of the memory that a tree takes, in bytes per node.
const BYTES_PER_NODE: usize = 16;

impl<const D: usize> Document<D> {
    /// Builds the tree of `scenario` from `content` and runs its query.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn new(
        scenario: Scenario<D>,
        content: Arc<Content<D>>,
        progress: &Progress,
    ) -> Result<Self, BuildError> {
        let tree = Arc::new(build(&content, scenario.grid()?, &scenario.recipe, progress)?);
        let Scenario { domain, recipe, ray, query, .. } = scenario;
        let traced = Traced::within(MOST_EVENTS, &tree, ray, query, progress)?;
        let Traced { trace, total, rounded, .. } = traced;
        let traced = (ray, query);
        let built = (domain, recipe);
        Ok(Self {
            scenario: Question { domain, recipe, ray, query },
            opened: Arc::new(scenario),
            content,
            tree,
            trace,
            path: None,
            folder: PathBuf::new(),
            total,
            rounded,
            comparison: Finding::default(),
            verdict: Finding::default(),
            traced,
            left_ray: None,
            resumed: None,
            built,
        })
    }

    /// The same document with the tree that its recipe asks for.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn rebuilt(self, progress: &Progress) -> Result<Self, BuildError> {
        let rebuilt = Self::new(self.whole_scenario(), self.content, progress)?;
        Ok(Self { path: self.path, folder: self.folder, opened: self.opened, ..rebuilt })
    }

    /// Address and size in bytes of what states may share.
    fn shared(&self) -> Vec<Shared> {
        let events = self.trace.events.len() * size_of::<Event<D>>();
        let kept = match &self.opened.source {
            Source::Inline(content) => content_bytes(content),
            Source::BuiltIn { .. } | Source::File { .. } => 0,
        };
        vec![
            Shared::of(&self.tree, self.tree.n_nodes() * BYTES_PER_NODE),
            Shared::of(&self.trace, events),
            Shared::of(&self.content, content_bytes(&self.content)),
            Shared::of(&self.opened, kept),
        ]
    }

    /// Whether the recipe or the domain has changed since the tree was built.
    pub fn needs_building(&self) -> bool {
        self.built != (self.scenario.domain, self.scenario.recipe)
    }

    /// What the pictures of the run show at `moment`: the ray and the query that were
    /// traced, also while those of now are not traced yet.
    pub fn shown<'a>(&'a self, moment: &'a Moment<D>) -> DiagramOf<'a, D> {
        DiagramOf {
            tree: &self.tree,
            ray: &self.traced.0,
            query: &self.trace.query,
            moment,
            event: moment.step.checked_sub(1).and_then(|index| self.trace.events.get(index)),
            strayed: self.strayed_nodes(),
        }
    }

    /// Takes over the tree of `rebuilt`, made meanwhile from an earlier state of
    /// this document, and the trace in it; everything else stays. Returns where the
    /// playhead, now at `step`, belongs.
    pub fn adopt(&mut self, rebuilt: &Self, step: usize) -> usize {
        self.tree = Arc::clone(&rebuilt.tree);
        self.built = rebuilt.built;
        self.take(rebuilt.as_traced(), step)
    }

    /// Goes back to the recipe and domain of the tree there is, because the
    /// tree that is wanted cannot be built.
    pub fn keep_tree(&mut self) {
        (self.scenario.domain, self.scenario.recipe) = self.built;
    }

    /// Turns the ray round: its tip becomes its origin.
    pub fn reverse_ray(&mut self) {
        let ray = self.scenario.ray;
        let back = ray.direction().map(|d| -d);
        if let Ok(reversed) = Ray::new(ray.at(1.0), back) {
            self.scenario.ray = reversed;
        }
    }

    /// Mean colours of the leaves by node number, if the tree is of a picture.
    pub fn leaf_colours(&self) -> Option<Vec<Option<[u8; 3]>>> {
        colours_of_leaves(&self.tree, &self.content)
    }

    /// State of the algorithm after `step` events.
    pub fn moment(&self, step: usize) -> Moment<D> {
        Moment::after(&self.tree, &self.trace, step)
    }

    /// Moves a camera to where all that is asked about is seen on a page, from its side.
    pub fn frame(&self, camera: &mut Camera<D>, page: Page) {
        let (ray, query) = (&self.scenario.ray, &self.scenario.query);
        camera.frame_mirrored(self.tree.domain(), ray, query, page);
    }

    /// The camera that sees all that is asked about on a page, from the usual side.
    pub fn framed(&self, page: Page) -> Camera<D> {
        let mut camera = Camera::framing(&self.tree.domain().root_box(), page);
        self.frame(&mut camera, page);
        camera
    }
}

/// Mean colours of the leaves by node number, if the tree is of a picture.
pub fn colours_of_leaves<const D: usize>(
    tree: &Tree<D>,
    content: &Content<D>,
) -> Option<Vec<Option<[u8; 3]>>> {
    let Content::Image(image) = content else { return None };
    // The tree of a picture is a quadtree.
    let tree: &dyn Any = tree;
    tree.downcast_ref::<Tree<2>>().map(|tree| leaf_colours(image, tree))
}

fn content_bytes<const D: usize>(content: &Content<D>) -> usize {
    match content {
        Content::Points(points) => size_of_val(&points[..]),
        Content::Cells(cells) => size_of_val(&cells[..]),
        Content::Image(image) => size_of_val(&image.pixels[..]),
        Content::Spheres(spheres) => size_of_val(&spheres[..]),
        Content::Boxes(boxes) => size_of_val(&boxes[..]),
        Content::Triangles(triangles) => size_of_val(&triangles[..]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::Weighed;
    use crate::open::open_built_in;
    use crate::with_document;
    use octoscope_core::scenario::{AnyScenario, BUILT_IN, built_in};
    use octoscope_core::traverse::Variants;

    #[test]
    fn a_tree_that_cannot_be_built_is_not_wanted_any_more() {
        let mut any = open_built_in(BUILT_IN[0].id, &Progress::default()).unwrap();
        let before = any.clone();
        with_document!(&mut any, document => {
            document.scenario.recipe.depth += 1;
            assert!(document.needs_building());
            document.keep_tree();
            assert!(!document.needs_building());
        });
        assert!(any.is_same_state(&before) && any.is_same_place(&before));
    }

    #[test]
    fn changing_the_ray_shares_the_tree_and_the_source() {
        let before = open_built_in(BUILT_IN[0].id, &Progress::default()).unwrap();
        let mut after = before.clone();
        with_document!(&mut after, document => {
            document.reverse_ray();
            document.refresh(0);
        });
        assert!(!after.is_same_state(&before));
        let [before, after] = [&before, &after].map(|document| document.shared());
        let same: Vec<bool> =
            before.iter().zip(&after).map(|(a, b)| a.address == b.address).collect();
        // Tree, trace, content and source: only the trace is another one.
        assert_eq!(same, [true, false, true, true]);
    }

    #[test]
    fn a_run_is_shown_with_its_own_ray_and_query() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let content = Arc::new(scenario.source.content().unwrap());
        let mut document = Document::new(scenario, content, &Progress::default()).unwrap();
        let Question { ray, query, .. } = document.scenario;
        document.reverse_ray();
        document.scenario.query =
            Query::Point { at: [0.5; 2], method: Default::default(), variants: Variants::NONE };
        let moment = document.moment(3);
        let shown = document.shown(&moment);
        assert_eq!((*shown.ray, *shown.query), (ray, query));
        assert_eq!(shown.event, document.trace.events.get(2));
    }
}
