//! From a file, a built-in scene or a scenario to a document.

use crate::document::{AnyDocument, Document};
use crate::{files, with_document};
use anyhow::{Context, anyhow};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::scenario::{AnyScenario, BUILT_IN, Scenario, Source, built_in};
use octoscope_core::scene::Content;
use octoscope_figure::scenario_inside;
use octoscope_import::{ImportError, Imported, hash, import};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use thiserror::Error;

/// Longest scenario that is read, 256 MiB: what it holds takes more in memory.
const MOST_BYTES_OF_A_SCENARIO: usize = 256 << 20;

/// An error, and the path of the file that it is about.
#[derive(Debug, Error)]
#[error("{error:#}: {}", path.display())]
pub struct AtPath {
    /// What is wrong.
    pub error: anyhow::Error,
    /// Where.
    pub path: PathBuf,
}

/// What is wrong with a scenario and its data file, or with no file at all.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum OpenFault {
    /// A scenario of more bytes than are read.
    #[error("the scenario is larger than 256 MiB; keep its data in a file of its own")]
    TooLarge,
    /// Neither a scenario nor anything that can be imported.
    #[error(
        "files of this kind cannot be opened; choose a scenario that ends in .octo, a file that \
         ends in .png, .jpg, .obj, .stl, .ply, .xyz or .csv, or an exported figure that ends in \
         .svg, .pdf, .png or .tex"
    )]
    UnknownKind,
    /// A list of cells, which does not say how deep the tree is.
    #[error(
        "a list of cells has no depth; write the cells into a scenario (.octo) as \"cells\" in its \
         \"scene\", with a \"depth\" in its \"build\", or send rays through them by octoscope visit \
         --cells FILE --depth N --rays FILE"
    )]
    Cells,
    /// A list of rays, without a tree.
    #[error(
        "a list of rays has no tree; send the rays through one by octoscope visit --cells FILE \
         --depth N --rays FILE, or write one of them into a scenario (.octo) as \"ray\""
    )]
    Rays,
    /// A figure that another program has made.
    #[error("there is no scenario inside; choose a figure that Octoscope has exported")]
    NoScenario,
    /// The data file cannot be read; the cause says why.
    #[error("the scenario's data file cannot be read; put it where \"file\" says")]
    DataFile,
    /// The data file has changed.
    #[error(
        "the data file is not the one the scenario was made with; restore it, or delete \"hash\" \
         from the scenario"
    )]
    OtherData,
    /// A picture for a scenario in space, or the other way round.
    #[error("the data file has another dimension than the scenario")]
    OtherDimension,
}

/// Document of what a user names: a built-in scene as `scene:NAME`, or else a
/// path.
///
/// # Errors
/// Says what is wrong, where, and the path.
pub fn open(name: &Path, progress: &Progress) -> anyhow::Result<AnyDocument> {
    match name.to_str().and_then(|name| name.strip_prefix("scene:")) {
        Some(id) => open_built_in(id, progress),
        None => open_path(name, progress),
    }
}

/// Document of a scenario file, of a figure that was exported, or of any data file
/// that can be imported.
///
/// # Errors
/// Says what is wrong, where, and the path.
pub fn open_path(path: &Path, progress: &Progress) -> anyhow::Result<AnyDocument> {
    let bytes = files::read(path, progress)?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    let name = name.unwrap_or_else(|| path.display().to_string());
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut document =
        open_bytes(&name, &bytes, folder, progress).map_err(|error| with_path(error, path))?;
    let is_scenario = is_scenario(&name);
    with_document!(&mut document, document => {
        document.path = is_scenario.then(|| path.to_owned());
        document.folder = folder.to_owned();
    });
    Ok(document)
}

/// Document of the bytes of a file called `name`, in `folder`.
///
/// # Errors
/// Says what is wrong, and where in the file.
pub fn open_bytes(
    name: &str,
    bytes: &[u8],
    folder: &Path,
    progress: &Progress,
) -> anyhow::Result<AnyDocument> {
    if is_scenario(name) {
        if bytes.len() > MOST_BYTES_OF_A_SCENARIO {
            return Err(OpenFault::TooLarge.into());
        }
        let text = files::as_text(bytes)?;
        return open_scenario(AnyScenario::parse(text)?, folder, progress);
    }
    // A picture of that size may be one to be imported.
    let is_too_large = bytes.len() > MOST_BYTES_OF_A_SCENARIO;
    if is_too_large && is_figure(name) {
        return Err(OpenFault::TooLarge.into());
    }
    if let Some(scenario) = (!is_too_large).then(|| scenario_inside(bytes)).flatten() {
        return open_scenario(AnyScenario::parse(&scenario)?, folder, progress);
    }
    if is_figure(name) {
        return Err(OpenFault::NoScenario.into());
    }
    let path = name.to_owned();
    let imported = match import(name, bytes, progress) {
        Err(ImportError::UnknownKind) => return Err(unknown_kind(name).into()),
        imported => imported?,
    };
    match imported {
        Imported::Plane { content, .. } => {
            let source = Source::File { path, hash: hash(bytes), fit: false };
            let scenario = Scenario::of(source, &content);
            Ok(AnyDocument::Plane(Box::new(Document::new(scenario, Arc::new(content), progress)?)))
        }
        Imported::Space { content, .. } => {
            let source = Source::File { path, hash: hash(bytes), fit: false };
            let scenario = Scenario::of(source, &content);
            Ok(AnyDocument::Space(Box::new(Document::new(scenario, Arc::new(content), progress)?)))
        }
    }
}

/// Document of a scenario; data files are looked for in `folder`.
///
/// # Errors
/// Says what is wrong with the scenario or its data file.
pub fn open_scenario(
    scenario: AnyScenario,
    folder: &Path,
    progress: &Progress,
) -> anyhow::Result<AnyDocument> {
    match scenario {
        AnyScenario::Quadtree(mut scenario) => {
            let content = content(&scenario.source, folder, progress, |imported| match imported {
                Imported::Plane { content, .. } => Some(content),
                Imported::Space { .. } => None,
            })?;
            scenario.fit_to(&content);
            Ok(AnyDocument::Plane(Box::new(Document::new(scenario, Arc::new(content), progress)?)))
        }
        AnyScenario::Octree(mut scenario) => {
            let content = content(&scenario.source, folder, progress, |imported| match imported {
                Imported::Space { content, .. } => Some(content),
                Imported::Plane { .. } => None,
            })?;
            scenario.fit_to(&content);
            Ok(AnyDocument::Space(Box::new(Document::new(scenario, Arc::new(content), progress)?)))
        }
    }
}

/// Document of the built-in scene with this identifier.
///
/// # Errors
/// Refuses unknown identifiers.
pub fn open_built_in(id: &str, progress: &Progress) -> anyhow::Result<AnyDocument> {
    let scenario = built_in(id).ok_or_else(|| {
        let known = BUILT_IN.map(|scene| scene.id).join(", ");
        anyhow!("there is no built-in scene ‘{id}’; there are {known}")
    })?;
    open_scenario(scenario, Path::new("."), progress)
}

/// The same error with the path at its end; of a cancelled work nothing is said.
fn with_path(error: anyhow::Error, path: &Path) -> anyhow::Error {
    if error.root_cause().is::<Cancelled>() {
        return error;
    }
    AtPath { error, path: path.to_owned() }.into()
}

/// Why a file of this name is no scenario, figure or data file.
fn unknown_kind(name: &str) -> OpenFault {
    let ending = Path::new(name).extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("cells") => OpenFault::Cells,
        Some("rays") => OpenFault::Rays,
        Some(_) | None => OpenFault::UnknownKind,
    }
}

/// Whether a file of this name holds a scenario.
fn is_scenario(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("octo"))
}

/// Whether a file of this name is a figure that holds a scenario or nothing.
fn is_figure(name: &str) -> bool {
    let ending = Path::new(name).extension().unwrap_or_default();
    ["svg", "pdf", "tex", "tikz"].iter().any(|figure| ending.eq_ignore_ascii_case(figure))
}

fn content<const D: usize>(
    source: &Source<D>,
    folder: &Path,
    progress: &Progress,
    of_dimension: impl FnOnce(Imported) -> Option<Content<D>>,
) -> anyhow::Result<Content<D>> {
    let Source::File { path, hash: expected, .. } = source else {
        return Ok(source.content()?);
    };
    let full = folder.join(path);
    let read = files::read(&full, progress);
    let bytes = read.context(OpenFault::DataFile)?;
    if !expected.is_empty() && *expected != hash(&bytes) {
        return Err(with_path(OpenFault::OtherData.into(), &full));
    }
    let imported =
        import(path, &bytes, progress).map_err(|error| with_path(error.into(), &full))?;
    of_dimension(imported)
        .ok_or_else(|| with_path(OpenFault::OtherDimension.into(), Path::new(path)))
}
