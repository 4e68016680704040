//! The window as its users meet it: the real program, operated by mouse and
//! keyboard through the accessibility tree.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod algorithms;
mod controls;
mod desk;
mod export;
mod files;
mod layout;
mod panels;
mod paper;
mod pictures;
mod queries;
mod ray;
mod steps;
