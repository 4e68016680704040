//! One step of an export, to be looked at before it is written, or to be copied.

use super::{Format, Order, Request, Series, Steps};
use crate::document::AnyDocument;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::StepAt;
use octoscope_figure::{Figure, FileOptions, Page, Pixels, PixelsError, Scale, Unit, svg};
use std::ops::RangeInclusive;

/// The picture of one step, and which one that is.
#[derive(Clone, Debug)]
pub struct Preview {
    /// The picture.
    pub pixels: Pixels,
    /// What it is of.
    pub of: OneOf,
}

/// One of the steps that are asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OneOf {
    /// Its number.
    pub step: usize,
    /// All of them.
    pub steps: RangeInclusive<usize>,
}

impl Request {
    /// One of the steps in pixels, `step` or the nearest one, no wider and no higher than
    /// `most`.
    ///
    /// # Errors
    /// Says what cannot be drawn.
    pub fn preview(
        &self,
        document: &AnyDocument,
        step: usize,
        most: [f64; 2],
        progress: &Progress,
    ) -> anyhow::Result<Preview> {
        let (figure, of) = self.with_one(document, step, progress, |series, of| {
            let (figure, _) = Series::figure_of(&self.order, series, of.step, progress)?;
            Ok((figure, of))
        })?;
        let page = [figure.page.width, figure.page.height];
        // A page like a thread is shown in the middle of a wider one.
        let least = 0.01 * page[0].max(page[1]);
        let [width, height] = page.map(|side| side.max(least));
        let corner = [0.5 * (width - page[0]), 0.5 * (height - page[1])];
        let figure = figure.on_page(Page { width, height }, corner);
        let factor = (most[0] / width).min(most[1] / height);
        Ok(Preview { pixels: self.pixels(&figure, factor)?, of })
    }

    /// The figure of one of the steps, `step` or the nearest one, as the text of an SVG.
    ///
    /// # Errors
    /// Says what cannot be drawn.
    pub fn svg(
        &self,
        document: &AnyDocument,
        step: usize,
        progress: &Progress,
    ) -> anyhow::Result<String> {
        self.with_one(document, step, progress, |series, OneOf { step, .. }| {
            let (figure, scale) = Series::figure_of(&self.order, series, step, progress)?;
            let (title, scenario) = ((series.caption)(step).plain(), (series.scenario)(step));
            let Order { theme, background, line_scale, .. } = self.order;
            let options = FileOptions {
                theme,
                background,
                title: &title,
                scenario: &scenario,
                scale,
                line_scale,
            };
            Ok(svg(&figure, &options))
        })
    }

    /// One of the steps, `step` or the nearest one, in as many pixels as a picture of it
    /// has; twice as many, if the file is one of vectors.
    ///
    /// # Errors
    /// Says what cannot be drawn.
    pub fn picture(
        &self,
        document: &AnyDocument,
        step: usize,
        progress: &Progress,
    ) -> anyhow::Result<Pixels> {
        let is_of_pixels = self.order.format.is_of_pixels();
        let more = if is_of_pixels || self.order.enlarged.is_some() { 1.0 } else { 2.0 };
        let order = Order { format: Format::Png, ..self.order };
        let picture = Self { order, ..self.clone() };
        let (figure, scale) = picture.with_one(document, step, progress, |series, of| {
            Series::figure_of(&picture.order, series, of.step, progress)
        })?;
        Ok(self.pixels(&figure, more * scale.factor)?)
    }

    fn pixels(&self, figure: &Figure, factor: f64) -> Result<Pixels, PixelsError> {
        let Order { theme, background, line_scale, .. } = self.order;
        let scale = Scale { factor, unit: Unit::Pixel };
        let options =
            FileOptions { theme, background, scale, line_scale, ..FileOptions::default() };
        Pixels::of(figure, &options)
    }

    /// The figures that are asked for, and one of their steps: `step` or the nearest one.
    fn with_one<T>(
        &self,
        document: &AnyDocument,
        step: usize,
        progress: &Progress,
        then: impl FnOnce(&Series, OneOf) -> anyhow::Result<T>,
    ) -> anyhow::Result<T> {
        // A text has all steps, and a figure of the last ones stands for it.
        let is_of_text = self.order.format.is_of_text();
        let steps = if is_of_text { Steps::One(StepAt::At(step)) } else { self.steps };
        self.with_series(document, steps, None, progress, |series| {
            let steps = series.steps.clone();
            then(series, OneOf { step: step.clamp(*steps.start(), *steps.end()), steps })
        })
    }
}
