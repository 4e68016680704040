//! Calling cargo.

use std::path::PathBuf;
use std::process::Command;

/// The cargo that runs this task.
pub fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Runs `command` to its end.
///
/// # Errors
/// Says what failed.
pub fn succeed(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{} failed ({status})", words(command))),
        Err(error) => Err(format!("{} could not be started: {error}", words(command))),
    }
}

/// Builds the program in release and returns the path of its binary.
///
/// # Errors
/// Says that the build failed.
pub fn build_release() -> Result<PathBuf, String> {
    succeed(cargo().args(["build", "--release", "--package", "octoscope"]))?;
    Ok(target_folder()?.join("release").join(format!("octoscope{}", std::env::consts::EXE_SUFFIX)))
}

/// Folder of everything that is built: two above this program.
pub fn target_folder() -> Result<PathBuf, String> {
    let own = std::env::current_exe()
        .map_err(|error| format!("the folder of this program is unknown: {error}"))?;
    let target = own.ancestors().nth(2).ok_or("this program does not lie in a target folder")?;
    Ok(target.to_owned())
}

fn words(command: &Command) -> String {
    let program = command.get_program().to_string_lossy();
    let name = program.rsplit('/').next().unwrap_or_default().to_owned();
    let arguments = command.get_args().map(|argument| argument.to_string_lossy().into_owned());
    std::iter::once(name).chain(arguments).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_named_without_its_folder() {
        let mut command = Command::new("/usr/bin/cargo");
        command.args(["test", "--workspace"]);
        assert_eq!(words(&command), "cargo test --workspace");
    }

    #[test]
    fn failure_names_the_command() {
        assert!(succeed(&mut Command::new("false")).unwrap_err().starts_with("false failed"));
        assert_eq!(succeed(&mut Command::new("true")), Ok(()));
    }
}
