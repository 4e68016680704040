//! The sample files: every byte follows from the rules here.
//!
//! Coordinates are rounded to the last place that is written, so that the same
//! shape reads back equal from each of its files.

pub mod example;
pub mod galaxy;
pub mod knot;
pub mod landscape;
pub mod picture;
pub mod scenarios;
pub mod spheres;

use image::ImageFormat;

/// Name and content of every sample file.
pub fn files() -> Vec<(&'static str, Vec<u8>)> {
    let landscape = landscape::landscape();
    let png = picture::encode(&landscape, ImageFormat::Png);
    let (mesh, points) = (knot::knot(), galaxy::galaxy());
    let knot_obj = knot::obj(&mesh);
    vec![
        ("lecture.octo", scenarios::lecture(&landscape, &png).print().into_bytes()),
        ("landscape.png", png),
        ("spheres.jpg", picture::encode(&spheres::spheres(), ImageFormat::Jpeg)),
        ("knot.octo", scenarios::knot(&mesh, knot_obj.as_bytes()).print().into_bytes()),
        ("knot.obj", knot_obj.into_bytes()),
        ("knot.stl", knot::stl(&mesh)),
        ("knot.ply", knot::ply(&mesh)),
        ("galaxy.xyz", galaxy::xyz(&points).into_bytes()),
        ("galaxy.csv", galaxy::csv(&points).into_bytes()),
        ("galaxy.ply", galaxy::ply(&points)),
        ("example.cells", example::cells().into_bytes()),
        ("example.rays", example::rays().into_bytes()),
    ]
}
