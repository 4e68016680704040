//! Figures of steps → files.

use super::frames::Frames;
use super::made::Made;
use super::moving::each_frame;
use super::{Format, Order};
use crate::files::{Output, is_standard};
use anyhow::bail;
use octoscope_core::explain::RichText;
use octoscope_core::progress::Progress;
use octoscope_figure::{Apng, Figure, FileOptions, Gif, Page, Pdf, Pixels, Scale, Tikz, png, svg};
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

    /// Figures of a line on the page that is offered.
    fn on_page(page: Page, step: usize) -> anyhow::Result<Figure> {
        let form = Form::Circle { centre: [100.0 + 10.0 * step as f64, 50.0], radius: 20.0 };
        let drawn = Drawn { form, role: Role::Touch, part: Part::Whole, node: None };
        Ok(Figure { page, drawn: vec![drawn] })
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
