//! `octoscope scenes`: what comes with the program.

use super::Answer;
use crate::files::Output;
use crate::text::texts;
use clap::Args;
use octoscope_core::explain::algorithm_name;
use octoscope_core::gallery::Degenerate;
use octoscope_core::paper::{ERRATA, paper_texts};
use octoscope_core::scenario::BUILT_IN;
use octoscope_core::text::Language;
use octoscope_core::traverse::{Algorithm, Variant};
use serde_json::json;
use std::collections::BTreeMap;
use std::io::Write;

/// Lists the built-in scenes, the algorithms, the degenerate rays and the errata of
/// the paper, with their identifiers.
///
/// A scene's identifier, scene:NAME, stands wherever a command takes a file; a
/// ray's, gallery:NAME, where one takes a ray. Variants follow an algorithm after @,
/// several with commas between them, as in parametric@B-1,B-3. A scenario that names a scene may
/// choose another seed of its random numbers, and another n, which says how many
/// or how large.
#[derive(Debug, Args)]
pub struct Scenes {
    /// Prints the list as JSON.
    #[arg(long)]
    json: bool,
}

/// Runs the command.
///
/// # Errors
/// Says that the list could not be written.
pub fn scenes(arguments: &Scenes) -> anyhow::Result<Answer> {
    let mut output = Output::open(None)?;
    let list = if arguments.json { as_json() } else { as_text() };
    output.write_all(list.as_bytes())?;
    output.finish()?;
    Ok(Answer::Done)
}

fn as_text() -> String {
    let texts = texts(Language::English);
    let or_dash = |number: Option<u64>| number.map_or("-".to_owned(), |n| n.to_string());
    let scenes = BUILT_IN.iter().map(|scene| {
        let n = or_dash(scene.n.map(|[n, _]| n.into()));
        let most = or_dash(scene.n.map(|[_, most]| most.into()));
        format!(
            "{:<22}{:<10}{:>6}{n:>6}{most:>9}   {}\n",
            format!("scene:{}", scene.id),
            if scene.dimension == 2 { "quadtree" } else { "octree" },
            or_dash(scene.seed),
            texts.get(&format!("scene-{}", scene.id)),
        )
    });
    let head = format!(
        "{:<22}{:<10}{:>6}{:>6}{:>9}   {}\n",
        "scene", "tree", "seed", "n", "largest", "what it is"
    );
    let algorithms = Algorithm::ALL.map(|algorithm| {
        let variants = variants(algorithm).map(|variant| format!(" @{}", variant.id()));
        let name = algorithm_name(algorithm, Language::English);
        format!("{:<22}{name}{}\n", algorithm.id(), variants.collect::<String>())
    });
    let rays = Degenerate::ALL.map(|ray| {
        let id = format!("gallery:{}", ray.id());
        let plane = if ray.is_of_space() { " (in space)" } else { "" };
        format!("{id:<22}{}{plane}\n", ray.name(Language::English))
    });
    let errata = ERRATA.map(|erratum| {
        let variants = erratum.variants.iter().map(|variant| format!(" @{}", variant.id()));
        let title = paper_texts(Language::English).get(&erratum.key("title"));
        format!("{:<22}{title}{}\n", erratum.id, variants.collect::<String>())
    });
    let scenes: String = scenes.collect();
    let [algorithms, rays, errata] = [algorithms.concat(), rays.concat(), errata.concat()];
    let [of_algorithms, of_rays, of_errata] =
        ["algorithm", "degenerate ray", "erratum"].map(|name| format!("{name:<22}what it is"));
    let of_algorithms = format!("{of_algorithms}, and its variants: @ONE, or @ONE,ANOTHER");
    format!(
        "{head}{scenes}\n{of_algorithms}\n{algorithms}\n{of_rays}\n{rays}\n{of_errata}\n{errata}"
    )
}

fn as_json() -> String {
    let scenes = BUILT_IN.iter().map(|scene| {
        json!({
            "id": format!("scene:{}", scene.id),
            "dimension": scene.dimension,
            "seed": scene.seed,
            "n": scene.n.map(|[n, _]| n),
            "largest_n": scene.n.map(|[_, most]| most),
        })
    });
    let errata = ERRATA.iter().map(|erratum| {
        let variants: Vec<_> = erratum.variants.iter().map(|variant| variant.id()).collect();
        json!({ "id": erratum.id, "severity": erratum.severity.id(), "variants": variants })
    });
    let list = json!({
        "scenes": scenes.collect::<Vec<_>>(),
        "algorithms": Algorithm::ALL.map(Algorithm::id),
        "rays": Degenerate::ALL.map(|ray| format!("gallery:{}", ray.id())),
        "errata": errata.collect::<Vec<_>>(),
        "variants": Algorithm::ALL
            .map(|algorithm| (algorithm.id(), variants(algorithm).map(Variant::id).collect()))
            .into_iter()
            .collect::<BTreeMap<_, Vec<_>>>(),
    });
    format!("{list:#}\n")
}

fn variants(algorithm: Algorithm) -> impl Iterator<Item = Variant> {
    Variant::ALL.into_iter().filter(move |variant| variant.belongs_to(algorithm))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_algorithm_ray_and_erratum_is_listed() {
        for list in [as_text(), as_json()] {
            for scene in &BUILT_IN {
                assert!(list.contains(&format!("scene:{}", scene.id)));
            }
            assert!(Algorithm::ALL.iter().all(|algorithm| list.contains(algorithm.id())));
            let named = |ray: &Degenerate| list.contains(&format!("gallery:{}", ray.id()));
            assert!(Degenerate::ALL.iter().all(named));
            assert!(ERRATA.iter().all(|erratum| list.contains(erratum.id)));
            assert!(list.contains("B-24c"));
        }
    }
}
