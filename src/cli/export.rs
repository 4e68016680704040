//! `octoscope export`: figures without a window.

use super::ray::RayChoice;
use super::values::{Numbers, language};
use super::{Answer, tell};
use crate::document::Document;
use crate::export::{Format, Order, Series, Size, Steps, left_out, space, write};
use crate::open::open;
use crate::space::interesting;
use crate::with_document;
use anyhow::{anyhow, bail};
use clap::Args;
use octoscope_core::explain::sentence;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::StepAt;
use octoscope_core::text::Language;
use octoscope_figure::{Background, Camera, Figure, Page, Show, Theme, TikzForm};
use std::path::PathBuf;
use std::str::FromStr;

/// Writes a figure of a scenario at one of its steps, or at several.
///
/// The same arguments give the same bytes. An SVG, PDF, PNG or TikZ file holds
/// the scenario, which Octoscope opens again. Of several steps, a PDF has a page
/// each, TikZ a picture, GIF and APNG a frame; of SVG and PNG there is a file
/// each, with the number of the step in its name. Needs no display and no
/// graphics adapter.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope export scene:quadtree-82 --view space --step last -o figure.svg\n  \
    octoscope export scene:quadtree-82 --step 12 --size 120x80mm -o figure.pdf\n  \
    octoscope export lecture.octo --step all --beamer -o slides.tex\n  \
    octoscope export lecture.octo --step 0-40 --pause 0.3 -o steps.gif\n  \
    octoscope export lecture.octo --view space --format png --step 12 \\\n    \
        --size 1280x720 --scale 2 --theme projector -o step-12.png\n  \
    octoscope export scene:cloud --step last --camera=-30,20,1.5 --theme dark -o cloud.png")]
pub struct Export {
    /// Scenario (.octo), exported figure, data file, or built-in scene as
    /// scene:NAME.
    pub file: PathBuf,
    /// What is drawn: space (the tree, the ray and the state of the algorithm).
    #[arg(long, value_name = "VIEW", default_value = "space")]
    view: View,
    /// svg, pdf, png, tikz, gif or apng; without it, the ending of the output
    /// tells.
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    format: Option<Format>,
    /// Writes to this file, which appears whole or not at all; without it, to
    /// standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Number of steps that have happened, first (before all) or last, a range
    /// such as 3-12, or all; without it, where the scenario says, and all for gif
    /// and apng.
    #[arg(long, value_name = "N|first|last|A-B|all", allow_negative_numbers = true)]
    step: Option<Steps>,
    /// Draws this ray, as octoscope trace takes it.
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ|gallery:ID", allow_hyphen_values = true)]
    ray: Option<RayChoice>,
    /// Extent in mm, pt or px (without a unit), into which the figure is
    /// fitted; without it, the file ends around the figure.
    #[arg(long, value_name = "WIDTHxHEIGHT[UNIT]", allow_negative_numbers = true)]
    size: Option<Size>,
    /// Enlarges the file so many times. Of a PNG whose size is in mm or pt, the
    /// pixels per point; without it, it has 300 dots per inch.
    #[arg(long, value_name = "FACTOR", value_parser = scale, allow_negative_numbers = true)]
    scale: Option<f64>,
    /// Size of type and lines against the usual, on a page of the same size.
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = type_scale, allow_negative_numbers = true)]
    type_scale: f64,
    /// light, dark, print or projector.
    #[arg(long, default_value = "print", value_parser = theme)]
    theme: Theme,
    /// Leaves out what lies behind the figure.
    #[arg(long)]
    transparent: bool,
    /// How long each step is shown in gif and apng, in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "0.5", value_parser = pause, allow_negative_numbers = true)]
    pause: f64,
    /// Writes TikZ for slides: one frame, an overlay a step.
    #[arg(long)]
    beamer: bool,
    /// Writes TikZ to be put into a document, not a document of its own.
    #[arg(long)]
    snippet: bool,
    /// Yaw and pitch of the eye in degrees, and a factor of 1 where everything
    /// fits. Yaw 0 looks from +x, 90 from +y; pitch 90 from above. In a
    /// quadtree only the factor counts.
    #[arg(long, value_name = "YAW,PITCH,ZOOM", allow_hyphen_values = true)]
    camera: Option<Eye>,
    /// Language of the title inside a file: en or de.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = language)]
    lang: Language,
}

/// What can be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum View {
    /// The tree, the ray and the state of the algorithm.
    Space,
}

impl FromStr for View {
    type Err = String;

    fn from_str(id: &str) -> Result<Self, String> {
        if id == "space" {
            return Ok(Self::Space);
        }
        Err(format!("there is no view ‘{id}’ to export; there is space"))
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
    Format::of_id(id).ok_or_else(|| {
        format!("there is no format ‘{id}’ to export to; there are {}", Format::known())
    })
}

fn scale(text: &str) -> Result<f64, String> {
    let scale = text.parse().ok().filter(|scale| (0.01..=100.0).contains(scale));
    scale.ok_or_else(|| "give a factor from 0.01 to 100, such as 2".to_owned())
}

fn type_scale(text: &str) -> Result<f64, String> {
    let scale = text.parse().ok().filter(|scale| (0.25..=8.0).contains(scale));
    scale.ok_or_else(|| "give a factor from 0.25 to 8, such as 1.5".to_owned())
}

fn pause(text: &str) -> Result<f64, String> {
    let pause = text.parse().ok().filter(|pause| (0.02..=60.0).contains(pause));
    pause.ok_or_else(|| "give seconds from 0.02 to 60, such as 0.5".to_owned())
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
    let order = arguments.order()?;
    let progress = Progress::default();
    let mut document = open(&arguments.file, &progress)?;
    if let Some(choice) = &arguments.ray {
        with_document!(&mut document, document => {
            choice.aim(document)?;
            document.refresh(0);
        });
    }
    let saved = with_document!(&document, document => document.opened().step);
    let steps = match arguments.step {
        Some(steps) => steps,
        None if order.format.moves() => Steps::All,
        None => Steps::One(StepAt::At(saved.position(document.n_events()))),
    };
    if let Some(note) = with_document!(&document, d => left_out_of(d)) {
        tell(&note);
    }
    let title = |step| {
        with_document!(&document, d => {
            sentence(&d.tree, &d.scenario.ray, &d.trace, step, arguments.lang).plain()
        })
    };
    let series = Series {
        steps: steps.numbers(document.n_events())?,
        figure: &|page, step| with_document!(&document, d => figure(d, arguments, page, step)),
        title: &title,
        scenario: &|step| document.scenario_at(step).print(),
    };
    write(&order, &series, arguments.output.as_deref(), &progress)?;
    Ok(Answer::Done)
}

impl Export {
    /// What the file is to be like.
    fn order(&self) -> anyhow::Result<Order> {
        let format = chosen_format(self)?;
        if (self.beamer || self.snippet) && format != Format::Tikz {
            let option = if self.beamer { "--beamer" } else { "--snippet" };
            bail!("{option} is for TikZ; give --format tikz, or leave it out");
        }
        let tikz = match (self.beamer, self.snippet) {
            (false, false) => TikzForm::Standalone,
            (false, true) => TikzForm::Snippet,
            (true, false) => TikzForm::Beamer,
            (true, true) => TikzForm::BeamerSnippet,
        };
        let background =
            if self.transparent { Background::Transparent } else { Background::Filled };
        Ok(Order {
            format,
            theme: self.theme,
            background,
            size: self.size,
            enlarged: self.scale,
            type_scale: self.type_scale,
            tikz,
            pause_secs: self.pause,
        })
    }
}

fn chosen_format(arguments: &Export) -> anyhow::Result<Format> {
    if let Some(format) = arguments.format {
        return Ok(format);
    }
    let name = arguments.output.as_deref();
    let Some(ending) = name.and_then(|name| name.extension()) else {
        bail!("the format is not told; give --format with one of {}", Format::known());
    };
    let ending = ending.to_string_lossy();
    Format::of_ending(&ending).ok_or_else(|| {
        anyhow!(
            "‘.{ending}’ is no ending of figures; give --format with one of {}",
            Format::known()
        )
    })
}

fn left_out_of<const D: usize>(document: &Document<D>) -> Option<String> {
    left_out(document, &Show::at_first::<D>())
}

fn figure<const D: usize>(
    document: &Document<D>,
    arguments: &Export,
    page: Page,
    step: usize,
) -> Figure {
    let View::Space = arguments.view;
    let camera = arguments.camera.map(|eye| eye.camera(document, page));
    space(document, camera, page, &Show::at_first::<D>(), step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_eye_has_three_numbers_within_bounds() {
        let eye = Eye { yaw_degrees: -30.0, pitch_degrees: 20.0, zoom: 1.5 };
        assert_eq!("-30,20,1.5".parse(), Ok(eye));
        for bad in ["-30,20", "1,2,3,4", "0,91,1", "0,0,0", "0,0,-1", "0,0,nan", "a,b,c"] {
            assert!(bad.parse::<Eye>().is_err(), "{bad}");
        }
    }
}
