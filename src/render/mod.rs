//! The tree and its scene, drawn by the GPU.
//!
//! A [`Picture`] is a [`View`] of [`Layer`]s; a layer is immutable and
//! uploaded once. [`paint`] shows a picture in the window; [`render_to_image`]
//! draws it without one. Every picture has targets of its own (colour, depth
//! and, where a GPU is at hand, several samples a pixel) and is drawn again
//! only if something in it changed. [`paint_in_steps`] shows a coarse one while
//! it changes, and draws the whole one bit by bit. Colours are the interface's: premultiplied
//! and blended gamma-encoded.
//!
//! Only this module names wgpu. No storage buffers are used, so that OpenGL ES
//! and WebGL will do.

mod buffers;
mod camera;
mod draw;
mod image;
mod instance;
mod layer;
mod mark;
mod mesh;
mod paint;
mod pipelines;
mod renderer;
mod steps;
#[cfg(test)]
mod tests;

pub use camera::{Plane, Space, View};
pub use image::{Gpu, ImageError, render_to_image};
pub use instance::{Cell, Grid};
pub use layer::{BoxStyle, Layer};
pub use mark::{BoxMark, Line};
pub use paint::{Pace, Picture, Speed, install, paint, paint_in_steps, stats};
pub use renderer::Stats;
