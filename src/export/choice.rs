//! What the window offers for an export; remembered from one to the next.

use super::{Format, Order, Size, Steps};
use crate::document::AnyDocument;
use crate::figures::{Moments, views_of};
use crate::with_document;
use octoscope_core::scenario::StepAt;
use octoscope_figure::views::FigureView;
use octoscope_figure::{Background, Theme, TikzForm, Unit};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What is chosen in the dialog of an export.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Choice {
    /// What is drawn, where the scenario has that.
    pub view: FigureView,
    /// Which moments a storyboard shows.
    pub moments: MomentChoice,
    /// How many, if they are chosen by rule.
    pub n_moments: usize,
    /// Which, if they are listed, between commas.
    pub listed_moments: String,
    /// Which ray a worksheet has.
    pub exercise: ExerciseChoice,
    /// Number of the exercise, if it has one.
    pub seed: u64,
    /// Whether the fields of a worksheet are filled in.
    pub solution: bool,
    /// Format of the file.
    pub format: Format,
    /// Whether the file ends around the figure, whatever its size.
    pub extent: Extent,
    /// Width and height otherwise.
    pub sides: [f64; 2],
    /// Their unit.
    pub unit: Unit,
    /// Pixels per pixel of the page.
    pub enlarged: f64,
    /// Size of type and lines against the usual.
    pub type_scale: f64,
    /// Width of lines against that.
    pub line_scale: f64,
    /// Colours and lines.
    pub theme: Theme,
    /// Whether something lies behind the figure.
    pub background: Background,
    /// Which steps.
    pub steps: StepChoice,
    /// The steps of a range.
    pub range: [usize; 2],
    /// What is written around TikZ.
    pub tikz: TikzForm,
    /// How long each step of what moves is shown, in seconds.
    pub pause_secs: f64,
    /// Path of the file.
    pub file: String,
}

/// Where a file ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Extent {
    /// Around the figure.
    #[default]
    Cropped,
    /// Around the figure, which is laid out in a width.
    Wide,
    /// At a size.
    Sized,
}

/// Which steps are exported.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum StepChoice {
    /// The one at which the playhead stands.
    #[default]
    Here,
    /// From one to another.
    Range,
    /// All.
    All,
}

/// Which moments a storyboard shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum MomentChoice {
    /// Some of all, at even distances.
    #[default]
    Even,
    /// Those at which a leaf is reported.
    Leaves,
    /// These.
    Listed,
}

/// Which ray a worksheet has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum ExerciseChoice {
    /// That of the scenario.
    #[default]
    Own,
    /// That of an exercise with a number.
    Numbered,
}

impl Default for Choice {
    fn default() -> Self {
        Self {
            view: FigureView::default(),
            moments: MomentChoice::Even,
            n_moments: 6,
            listed_moments: String::new(),
            exercise: ExerciseChoice::Own,
            seed: 1,
            solution: false,
            format: Format::Svg,
            extent: Extent::Cropped,
            sides: [120.0, 90.0],
            unit: Unit::Millimetre,
            enlarged: 1.0,
            type_scale: 1.0,
            line_scale: 1.0,
            theme: Theme::Print,
            background: Background::Filled,
            steps: StepChoice::Here,
            range: [0, 10],
            tikz: TikzForm::Standalone,
            pause_secs: 0.5,
            file: "figure.svg".to_owned(),
        }
    }
}

impl Choice {
    /// Takes another view; where the format is one of tables, and the view is none, SVG.
    pub fn set_view(&mut self, view: FigureView) {
        self.view = view;
        if self.format.is_of_text() && view != FigureView::Table {
            self.set_format(Format::Svg);
        }
    }

    /// Takes another format; the name of the file ends as it does. What moves is
    /// of all steps, unless others are chosen.
    pub fn set_format(&mut self, format: Format) {
        let stem = match self.file.rsplit_once('.') {
            Some((stem, ending)) if Format::of_ending(ending).is_some() => stem,
            Some(_) | None => &self.file,
        };
        self.file = format!("{stem}.{}", format.ending());
        self.take_format(format);
    }

    /// Takes another name of the file, whose ending tells the format if it is one.
    pub fn set_file(&mut self, file: &str) {
        self.file = file.to_owned();
        let ending = Path::new(file.trim()).extension().unwrap_or_default().to_string_lossy();
        let Some(told) = Format::of_ending(&ending) else { return };
        // What moves as PNG does is called so, too; and TeX is a figure or a table.
        let is_apng = self.format == Format::Apng && told == Format::Png;
        let is_table =
            self.format.is_of_text() && ending.eq_ignore_ascii_case(self.format.ending());
        if told != self.format && !is_apng && !is_table {
            self.take_format(told);
        }
    }

    fn take_format(&mut self, format: Format) {
        self.format = format;
        if format.moves() && self.steps == StepChoice::Here {
            self.steps = StepChoice::All;
        }
    }

    /// The size that is asked for, within what is possible.
    pub fn size(&self) -> Option<Size> {
        let longest = Size::longest(self.unit);
        // Short numbers, and whole pixels.
        let rounded = |side: f64| match self.unit {
            Unit::Pixel => side.round(),
            Unit::Millimetre | Unit::Point => (side * 100.0).round() / 100.0,
        };
        let [width, height] = self.sides.map(|side| rounded(side).clamp(1.0, longest));
        match self.extent {
            Extent::Cropped => None,
            Extent::Wide => Some(Size { width, height: None, unit: self.unit }),
            Extent::Sized => Some(Size { width, height: Some(height), unit: self.unit }),
        }
    }

    /// What is drawn of `document`: the view in space where the chosen one has nothing
    /// to show.
    pub fn view_of(&self, document: &AnyDocument) -> FigureView {
        let views = with_document!(document, d => views_of(&d.scenario.query));
        if views.contains(&self.view) { self.view } else { FigureView::default() }
    }

    /// The moments of a storyboard, within a run of `n_events`.
    pub fn moments(&self, n_events: usize) -> Moments {
        let few = self.n_moments.clamp(1, Moments::MOST);
        match self.moments {
            MomentChoice::Even => Moments::Even(few),
            MomentChoice::Leaves => Moments::Leaves(few),
            MomentChoice::Listed => self.listed(n_events).unwrap_or_default(),
        }
    }

    /// The moments that are listed; `None` if a run of `n_events` has them not.
    pub fn listed(&self, n_events: usize) -> Option<Moments> {
        let steps: String = self.listed_moments.split_whitespace().collect();
        let moments = steps.trim_end_matches(',').parse().ok();
        moments.filter(|moments: &Moments| match moments {
            Moments::At(_) => moments.missing(n_events).is_none(),
            Moments::Even(_) | Moments::Leaves(_) => false,
        })
    }

    /// What the file is to be like, within what is possible.
    pub fn order(&self) -> Order {
        let short =
            |x: f64, [least, most]: [f64; 2]| ((x * 100.0).round() / 100.0).clamp(least, most);
        let enlarged = short(self.enlarged, [0.01, 100.0]);
        let usual = Order { format: self.format, ..Order::default() };
        // Text has no looks.
        if self.format.is_of_text() {
            return usual;
        }
        Order {
            format: self.format,
            theme: self.theme,
            background: self.background,
            size: self.size(),
            enlarged: Some(enlarged).filter(|x| self.can_be_enlarged() && *x != 1.0),
            type_scale: short(self.type_scale, [0.25, 8.0]),
            line_scale: short(self.line_scale, [0.25, 8.0]),
            tikz: if self.format == Format::Tikz { self.tikz } else { usual.tikz },
            pause_secs: match self.format.moves() {
                true => short(self.pause_secs, [0.02, 60.0]),
                false => usual.pause_secs,
            },
        }
    }

    /// The steps of `view` in a run of `n_events` of which `step` is shown.
    pub fn steps(&self, view: FigureView, step: usize, n_events: usize) -> Steps {
        let chosen = match view.is_of_a_step() {
            true if self.format.is_of_text() => StepChoice::All,
            true => self.steps,
            false => StepChoice::Here,
        };
        match chosen {
            StepChoice::Here => Steps::One(StepAt::At(step)),
            StepChoice::All => Steps::All,
            StepChoice::Range => {
                let [first, last] = self.range.map(|step| step.min(n_events));
                Steps::Range(StepAt::At(first.min(last)), StepAt::At(first.max(last)))
            }
        }
    }

    /// Whether the enlargement counts.
    pub fn can_be_enlarged(&self) -> bool {
        let on_paper = matches!(self.unit, Unit::Millimetre | Unit::Point);
        self.format.is_of_pixels() && (self.extent == Extent::Cropped || !on_paper)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_format_has_another_ending() {
        let check = |file: &str, expected: &str| {
            let mut choice = Choice { file: file.to_owned(), ..Choice::default() };
            choice.set_format(Format::Tikz);
            assert_eq!(choice.file, expected);
        };
        check("a/b.svg", "a/b.tex");
        check("b", "b.tex");
        check("v1.2", "v1.2.tex");
    }

    #[test]
    fn the_name_of_a_file_tells_its_format() {
        let mut choice = Choice::default();
        let mut check = |file: &str, format: Format, steps: StepChoice| {
            choice.set_file(file);
            assert_eq!((choice.file.as_str(), choice.format), (file, format));
            assert_eq!(choice.steps, steps, "{file}");
        };
        check("a.PDF", Format::Pdf, StepChoice::Here);
        check("a.b", Format::Pdf, StepChoice::Here);
        check("", Format::Pdf, StepChoice::Here);
        check("a.gif", Format::Gif, StepChoice::All);
        check("a.apng", Format::Apng, StepChoice::All);
        check("a.png", Format::Apng, StepChoice::All);
        check("a.tex", Format::Tikz, StepChoice::All);
        let mut table = Choice { format: Format::Latex, ..Choice::default() };
        table.set_file("a.tex");
        assert_eq!(table.format, Format::Latex);
    }

    #[test]
    fn what_moves_is_of_all_steps() {
        let mut choice = Choice::default();
        choice.set_format(Format::Pdf);
        assert_eq!(choice.steps, StepChoice::Here);
        choice.set_format(Format::Gif);
        assert_eq!(choice.steps, StepChoice::All);
        choice.steps = StepChoice::Range;
        choice.set_format(Format::Apng);
        assert_eq!(choice.steps, StepChoice::Range);
    }

    #[test]
    fn tables_are_of_all_steps_and_of_no_other_view() {
        let mut choice = Choice { view: FigureView::Table, ..Choice::default() };
        choice.set_format(Format::Latex);
        assert_eq!((choice.file.as_str(), choice.view), ("figure.tex", FigureView::Table));
        choice.set_view(FigureView::Chart);
        assert_eq!((choice.file.as_str(), choice.format), ("figure.svg", Format::Svg));
    }

    #[test]
    fn listed_moments_are_those_of_the_run() {
        let check = |text: &str, expected: Option<Vec<usize>>| {
            let choice = Choice { listed_moments: text.to_owned(), ..Choice::default() };
            assert_eq!(choice.listed(20), expected.map(Moments::At), "{text}");
        };
        check("3, 7,12", Some(vec![3, 7, 12]));
        check("3,", Some(vec![3]));
        for bad in ["", "3, x", "21", "-1", "even:3"] {
            check(bad, None);
        }
    }

    #[test]
    fn sizes_are_possible_ones() {
        let choice = Choice {
            extent: Extent::Sized,
            sides: [1e9, 0.0],
            unit: Unit::Pixel,
            ..Choice::default()
        };
        assert_eq!(choice.size().unwrap().to_string(), "16384x1px");
        let choice = Choice { sides: [33.333_333, 20.0], unit: Unit::Millimetre, ..choice };
        assert_eq!(choice.size().unwrap().to_string(), "33.33x20mm");
        let choice = Choice { extent: Extent::Wide, ..choice };
        assert_eq!(choice.size().unwrap().to_string(), "33.33mm");
    }
}
