//! Scenarios that ask about the other samples.

use super::knot::Mesh;
use image::RgbImage;
use octoscope_core::geometry::Ray;
use octoscope_core::scenario::{AnyScenario, Scenario, Source};
use octoscope_core::scene::{Content, Image};
use octoscope_core::tree::Recipe;
use octoscope_import::hash;

/// A ray over the lake and up into the sky; `file` is what `landscape.png` holds.
pub fn lecture(picture: &RgbImage, file: &[u8]) -> AnyScenario {
    let (width, height) = picture.dimensions();
    let pixels = picture.pixels().map(|pixel| pixel.0).collect();
    let content = Content::Image(Image { width, height, pixels });
    let ray = Ray::new([-24.0, 52.0], [256.0, 176.0]).expect("finite and not zero");
    let recipe = Recipe { depth: 7, threshold: 32, ..Recipe::default() };
    let scenario = Scenario::of(source("landscape.png", file), &content);
    AnyScenario::Quadtree(Scenario { ray, recipe, ..scenario })
}

/// A ray through three turns of the knot; `file` is what `knot.obj` holds.
pub fn knot(mesh: &Mesh, file: &[u8]) -> AnyScenario {
    let content = Content::Triangles(mesh.triangles());
    let ray = Ray::new([-80.0, -30.0, -9.0], [160.0, 60.0, 20.0]).expect("finite and not zero");
    let scenario = Scenario::of(source("knot.obj", file), &content);
    AnyScenario::Octree(Scenario { ray, ..scenario })
}

fn source<const D: usize>(path: &str, file: &[u8]) -> Source<D> {
    Source::File { path: path.to_owned(), hash: hash(file), fit: false }
}
