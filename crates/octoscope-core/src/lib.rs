//! Trees, location codes, queries and ray traversals, each of which can be
//! watched step by step.
//!
//! The path through the crate is the path through the product:
//! [`scenario`] (the question) → [`tree`] → [`trace`] (what an algorithm did)
//! → [`trace::Moment`] (where it stands after n steps) → [`explain`] (the same
//! in words). Every algorithm of [`locate`] and [`traverse`] is written once;
//! what is timed, traced, counted and checked is the same code, seen through
//! another [`event::Observer`].
//!
//! The crate knows no file, clock or window, and threads only in [`threads`].

pub mod event;
pub mod explain;
pub mod family;
pub mod gallery;
pub mod geometry;
pub mod locate;
pub mod measure;
pub mod paper;
pub mod progress;
pub mod query;
pub mod random;
pub mod scenario;
pub mod scene;
pub mod text;
pub mod threads;
pub mod trace;
pub mod traverse;
pub mod tree;
pub mod variant;
