//! The program's modules; `main.rs` only starts them.

pub mod render;
