//! `octoscope export`: figures without a window.

use super::ray::RayChoice;
use super::values::{Numbers, language};
use super::{Answer, tell};
use crate::document::Document;
use crate::export::{Format, MARGIN, PAGE, Style, bytes, left_out};
use crate::figures::{Moments, Wanted, figure_of, fitted, take_exercise};
use crate::files::Output;
use crate::open::open;
use crate::space::interesting;
use crate::with_document;
use anyhow::{anyhow, bail};
use clap::Args;
use octoscope_core::explain::sentence;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::StepAt;
use octoscope_core::text::Language;
use octoscope_core::traverse::Method;
use octoscope_figure::views::{Fields, FigureView};
use octoscope_figure::{Camera, Figure, Page, Show, Theme};
use std::io::Write;
use std::path::PathBuf;
use std::str::FromStr;

/// Writes a figure of a scenario at one of its steps.
///
/// The same arguments give the same bytes. An SVG holds its text as text and
/// the scenario as metadata. Needs no display and no graphics adapter.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope export scene:quadtree-82 --view space --step last -o figure.svg\n  \
    octoscope export lecture.octo --view space --format png --step 12 \\\n    \
        --size 1280x720 --scale 2 --theme projector -o step-12.png\n  \
    octoscope export scene:points-3d --view tree --step 40 -o tree.svg\n  \
    octoscope export scene:quadtree-82 --view t-rail --step 12 -o rail.svg\n  \
    octoscope export scene:figure-7 --view storyboard --steps leaves:6 -o story.svg\n  \
    octoscope export scene:figure-1 --view worksheet --seed 17 --lang de -o sheet.svg\n  \
    octoscope export scene:cloud --step last --camera=-30,20,1.5 --theme dark -o cloud.png")]
pub struct Export {
    /// Scenario (.octo), data file, or built-in scene as scene:NAME.
    file: PathBuf,
    /// What is drawn: space (the tree, the ray and the state of the algorithm),
    /// tree (the same as a diagram of nodes, what is off the path folded), automaton,
    /// t-rail, codes, region, neighbour, listing (with variables),
    /// table (of the steps), chart (of the costs), storyboard (several steps with
    /// their sentences) or worksheet (an exercise to be solved on paper).
    #[arg(long, value_name = "VIEW", default_value = "space")]
    view: FigureView,
    /// svg or png; without it, the ending of the output tells.
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    format: Option<Format>,
    /// Writes to this file, which appears whole or not at all; without it, to
    /// standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Number of steps that have happened, first (before all) or last; without
    /// it, where the scenario says.
    #[arg(long, value_name = "N|first|last", value_parser = step, allow_negative_numbers = true)]
    step: Option<StepAt>,
    /// Steps of a storyboard: even:N of all, leaves:N of those that report a leaf,
    /// or a list as 3,7,12.
    #[arg(long, value_name = "even:N|leaves:N|LIST", default_value = "even:6", value_parser = moments)]
    steps: Moments,
    /// Number of the exercise on a worksheet: each has another ray through the
    /// tree; without it, the ray of the scenario is the exercise.
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Fills the worksheet in.
    #[arg(long)]
    solution: bool,
    /// Traverses by this algorithm, as octoscope trace takes it.
    #[arg(long, value_name = "ID")]
    algorithm: Option<Method>,
    /// Draws this ray, as octoscope trace takes it.
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ|gallery:ID", allow_hyphen_values = true)]
    ray: Option<RayChoice>,
    /// Page in points, into which the figure is fitted; without it, the page
    /// ends around the figure.
    #[arg(long, value_name = "WIDTHxHEIGHT", allow_negative_numbers = true)]
    size: Option<Size>,
    /// Pixels per point; an SVG is shown larger by it.
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = scale, allow_negative_numbers = true)]
    scale: f64,
    /// light, dark, print or projector.
    #[arg(long, default_value = "light", value_parser = theme)]
    theme: Theme,
    /// Yaw and pitch of the eye in degrees, and a factor of 1 where everything
    /// fits. Yaw 0 looks from +x, 90 from +y; pitch 90 from above. In a
    /// quadtree only the factor counts.
    #[arg(long, value_name = "YAW,PITCH,ZOOM", allow_hyphen_values = true)]
    camera: Option<Eye>,
    /// Language of all words, and of the title inside an SVG: en or de.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = language)]
    lang: Language,
}

/// Page in points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Size {
    width: u16,
    height: u16,
}

impl Size {
    fn page(self) -> Page {
        Page { width: f64::from(self.width), height: f64::from(self.height) }
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const LARGEST: u16 = 1 << 14;
        let length = |text: &str| text.parse().ok().filter(|n| (1..=LARGEST).contains(n));
        let lengths = text.split_once(['x', 'X', '×']);
        let size = lengths.and_then(|(width, height)| {
            Some(Self { width: length(width)?, height: length(height)? })
        });
        size.ok_or_else(|| format!("give width and height from 1 to {LARGEST}, such as 1280x720"))
    }
}

/// Where the scene is looked at from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Eye {
    yaw_degrees: f64,
    pitch_degrees: f64,
    zoom: f64,
}

impl FromStr for Eye {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Numbers(numbers) = text.parse()?;
        let [yaw_degrees, pitch_degrees, zoom] = numbers[..] else {
            return Err(format!(
                "there are {} numbers; give three: yaw and pitch in degrees, zoom",
                numbers.len()
            ));
        };
        if !(-90.0..=90.0).contains(&pitch_degrees) {
            return Err(format!("the pitch is {pitch_degrees}; give degrees from -90 to 90"));
        }
        if !(0.01..=100.0).contains(&zoom) {
            return Err(format!("the zoom is {zoom}; give a factor from 0.01 to 100"));
        }
        Ok(Self { yaw_degrees, pitch_degrees, zoom })
    }
}

impl Eye {
    fn camera<const D: usize>(self, document: &Document<D>, page: Page) -> Camera<D> {
        let bounds = interesting(document);
        let mut camera = Camera::framing(&bounds, page);
        camera.yaw = self.yaw_degrees.rem_euclid(360.0).to_radians();
        camera.pitch = self.pitch_degrees.to_radians();
        camera.frame(&bounds, page);
        camera.height /= self.zoom;
        camera
    }
}

fn format(id: &str) -> Result<Format, String> {
    Format::of_ending(id)
        .ok_or_else(|| format!("there is no format ‘{id}’ to export to; there are svg and png"))
}

fn step(text: &str) -> Result<StepAt, String> {
    match text {
        "first" => Ok(StepAt::First),
        "last" => Ok(StepAt::Last),
        _ => text.parse().map(StepAt::At).map_err(|_| {
            format!("‘{text}’ is no single step; give a number from 0, first or last")
        }),
    }
}

fn moments(text: &str) -> Result<Moments, String> {
    let few = |n: &str| n.parse().ok().filter(|n| (1..=Moments::MOST).contains(n));
    let parsed = match text.split_once(':') {
        Some(("even", n)) => few(n).map(Moments::Even),
        Some(("leaves", n)) => few(n).map(Moments::Leaves),
        Some(_) => None,
        None => {
            let steps: Result<Vec<usize>, _> = text.split(',').map(|n| n.trim().parse()).collect();
            steps.ok().filter(|steps| steps.len() <= Moments::MOST).map(Moments::At)
        }
    };
    parsed.ok_or_else(|| {
        format!("give even:N, leaves:N or a list as 3,7,12, of at most {} steps", Moments::MOST)
    })
}

fn scale(text: &str) -> Result<f64, String> {
    let scale = text.parse().ok().filter(|scale| (0.01..=100.0).contains(scale));
    scale.ok_or_else(|| "give a factor from 0.01 to 100, such as 2".to_owned())
}

fn theme(id: &str) -> Result<Theme, String> {
    Theme::ALL.into_iter().find(|theme| theme.id() == id).ok_or_else(|| {
        let known = Theme::ALL.map(Theme::id).join(", ");
        format!("there is no theme ‘{id}’; there are {known}")
    })
}

/// Runs the command.
///
/// # Errors
/// Says what is wrong with the file or the arguments.
pub fn export(arguments: &Export) -> anyhow::Result<Answer> {
    let format = chosen_format(arguments)?;
    let mut document = open(&arguments.file, &Progress::default())?;
    with_document!(&mut document, document => aim(document, arguments)?);
    with_document!(&mut document, document => document.trace_whole());
    let n_steps = document.n_events();
    if let Some(StepAt::At(step)) = arguments.step
        && step > n_steps
    {
        bail!("there is no step {step}; give one from 0 to {n_steps}, first or last");
    }
    if let Moments::At(steps) = &arguments.steps
        && let Some(step) = steps.iter().find(|step| **step > n_steps)
    {
        bail!("there is no step {step}; give steps from 0 to {n_steps}");
    }
    let saved = with_document!(&document, document => document.opened().step);
    let step = arguments.step.unwrap_or(saved).position(n_steps);
    let (figure, title) = with_document!(&document, document => {
        let title = sentence(
            &document.tree, &document.scenario.ray, &document.trace, step, arguments.lang,
        );
        (figure(document, arguments, step)?, title.plain())
    });
    let (figure, fit) = match arguments.size {
        Some(size) if arguments.view != FigureView::Space => fitted(figure, size.page()),
        Some(_) | None => (figure, 1.0),
    };
    if let Some(note) = with_document!(&document, d => left_out_of(d, arguments)) {
        tell(&note);
    }
    let style =
        Style { format, theme: arguments.theme, scale: arguments.scale * fit, title: &title };
    let bytes = bytes(&figure, style, &document.scenario_at(step))?;
    let mut output = Output::open(arguments.output.as_deref())?;
    output.write_all(&bytes)?;
    output.finish()?;
    Ok(Answer::Done)
}

fn chosen_format(arguments: &Export) -> anyhow::Result<Format> {
    if let Some(format) = arguments.format {
        return Ok(format);
    }
    let name = arguments.output.as_deref();
    let Some(ending) = name.and_then(|name| name.extension()) else {
        bail!("the format is not told; give --format svg or --format png");
    };
    let ending = ending.to_string_lossy();
    Format::of_ending(&ending).ok_or_else(|| {
        anyhow!(
            "‘.{ending}’ is no format of figures; end the name in .svg or .png, or give --format"
        )
    })
}

/// Takes the ray and the algorithm of the command line.
fn aim<const D: usize>(document: &mut Document<D>, arguments: &Export) -> anyhow::Result<()> {
    if let Some(choice) = &arguments.ray {
        choice.aim(document)?;
    }
    if let Some(method) = arguments.algorithm {
        document.scenario.query = document.scenario.query.along_the_ray_by(method);
    }
    document.refresh(0);
    if let (FigureView::Worksheet, Some(number)) = (arguments.view, arguments.seed) {
        take_exercise(document, number)?;
    }
    Ok(())
}

fn left_out_of<const D: usize>(document: &Document<D>, arguments: &Export) -> Option<String> {
    match arguments.view {
        FigureView::Space | FigureView::Storyboard | FigureView::Worksheet => {
            left_out(document, &Show::at_first::<D>())
        }
        FigureView::Tree
        | FigureView::Automaton
        | FigureView::TRail
        | FigureView::Codes
        | FigureView::Region
        | FigureView::Neighbour
        | FigureView::Listing
        | FigureView::Table
        | FigureView::Chart => None,
    }
}

fn figure<const D: usize>(
    document: &Document<D>,
    arguments: &Export,
    step: usize,
) -> anyhow::Result<Figure> {
    let page = arguments.size.map_or(PAGE, Size::page);
    let wanted = Wanted {
        view: arguments.view,
        step,
        moments: arguments.steps.clone(),
        exercise: (arguments.seed, if arguments.solution { Fields::Solved } else { Fields::Empty }),
        page,
        unfolded: Vec::new(),
        camera: arguments.camera.map(|eye| eye.camera(document, page)),
        show: Show::at_first::<D>(),
        language: arguments.lang,
    };
    let figure = figure_of(document, &wanted)?;
    let is_whole = arguments.view != FigureView::Space || arguments.size.is_some();
    Ok(if is_whole { figure } else { figure.cropped(MARGIN) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_width_and_height() {
        assert_eq!("640x480".parse(), Ok(Size { width: 640, height: 480 }));
        for bad in ["640", "640x", "0x480", "-1x5", "640x99999", "a4", "640x480x2"] {
            assert!(bad.parse::<Size>().is_err(), "{bad}");
        }
    }

    #[test]
    fn the_eye_has_three_numbers_within_bounds() {
        let eye = Eye { yaw_degrees: -30.0, pitch_degrees: 20.0, zoom: 1.5 };
        assert_eq!("-30,20,1.5".parse(), Ok(eye));
        for bad in ["-30,20", "1,2,3,4", "0,91,1", "0,0,0", "0,0,-1", "0,0,nan", "a,b,c"] {
            assert!(bad.parse::<Eye>().is_err(), "{bad}");
        }
    }

    #[test]
    fn steps_are_numbers_first_or_last() {
        assert_eq!(step("12"), Ok(StepAt::At(12)));
        assert_eq!(step("last"), Ok(StepAt::Last));
        for bad in ["all", "-1", "1.5", ""] {
            assert!(step(bad).unwrap_err().contains("first or last"), "{bad}");
        }
    }
}
