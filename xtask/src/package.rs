//! Packages of Debian and Ubuntu that the program needs.

use std::process::{Command, Stdio};

/// What the packages are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Building and testing, pictures included; no display.
    Test,
    /// A window on the user's display.
    Window,
    /// A window on a display that nobody sees.
    HiddenWindow,
}

/// Names of the packages that `purpose` needs.
pub fn needed(purpose: Purpose) -> Vec<&'static str> {
    let build = ["gcc", "libc6-dev"];
    let driver = ["mesa-vulkan-drivers"];
    // What counts instructions.
    let counter: &[_] = if purpose == Purpose::Test { &["valgrind"] } else { &[] };
    let window = ["libx11-6", "libx11-xcb1", "libxcursor1", "libxi6", "libxkbcommon-x11-0"];
    let display = ["xvfb"];
    let (window, display): (&[_], &[_]) = match purpose {
        Purpose::Test => (&[], &[]),
        Purpose::Window => (&window, &[]),
        Purpose::HiddenWindow => (&window, &display),
    };
    [&build[..], &driver, counter, window, display].concat()
}

/// Those of `packages` that are not installed, or `None` on a system without
/// Debian's package manager.
pub fn missing(packages: &[&'static str]) -> Option<Vec<&'static str>> {
    let output = Command::new("dpkg-query")
        .args(["--show", "--showformat=${Package} ${db:Status-Status}\n"])
        .args(packages)
        .stderr(Stdio::null())
        .output()
        .ok()?;
    Some(not_installed(packages, &String::from_utf8_lossy(&output.stdout)))
}

/// Those of `packages` that the answer of `dpkg-query`, lines of name and
/// state, does not call installed.
fn not_installed(packages: &[&'static str], answer: &str) -> Vec<&'static str> {
    let is_installed =
        |package: &str| answer.lines().any(|line| line == format!("{package} installed"));
    packages.iter().copied().filter(|package| !is_installed(package)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_hidden_window_needs_a_virtual_display() {
        assert!(needed(Purpose::HiddenWindow).contains(&"xvfb"));
        assert!(!needed(Purpose::Window).contains(&"xvfb"));
        assert!(!needed(Purpose::Test).contains(&"libx11-6"));
        assert!(!needed(Purpose::Window).contains(&"valgrind"));
    }

    #[test]
    fn unknown_and_removed_packages_are_missing() {
        let answer = "gcc installed\nxvfb config-files\n";
        assert_eq!(not_installed(&["gcc", "xvfb", "libxi6"], answer), ["xvfb", "libxi6"]);
    }
}
