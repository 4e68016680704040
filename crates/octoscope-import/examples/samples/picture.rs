//! From colours of places to the bytes of a picture.

use image::codecs::jpeg::JpegEncoder;
use image::{ImageFormat, RgbImage};
use std::io::Cursor;

/// Red, green and blue, 0 … 255.
pub type Colour = [f64; 3];

/// Picture of a function of the place: mean of 3 × 3 samples a pixel.
///
/// `colour`: takes x from the left and y from below, in units of the height.
pub fn paint(width: u32, height: u32, colour: impl Fn(f64, f64) -> Colour) -> RgbImage {
    const SAMPLES: u32 = 3;
    let unit = f64::from(SAMPLES * height);
    RgbImage::from_fn(width, height, |column, row| {
        let mut sum = [0.0; 3];
        for number in 0..SAMPLES * SAMPLES {
            let x = f64::from(column * SAMPLES + number % SAMPLES) + 0.5;
            let y = f64::from(row * SAMPLES + number / SAMPLES) + 0.5;
            let sample = colour(x / unit, 1.0 - y / unit);
            sum = std::array::from_fn(|c| sum[c] + sample[c]);
        }
        let mean = sum.map(|c| c / f64::from(SAMPLES * SAMPLES));
        image::Rgb(mean.map(|c| c.round().clamp(0.0, 255.0) as u8))
    })
}

/// Colour between `a` (`t` = 0 or less) and `b` (`t` = 1 or more).
pub fn blend(a: Colour, b: Colour, t: f64) -> Colour {
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
}

/// The picture as a file: lossless, or a JPEG of quality 90.
pub fn encode(picture: &RgbImage, format: ImageFormat) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let written = match format {
        ImageFormat::Jpeg => {
            picture.write_with_encoder(JpegEncoder::new_with_quality(&mut file, 90))
        }
        _ => picture.write_to(&mut file, format),
    };
    written.expect("a small picture in memory can be written");
    file.into_inner()
}
