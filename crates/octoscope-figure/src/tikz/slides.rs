//! Figures that follow each other on slides; what they share is written once.

use super::Tikz;
use crate::shared::{SharedRun, shared_runs};

/// Fewer lines than this are not worth a command.
const LEAST: usize = 2;

impl Tikz<'_> {
    /// One frame that is as high or as wide as a slide has room for.
    pub(super) fn frame(&self, out: &mut String) {
        let has_captions = self.pictures.iter().any(|picture| !picture.caption.is_empty());
        let share = if has_captions { 0.78 } else { 0.92 };
        // A slide is 4 to 3 wide.
        let widest = 0.96 * 4.0 / (3.0 * share);
        let is_wide = self.pictures.first().is_some_and(|p| p.width > widest * p.height);
        let size = if is_wide {
            "{0.96\\paperwidth}{!}".to_owned()
        } else {
            format!("{{!}}{{{share}\\paperheight}}")
        };
        let shared = self.shared(out);
        *out += &format!(
            "\\begin{{frame}}[plain]\n\\centering\n\\makebox[\\linewidth]{{\\resizebox{size}{{%\n"
        );
        self.overlays(out, &shared);
        *out += "}}\n";
        self.captions(out);
        *out += "\\end{frame}\n";
    }

    /// Defines a command for every run of lines that all figures share.
    pub(super) fn shared(&self, out: &mut String) -> Vec<SharedRun> {
        let pictures: Vec<&[u32]> = self.pictures.iter().map(|p| &p.lines[..]).collect();
        let runs = if pictures.len() < 2 { Vec::new() } else { shared_runs(&pictures, LEAST) };
        for (index, run) in runs.iter().enumerate() {
            let start = run.starts[0];
            *out += &format!("\\newcommand*{{{}}}{{%\n", shared_name(index));
            self.write_lines(out, &self.pictures[0].lines[start..start + run.length]);
            *out += "}\n";
        }
        runs
    }

    /// One picture: each figure on a slide of its own.
    pub(super) fn overlays(&self, out: &mut String, shared: &[SharedRun]) {
        let Some(first) = self.pictures.first() else { return };
        self.begin(out, first);
        for (slide, picture) in self.pictures.iter().enumerate() {
            *out += &format!("\\only<{}>{{%\n", slide + 1);
            let mut runs: Vec<_> = shared.iter().enumerate().collect();
            runs.sort_by_key(|(_, run)| run.starts[slide]);
            let mut done = 0;
            for (index, run) in runs {
                self.write_lines(out, &picture.lines[done..run.starts[slide]]);
                *out += &format!("{}\n", shared_name(index));
                done = run.starts[slide] + run.length;
            }
            self.write_lines(out, &picture.lines[done..]);
            *out += "}%\n";
        }
        *out += "\\end{tikzpicture}\n";
    }

    /// What is said on every slide, in a box of two lines: nothing moves.
    pub(super) fn captions(&self, out: &mut String) {
        if self.pictures.iter().all(|picture| picture.caption.is_empty()) {
            return;
        }
        *out += "\\par\\smallskip\n\\begin{minipage}[t][2.4\\baselineskip]{0.96\\linewidth}\n\
                 \\centering\\small\n";
        for (slide, picture) in self.pictures.iter().enumerate() {
            *out += &format!("\\only<{}>{{{}}}%\n", slide + 1, picture.caption);
        }
        *out += "\\end{minipage}\n";
    }
}

/// Name of the command for a run of lines; letters alone may be in it.
fn shared_name(index: usize) -> String {
    let mut name = String::new();
    let mut rest = index;
    loop {
        name.insert(0, char::from(b'a' + (rest % 26) as u8));
        rest /= 26;
        if rest == 0 {
            return format!("\\octoshared{name}");
        }
        rest -= 1;
    }
}
