//! What the command line calls the scenario that is open.

use crate::document::{AnyDocument, Document};
use crate::with_document;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, Scenario, Source, StepAt, built_in};
use std::path::{Path, PathBuf};

/// What a command has to name to draw what is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// A file, or a built-in scene as scene:NAME.
    pub file: String,
    /// The ray, if it is another one than the file's.
    pub ray: Option<Vec<f64>>,
    /// Whether the scenario has to be saved under that name first.
    pub is_unsaved: bool,
}

/// Name of a scenario that has none yet.
const UNSAVED: &str = "scenario.octo";

impl Origin {
    /// The origin of `document`; `saved` is the last scenario that was saved.
    pub fn of(document: &AnyDocument, saved: Option<&(PathBuf, AnyScenario)>) -> Self {
        let now = document.scenario_at(0);
        if let Some((path, scenario)) = saved
            && at_first(scenario.clone()) == at_first(now)
        {
            let file = path.display().to_string();
            return Self { file, ray: None, is_unsaved: false };
        }
        with_document!(document, d => opened(d)).unwrap_or_else(|| Self {
            file: UNSAVED.to_owned(),
            ray: None,
            is_unsaved: true,
        })
    }
}

/// The file that was opened, if no more than the ray has changed since.
fn opened<const D: usize>(document: &Document<D>) -> Option<Origin> {
    let opened = document.opened();
    let (now, ray) = (document.whole_scenario(), document.scenario.ray);
    if (Scenario { ray: opened.ray, step: opened.step, ..now }) != *opened {
        return None;
    }
    let is_along_ray = matches!(opened.query, Query::Ray { .. });
    let ray = (ray != opened.ray).then(|| [ray.origin(), ray.direction()].concat());
    if ray.is_some() && !is_along_ray {
        return None;
    }
    let file = match (&document.path, &opened.source) {
        (Some(path), _) => path.display().to_string(),
        (None, Source::BuiltIn { name, .. }) => {
            let scene = at_first(built_in(name)?);
            (scene == at_first(any(opened.clone())?)).then(|| format!("scene:{name}"))?
        }
        (None, Source::File { path, .. }) => {
            let is_whole = *opened == Scenario::of(opened.source.clone(), &document.content);
            let path = document.folder.join(Path::new(path));
            is_whole.then(|| path.display().to_string())?
        }
        (None, Source::Inline(_)) => return None,
    };
    Some(Origin { file, ray, is_unsaved: false })
}

/// The scenario with the playhead at the beginning, to be compared.
fn at_first(scenario: AnyScenario) -> AnyScenario {
    match scenario {
        AnyScenario::Quadtree(scenario) => {
            AnyScenario::Quadtree(Scenario { step: StepAt::First, ..scenario })
        }
        AnyScenario::Octree(scenario) => {
            AnyScenario::Octree(Scenario { step: StepAt::First, ..scenario })
        }
    }
}

/// The scenario of whichever dimension.
fn any<const D: usize>(scenario: Scenario<D>) -> Option<AnyScenario> {
    let scenario: Box<dyn std::any::Any> = Box::new(scenario);
    match scenario.downcast::<Scenario<2>>() {
        Ok(plane) => Some(AnyScenario::Quadtree(*plane)),
        Err(other) => other.downcast::<Scenario<3>>().ok().map(|space| AnyScenario::Octree(*space)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::open::open_built_in;
    use octoscope_core::progress::Progress;

    #[test]
    fn a_scene_is_named_until_more_than_its_ray_changes() {
        let mut document = open_built_in("quadtree-82", &Progress::default()).unwrap();
        let plain = Origin::of(&document, None);
        assert_eq!(
            plain,
            Origin { file: "scene:quadtree-82".to_owned(), ray: None, is_unsaved: false }
        );
        with_document!(&mut document, d => d.reverse_ray());
        assert_eq!(Origin::of(&document, None).ray.map(|ray| ray.len()), Some(4));
        with_document!(&mut document, d => d.scenario.recipe.depth += 1);
        assert!(Origin::of(&document, None).is_unsaved);
        let saved = (PathBuf::from("a.octo"), document.scenario_at(7));
        let saved = Origin::of(&document, Some(&saved));
        assert_eq!((saved.file.as_str(), saved.is_unsaved), ("a.octo", false));
    }
}
