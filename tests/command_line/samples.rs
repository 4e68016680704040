//! The page of sample figures is what its commands make.

use crate::desk::desk_with_scenario;
use resvg::tiny_skia::Pixmap;
use std::fs;
use std::path::{Path, PathBuf};

/// The arguments and the file of every command on the page.
fn commands(page: &str) -> Vec<(String, String)> {
    let line = |line: &str| {
        let arguments = line.strip_prefix("    octoscope ")?;
        let (arguments, name) = arguments.split_once(" -o ")?;
        Some((arguments.to_owned(), name.to_owned()))
    };
    page.lines().filter_map(line).collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("screenshots/figures")
}

#[test]
fn every_sample_is_what_its_command_makes() {
    let desk = desk_with_scenario();
    let page = fs::read_to_string(folder().join("README.md")).unwrap();
    let commands = commands(&page);
    assert!(commands.len() >= 14, "{commands:?}");
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    for (arguments, name) in commands {
        let scenes = format!("{}/", scenes.display());
        let arguments = arguments.replace("../../assets/scenes/", &scenes);
        desk.prints(&format!("{arguments} --scale 2 -o a.png"));
        let (made, kept) = (desk.0.path().join("a.png"), folder().join(&name));
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            fs::copy(&made, &kept).unwrap();
        }
        let [made, kept] =
            [&made, &kept].map(|path| Pixmap::decode_png(&fs::read(path).unwrap_or_default()).ok());
        let (Some(made), Some(kept)) = (made, kept) else { panic!("{name} is no picture") };
        let is_same = made.width() == kept.width() && made.data() == kept.data();
        assert!(is_same, "{name}: UPDATE_SNAPSHOTS=1 makes it anew");
        assert!(page.contains(&format!("![]({name})")), "{name} is not shown");
    }
}
