//! The command line: one file a command.
//!
//! Results go to standard output or a file, messages to standard error. A
//! command answers [`Answer::Done`] or [`Answer::No`], or fails; these are the
//! exit statuses 0, 1 and 2.

mod bench;
mod check;
mod export;
mod progress;
mod ray;
mod scenes;
mod trace;
mod values;
mod visit;

use crate::files;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Shows quadtrees and octrees and every step of the algorithms on them.
///
/// Without a command, opens the window. Exit status: 0 done; 1 the answer is no
/// (a comparison found a difference, a check failed); 2 bad arguments or input.
#[derive(Debug, Parser)]
#[command(
    name = "octoscope",
    version,
    args_conflicts_with_subcommands = true,
    after_long_help = "Examples:\n  \
        octoscope scene:cloud\n  \
        octoscope lecture.octo\n  \
        octoscope trace scene:quadtree-82 --lang de\n  \
        octoscope export scene:quadtree-82 --view space --step last -o figure.svg\n  \
        octoscope scenes\n  \
        octoscope visit --cells a.cells --depth 6 --rays a.rays --algorithm all"
)]
pub struct Arguments {
    /// What to do instead of opening the window.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Scenario or data file that the window opens, or scene:NAME.
    pub file: Option<PathBuf>,
    /// Steps the ray of the first built-in scene to its end, writes a picture
    /// of the window and ends.
    #[arg(long, value_name = "FILE", hide = true)]
    pub demo_screenshot: Option<PathBuf>,
}

impl Arguments {
    /// The arguments that the program was started with. Ends the program if
    /// they are wrong or ask for help.
    pub fn from_command_line() -> Self {
        if let Some(word) = std::env::args_os().nth(1)
            && let Some(message) = no_command(&word)
        {
            Self::command().error(ErrorKind::InvalidSubcommand, message).exit();
        }
        Self::parse()
    }
}

/// What can be done without a window.
#[derive(Debug, Subcommand)]
#[expect(missing_docs, reason = "what stands at the arguments of each is its help text")]
pub enum Command {
    Trace(trace::Trace),
    Export(Box<export::Export>),
    Check(check::Check),
    Visit(visit::Visit),
    Bench(bench::Bench),
    Scenes(scenes::Scenes),
}

/// What is wrong with a first word that looks like a command and is none, nor
/// a file.
fn no_command(word: &OsStr) -> Option<String> {
    let word = word.to_str()?;
    let looks_like_one = word.chars().all(|c| c.is_alphanumeric()) && !word.is_empty();
    let mut program = Arguments::command();
    program.build();
    let commands: Vec<&str> = program.get_subcommands().map(clap::Command::get_name).collect();
    if !looks_like_one || commands.contains(&word) || files::is_there(Path::new(word)) {
        return None;
    }
    let known = commands.join(", ");
    Some(format!("there is neither a command nor a file ‘{word}’; the commands are {known}"))
}

/// How a command ended that did not fail.
#[derive(Debug, PartialEq, Eq)]
pub enum Answer {
    /// It is done.
    Done,
    /// The answer is no, for this reason.
    No(String),
}

/// Runs a command and tells its exit status; messages go to standard error. A
/// broken pipe ends it quietly.
pub fn run(command: &Command) -> ExitCode {
    let answer = match command {
        Command::Trace(arguments) => trace::trace(arguments),
        Command::Export(arguments) => export::export(arguments),
        Command::Check(arguments) => check::check(arguments),
        Command::Visit(arguments) => visit::visit(arguments),
        Command::Bench(arguments) => bench::bench(arguments),
        Command::Scenes(arguments) => scenes::scenes(arguments),
    };
    match answer {
        Ok(Answer::Done) => ExitCode::SUCCESS,
        Ok(Answer::No(reason)) => {
            tell(&reason);
            ExitCode::from(1)
        }
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            tell(&format!("{error:#}"));
            ExitCode::from(2)
        }
    }
}

/// Writes a message to standard error; if nobody reads it, that is no fault.
pub fn tell(message: &str) {
    let _ = writeln!(io::stderr(), "octoscope: {message}");
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>())
        .any(|cause| cause.kind() == io::ErrorKind::BrokenPipe)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_well_formed() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn a_file_opens_the_window_and_a_command_does_not() {
        let parse = |words: &[&str]| Arguments::try_parse_from(words).unwrap();
        assert!(parse(&["octoscope"]).command.is_none());
        assert_eq!(parse(&["octoscope", "a.png"]).file, Some("a.png".into()));
        assert!(parse(&["octoscope", "scenes"]).command.is_some());
        assert!(Arguments::try_parse_from(["octoscope", "--no-such"]).is_err());
    }
}
