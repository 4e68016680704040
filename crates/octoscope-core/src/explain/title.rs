//! A scenario in one line.

use super::names::step_texts;
use crate::scenario::{Scenario, Source};
use crate::text::Language;

/// Kind of tree, scene and number of leaves, in one short line; a built-in scene by the
/// name that `name_of` has for its identifier, what is in a `file` by that of the file.
pub fn short_title<const D: usize>(
    scenario: &Scenario<D>,
    file: Option<&str>,
    n_leaves: usize,
    language: Language,
    name_of: impl Fn(&str) -> String,
) -> String {
    let texts = step_texts(language);
    let tree = texts.get(if D == 2 { "title-quadtree" } else { "title-octree" });
    let scene = match &scenario.source {
        _ if file.is_some() => file.unwrap_or_default().to_owned(),
        Source::BuiltIn { name, .. } => name_of(name),
        Source::Inline(_) => texts.get("scene-inline"),
        Source::File { path, .. } => path.rsplit('/').next().unwrap_or(path).to_owned(),
    };
    let n = n_leaves as u64;
    texts.format("title", &[("tree", tree.into()), ("scene", scene.into()), ("n", n.into())])
}
