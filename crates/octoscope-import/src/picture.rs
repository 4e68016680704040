//! Pictures: PNG and JPEG.

use crate::error::{ImportError, PictureFault};
use crate::jpeg_end::jpeg_is_whole;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use octoscope_core::progress::Progress;
use octoscope_core::scene::Image;
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Most pixels that are accepted, 2^26.
pub const MAX_PIXELS: u64 = 1 << 26;

/// The picture in a PNG or JPEG file, turned as its camera says, transparent
/// parts laid on white.
///
/// # Errors
/// Refuses more than [`MAX_PIXELS`], a JPEG that ends too early, and what the
/// decoder refuses.
pub fn read(bytes: &[u8], format: ImageFormat, progress: &Progress) -> Result<Image, ImportError> {
    progress.start(0);
    progress.check()?;
    if format == ImageFormat::Jpeg && !jpeg_is_whole(bytes) {
        return Err(ImportError::Picture(PictureFault::EndsEarly));
    }
    // The last resort against a decoder that panics on a damaged file: nothing
    // of it is used afterwards.
    let decoded = catch_unwind(AssertUnwindSafe(|| decode(bytes, format)));
    let picture = decoded.unwrap_or(Err(ImportError::Picture(PictureFault::GivenUp)))?;
    progress.check()?;
    let (width, height) = (picture.width(), picture.height());
    let pixels = picture.into_rgba8().pixels().map(|pixel| on_white(pixel.0)).collect();
    Ok(Image { width, height, pixels })
}

fn decode(bytes: &[u8], format: ImageFormat) -> Result<DynamicImage, ImportError> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(16 * MAX_PIXELS);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(|error| damaged(&error))?;
    let (width, height) = decoder.dimensions();
    let found = u64::from(width) * u64::from(height);
    if found > MAX_PIXELS {
        return Err(ImportError::TooLarge { what: "pixels", found, limit: MAX_PIXELS });
    }
    let orientation = decoder.orientation().map_err(|error| damaged(&error))?;
    let mut picture = DynamicImage::from_decoder(decoder).map_err(|error| damaged(&error))?;
    picture.apply_orientation(orientation);
    Ok(picture)
}

fn damaged(reason: &impl ToString) -> ImportError {
    let reason = reason.to_string().trim_end_matches('.').to_owned();
    ImportError::Picture(PictureFault::Decoder(reason))
}

fn on_white([r, g, b, alpha]: [u8; 4]) -> [u8; 3] {
    let alpha = u32::from(alpha);
    [r, g, b].map(|c| ((u32::from(c) * alpha + 255 * (255 - alpha) + 127) / 255) as u8)
}

#[cfg(test)]
mod tests {
    use super::on_white;

    #[test]
    fn transparent_parts_are_laid_on_white() {
        assert_eq!(on_white([10, 20, 30, 255]), [10, 20, 30]);
        assert_eq!(on_white([10, 20, 30, 0]), [255; 3]);
        assert_eq!(on_white([0, 0, 0, 128]), [127; 3]);
    }
}
