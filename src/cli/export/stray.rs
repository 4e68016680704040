//! Options of `octoscope export` that say nothing about the figure asked for.

use super::Export;
use crate::export::{Format, Steps};
use anyhow::bail;
use octoscope_figure::views::FigureView;

/// Refuses options that are for other views or formats than those asked for.
///
/// # Errors
/// Names the first such option, and what it is for.
pub fn refuse_stray(arguments: &Export, format: Format) -> anyhow::Result<()> {
    of_views(arguments)?;
    of_formats(arguments, format)
}

fn of_views(arguments: &Export) -> anyhow::Result<()> {
    let view = arguments.view;
    let in_space = FigureView::ALL.into_iter().filter(|view| view.shows_space()).collect();
    let storyboard = || vec![FigureView::Storyboard];
    let worksheet = || vec![FigureView::Worksheet];
    let options = [
        ("--steps", arguments.steps.is_some(), storyboard()),
        ("--seed", arguments.seed.is_some(), worksheet()),
        ("--solution", arguments.solution, worksheet()),
        ("--notation", arguments.notation.is_some(), vec![FigureView::Formula]),
        ("--camera", arguments.camera.is_some(), Vec::clone(&in_space)),
        ("--show", arguments.show.is_some(), in_space),
    ];
    for (option, is_given, views) in options {
        if is_given && !views.contains(&view) {
            let (word, ids) = (if views.len() == 1 { "view" } else { "views" }, listed(&views));
            let first = views[0];
            bail!("{option} is for the {word} {ids}; give --view {first}, or leave it out");
        }
    }
    match arguments.step {
        Some(Steps::Range(..) | Steps::All) if !view.is_of_a_step() => {
            bail!("the view ‘{view}’ is not of one step; give --step one number, or leave it out")
        }
        Some(Steps::Range(..) | Steps::All | Steps::One(_)) | None => Ok(()),
    }
}

fn listed(views: &[FigureView]) -> String {
    let ids = views.iter().map(|view| format!("‘{view}’"));
    ids.collect::<Vec<_>>().join(", ")
}

fn of_formats(arguments: &Export, format: Format) -> anyhow::Result<()> {
    let is_tikz = format == Format::Tikz;
    for (option, is_given) in [("--beamer", arguments.beamer), ("--snippet", arguments.snippet)] {
        if is_given && !is_tikz {
            bail!("{option} is for TikZ; give --format tikz, or leave it out");
        }
    }
    if arguments.pause.is_some() && !format.moves() {
        bail!("--pause is for GIF and APNG; give --format gif, or leave it out");
    }
    let looks = [
        ("--size", arguments.size.is_some()),
        ("--scale", arguments.scale.is_some()),
        ("--type-scale", arguments.type_scale.is_some()),
        ("--line-scale", arguments.line_scale.is_some()),
        ("--theme", arguments.theme.is_some()),
        ("--transparent", arguments.transparent),
    ];
    match looks.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) if format.is_of_text() => {
            bail!(
                "{option} is for figures, and {} is text; give --format svg, or leave it out",
                format.name()
            )
        }
        Some(_) | None => Ok(()),
    }
}
