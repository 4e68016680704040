//! Writes the trees and rays of the measurements as files that `octoscope visit`
//! reads: NAME.cells and NAME.rays in the given folder.
//!
//!     cargo run --release -p octoscope-core --example workload FOLDER
//!     octoscope visit --cells FOLDER/cloud-d8.cells --depth 8 --keep-cells \
//!         --rays FOLDER/ext100k.rays --algorithm parametric --summary

use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;
use workload::{Rays, Scene};

#[path = "../benches/workload/mod.rs"]
mod workload;

const TREES: [(Scene, u8); 7] = [
    (Scene::Grid(3), 6),
    (Scene::Grid(4), 8),
    (Scene::Grid(5), 8),
    (Scene::Cloud, 8),
    (Scene::Cloud, 10),
    (Scene::Boxes, 8),
    (Scene::Triangles, 8),
];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("give a folder for the files")?);
    std::fs::create_dir_all(&folder)?;
    for (scene, depth) in TREES {
        let path = folder.join(format!("{}-d{depth}.cells", scene.name()));
        let mut file = BufWriter::new(File::create(&path)?);
        let tree = scene.tree(depth);
        for leaf in tree.leaves().filter(|leaf| leaf.is_full()) {
            let [x, y, z] = tree.code(leaf.id);
            writeln!(file, "{x} {y} {z}")?;
        }
        file.flush()?;
        println!("{}", path.display());
    }
    for rays in [Rays::Outside, Rays::Inside, Rays::Camera] {
        let path = folder.join(format!("{}.rays", rays.name()));
        let mut file = BufWriter::new(File::create(&path)?);
        for ray in rays.all() {
            let numbers: Vec<String> =
                ray.origin().into_iter().chain(ray.direction()).map(|x| x.to_string()).collect();
            writeln!(file, "{}", numbers.join(" "))?;
        }
        file.flush()?;
        println!("{}", path.display());
    }
    Ok(())
}
