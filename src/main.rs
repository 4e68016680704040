//! Arguments → window or command.

use octoscope::cli::{self, Arguments};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::from_command_line();
    match arguments.command {
        Some(command) => cli::run(&command),
        None => {
            eprintln!("octoscope: this build has no window; try ‘octoscope help’");
            ExitCode::from(2)
        }
    }
}
