//! Saving scenarios, and remembering the last one between two starts.

use crate::document::AnyDocument;
use crate::files;
use crate::with_document;
use octoscope_core::scenario::{AnyScenario, Scenario, Source};
use std::path::{Path, PathBuf};

/// Key of the window's state in the program's storage.
pub const VIEW_KEY: &str = "view";
const SCENARIO_KEY: &str = "scenario";
const FOLDER_KEY: &str = "folder";

/// Writes `scenario` of `document` to `path`; its data file is named relative
/// to the folder of `path` where it can be.
///
/// # Errors
/// Says why it cannot be written, and the path.
pub fn scenario(document: &AnyDocument, scenario: AnyScenario, path: &Path) -> anyhow::Result<()> {
    let from = with_document!(document, document => document.folder.clone());
    let to = path.parent().map(Path::to_owned).unwrap_or_default();
    let scenario = match scenario {
        AnyScenario::Quadtree(scenario) => AnyScenario::Quadtree(moved(scenario, &from, &to)),
        AnyScenario::Octree(scenario) => AnyScenario::Octree(moved(scenario, &from, &to)),
    };
    files::write(path, scenario.print().as_bytes())
}

/// Keeps the scenario for the next start.
pub fn remember(storage: &mut dyn eframe::Storage, document: &AnyDocument, scenario: AnyScenario) {
    let folder = with_document!(document, document => document.folder.clone());
    storage.set_string(SCENARIO_KEY, scenario.print());
    storage.set_string(FOLDER_KEY, folder.to_string_lossy().into_owned());
}

/// The scenario of the last time, and the folder of its data file; `None` if
/// there is none or it cannot be read any more.
pub fn remembered(storage: &dyn eframe::Storage) -> Option<(AnyScenario, PathBuf)> {
    let scenario = AnyScenario::parse(&storage.get_string(SCENARIO_KEY)?).ok()?;
    let folder = PathBuf::from(storage.get_string(FOLDER_KEY).unwrap_or_default());
    Some((scenario, folder))
}

fn moved<const D: usize>(mut scenario: Scenario<D>, from: &Path, to: &Path) -> Scenario<D> {
    if let Source::File { path, .. } = &mut scenario.source {
        let full = from.join(&*path);
        let shown = full.strip_prefix(to).unwrap_or(&full);
        *path = shown.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/");
    }
    scenario
}
