//! Arguments → window or command.

use octoscope::cli::{self, Arguments};
use octoscope::window::{self, Opening};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::from_command_line();
    if let Some(command) = arguments.command {
        return cli::run(&command);
    }
    let opening = Opening { file: arguments.file, picture: arguments.demo_screenshot };
    match window::run(opening) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            cli::tell(&format!("{error:#}"));
            ExitCode::from(2)
        }
    }
}
