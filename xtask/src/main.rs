//! Sets up a fresh Debian or Ubuntu, then builds and runs or tests the program.
//!
//! `cargo xtask run` opens the window; `cargo xtask test` runs all tests; `cargo
//! xtask bench` measures the core and writes `BENCHMARKS.md`. What
//! is missing on the machine is installed if that needs no password, otherwise
//! the command that installs it is printed.

mod bench;
mod cargo;
mod demo;
mod display;
mod install;
mod package;
mod run;
mod test;

use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask run [ARGUMENTS…]   build in release, open the window
       cargo xtask test               run all tests
       cargo xtask bench              measure, write BENCHMARKS.md

Run and test first install what is missing on a Debian or Ubuntu machine.";

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let done = match arguments.next().as_deref() {
        Some("run") => run::run(arguments.collect()),
        Some("test") => test::test(arguments.collect()),
        Some("bench") => bench::bench(),
        Some("help" | "--help" | "-h") => {
            println!("{USAGE}");
            Ok(())
        }
        Some(other) => Err(format!("there is no task ‘{other}’\n\n{USAGE}")),
        None => Err(USAGE.to_owned()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
