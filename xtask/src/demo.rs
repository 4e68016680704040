//! The main job, shown on a machine without a display.

use crate::cargo::{succeed, target_folder};
use crate::display::VirtualDisplay;
use std::path::Path;
use std::process::Command;

/// Opens the first built-in scene in the window of `program`, steps its ray to
/// the end, and leaves a screenshot and the trace.
///
/// # Errors
/// Says what has failed.
pub fn demo(program: &Path, display: &VirtualDisplay) -> Result<(), String> {
    let folder = target_folder()?.join("demo");
    std::fs::create_dir_all(&folder)
        .map_err(|error| format!("the folder cannot be made, {error}: {}", folder.display()))?;
    let [screenshot, trace] =
        ["octoscope.png", "octoscope.trace.txt"].map(|name| folder.join(name));

    // A picture of an earlier run must not pass for one of this.
    if screenshot.exists() {
        std::fs::remove_file(&screenshot)
            .map_err(|error| format!("the old picture stays, {error}: {}", screenshot.display()))?;
    }

    let scenes = Command::new(program)
        .arg("scenes")
        .output()
        .map_err(|error| format!("the program could not be started: {error}"))?;
    let scene = first_scene(&String::from_utf8_lossy(&scenes.stdout))
        .ok_or("the program lists no built-in scene")?;

    succeed(Command::new(program).args(["trace", &scene, "-o"]).arg(&trace))?;
    let mut window = Command::new(program);
    window.arg("--demo-screenshot").arg(&screenshot).env("WGPU_BACKEND", "vulkan");
    display.show(&mut window, &folder);
    succeed(&mut window)?;
    if !screenshot.is_file() {
        return Err(format!("the window left no picture: {}", screenshot.display()));
    }
    println!("Screenshot of {scene}  {}", screenshot.display());
    println!("Trace of {scene}       {}", trace.display());
    Ok(())
}

/// Identifier of the first scene in the list that `octoscope scenes` prints.
fn first_scene(list: &str) -> Option<String> {
    list.split_whitespace().find(|word| word.starts_with("scene:")).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_scene_is_the_first_word_that_names_one() {
        let list = "Scenes\n  scene:figure-1  A tree\n  scene:cloud  Spheres\n";
        assert_eq!(first_scene(list).as_deref(), Some("scene:figure-1"));
        assert_eq!(first_scene("Algorithms\n  codes\n"), None);
    }
}
