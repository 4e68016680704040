//! Built-in scenes, and what is asked of them.

use octoscope_core::explain::Notation;
use octoscope_core::query::Query;
use octoscope_core::scenario::Scenario;
use octoscope_core::text::{Language, Texts};
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Method, Variant, Variants};
use octoscope_core::tree::Tree;
use octoscope_figure::views::{Subject, figure_texts};
use octoscope_figure::{Camera, Figure, Page, Show, axes, cells, marks, space_figure};

/// A scenario with its tree.
pub struct Scene<const D: usize> {
    pub scenario: Scenario<D>,
    pub tree: Tree<D>,
}

impl<const D: usize> Scene<D> {
    pub fn new(scenario: Scenario<D>) -> Self {
        let tree = scenario.tree().unwrap();
        Self { scenario, tree }
    }

    pub fn trace(&self, query: &Query<D>) -> Trace<D> {
        record(&self.tree, &self.scenario.ray, query)
    }

    pub fn subject<'a>(
        &'a self,
        trace: &'a Trace<D>,
        moment: &'a Moment<D>,
        texts: &'a Texts,
    ) -> Subject<'a, D> {
        Subject {
            tree: &self.tree,
            ray: &self.scenario.ray,
            trace,
            moment,
            texts,
            notation: Notation::default(),
        }
    }
}

/// A traversal by every algorithm, and a point, a region and neighbours.
pub fn queries<const D: usize>(scene: &Scene<D>) -> Vec<Query<D>> {
    let by = |algorithm| {
        scene.scenario.query.along_the_ray_by(Method { algorithm, variants: Variants::NONE })
    };
    let domain = scene.tree.domain();
    let place = |share: f64| std::array::from_fn(|e| domain.min()[e] + share * domain.side());
    let mut queries: Vec<Query<D>> = Algorithm::ALL.into_iter().map(by).collect();
    queries.push(Query::Point {
        at: place(0.3),
        method: Default::default(),
        variants: Variants::NONE,
    });
    for [from, to] in [[0.3, 0.4], [0.1, 0.6]] {
        let [min, max] = [from, to].map(place);
        queries.push(Query::Region { min, max, variants: Variants::NONE });
    }
    // Corners that differ along x alone.
    for variant in [Variant::B24a, Variant::B24b, Variant::B24c] {
        let [min, max] = [5.0, 6.0].map(|x| {
            let sixteenths = |e: usize| if e == 0 { x } else { 9.0 };
            std::array::from_fn(|e| domain.min()[e] + domain.side() * sixteenths(e) / 16.0)
        });
        queries.push(Query::Region { min, max, variants: Variants::NONE.with(variant) });
    }
    for sign in [1, -1] {
        queries.push(Query::Neighbour {
            level: 1,
            code: [domain.grid_size() / 2; D],
            direction: octoscope_core::locate::Direction::new([sign; D]).unwrap(),
            reach: Default::default(),
            method: Default::default(),
            variants: Variants::NONE,
        });
    }
    queries
}

/// The picture of a scene after `step` events of its query.
pub fn picture(scene: &Scene<2>, step: usize, side: f64) -> Figure {
    let trace = scene.trace(&scene.scenario.query);
    let moment = Moment::after(&scene.tree, &trace, step);
    let event = step.checked_sub(1).map(|last| &trace.events[last]);
    let show = Show::at_first::<2>();
    let Scenario { ray, query, .. } = &scene.scenario;
    let mut all: Vec<_> = cells(&scene.tree, &show, None).into_iter().collect();
    let page = Page { width: side, height: side };
    let camera = Camera::framing(&scene.tree.domain().root_box(), page);
    all.extend(axes(scene.tree.domain(), &show, &camera));
    all.extend(marks(&scene.tree, ray, query, &moment, event, &show));
    space_figure(&all, &camera, page)
}

/// The texts of figures.
pub fn texts(language: Language) -> Texts {
    Texts::new(language, &[figure_texts(language)])
}
