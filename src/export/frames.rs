//! The page that all figures of a file share.

use super::Order;
use super::made::Made;
use crate::figures::MARGIN;
use octoscope_core::progress::Progress;
use octoscope_figure::{Extent, Figure, Page, Scale};
use std::ops::RangeInclusive;

/// Where the figures lie in the file: all of them on the same page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frames {
    /// The page on which they are laid out.
    page: Page,
    /// The part of it that is kept, if not all is.
    kept: Option<Extent>,
    /// How much larger than the order says what is kept is shown.
    zoom: f64,
}

impl Frames {
    /// The page around all figures, or the one of the size that is asked for, which may
    /// be a width. A figure that has a page of its own, whatever it is offered, is shown
    /// whole, as large as there is room.
    pub(super) fn of(
        order: &Order,
        steps: RangeInclusive<usize>,
        made: &Made,
        progress: &Progress,
    ) -> anyhow::Result<Self> {
        let page = made.page();
        let whole = Self { page, kept: None, zoom: 1.0 };
        let has_own_page = made.look(*steps.start(), |first| first.page != page)?;
        let height = order.size.map(|size| size.height);
        if matches!(height, Some(Some(_))) && !has_own_page {
            return Ok(whole);
        }
        let mut kept: Option<Extent> = None;
        for step in steps {
            let found = made.look(step, |figure| {
                let max = [figure.page.width, figure.page.height];
                match has_own_page {
                    true => Some(Extent { min: [0.0; 2], max }),
                    false => figure.extent().map(|extent| extent.widened(MARGIN)),
                }
            })?;
            kept = match (kept, found) {
                (Some(a), Some(b)) => Some(a.and(b)),
                (a, b) => a.or(b),
            };
            progress.advance(1)?;
        }
        Ok(match (kept, height) {
            (Some(kept), Some(Some(_))) => whole.fitting(kept),
            (Some(kept), Some(None)) => whole.as_wide(kept),
            (kept, _) => Self { kept, ..whole },
        })
    }

    /// What is kept as wide as the page, or in its middle where that would make its type
    /// much larger than usual.
    fn as_wide(self, kept: Extent) -> Self {
        const MOST: f64 = 1.25;
        let wide = kept.max[0] - kept.min[0];
        let zoom = (self.page.width / wide).min(MOST);
        let room = 0.5 * (self.page.width / zoom - wide);
        let kept = Extent {
            min: [kept.min[0] - room, kept.min[1]],
            max: [kept.max[0] + room, kept.max[1]],
        };
        Self { kept: Some(kept), zoom, ..self }
    }

    /// What is kept in the middle of the page, as large as there is room.
    fn fitting(self, kept: Extent) -> Self {
        let Page { width, height } = self.page;
        let [wide, high]: [f64; 2] = std::array::from_fn(|e| kept.max[e] - kept.min[e]);
        let zoom = (width / wide).min(height / high);
        let room = [0.5 * (width / zoom - wide), 0.5 * (height / zoom - high)];
        let kept = Extent {
            min: std::array::from_fn(|e| kept.min[e] - room[e]),
            max: std::array::from_fn(|e| kept.max[e] + room[e]),
        };
        Self { kept: Some(kept), zoom, ..self }
    }

    /// The figure of a step, on the page of all.
    pub(super) fn figure(&self, made: &Made, step: usize) -> anyhow::Result<Figure> {
        made.take(step).map(|figure| self.shown(figure))
    }

    pub(super) fn shown(&self, figure: Figure) -> Figure {
        match self.kept {
            Some(kept) => figure.on(kept),
            None => figure,
        }
    }

    /// Length of the units of that page.
    pub(super) fn scale(&self, order: &Order) -> Scale {
        let scale = order.scale();
        Scale { factor: scale.factor * self.zoom, ..scale }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_figure::{Drawn, Form, Part, Role};

    /// Figures with a page of their own, higher from step to step.
    fn own_page(_: Page, step: usize) -> anyhow::Result<Figure> {
        let page = Page { width: 300.0, height: 50.0 * (step + 1) as f64 };
        Ok(Figure { page, drawn: Vec::new() })
    }

    /// Figures of a line on the page that is offered.
    fn on_page(page: Page, step: usize) -> anyhow::Result<Figure> {
        let form = Form::Circle { centre: [100.0 + 10.0 * step as f64, 50.0], radius: 20.0 };
        let drawn = Drawn { form, role: Role::Touch, part: Part::Whole, node: None };
        Ok(Figure { page, drawn: vec![drawn] })
    }

    /// Width and height of all figures of two steps, in the unit of the order.
    #[track_caller]
    fn check(
        figure: fn(Page, usize) -> anyhow::Result<Figure>,
        size: Option<&str>,
        expected: [f64; 2],
    ) {
        let order = Order { size: size.map(|size| size.parse().unwrap()), ..Order::default() };
        let made = Made::new(&figure, order.page());
        let frames = Frames::of(&order, 0..=1, &made, &Progress::default()).unwrap();
        for step in 0..=1 {
            let page = frames.figure(&made, step).unwrap().page;
            let factor = frames.scale(&order).factor;
            let found = [page.width * factor, page.height * factor];
            for e in 0..2 {
                assert!((found[e] - expected[e]).abs() < 1e-9, "{size:?}: {found:?}");
            }
        }
    }

    #[test]
    fn figures_of_a_file_share_a_page_of_the_right_size() {
        check(own_page, None, [300.0, 100.0]);
        check(own_page, Some("640x480"), [640.0, 480.0]);
        check(own_page, Some("120x80mm"), [120.0, 80.0]);
        check(on_page, Some("640x480"), [640.0, 480.0]);
        // A width: type becomes a quarter larger at most.
        check(own_page, Some("330px"), [330.0, 110.0]);
        check(own_page, Some("600px"), [600.0, 125.0]);
        check(on_page, Some("80px"), [80.0, 67.5]);
        // Two circles, their line and the margin.
        check(on_page, None, [50.0 + 2.0 * 7.0, 40.0 + 2.0 * 7.0]);
    }
}
