//! `octoscope check`: whether files can be opened, and what they hold.

use super::Answer;
use crate::document::Document;
use crate::files::Output;
use crate::open::open;
use crate::with_document;
use clap::Args;
use octoscope_core::progress::Progress;
use octoscope_core::scene::Content;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Opens files and reports what they hold; changes nothing.
///
/// One line a file: its name, ok, quadtree or octree, what it is built from,
/// leaves, occupied leaves, the depth of the deepest leaf below the root and
/// the steps of the query; or its name, bad and what is wrong with it.
///
/// Exit status: 1 if a file is bad.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope check lecture.octo knot.stl landscape.png\n  \
    octoscope check scene:cloud")]
pub struct Check {
    /// Scenarios (.octo), data files, or built-in scenes as scene:NAME.
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
        let report = match open(file, &Progress::default()) {
            Ok(document) => {
                format!("ok, {}", with_document!(&document, document => summary(document)))
            }
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

fn summary<const D: usize>(document: &Document<D>) -> String {
    let tree = &document.tree;
    let kind = if D == 2 { "quadtree" } else { "octree" };
    let n_full = tree.leaves().filter(|leaf| leaf.is_full()).count();
    let root_level = tree.domain().root_level();
    let depth = tree.leaves().map(|leaf| root_level - tree.level(leaf.id)).max().unwrap_or(0);
    let counted = [
        made_of(&document.content),
        count(tree.n_leaves(), "leaf", "leaves"),
        format!("{n_full} occupied"),
        format!("depth {depth}"),
        count(document.trace.events.len(), "step", "steps"),
    ];
    format!("{kind}, {}", counted.join(", "))
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
