//! One export, whole: what the window and the command line ask for alike.

use super::table::table;
use super::{Order, Series, Steps, write};
use crate::comparison::MOST_TESTED;
use crate::document::{AnyDocument, Document};
use crate::eye::Eye;
use crate::figures::{Moments, Wanted, figure_of, left_out, take_exercise};
use crate::files::Output;
use crate::kept_view::{keep_eye, keep_show};
use crate::save;
use crate::shown::print_shown;
use crate::text::texts;
use crate::with_document;
use anyhow::bail;
use octoscope_core::explain::{Notation, sentence};
use octoscope_core::progress::Progress;
use octoscope_core::text::{Language, Texts};
use octoscope_figure::views::{Fields, FigureView, ViewError, rows_of_table};
use octoscope_figure::{Background, Figure, Page, Show, TikzForm};
use std::ops::RangeInclusive;
use std::path::Path;

/// What is exported of a document, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// What is drawn.
    pub view: FigureView,
    /// What the file is like.
    pub order: Order,
    /// The steps.
    pub steps: Steps,
    /// The moments of a storyboard.
    pub moments: Moments,
    /// Number of the exercise on a worksheet, and what is in its fields.
    pub exercise: (Option<u64>, Fields),
    /// Where the scene is looked at from; without it, everything is seen.
    pub eye: Option<Eye>,
    /// What is shown; without it, what is shown at first.
    pub show: Option<Show>,
    /// Language of all words, and of the title.
    pub language: Language,
    /// How formulas are written.
    pub notation: Notation,
}

impl Request {
    /// Writes the files: to `path`, else to standard output.
    ///
    /// # Errors
    /// Says what cannot be drawn or written; tells if it was cancelled.
    pub fn run(
        &self,
        document: &AnyDocument,
        path: Option<&Path>,
        progress: &Progress,
    ) -> anyhow::Result<()> {
        if self.order.format.is_of_text() {
            let mut output = Output::open(path)?;
            output.put(self.text(document)?.as_bytes())?;
            return output.finish();
        }
        let folder = path.map(|path| path.parent().unwrap_or(Path::new("")));
        self.with_series(document, self.steps, folder, progress, |series| {
            write(&self.order, series, path, progress)
        })
    }

    /// The table of all steps as text.
    ///
    /// # Errors
    /// Refuses other views, and some of the steps.
    pub fn text(&self, document: &AnyDocument) -> anyhow::Result<String> {
        let format = self.order.format;
        if self.view != FigureView::Table {
            let view = self.view;
            bail!("{} is for the view ‘table’, not ‘{view}’; give --view table", format.name());
        }
        if self.steps != Steps::All {
            bail!("{} holds all steps; leave --step out", format.name());
        }
        with_document!(document, d => table(d, format, self.language))
    }

    /// The figures of these steps of a document, whose scenario names its data file from
    /// `folder`, or as it does now.
    pub(super) fn with_series<T>(
        &self,
        document: &AnyDocument,
        steps: Steps,
        folder: Option<&Path>,
        progress: &Progress,
        then: impl FnOnce(&Series) -> anyhow::Result<T>,
    ) -> anyhow::Result<T> {
        let document = &self.shown_document(document, progress)?;
        let caption = |step| {
            if !self.view.is_of_a_step() {
                return texts(self.language).get(&format!("figure-{}", self.view)).into();
            }
            with_document!(document, d => {
                sentence(&d.tree, &d.scenario.ray, &d.trace, step, self.language)
            })
        };
        let scenario = |step| {
            let mut scenario = document.scenario_at(step);
            if let Some(show) = &self.show {
                keep_show(&mut scenario, show);
            }
            if self.eye.is_some() {
                keep_eye(&mut scenario, self.eye.as_ref());
            }
            match folder {
                Some(folder) => save::named_from(document, scenario, folder).print(),
                None => scenario.print(),
            }
        };
        let n_events = document.n_events();
        if let Some(step) = self.moments.missing(n_events) {
            bail!("there is no step {step}; give steps from 0 to {n_events}");
        }
        then(&Series {
            steps: self.shown_of(document, steps)?,
            figure: &|page, step| with_document!(document, d => self.figure(d, page, step)),
            caption: &caption,
            scenario: &scenario,
        })
    }

    /// The document with all that its figures show, and with the question of a worksheet,
    /// if one is asked for.
    fn shown_document(
        &self,
        document: &AnyDocument,
        progress: &Progress,
    ) -> anyhow::Result<AnyDocument> {
        let mut shown = document.clone();
        if self.view == FigureView::Worksheet {
            with_document!(&mut shown, d => take_exercise(d, self.exercise.0)?);
        }
        if self.marks_results() {
            with_document!(&mut shown, d => d.find_right_nodes(progress))?;
        }
        Ok(shown)
    }

    /// The numbers of these steps; of all, those from the first with something to show.
    /// Of a view that is not of one step, the first.
    fn shown_of(
        &self,
        document: &AnyDocument,
        steps: Steps,
    ) -> anyhow::Result<RangeInclusive<usize>> {
        if self.view == FigureView::Worksheet && self.exercise.0.is_some() {
            return Ok(0..=0);
        }
        let numbers = steps.numbers(document.n_events())?;
        if !self.view.is_of_a_step() {
            return Ok(*numbers.start()..=*numbers.start());
        }
        let (start, last) = (*numbers.start(), *numbers.end());
        if steps != Steps::All {
            return Ok(numbers);
        }
        let page = self.order.page();
        let shown = with_document!(document, d => self.figure(d, page, start));
        let first = shown.err().and_then(|error| match error.downcast_ref() {
            Some(ViewError::Step { first, .. }) => Some(*first),
            Some(ViewError::Query { .. } | ViewError::Never { .. }) | None => None,
        });
        Ok(first.unwrap_or(start)..=last)
    }

    fn figure<const D: usize>(
        &self,
        document: &Document<D>,
        page: Page,
        step: usize,
    ) -> anyhow::Result<Figure> {
        let camera = self.eye.as_ref().map(|eye| eye.camera(document, page)).transpose()?;
        let wanted = Wanted {
            view: self.view,
            step,
            moments: self.moments.clone(),
            exercise: self.exercise,
            page,
            column: self.order.column(),
            camera,
            show: self.show::<D>(),
            language: self.language,
            notation: self.notation,
        };
        figure_of(document, &wanted)
    }

    /// What the figure leaves out, in words, if anything.
    pub fn left_out<const D: usize>(
        &self,
        document: &Document<D>,
        texts: &Texts,
    ) -> Option<String> {
        let mut told = Vec::new();
        if self.view.shows_space() {
            told = left_out(document, &self.show::<D>(), texts);
        }
        if let Ok(steps) = self.steps.numbers(document.trace.events.len()) {
            let last = *steps.end();
            told.extend(self.last_rows(last).map(|shown| {
                let numbers = [("shown", shown.count().into()), ("steps", last.into())];
                texts.format("left-out-rows", &numbers)
            }));
        }
        if self.marks_results() && document.is_unjudged() {
            told.push(texts.format("left-out-right", &[("most", MOST_TESTED.into())]));
        }
        (!told.is_empty()).then(|| told.join("; "))
    }

    /// The steps that the table of those up to `step` shows, where it has not room for all.
    pub fn last_rows(&self, step: usize) -> Option<RangeInclusive<usize>> {
        let is_figure = self.view == FigureView::Table && !self.order.format.is_of_text();
        Some(rows_of_table(step)).filter(|shown| is_figure && *shown.start() > 1)
    }

    /// Whether the figure marks what a misprint reports and should not.
    fn marks_results(&self) -> bool {
        let is_solved = self.view != FigureView::Worksheet;
        self.view.shows_space() && is_solved || self.view == FigureView::Tree
    }

    /// What is shown of a tree of dimension D.
    pub fn show<const D: usize>(&self) -> Show {
        self.show.unwrap_or_else(Show::at_first::<D>)
    }

    /// The command that does the same with the scenario called `file`, along the
    /// ray of these numbers if they are given.
    pub fn command(&self, file: &str, ray: Option<&[f64]>, output: &str) -> Vec<String> {
        let Self { view, order, steps, moments, exercise, eye, show, language, notation } = self;
        let mut words = vec!["octoscope".to_owned(), "export".to_owned(), file.to_owned()];
        let mut option = |name: &str, value: String| words.push(format!("--{name}={value}"));
        option("view", view.id().to_owned());
        option("format", order.format.id().to_owned());
        option("step", steps.to_string());
        if *moments != Moments::default() {
            option("steps", moments.to_string());
        }
        let (number, fields) = exercise;
        if let Some(number) = number {
            option("seed", number.to_string());
        }
        if let Some(ray) = ray {
            let numbers: Vec<_> = ray.iter().map(|x| format!("{x:?}")).collect();
            option("ray", numbers.join(","));
        }
        if let Some(size) = order.size {
            option("size", size.to_string());
        }
        if let Some(enlarged) = order.enlarged {
            option("scale", enlarged.to_string());
        }
        let usual = Order::default();
        if order.type_scale != usual.type_scale {
            option("type-scale", order.type_scale.to_string());
        }
        if order.line_scale != usual.line_scale {
            option("line-scale", order.line_scale.to_string());
        }
        if order.theme != usual.theme {
            option("theme", order.theme.id().to_owned());
        }
        if order.pause_secs != usual.pause_secs {
            option("pause", order.pause_secs.to_string());
        }
        if let Some(eye) = eye {
            option("camera", eye.to_string());
        }
        if let Some(show) = show {
            option("show", print_shown(show));
        }
        if *language != Language::default() {
            option("lang", language.id().to_owned());
        }
        if *notation != Notation::default() {
            option("notation", notation.to_string());
        }
        let flags = [
            ("--solution", *fields == Fields::Solved),
            ("--transparent", order.background == Background::Transparent),
            ("--beamer", matches!(order.tikz, TikzForm::Beamer | TikzForm::BeamerSnippet)),
            ("--snippet", matches!(order.tikz, TikzForm::Snippet | TikzForm::BeamerSnippet)),
        ];
        words
            .extend(flags.into_iter().filter(|(_, is_on)| *is_on).map(|(flag, _)| flag.to_owned()));
        words.extend(["-o".to_owned(), output.to_owned()]);
        words
    }
}

/// Words as a shell reads them.
pub fn shell_line(words: &[String]) -> String {
    let quoted = words.iter().map(|word| {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,@+%".contains(c);
        if !word.is_empty() && word.chars().all(is_plain) {
            word.clone()
        } else {
            format!("'{}'", word.replace('\'', "'\\''"))
        }
    });
    quoted.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests;
