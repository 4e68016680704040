//! The figure of any view of a document.

mod moments;
mod space;
mod tree;

pub use moments::Moments;
pub use space::left_out;

use crate::document::Document;
use crate::text::texts;
use octoscope_core::explain::{Notation, sentence};
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_figure::views::{
    Exercise, Fields, FigureView, Layout, Panel, Subject, common_extent, figure, storyboard,
    worksheet,
};
use octoscope_figure::{Camera, Extent, Figure, Page, Show};
use space::space;
use tree::whole_tree;

/// Room around a figure that is cropped, in page units.
pub const MARGIN: f64 = 6.0;

/// What a figure shows, and how.
#[derive(Clone, Debug)]
pub struct Wanted<const D: usize> {
    /// What it shows.
    pub view: FigureView,
    /// Number of events that have happened.
    pub step: usize,
    /// Moments of a storyboard.
    pub moments: Moments,
    /// Number of the exercise on a worksheet, and what is in its fields.
    pub exercise: (Option<u64>, Fields),
    /// Page of the view in space.
    pub page: Page,
    /// Width in which other views are laid out; without it, the usual one.
    pub column: Option<f64>,
    /// Camera of pictures of space; none fits everything.
    pub camera: Option<Camera<D>>,
    /// What such pictures show.
    pub show: Show,
    /// Language of all words.
    pub language: Language,
    /// How formulas are written.
    pub notation: Notation,
}

/// The views that have something to show of a query.
pub fn views_of<const D: usize>(query: &Query<D>) -> Vec<FigureView> {
    FigureView::ALL.into_iter().filter(|view| view.fits(query).is_ok()).collect()
}

/// Figure of a view of `document`: that of space on its whole page, any other on
/// a page that ends around it.
///
/// # Errors
/// Says which query, step or tree a view would fit that has nothing to show.
pub fn figure_of<const D: usize>(
    document: &Document<D>,
    wanted: &Wanted<D>,
) -> anyhow::Result<Figure> {
    let Wanted { view, step, page, camera, show, language, column, .. } = *wanted;
    let width = view.width_in::<D>(column);
    let figure = match view {
        FigureView::Space => return Ok(space(document, camera, page, &show, step)),
        FigureView::Tree => whole_tree(document, step, column),
        FigureView::Storyboard => story(document, wanted),
        FigureView::Worksheet => exercise(document, wanted)?,
        FigureView::Automaton
        | FigureView::TRail
        | FigureView::Codes
        | FigureView::Region
        | FigureView::Neighbour
        | FigureView::Listing
        | FigureView::Table
        | FigureView::Chart
        | FigureView::Formula => {
            let subject = Subject {
                tree: &document.tree,
                ray: &document.scenario.ray,
                trace: &document.trace,
                moment: &document.moment(step),
                texts: &texts(language),
                notation: wanted.notation,
            };
            figure(view, &subject, width)?
        }
    };
    Ok(figure.cropped(MARGIN))
}

/// Several moments with their sentences on one page.
fn story<const D: usize>(document: &Document<D>, wanted: &Wanted<D>) -> Figure {
    let Wanted { camera, show, language, .. } = *wanted;
    let steps = wanted.moments.steps(document);
    let width = FigureView::Storyboard.width_in::<D>(wanted.column);
    let layout = Layout::of(steps.len(), width);
    let panels = |page: Page| -> Vec<Panel> {
        let panel = |&step: &usize| Panel {
            step,
            picture: space(document, camera, page, &show, step),
            caption: sentence(
                &document.tree,
                &document.scenario.ray,
                &document.trace,
                step,
                language,
            ),
        };
        steps.iter().map(panel).collect()
    };
    let panels = filling(layout.column, camera.is_some(), panels, |panels| {
        common_extent(panels.iter().map(|panel| &panel.picture))
    });
    storyboard(panels, layout, &texts(language), width)
}

/// Pictures on a page that is so large that what is seen on it is `width` wide.
fn filling<T>(
    width: f64,
    is_fixed: bool,
    draw: impl Fn(Page) -> T,
    extent: impl Fn(&T) -> Option<Extent>,
) -> T {
    let page = Page { width, height: width };
    let first = draw(page);
    let Some(extent) = extent(&first).filter(|_| !is_fixed) else { return first };
    // Letters do not grow with the page: a little less than it would take.
    let factor = (width / extent.size()[0]).clamp(0.5, 2.0).powf(0.95);
    draw(Page { width: width * factor, height: width * factor })
}

/// A worksheet of the ray of `document`.
fn exercise<const D: usize>(document: &Document<D>, wanted: &Wanted<D>) -> anyhow::Result<Figure> {
    const SIDE: f64 = 230.0;
    let (number, fields) = wanted.exercise;
    let exercise = Exercise::of(&document.tree, &document.scenario.ray, number)?;
    let draw = |page: Page| space(document, wanted.camera, page, &wanted.show, 0);
    let picture = filling(SIDE, wanted.camera.is_some(), draw, Figure::extent).cropped(0.0);
    let width = FigureView::Worksheet.width_in::<D>(wanted.column);
    let texts = texts(wanted.language);
    Ok(worksheet(&document.tree, &exercise, picture, &texts, (fields, width)))
}

/// Asks of `document` what a worksheet does: to follow the ray of an exercise, or its own,
/// by rules that are right.
///
/// # Errors
/// Says that no ray through its tree can be followed by hand.
pub fn take_exercise<const D: usize>(
    document: &mut Document<D>,
    number: Option<u64>,
) -> anyhow::Result<()> {
    if let Some(number) = number {
        document.scenario.ray = Exercise::ray_of(&document.tree, number)?;
    }
    document.scenario.query = Query::default();
    document.refresh(0);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::AnyDocument;
    use crate::open::{open_built_in, open_scenario};
    use crate::with_document;
    use octoscope_core::paper::counterexample;
    use octoscope_core::progress::Progress;
    use octoscope_core::scenario::AnyScenario;
    use octoscope_core::traverse::Variant;
    use octoscope_figure::{Drawn, Form, Role, metrics};
    use std::collections::BTreeSet;
    use std::path::Path;

    /// Left, top, right and bottom of a text, and whether it is a caption.
    fn box_of(drawn: &Drawn) -> Option<([f64; 4], bool)> {
        let Form::Text { at: [x, y], anchor, text } = &drawn.form else { return None };
        let (width, size) = (metrics::width(drawn.role, text), metrics::size(drawn.role));
        let left = x - anchor.share() * width;
        Some(([left, y - 0.4 * size, left + width, y + 0.5 * size], drawn.role == Role::Note))
    }

    fn check_story<const D: usize>(document: &Document<D>, moments: Moments, language: Language) {
        let wanted = Wanted {
            view: FigureView::Storyboard,
            step: 0,
            moments: moments.clone(),
            exercise: (None, Fields::Empty),
            page: Page { width: 960.0, height: 720.0 },
            column: None,
            camera: None,
            show: Show::at_first::<D>(),
            language,
            notation: Notation::default(),
        };
        let figure = figure_of(document, &wanted).unwrap();
        assert!((300.0..560.0).contains(&figure.page.width), "{:?}", figure.page);
        let boxes: Vec<_> = figure.drawn.iter().filter_map(box_of).collect();
        for (index, (a, is_caption)) in boxes.iter().enumerate().filter(|(_, (_, is))| *is) {
            assert!(*is_caption && a[0] > 0.0 && a[2] < figure.page.width);
            let others = boxes.iter().enumerate().filter(|(other, _)| *other != index);
            for (_, (b, _)) in others {
                let is_apart = a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
                assert!(is_apart, "{moments:?} {language:?}: {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn captions_and_legend_of_storyboards_cover_nothing() {
        for (id, language) in [("quadtree-82", Language::English), ("figure-7", Language::German)] {
            for moments in [1, 2, 3, 4, 6, 7].map(Moments::Even) {
                let any = open_built_in(id, &Progress::default()).unwrap();
                with_document!(&any, document => check_story(document, moments, language));
            }
        }
    }

    #[test]
    fn more_leaves_than_can_be_told_apart_are_left_out_of_a_figure_which_is_said() {
        let page = Page { width: 400.0, height: 300.0 };
        for (n, is_drawn) in [(6, true), (10, false)] {
            let text = format!(
                r#"{{"octoscope": 1, "scene": {{"built-in": "checker-cells", "parameters": {{"n": {n}}}}}}}"#
            );
            let scenario = AnyScenario::parse(&text).unwrap();
            let any = open_scenario(scenario, Path::new(""), &Progress::default()).unwrap();
            let AnyDocument::Plane(document) = any else { panic!() };
            assert_eq!(document.tree.n_leaves(), 1 + (3 << (2 * n - 2)));
            let show = Show::at_first::<2>();
            let figure = space(&document, None, page, &show, 0);
            let is_leaf = |role: Role| matches!(role, Role::EmptyLeaf | Role::FullLeaf);
            let n_leaves = figure.drawn.iter().filter(|drawn| is_leaf(drawn.role)).count();
            assert_eq!(n_leaves > 0, is_drawn, "{n}");
            let told = left_out(&document, &show, &texts(Language::English)).join("; ");
            let said = "786433 leaves beside the ray are left out; figures show at most 200000";
            assert_eq!(told, if is_drawn { "" } else { said });
        }
    }

    #[test]
    fn what_is_wrong_and_what_would_be_right_is_in_a_figure_of_a_misprint() {
        let AnyDocument::Plane(mut document) =
            open_scenario(counterexample(Variant::B3), Path::new(""), &Progress::default())
                .unwrap()
        else {
            panic!()
        };
        document.find_right_nodes(&Progress::default()).unwrap();
        let last = document.trace.events.len();
        let page = Page { width: 400.0, height: 300.0 };
        let figure = space(&document, None, page, &Show::at_first::<2>(), last);
        let nodes = |role: Role| -> BTreeSet<u32> {
            let own = figure.drawn.iter().filter(|drawn| drawn.role == role);
            own.filter_map(|drawn| Some(drawn.node?.0)).collect()
        };
        // Leaves 1 to 4; 0, 2 instead of 0, 1, 3.
        assert_eq!(nodes(Role::Expected), BTreeSet::from([1, 3]));
        assert_eq!(nodes(Role::Strayed), BTreeSet::from([2, 4]));
    }
}
