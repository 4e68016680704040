//! Pictures, meshes, point clouds and texts as material for trees: bytes in,
//! [`Content`](octoscope_core::scene::Content) out.
//!
//! The crate reads no file by itself. Wrong, truncated or huge bytes give one
//! message that says what is wrong, where, and what would be right; a number of
//! items that a file announces is compared with its length before memory is
//! taken for them. At most [`MAX_PIXELS`], [`MAX_POINTS`] and [`MAX_TRIANGLES`]
//! are accepted.

mod cloud;
mod error;
mod hash;
mod hexadecimal;
mod import;
mod jpeg_end;
mod kind;
mod obj;
mod picture;
mod ply;
mod ply_header;
mod shape;
mod stl;
mod text_formats;
mod words;

pub use error::{ImportError, PictureFault, Place, import_texts};
pub use hash::hash;
pub use hexadecimal::hexadecimal;
pub use import::{Imported, import};
pub use kind::Kind;
pub use picture::MAX_PIXELS;
pub use shape::{MAX_POINTS, MAX_TRIANGLES};
pub use text_formats::{cells, rays};
