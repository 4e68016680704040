//! Octoscope shows quadtrees and octrees, and every step of the algorithms on
//! them: in a window and on the command line.

pub mod cli;
pub mod files;
pub mod render;
