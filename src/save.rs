//! Saving scenarios, and remembering the last one between two starts.

use crate::document::AnyDocument;
use crate::files;
use crate::with_document;
use octoscope_core::scenario::{AnyScenario, Scenario, Source};
use std::path::{Component, Path, PathBuf};

/// Key of the window's state in the program's storage.
pub const VIEW_KEY: &str = "view";
const SCENARIO_KEY: &str = "scenario";
const UNCHANGED_KEY: &str = "unchanged";
const FOLDER_KEY: &str = "folder";
const PATH_KEY: &str = "path";

/// What is open, as it is kept for the next start.
#[derive(Clone, Debug, PartialEq)]
pub struct Last {
    /// The scenario with all changes.
    pub scenario: AnyScenario,
    /// The scenario as its file has it, or as it was opened, if there are changes.
    pub unchanged: Option<AnyScenario>,
    /// Folder from which the data file is named.
    pub folder: PathBuf,
    /// The scenario's file, if it has one.
    pub path: Option<PathBuf>,
}

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
    let [from, to] = [from.as_path(), to].map(from_here);
    match scenario {
        AnyScenario::Quadtree(scenario) => AnyScenario::Quadtree(moved(scenario, &from, &to)),
        AnyScenario::Octree(scenario) => AnyScenario::Octree(moved(scenario, &from, &to)),
    }
}

/// What is open as texts by their keys in the program's storage.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept([(&'static str, Option<String>); 4]);

impl Kept {
    /// Prints what is open for the next start, which may be in another folder.
    pub fn of(last: &Last) -> Self {
        let whole = |path: &PathBuf| from_here(path).to_string_lossy().into_owned();
        Self([
            (SCENARIO_KEY, Some(last.scenario.print())),
            (UNCHANGED_KEY, last.unchanged.as_ref().map(AnyScenario::print)),
            (FOLDER_KEY, Some(whole(&last.folder))),
            (PATH_KEY, last.path.as_ref().map(whole)),
        ])
    }

    /// Puts it into the storage.
    pub fn put(self, storage: &mut dyn eframe::Storage) {
        for (key, text) in self.0 {
            match text {
                Some(text) => storage.set_string(key, text),
                None => storage.remove_string(key),
            }
        }
    }
}

/// What was open last; `None` if nothing was or it cannot be read any more.
pub fn remembered(storage: &dyn eframe::Storage) -> Option<Last> {
    let scenario = |key| AnyScenario::parse(&storage.get_string(key)?).ok();
    Some(Last {
        scenario: scenario(SCENARIO_KEY)?,
        unchanged: scenario(UNCHANGED_KEY),
        folder: storage.get_string(FOLDER_KEY).unwrap_or_default().into(),
        path: storage.get_string(PATH_KEY).map(PathBuf::from),
    })
}

/// The whole path of what is named from the folder where the program was started.
fn from_here(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
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
