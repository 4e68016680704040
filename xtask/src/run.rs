//! `cargo xtask run`.

use crate::cargo::{build_release, succeed, target_folder};
use crate::demo::demo;
use crate::display::VirtualDisplay;
use crate::install::install;
use crate::package::Purpose;
use std::process::Command;

/// Builds the program in release and starts it with `arguments`. Without a
/// display it runs on a virtual one, and without arguments shows its main job
/// there: a screenshot and a trace.
///
/// # Errors
/// Says what is missing or has failed.
pub fn run(arguments: Vec<String>) -> Result<(), String> {
    let has_display = ["DISPLAY", "WAYLAND_DISPLAY"]
        .iter()
        .any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()));
    install(if has_display { Purpose::Window } else { Purpose::HiddenWindow })?;
    let program = build_release()?;
    if has_display {
        return succeed(Command::new(program).args(arguments));
    }
    let display = VirtualDisplay::start()?;
    if arguments.is_empty() {
        eprintln!("There is no display, so the window opens on a virtual one, {}.", display.name);
        return demo(&program, &display);
    }
    let mut window = Command::new(program);
    window.args(arguments);
    display.show(&mut window, &target_folder()?);
    succeed(&mut window)
}
