//! The table of the steps as text.

use super::Format;
use crate::document::Document;
use anyhow::bail;
use octoscope_core::explain::{trace_csv, trace_latex, trace_markdown};
use octoscope_core::text::Language;

/// All steps of `document` as a table: one row a step, the first says what is asked.
///
/// # Errors
/// Refuses formats of figures.
pub(super) fn table<const D: usize>(
    document: &Document<D>,
    format: Format,
    language: Language,
) -> anyhow::Result<String> {
    let Document { tree, trace, scenario, .. } = document;
    Ok(match format {
        Format::Markdown => trace_markdown(tree, &scenario.ray, trace, language),
        Format::Csv => trace_csv(tree, trace),
        Format::Latex => trace_latex(tree, &scenario.ray, trace, language),
        Format::Svg | Format::Pdf | Format::Png | Format::Tikz | Format::Gif | Format::Apng => {
            bail!("{} is a format of figures", format.name())
        }
    })
}
