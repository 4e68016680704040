//! Saving scenarios, and remembering the last one between two starts.

use crate::document::AnyDocument;
use crate::files;
use crate::with_document;
use octoscope_core::scenario::{AnyScenario, Scenario, Source};
use std::path::{Component, Path, PathBuf};

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
    let to = path.parent().unwrap_or(Path::new(""));
    files::write(path, named_from(document, scenario, to).print().as_bytes())
}

/// `scenario` of `document` with its data file named from the folder `to`, where
/// it can be.
pub fn named_from(document: &AnyDocument, scenario: AnyScenario, to: &Path) -> AnyScenario {
    let from = with_document!(document, document => document.folder.clone());
    // Folders that are named from here are compared whole.
    let [from, to] = [from.as_path(), to].map(|folder| {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned())
    });
    match scenario {
        AnyScenario::Quadtree(scenario) => AnyScenario::Quadtree(moved(scenario, &from, &to)),
        AnyScenario::Octree(scenario) => AnyScenario::Octree(moved(scenario, &from, &to)),
    }
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
        *path = from_folder(&from.join(&*path), to)
            .to_string_lossy()
            .replace(std::path::MAIN_SEPARATOR, "/");
    }
    scenario
}

/// `path` as it is named from the folder `to`: up from there and down again,
/// if both lie below a common folder.
fn from_folder(path: &Path, to: &Path) -> PathBuf {
    let n_shared = path.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    // The root alone is nothing common.
    if n_shared < 2 {
        return path.to_owned();
    }
    let up = to.components().skip(n_shared).map(|_| Component::ParentDir);
    up.chain(path.components().skip(n_shared)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_files_are_named_from_the_folder_of_the_scenario() {
        let check = |path: &str, to: &str, expected: &str| {
            assert_eq!(from_folder(Path::new(path), Path::new(to)), Path::new(expected));
        };
        check("/a/b/c.obj", "/a/b", "c.obj");
        check("/a/b/c.obj", "/a", "b/c.obj");
        check("/a/b/c.obj", "/a/d/e", "../../b/c.obj");
        check("/a/b/c.obj", "/d", "/a/b/c.obj");
    }
}
