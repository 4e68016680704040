//! Figures as pixels.

use crate::fonts;
use resvg::{tiny_skia, usvg};
use std::sync::{Arc, LazyLock};
use thiserror::Error;

/// Why a picture could not be made.
#[derive(Debug, Error)]
pub enum PngError {
    /// The text is no SVG.
    #[error("this is no SVG that can be drawn: {0}")]
    Svg(#[from] usvg::Error),
    /// The picture would have no pixels, or more than 16 384 along a side.
    #[error("a picture of {0} × {1} pixels is not possible; choose 1 to 16384 along each side")]
    Size(u32, u32),
    /// The pixels could not be compressed.
    #[error("the picture could not be written: {0}")]
    Encode(String),
}

/// PNG file of an SVG document that is `width` pixels wide and as high as its
/// proportions ask for. Text is set in the typefaces of [`fonts`].
///
/// # Errors
/// Refuses what is no SVG, and sizes without pixels or with far too many.
pub fn png(svg: &str, width: u32) -> Result<Vec<u8>, PngError> {
    static TYPEFACES: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
        let mut database = usvg::fontdb::Database::new();
        for font in fonts::ALL {
            database.load_font_data(font.to_vec());
        }
        database.set_sans_serif_family("Inter");
        database.set_monospace_family("JetBrains Mono");
        Arc::new(database)
    });
    const LARGEST: u32 = 1 << 14;

    let options = usvg::Options {
        fontdb: TYPEFACES.clone(),
        font_family: "Inter".to_string(),
        ..usvg::Options::default()
    };
    let tree = usvg::Tree::from_str(svg, &options)?;
    let scale = width as f32 / tree.size().width();
    let height = (tree.size().height() * scale).round() as u32;
    if !(1..=LARGEST).contains(&width) || !(1..=LARGEST).contains(&height) {
        return Err(PngError::Size(width, height));
    }
    let pixmap = tiny_skia::Pixmap::new(width, height);
    let mut pixmap = pixmap.ok_or(PngError::Size(width, height))?;
    let transform = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, transform, &mut pixmap.as_mut());
    pixmap.encode_png().map_err(|error| PngError::Encode(error.to_string()))
}

/// PNG file of opaque pixels: red, green, blue and 255, row by row from the top.
///
/// # Errors
/// Refuses another number of bytes than 4 · `width` · `height`.
pub fn png_of_pixels(width: u32, height: u32, pixels: Vec<u8>) -> Result<Vec<u8>, PngError> {
    let size = tiny_skia::IntSize::from_wh(width, height);
    let pixmap = size.and_then(|size| tiny_skia::Pixmap::from_vec(pixels, size));
    let pixmap = pixmap.ok_or(PngError::Size(width, height))?;
    pixmap.encode_png().map_err(|error| PngError::Encode(error.to_string()))
}
