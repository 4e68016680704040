//! `octoscope check`: whether files can be opened, and what they hold.

use super::Answer;
use crate::document::Document;
use crate::files::{Output, read_text};
use crate::open::open;
use crate::traced::MOST_EVENTS;
use crate::with_document;
use clap::Args;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::StepAt;
use octoscope_core::scene::Content;
use octoscope_core::tree::MAX_ROOT_LEVEL;
use octoscope_import::{cells, rays};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Opens files and reports what they hold; changes nothing.
///
/// One line a file: its name, ok, quadtree or octree, what it is built from,
/// leaves, occupied leaves, the depth of the deepest leaf below the root and
/// the steps of the query, with the step that is taken if the scenario names a later
/// one than there is; of lists of cells and rays, what is in them; or its
/// name, bad and what is wrong with it.
///
/// Exit status: 1 if a file is bad.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope check lecture.octo knot.stl landscape.png\n  \
    octoscope check scene:cloud")]
pub struct Check {
    /// Scenarios (.octo), data files, lists (.cells, .rays), or built-in scenes as
    /// scene:NAME.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
}

/// Runs the command.
///
/// # Errors
/// Says that the report could not be written.
pub fn check(arguments: &Check) -> anyhow::Result<Answer> {
    let mut output = Output::open(None)?;
    let mut n_bad = 0;
    for file in &arguments.files {
        let report = match held(file) {
            Ok(held) => format!("ok, {held}"),
            Err(error) => {
                n_bad += 1;
                format!("bad, {}", reason(&format!("{error:#}"), file))
            }
        };
        writeln!(output, "{}: {report}", file.display())?;
    }
    output.finish()?;
    let n_files = arguments.files.len();
    Ok(match n_bad {
        0 => Answer::Done,
        1 if n_files == 1 => Answer::No("the file is bad".to_owned()),
        _ => Answer::No(format!("{n_bad} of {n_files} files are bad")),
    })
}

/// What a file holds, in words.
fn held(file: &Path) -> anyhow::Result<String> {
    let ending = file.extension().unwrap_or_default().to_ascii_lowercase();
    if ending == "cells" {
        let text = read_text(file)?;
        return if n_columns(&text) == 2 {
            list_of_cells::<2>(&text)
        } else {
            list_of_cells::<3>(&text)
        };
    }
    if ending == "rays" {
        let text = read_text(file)?;
        return if n_columns(&text) == 4 {
            list_of_rays::<2>(&text)
        } else {
            list_of_rays::<3>(&text)
        };
    }
    let document = open(file, &Progress::default())?;
    Ok(with_document!(&document, document => summary(document)))
}

/// Numbers in the first line that has any.
fn n_columns(text: &str) -> usize {
    let numbers = text.split(['\n', '\r']).map(|line| line.split('#').next().unwrap_or_default());
    numbers.map(|line| line.split_whitespace().count()).find(|&n| n > 0).unwrap_or(0)
}

fn list_of_cells<const D: usize>(text: &str) -> anyhow::Result<String> {
    let cells = cells::<D>(text, MAX_ROOT_LEVEL)?;
    let largest = cells.iter().flatten().max().copied().unwrap_or(0);
    let depth = u32::BITS - largest.leading_zeros();
    Ok(format!("{}, {}, depth {depth} or more", kind::<D>(), count(cells.len(), "cell", "cells")))
}

fn list_of_rays<const D: usize>(text: &str) -> anyhow::Result<String> {
    let place = if D == 2 { "in the plane" } else { "in space" };
    Ok(format!("{} {place}", count(rays::<D>(text)?.len(), "ray", "rays")))
}

fn kind<const D: usize>() -> &'static str {
    if D == 2 { "quadtree" } else { "octree" }
}

fn summary<const D: usize>(document: &Document<D>) -> String {
    let tree = &document.tree;
    let n_full = tree.leaves().filter(|leaf| leaf.is_full()).count();
    let root_level = tree.domain().root_level();
    let depth = tree.leaves().map(|leaf| root_level - tree.level(leaf.id)).max().unwrap_or(0);
    let counted = [
        made_of(&document.content),
        count(tree.n_leaves(), "leaf", "leaves"),
        format!("{n_full} occupied"),
        format!("depth {depth}"),
        steps(document),
    ];
    format!("{}, {}", kind::<D>(), counted.join(", "))
}

fn made_of<const D: usize>(content: &Content<D>) -> String {
    let n = content.len();
    match content {
        Content::Points(_) => count(n, "point", "points"),
        Content::Cells(_) => count(n, "cell", "cells"),
        Content::Image(image) => format!("{} × {} pixels", image.width, image.height),
        Content::Spheres(_) if D == 2 => count(n, "circle", "circles"),
        Content::Spheres(_) => count(n, "sphere", "spheres"),
        Content::Boxes(_) => count(n, "box", "boxes"),
        Content::Triangles(_) => count(n, "triangle", "triangles"),
    }
}

/// Number of steps of the query, and whether the scenario names a later one; of a long
/// run that there are more than are kept.
fn steps<const D: usize>(document: &Document<D>) -> String {
    if document.trace.is_cut() {
        return format!("more than {MOST_EVENTS} steps");
    }
    let n = document.trace.events.len();
    let steps = count(n, "step", "steps");
    match document.opened().step {
        StepAt::At(step) if step > n => format!("{steps} (\"step\" is {step}: the last is taken)"),
        StepAt::At(_) | StepAt::First | StepAt::Last => steps,
    }
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// The message on one line, without the name that stands before it already.
fn reason(message: &str, file: &Path) -> String {
    let message = message.replace('\n', " ");
    let whole = format!(": {}", file.display());
    message.strip_suffix(&whole).unwrap_or(&message).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_does_not_repeat_the_name() {
        assert_eq!(reason("it is empty: a.octo", Path::new("a.octo")), "it is empty");
    }

    #[test]
    fn one_thing_is_counted_in_the_singular() {
        assert_eq!(made_of(&Content::<2>::Points(vec![[0.0; 2]])), "1 point");
        assert_eq!(made_of(&Content::<3>::Points(vec![[0.0; 3]; 2])), "2 points");
    }
}
