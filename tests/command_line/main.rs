//! The command line as its users meet it: the real program, its output, its
//! messages and its exit status.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod arguments;
mod bench;
mod desk;
mod export;
mod files;
mod matrix;
mod samples;
mod scenario;
mod visit;
