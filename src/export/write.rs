//! Figures of steps → files.

use super::made::Made;
use super::moving::each_frame;
use super::{Format, Order};
use crate::files::{Output, is_standard};
use anyhow::bail;
use octoscope_core::explain::RichText;
use octoscope_core::progress::Progress;
use octoscope_figure::{
    Apng, Extent, Figure, FileOptions, Gif, Page, Pdf, Pixels, Scale, Tikz, png, svg,
};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// Makes the figure of a step, laid out on a page; of several on several threads.
pub(super) type FigureOf<'a> = &'a (dyn Fn(Page, usize) -> anyhow::Result<Figure> + Sync);

/// What is exported: figures of the steps of one run, made when they are needed.
pub struct Series<'a> {
    /// The steps.
    pub steps: RangeInclusive<usize>,
    /// Figure of a step, laid out on a page.
    pub figure: FigureOf<'a>,
    /// What happens in a step, in words.
    pub caption: &'a dyn Fn(usize) -> RichText,
    /// The scenario with the playhead at a step, as JSON.
    pub scenario: &'a dyn Fn(usize) -> String,
}

impl Series<'_> {
    /// The figure of one step as in a file of its own, and the length of its units.
    pub(super) fn figure_of(
        order: &Order,
        series: &Series,
        step: usize,
        progress: &Progress,
    ) -> anyhow::Result<(Figure, Scale)> {
        let made = Made::new(series.figure, order.page());
        let frames = Frames::of(order, step..=step, &made, progress)?;
        Ok((frames.figure(&made, step)?, frames.scale(order)))
    }
}

/// Writes `series` as `order` says to `path`, else to standard output. Formats
/// that hold one step become a file a step, with its number before the ending.
/// Every file appears whole or not at all.
///
/// # Errors
/// Says what cannot be drawn or written; tells if it was cancelled.
pub fn write(
    order: &Order,
    series: &Series,
    path: Option<&Path>,
    progress: &Progress,
) -> anyhow::Result<()> {
    let (first, last) = (*series.steps.start(), *series.steps.end());
    let n_steps = (last - first + 1) as u64;
    progress.start(n_steps);
    let made = Made::new(series.figure, order.page());
    let frames = Frames::of(order, series.steps.clone(), &made, progress)?;
    progress.start(n_steps);
    if first == last || order.format.holds_steps() {
        let mut output = Output::open(path)?;
        output.put(&bytes(order, series, (&made, &frames), progress)?)?;
        return output.finish();
    }
    let Some(path) = path.filter(|path| !is_standard(path)) else {
        bail!("these are {n_steps} files; give the name of the first with -o");
    };
    for step in first..=last {
        let one = Series { steps: step..=step, ..*series };
        let mut output = Output::open(Some(&numbered(path, step, last)))?;
        output.put(&bytes(order, &one, (&made, &frames), progress)?)?;
        output.finish()?;
    }
    Ok(())
}

/// `name.svg` with the number of the step: `name-007.svg`, with as many digits
/// as the last one has.
fn numbered(path: &Path, step: usize, last: usize) -> PathBuf {
    let digits = last.to_string().len().max(3);
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let number = format!("{stem}-{step:0digits$}");
    match path.extension() {
        Some(ending) => path.with_file_name(format!("{number}.{}", ending.to_string_lossy())),
        None => path.with_file_name(number),
    }
}

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
                    false => figure.extent().map(|extent| extent.widened(Order::MARGIN)),
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

    fn shown(&self, figure: Figure) -> Figure {
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

/// One file of the series.
fn bytes(
    order: &Order,
    series: &Series,
    (made, frames): (&Made, &Frames),
    progress: &Progress,
) -> anyhow::Result<Vec<u8>> {
    let first = *series.steps.start();
    let (title, scenario) = ((series.caption)(first).plain(), (series.scenario)(first));
    let options = FileOptions {
        theme: order.theme,
        background: order.background,
        title: &title,
        scenario: &scenario,
        scale: frames.scale(order),
        line_scale: order.line_scale,
    };
    let mut figures = series.steps.clone().map(|step| -> anyhow::Result<Figure> {
        progress.advance(1)?;
        frames.figure(made, step)
    });
    match order.format {
        Format::Svg => match figures.next() {
            Some(figure) => Ok(svg(&figure?, &options).into_bytes()),
            None => bail!("there is no step to draw"),
        },
        Format::Png => match figures.next() {
            Some(figure) => Ok(png(&figure?, &options)?),
            None => bail!("there is no step to draw"),
        },
        Format::Pdf => {
            let mut pdf = Pdf::new(&options);
            for figure in figures {
                pdf.page(&figure?)?;
            }
            Ok(pdf.finish()?)
        }
        Format::Tikz => {
            let mut tikz = Tikz::new(order.tikz, &options);
            for (step, figure) in series.steps.clone().zip(figures) {
                tikz.figure(&figure?, &(series.caption)(step));
            }
            Ok(tikz.finish().into_bytes())
        }
        Format::Gif => {
            let (mut file, pause) = (Vec::new(), order.pause_secs);
            let mut gif =
                Gif::begin(&mut file, &samples(series, (made, frames), &options)?, pause)?;
            each_frame(
                series,
                (made, frames),
                &options,
                progress,
                |pixels| Ok(gif.frame(pixels)?),
            )?;
            gif.finish()?;
            Ok(file)
        }
        Format::Apng => {
            let (mut file, pause) = (Vec::new(), order.pause_secs);
            let n_frames = u32::try_from(series.steps.clone().count())?;
            let alone = frames.figure(made, first)?;
            let alone = Pixels::of(&alone, &options)?;
            progress.advance(1)?;
            let mut apng = Apng::begin(&mut file, alone, n_frames, pause, &options)?;
            let others = Series { steps: first + 1..=*series.steps.end(), ..*series };
            each_frame(&others, (made, frames), &options, progress, |pixels| {
                Ok(apng.frame(pixels)?)
            })?;
            apng.finish()?;
            Ok(file)
        }
        Format::Markdown | Format::Csv | Format::Latex => {
            bail!("{} is a format of tables, not of figures", order.format.name())
        }
    }
}

/// Some frames, from the first to the last, in which all colours are seen.
fn samples(
    series: &Series,
    (made, frames): (&Made, &Frames),
    options: &FileOptions,
) -> anyhow::Result<Vec<Pixels>> {
    const MOST: usize = 6;
    let (first, last) = (*series.steps.start(), *series.steps.end());
    let mut steps: Vec<usize> =
        (0..MOST).map(|i| first + (last - first) * i / (MOST - 1)).collect();
    steps.dedup();
    let pixels = steps.into_iter().map(|step| {
        let figure = made.look(step, |figure| frames.shown(figure.clone()))?;
        Ok(Pixels::of(&figure, options)?)
    });
    pixels.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Cancelled;
    use octoscope_figure::{Drawn, Form, Part, Role};
    use std::sync::atomic::{AtomicUsize, Ordering};

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
        let series = Series {
            steps: 0..=1,
            figure: &figure,
            caption: &|_| RichText::default(),
            scenario: &|_| String::new(),
        };
        let made = Made::new(series.figure, order.page());
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

    /// Writes 200 steps as `format` until step 150 is drawn, when it is cancelled.
    fn check_cancelled(format: Format) {
        let folder = tempfile::tempdir().unwrap();
        let order = Order { format, size: Some("40x30".parse().unwrap()), ..Order::default() };
        let progress = Progress::default();
        let figure = |page: Page, step: usize| {
            if step == 150 {
                progress.cancel();
            }
            on_page(page, step)
        };
        let series = Series {
            steps: 0..=199,
            figure: &figure,
            caption: &|_| RichText::default(),
            scenario: &|_| String::new(),
        };
        let path = folder.path().join("a.out");
        let error = write(&order, &series, Some(&path), &progress).unwrap_err();
        assert!(error.root_cause().is::<Cancelled>(), "{format:?}: {error}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "{format:?}");
        assert!(progress.fraction() < Some(0.8), "{format:?}");
    }

    #[test]
    fn what_is_cancelled_leaves_no_file() {
        for format in [Format::Gif, Format::Apng, Format::Pdf, Format::Tikz] {
            check_cancelled(format);
        }
    }

    #[test]
    fn every_figure_is_made_once() {
        let folder = tempfile::tempdir().unwrap();
        let n_steps = 40;
        let mut n_made = Vec::new();
        for format in [Format::Gif, Format::Apng, Format::Pdf, Format::Tikz, Format::Svg] {
            for size in [None, Some("60px".parse().unwrap()), Some("60x40".parse().unwrap())] {
                let count = AtomicUsize::new(0);
                let figure = |page: Page, step: usize| {
                    count.fetch_add(1, Ordering::Relaxed);
                    on_page(page, step)
                };
                let series = Series {
                    steps: 0..=n_steps - 1,
                    figure: &figure,
                    caption: &|_| RichText::default(),
                    scenario: &|_| String::new(),
                };
                let order = Order { format, size, ..Order::default() };
                let path = folder.path().join("a.out");
                write(&order, &series, Some(&path), &Progress::default()).unwrap();
                n_made.push(count.into_inner());
            }
        }
        assert_eq!(n_made, [n_steps; 15]);
    }

    #[test]
    fn names_of_a_sequence_sort_as_the_steps_do() {
        let check = |path, step, last, expected: &str| {
            assert_eq!(numbered(Path::new(path), step, last), Path::new(expected));
        };
        check("a/b.svg", 7, 12, "a/b-007.svg");
        check("a.b.png", 7, 12_000, "a.b-00007.png");
        check("name", 0, 3, "name-000");
    }
}
