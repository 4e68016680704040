//! A line about a path.

use crate::look::Look;
use eframe::egui::{Color32, FontId, Label, RichText, Ui};
use std::path::Path;

/// Size of its type.
const SIZE: f32 = 13.0;

/// Shows what `line` says of a path, on one line: where there is no room for the whole
/// path, its middle is left out, and the whole is told where it is pointed at.
pub fn path_line(ui: &mut Ui, look: &Look, path: &Path, line: impl Fn(&str) -> String) {
    let room = ui.available_width();
    let fits = |path: &str| {
        let font = FontId::proportional(SIZE);
        let galley = ui.painter().layout_no_wrap(line(path), font, Color32::BLACK);
        galley.size().x <= room
    };
    let whole = path.display().to_string();
    let short = without_middle(&whole, fits);
    let text = RichText::new(line(&short)).size(SIZE).color(look.palette.quiet);
    let shown = ui.add(Label::new(text).truncate());
    if short != whole {
        shown.on_hover_text(whole);
    }
}

/// `text`, or as much of its two ends as fits, with dots between them.
fn without_middle(text: &str, fits: impl Fn(&str) -> bool) -> String {
    if fits(text) {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    let ends = |n_kept: usize| {
        let n_first = n_kept / 2;
        let last = &letters[letters.len() - (n_kept - n_first)..];
        letters[..n_first].iter().chain(['…'].iter()).chain(last).collect::<String>()
    };
    let lengths: Vec<usize> = (1..letters.len()).collect();
    ends(lengths.partition_point(|&n_kept| fits(&ends(n_kept))))
}

#[cfg(test)]
mod tests {
    use super::without_middle;

    #[test]
    fn a_text_without_room_loses_its_middle_only() {
        let check = |text: &str, most: usize, shown: &str| {
            assert_eq!(without_middle(text, |text| text.chars().count() <= most), shown);
        };
        check("/home/a/figure.svg", 18, "/home/a/figure.svg");
        check("/home/a/figure.svg", 13, "/home/…re.svg");
        check("/ä/ö/ü/ß", 6, "/ä…ü/ß");
        check("abc", 0, "…");
        check("", 0, "");
    }
}
