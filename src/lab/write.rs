//! What is shown in the lab → files.

use crate::bench::{csv, markdown};
use crate::export::{self, Format, Order, Series};
use crate::files;
pub use crate::files::LAB_ENDINGS as ENDINGS;
use octoscope_core::explain::RichText;
use octoscope_core::measure::Results;
use octoscope_core::progress::Progress;
use octoscope_figure::{Figure, Theme};
use std::path::Path;

/// Ending of a file that the lab writes.
pub type Ending = &'static str;

/// Writes to `path` what its ending says: a table, or `chart` in some format.
///
/// # Errors
/// Says what cannot be drawn or written; tells if it was cancelled.
pub fn write(
    results: &Results,
    chart: &Figure,
    (theme, title): (Theme, &str),
    path: &Path,
    progress: &Progress,
) -> anyhow::Result<()> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match ending.as_str() {
        "csv" => return files::write(path, csv(results).as_bytes()),
        "md" => return files::write(path, markdown(results).as_bytes()),
        _ => {}
    }
    let format = Format::of_ending(&ending).unwrap_or_default();
    let order = Order { format, theme, ..Order::default() };
    let series = Series {
        steps: 0..=0,
        figure: &|_, _| Ok(chart.clone()),
        caption: &|_| RichText::parse(title),
        scenario: &|_| String::new(),
    };
    export::write(&order, &series, Some(path), progress)
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::text::Language;
    use octoscope_figure::views::lab::published_chart;

    #[test]
    fn every_ending_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let texts = crate::text::texts(Language::German);
        let results = Results::default();
        let chart = published_chart(&results, &texts, 860.0);
        for (ending, start) in
            ENDINGS.into_iter().zip(["<svg", "%PDF", "PNG", "tikzpicture", "scene,", "| scene"])
        {
            let path = folder.path().join(format!("chart.{ending}"));
            write(&results, &chart, (Theme::Print, "chart"), &path, &Progress::default()).unwrap();
            let bytes = files::read(&path, &Progress::default()).unwrap();
            let text = String::from_utf8_lossy(&bytes);
            assert!(!bytes.is_empty() && text.contains(start), "{ending}");
        }
    }
}
