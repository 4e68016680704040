//! The figure of the view, as long as what it shows stays the same: labels that nothing
//! has moved are not placed anew.

use eframe::egui::{Id, Ui};
use octoscope_figure::{Camera, Figure, Mark, Page, space_figure_over};
use std::sync::Arc;

/// What a figure is made of.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parts<const D: usize> {
    /// What something else draws below it.
    pub below: Vec<Mark<D>>,
    /// What is drawn, in any order.
    pub marks: Vec<Mark<D>>,
    /// From where it is seen.
    pub camera: Camera<D>,
    /// How large it is.
    pub page: Page,
}

impl<const D: usize> Parts<D> {
    /// The figure; that of the last frame if it had the same parts.
    pub fn placed(self, ui: &Ui) -> Arc<Figure> {
        type Kept<const D: usize> = Arc<(Parts<D>, Arc<Figure>)>;
        let id = Id::unique("placed figure of the space view");
        let kept = ui.data(|data| data.get_temp::<Kept<D>>(id));
        if let Some(kept) = kept.filter(|kept| kept.0 == self) {
            return Arc::clone(&kept.1);
        }
        let figure = Arc::new(self.figure());
        ui.data_mut(|data| data.insert_temp::<Kept<D>>(id, Arc::new((self, Arc::clone(&figure)))));
        figure
    }

    fn figure(&self) -> Figure {
        let Self { below, marks, camera, page } = self;
        let mut marks = marks.clone();
        marks.sort_by_cached_key(|mark| mark.role.layer());
        space_figure_over(below, &marks, camera, *page)
    }
}
