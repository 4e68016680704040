//! Writes the sample files into `assets/scenes`:
//! `cargo run -p octoscope-import --example make_samples`.

mod samples;

use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    std::fs::create_dir_all(&folder)?;
    for (name, bytes) in samples::files() {
        std::fs::write(folder.join(name), &bytes)?;
        println!("{name}: {} bytes", bytes.len());
    }
    Ok(())
}
