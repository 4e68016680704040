//! Exporting what the space view shows.

use crate::document::{AnyDocument, Document};
use crate::files;
use crate::view::View;
use anyhow::bail;
use octoscope_core::scenario::AnyScenario;
use octoscope_figure::{
    Background, Camera, Figure, Page, Show, SvgOptions, Theme, axes, content, leaves, marks, png,
    space_figure, svg,
};
use std::path::Path;

/// Format of an exported figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Vectors, text as text.
    Svg,
    /// Pixels.
    Png,
}

impl Format {
    /// Format of this file ending or name.
    pub fn of_ending(ending: &str) -> Option<Self> {
        match ending.to_ascii_lowercase().as_str() {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            _ => None,
        }
    }
}

/// Figure of the space view of `document` after `step` events.
pub fn space<const D: usize>(
    document: &Document<D>,
    camera: Option<Camera<D>>,
    page: Page,
    show: &Show,
    step: usize,
) -> Figure {
    let bounds = crate::space::interesting(document);
    let camera = camera.unwrap_or_else(|| Camera::framing(&bounds, page));
    let scenario = &document.scenario;
    let moment = document.moment(step);
    let event = step.checked_sub(1).and_then(|index| document.trace.events.get(index));
    let mut all = leaves(&document.tree, show);
    if show.content {
        all.extend(content(&document.content));
    }
    all.extend(axes(document.tree.domain()));
    all.extend(marks(&document.tree, &scenario.ray, &scenario.query, &moment, event, show));
    all.sort_by_key(|mark| mark.role.layer());
    space_figure(&all, &camera, page).cropped(6.0)
}

/// Bytes of `figure` in `format`; `width` in pixels is for pixels only.
///
/// # Errors
/// Says why it cannot be drawn in pixels.
pub fn bytes(
    figure: &Figure,
    format: Format,
    theme: Theme,
    scenario: &AnyScenario,
    width: u32,
) -> anyhow::Result<Vec<u8>> {
    let scenario = scenario.print();
    let options = SvgOptions {
        theme,
        background: Background::Filled,
        title: "Octoscope",
        scenario: &scenario,
    };
    let text = svg(figure, &options);
    Ok(match format {
        Format::Svg => text.into_bytes(),
        Format::Png => png(&text, width)?,
    })
}

/// Writes the space view as the window shows it to `path`, whose ending tells
/// the format.
///
/// # Errors
/// Refuses endings without a format; says why the file cannot be written.
pub fn space_view(
    document: &AnyDocument,
    scenario: &AnyScenario,
    view: &View,
    path: &Path,
) -> anyhow::Result<()> {
    const PAGE: Page = Page { width: 960.0, height: 720.0 };
    let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
    let Some(format) = Format::of_ending(&ending) else {
        bail!(
            "‘.{ending}’ is no format of figures; name the file .svg or .png: {}",
            path.display()
        );
    };
    let step = view.playback.step;
    let figure = match document {
        AnyDocument::Plane(document) => {
            space(document, view.camera(), PAGE, &view.plane_show, step)
        }
        AnyDocument::Space(document) => {
            space(document, view.camera(), PAGE, &view.space_show, step)
        }
    };
    let width = (figure.page.width * 2.0).round() as u32;
    files::write(path, &bytes(&figure, format, view.theme, scenario, width)?)
}
