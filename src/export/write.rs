//! Figures of steps → files.

use super::{Format, Order};
use crate::files::Output;
use anyhow::{Context, bail};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_figure::{Apng, Extent, Figure, FileOptions, Gif, Page, Pdf, Pixels, Tikz, png, svg};
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// What is exported: figures of the steps of one run, made when they are needed.
pub struct Series<'a> {
    /// The steps.
    pub steps: RangeInclusive<usize>,
    /// Figure of a step, laid out on a page.
    pub figure: &'a dyn Fn(Page, usize) -> Figure,
    /// What happens in a step, in words.
    pub title: &'a dyn Fn(usize) -> String,
    /// The scenario with the playhead at a step, as JSON.
    pub scenario: &'a dyn Fn(usize) -> String,
}

impl Series<'_> {
    /// The figure of one step, on the page that it has in a file of all.
    pub(super) fn figure_of(
        order: &Order,
        series: &Series,
        step: usize,
        progress: &Progress,
    ) -> anyhow::Result<Figure> {
        let one = Series { steps: step..=step, ..*series };
        Ok(Frames::of(order, &one, progress)?.figure(&one, step))
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
    let is_cropped = order.size.is_none();
    progress.start(if is_cropped { 2 * n_steps } else { n_steps });
    let frames = Frames::of(order, series, progress)?;
    if first == last || order.format.holds_steps() {
        let mut output = Output::open(path)?;
        output.write_all(&bytes(order, series, &frames, progress)?).with_context(|| place(path))?;
        return output.finish();
    }
    let Some(path) = path else {
        bail!("these are {n_steps} files; give the name of the first with -o");
    };
    for step in first..=last {
        let one = Series { steps: step..=step, ..*series };
        let mut output = Output::open(Some(&numbered(path, step, last)))?;
        output
            .write_all(&bytes(order, &one, &frames, progress)?)
            .with_context(|| place(Some(path)))?;
        output.finish()?;
    }
    Ok(())
}

fn place(path: Option<&Path>) -> String {
    path.map_or_else(|| "standard output".to_owned(), |path| path.display().to_string())
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
#[derive(Clone, Copy, Debug)]
pub(super) struct Frames {
    page: Page,
    extent: Option<Extent>,
}

impl Frames {
    /// The page around all figures, or the one of the size that is asked for.
    pub(super) fn of(
        order: &Order,
        series: &Series,
        progress: &Progress,
    ) -> Result<Self, Cancelled> {
        let page = order.page();
        let mut extent: Option<Extent> = None;
        if order.size.is_none() {
            for step in series.steps.clone() {
                let found = (series.figure)(page, step).extent();
                extent = match (extent, found) {
                    (Some(a), Some(b)) => Some(a.and(b)),
                    (a, b) => a.or(b),
                };
                progress.advance(1)?;
            }
        }
        Ok(Self { page, extent })
    }

    pub(super) fn figure(&self, series: &Series, step: usize) -> Figure {
        let figure = (series.figure)(self.page, step);
        match self.extent {
            Some(extent) => figure.on(extent, Order::MARGIN),
            None => figure,
        }
    }
}

/// One file of the series.
fn bytes(
    order: &Order,
    series: &Series,
    frames: &Frames,
    progress: &Progress,
) -> anyhow::Result<Vec<u8>> {
    let first = *series.steps.start();
    let (title, scenario) = ((series.title)(first), (series.scenario)(first));
    let options = FileOptions {
        theme: order.theme,
        background: order.background,
        title: &title,
        scenario: &scenario,
        scale: order.scale(),
    };
    let mut figures = series.steps.clone().map(|step| -> Result<Figure, Cancelled> {
        progress.advance(1)?;
        Ok(frames.figure(series, step))
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
            for figure in figures {
                tikz.figure(&figure?);
            }
            Ok(tikz.finish().into_bytes())
        }
        Format::Gif => {
            let (mut file, pause) = (Vec::new(), order.pause_secs);
            let mut gif = Gif::begin(&mut file, &samples(series, frames, &options)?, pause)?;
            for figure in figures {
                gif.frame(Pixels::of(&figure?, &options)?)?;
            }
            gif.finish()?;
            Ok(file)
        }
        Format::Apng => {
            let Some(first) = figures.next() else { bail!("there is no step to draw") };
            let (mut file, pause) = (Vec::new(), order.pause_secs);
            let n_frames = u32::try_from(series.steps.clone().count())?;
            let first = Pixels::of(&first?, &options)?;
            let mut apng = Apng::begin(&mut file, first, n_frames, pause, &options)?;
            for figure in figures {
                apng.frame(Pixels::of(&figure?, &options)?)?;
            }
            apng.finish()?;
            Ok(file)
        }
    }
}

/// Some frames, from the first to the last, in which all colours are seen.
fn samples(series: &Series, frames: &Frames, options: &FileOptions) -> anyhow::Result<Vec<Pixels>> {
    const MOST: usize = 6;
    let (first, last) = (*series.steps.start(), *series.steps.end());
    let mut steps: Vec<usize> =
        (0..MOST).map(|i| first + (last - first) * i / (MOST - 1)).collect();
    steps.dedup();
    let pixels =
        steps.into_iter().map(|step| Ok(Pixels::of(&frames.figure(series, step), options)?));
    pixels.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
