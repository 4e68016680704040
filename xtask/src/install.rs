//! Installing what is missing.

use crate::package::{Purpose, missing, needed};
use std::process::{Command, Stdio};

/// Sees to it that the packages for `purpose` are there.
///
/// # Errors
/// Tells the command that installs them where that needs a password, or that
/// the installation failed.
pub fn install(purpose: Purpose) -> Result<(), String> {
    let packages = needed(purpose);
    let Some(missing) = missing(&packages) else {
        eprintln!(
            "This is neither Debian nor Ubuntu; if something is missing, install what \
             corresponds to {}.",
            packages.join(" ")
        );
        return Ok(());
    };
    if missing.is_empty() {
        return Ok(());
    }
    let Some(prefix) = root_prefix() else {
        return Err(format!(
            "These packages are missing: {}\nInstall them, then try again:\n\n    {}\n",
            missing.join(" "),
            command_for_the_user(&missing, has_sudo())
        ));
    };
    eprintln!("Installing {} …", missing.join(" "));
    apt_get(prefix, &["update"])?;
    let install = ["install", "--yes", "--no-install-recommends"];
    apt_get(prefix, &[&install, &missing[..]].concat())
}

/// What makes a command one of root: nothing for root, `sudo` where it asks no
/// password.
fn root_prefix() -> Option<&'static [&'static str]> {
    let is_root = Command::new("id")
        .arg("-u")
        .output()
        .is_ok_and(|output| output.stdout.trim_ascii() == b"0");
    if is_root {
        return Some(&[]);
    }
    let sudo = Command::new("sudo")
        .args(["-n", "true"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    sudo.is_ok_and(|status| status.success()).then_some(&["sudo", "-n"])
}

/// Whether there is a `sudo`: a Debian whose root has a password comes without.
fn has_sudo() -> bool {
    let version =
        Command::new("sudo").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    version.is_ok_and(|status| status.success())
}

fn apt_get(prefix: &[&str], arguments: &[&str]) -> Result<(), String> {
    let words = [prefix, &["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"], arguments].concat();
    let status = Command::new(words[0]).args(&words[1..]).stdin(Stdio::null()).status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("this command failed: {}", words.join(" "))),
        Err(error) => Err(format!("this command could not be started, {error}: {}", words[0])),
    }
}

/// What a user types who has to give a password.
fn command_for_the_user(packages: &[&str], has_sudo: bool) -> String {
    let install = format!("apt-get install --no-install-recommends {}", packages.join(" "));
    if has_sudo {
        format!("sudo apt-get update && sudo {install}")
    } else {
        // `--login` for the path of root, without which dpkg refuses to work.
        format!("su --login --command 'apt-get update && {install}'")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_for_the_user_names_every_package() {
        assert_eq!(
            command_for_the_user(&["gcc", "xvfb"], true),
            "sudo apt-get update && sudo apt-get install --no-install-recommends gcc xvfb"
        );
    }

    #[test]
    fn without_sudo_the_command_asks_for_the_password_of_root() {
        assert_eq!(
            command_for_the_user(&["gcc", "xvfb"], false),
            "su --login --command 'apt-get update && \
             apt-get install --no-install-recommends gcc xvfb'"
        );
    }
}
