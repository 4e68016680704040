//! `octoscope export`: figures without a window.

mod stray;

use self::stray::refuse_stray;
use super::progress::run_with_progress;
use super::ray::RayChoice;
use super::values::{language, theme};
use super::{Answer, tell};
use crate::document::Document;
use crate::export::{Format, Order, Request, Size, Steps};
use crate::eye::Eye;
use crate::figures::Moments;
use crate::kept_view::{kept_eye, kept_show};
use crate::open::open;
use crate::shown::parse_shown;
use crate::text::texts;
use crate::with_document;
use anyhow::{anyhow, bail};
use clap::Args;
use octoscope_core::explain::Notation;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::StepAt;
use octoscope_core::text::Language;
use octoscope_core::traverse::Method;
use octoscope_figure::views::{Fields, FigureView};
use octoscope_figure::{Background, Show, Theme, TikzForm};
use std::path::PathBuf;

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
    octoscope export scene:points-3d --view tree --step 40 -o tree.svg\n  \
    octoscope export scene:quadtree-82 --view t-rail --step 12 -o rail.svg\n  \
    octoscope export scene:quadtree-82 --view formula --step 12 --notation revelles -o f.tex\n  \
    octoscope export scene:figure-7 --view table --format latex --lang de -o steps.tex\n  \
    octoscope export scene:figure-7 --view storyboard --steps leaves:6 -o story.svg\n  \
    octoscope export scene:figure-1 --view worksheet --seed 17 --lang de -o sheet.svg\n  \
    octoscope export scene:cloud --step last --camera=-30,20,1.5 --theme dark -o cloud.png")]
pub struct Export {
    /// Scenario (.octo), exported figure, data file, or built-in scene as
    /// scene:NAME.
    pub file: PathBuf,
    /// What is drawn: space (the tree, the ray and the state of the algorithm),
    /// tree (the same as a diagram of nodes, what is off the path folded), automaton,
    /// t-rail, codes, region, neighbour, listing (with variables),
    /// table (of the steps), chart (of the costs), formula (of the step), storyboard
    /// (several steps with their sentences) or worksheet (an exercise to be solved on
    /// paper).
    #[arg(long, value_name = "VIEW", default_value = "space")]
    view: FigureView,
    /// svg, pdf, png, tikz, gif or apng; for the view table also markdown, csv or
    /// latex, a table of all steps as text; without it, the ending of the output
    /// tells.
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    format: Option<Format>,
    /// Writes to this file, which appears whole or not at all; without it, or to
    /// ‘-’, to standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Number of steps that have happened, first (before all) or last, a range
    /// such as 3-12, or all; without it, where the scenario says, all for gif and
    /// apng, and the last for table and chart unless the scenario says a later one
    /// than the first.
    #[arg(long, value_name = "N|first|last|A-B|all", allow_hyphen_values = true)]
    step: Option<Steps>,
    /// Steps of a storyboard: even:N of all, leaves:N of those that report a leaf,
    /// or a list as 3,7,12; without it, even:6.
    #[arg(long, value_name = "even:N|leaves:N|LIST", allow_hyphen_values = true)]
    steps: Option<Moments>,
    /// Number of the exercise on a worksheet: each has another ray through the
    /// tree; without it, the ray of the scenario is the exercise.
    #[arg(long, value_name = "N", value_parser = seed, allow_hyphen_values = true)]
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
    /// Extent in mm, pt or px (without a unit), into which the figure is
    /// fitted; or a width with its unit, such as 85mm for a column, in which the figure
    /// is laid out, as high as it then is; without it, the file ends around the figure.
    #[arg(long, value_name = "WIDTH[xHEIGHT][UNIT]", allow_hyphen_values = true)]
    size: Option<Size>,
    /// Enlarges the file so many times. Of a PNG whose size is in mm or pt, the
    /// pixels per point; without it, it has 300 dots per inch.
    #[arg(long, value_name = "FACTOR", value_parser = scale, allow_hyphen_values = true)]
    scale: Option<f64>,
    /// Size of type and lines against the usual, on a page of the same size; without it, 1.
    #[arg(long, value_name = "FACTOR", value_parser = type_scale, allow_hyphen_values = true)]
    type_scale: Option<f64>,
    /// Width of lines against that; without it, 1.
    #[arg(long, value_name = "FACTOR", value_parser = type_scale, allow_hyphen_values = true)]
    line_scale: Option<f64>,
    /// light, dark, print or projector; without it, print.
    #[arg(long, value_parser = theme)]
    theme: Option<Theme>,
    /// Leaves out what lies behind the figure.
    #[arg(long)]
    transparent: bool,
    /// How long each step is shown in gif and apng, in seconds; without it, 0.5.
    #[arg(long, value_name = "SECONDS", value_parser = pause, allow_hyphen_values = true)]
    pause: Option<f64>,
    /// Writes TikZ for slides: one frame, an overlay a step.
    #[arg(long)]
    beamer: bool,
    /// Writes TikZ to be put into a document, not a document of its own.
    #[arg(long)]
    snippet: bool,
    /// Yaw and pitch of the eye in degrees, and a factor of 1 where everything
    /// fits; then, if you like, the point in the middle, and the word parallel for
    /// parallel lines that stay so. Yaw 0 looks from +x, 90 from +y; pitch 90 from
    /// above. A quadtree is seen from above anyway.
    #[arg(long, value_name = "YAW,PITCH,ZOOM[,X,Y[,Z]][,parallel]", allow_hyphen_values = true)]
    camera: Option<Eye>,
    /// What is shown beside the state of the algorithm, by names between commas:
    /// order-numbers, half-open-sides, codes, mirrored-ray, content,
    /// empty-leaves, inner-nodes, ancestors, children, or none. Then, if you like:
    /// levels=2-5, the levels of the cells off the path; rest=faint or rest=hidden,
    /// how these cells are drawn; slice=x:0.5, a plane across an axis, at a share of
    /// the side, that cuts an octree open; apart=0.7, how far the children of the
    /// current node are moved apart, in their sides. What is not named is not shown:
    /// with slice or apart alone, nothing else is. Without --show, what the scenario
    /// says.
    #[arg(long, value_name = "NAMES", value_parser = parse_shown)]
    show: Option<Show>,
    /// Language of all words, and of the title inside a file: en or de.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = language)]
    lang: Language,
    /// How the view formula writes: seed (as in "Ray Tracing mit Octrees"), revelles
    /// or frisken-perry; without it, seed.
    #[arg(long, value_name = "NOTATION")]
    notation: Option<Notation>,
}

fn format(id: &str) -> Result<Format, String> {
    Format::of_id(id).ok_or_else(|| {
        format!("there is no format ‘{id}’ to export to; there are {}", Format::known())
    })
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("give a whole number from 0 to {}", u64::MAX))
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

/// Runs the command.
///
/// # Errors
/// Says what is wrong with the file or the arguments.
pub fn export(arguments: &Export) -> anyhow::Result<Answer> {
    let request = arguments.request()?;
    let mut document = open(&arguments.file, &Progress::default())?;
    with_document!(&mut document, document => aim(document, arguments)?);
    with_document!(&mut document, document => document.trace_whole());
    let saved = with_document!(&document, document => document.opened().step);
    let steps = match arguments.step {
        Some(steps) => steps,
        None if request.order.format.moves() || request.order.format.is_of_text() => Steps::All,
        // What tells of the steps so far tells of all of them.
        None if saved == StepAt::First && arguments.view.is_of_the_way() => {
            Steps::One(StepAt::Last)
        }
        None => Steps::One(StepAt::At(saved.position(document.n_events()))),
    };
    let show = match request.show {
        Some(show) => Some(show),
        None => with_document!(&document, d => kept_show(&d.opened().view))?,
    };
    let eye = match request.eye {
        Some(eye) => Some(eye),
        None => with_document!(&document, d => kept_eye_of(d))?,
    };
    let request = Request { steps, show, eye, ..request };
    if let Some(note) =
        with_document!(&document, d => request.left_out(d, &texts(Language::English)))
    {
        tell(&note);
    }
    run_with_progress(|progress| request.run(&document, arguments.output.as_deref(), progress))?;
    Ok(Answer::Done)
}

fn kept_eye_of<const D: usize>(document: &Document<D>) -> anyhow::Result<Option<Eye>> {
    Ok(kept_eye::<D>(&document.opened().view)?)
}

impl Export {
    /// What is asked for; the steps only if they are told.
    fn request(&self) -> anyhow::Result<Request> {
        Ok(Request {
            view: self.view,
            order: self.order()?,
            steps: self.step.unwrap_or(Steps::One(StepAt::First)),
            moments: self.steps.clone().unwrap_or_default(),
            exercise: (self.seed, if self.solution { Fields::Solved } else { Fields::Empty }),
            eye: self.camera.clone(),
            show: self.show,
            language: self.lang,
            notation: self.notation.unwrap_or_default(),
        })
    }

    /// What the file is to be like.
    fn order(&self) -> anyhow::Result<Order> {
        let format = chosen_format(self)?;
        refuse_stray(self, format)?;
        let usual = Order::default();
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
            theme: self.theme.unwrap_or(usual.theme),
            background,
            size: self.size,
            enlarged: self.scale,
            type_scale: self.type_scale.unwrap_or(usual.type_scale),
            line_scale: self.line_scale.unwrap_or(usual.line_scale),
            tikz,
            pause_secs: self.pause.unwrap_or(usual.pause_secs),
        })
    }
}

fn chosen_format(arguments: &Export) -> anyhow::Result<Format> {
    let ending = arguments.output.as_deref().and_then(|name| name.extension());
    let ending = ending.map(|ending| ending.to_string_lossy());
    if let Some(format) = arguments.format {
        if let Some(ending) = ending
            && let Some(other) = Format::of_ending(&ending)
            && !format.may_end_in(other.ending())
        {
            bail!(
                "--format {format} writes {}, but ‘.{ending}’ is the ending of {}; leave --format \
                 out, or end the name in .{}",
                format.name(),
                other.name(),
                format.ending(),
                format = format.id(),
            );
        }
        return Ok(format);
    }
    let Some(ending) = ending else {
        bail!("the format is not told; give --format with one of {}", Format::known());
    };
    Format::of_ending(&ending).ok_or_else(|| {
        anyhow!(
            "‘.{ending}’ is no ending of figures; give --format with one of {}",
            Format::known()
        )
    })
}

/// Takes the ray and the algorithm of the command line.
fn aim<const D: usize>(document: &mut Document<D>, arguments: &Export) -> anyhow::Result<()> {
    if let Some(choice) = &arguments.ray {
        choice.aim(document)?;
    }
    if let Some(method) = arguments.algorithm {
        document.scenario.query = document.scenario.query.along_the_ray_by(method.in_dimension(D)?);
    }
    document.refresh(0);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::{Arguments, Command};
    use crate::shown::parse_shown;
    use clap::Parser;

    /// Whether the command line of `request` asks for it.
    #[track_caller]
    fn check(request: Request) {
        let words = request.command("a b.octo", Some(&[-0.0, 1e-200, 0.1, -3.5]), "out.x");
        let parsed = Arguments::try_parse_from(&words).unwrap();
        let Some(Command::Export(export)) = parsed.command else { panic!("{words:?}") };
        assert_eq!(export.request().unwrap(), request, "{words:?}");
        assert_eq!(export.file, PathBuf::from("a b.octo"));
        assert_eq!(export.output, Some(PathBuf::from("out.x")));
        let ray: RayChoice = "-0.0,1e-200,0.1,-3.5".parse().unwrap();
        assert_eq!(export.ray, Some(ray));
    }

    #[test]
    fn a_command_line_asks_for_what_it_was_made_of() {
        let plain = Request {
            view: FigureView::Space,
            order: Order::default(),
            steps: Steps::One(StepAt::At(12)),
            moments: Moments::default(),
            exercise: (None, Fields::Empty),
            eye: None,
            show: None,
            language: Language::English,
            notation: Notation::Seed,
        };
        check(plain.clone());
        let sheet = Request {
            view: FigureView::Worksheet,
            exercise: (Some(4), Fields::Solved),
            ..plain.clone()
        };
        check(sheet);
        let formula = FigureView::Formula;
        check(Request { view: formula, notation: Notation::FriskenPerry, ..plain.clone() });
        let order = Order { format: Format::Gif, pause_secs: 0.1, ..plain.order };
        let steps = Steps::Range(StepAt::At(3), StepAt::Last);
        check(Request { order, steps, ..plain.clone() });
        let slides = [TikzForm::Beamer, TikzForm::Snippet, TikzForm::BeamerSnippet];
        for (tikz, theme) in slides.into_iter().zip(Theme::ALL) {
            let order = Order {
                format: Format::Tikz,
                theme,
                background: Background::Transparent,
                size: Some("120.5x80mm".parse().unwrap()),
                enlarged: Some(0.3),
                type_scale: 1.25,
                line_scale: 0.8,
                tikz,
                pause_secs: plain.order.pause_secs,
            };
            check(Request {
                view: FigureView::Storyboard,
                order,
                steps: Steps::One(StepAt::Last),
                moments: Moments::At(vec![3, 7]),
                exercise: (None, Fields::Empty),
                eye: Some("298,24,1.062,-0.5,0.25,1".parse().unwrap()),
                show: Some(parse_shown("codes,children").unwrap()),
                language: Language::German,
                notation: Notation::Seed,
            });
        }
        for format in Format::ALL {
            check(Request { order: Order { format, ..plain.order }, ..plain.clone() });
        }
        for view in FigureView::ALL {
            check(Request { view, ..plain.clone() });
        }
    }
}
