//! Pixels as PNG and as animated PNG.

use crate::{Figure, FileOptions, Pixels, PixelsError};
use png::{BitDepth, BlendOp, ColorType, DisposeOp, Encoder, EncodingError};
use std::io::Write;
use thiserror::Error;

/// Keyword of the scenario among the texts of a PNG.
pub(crate) const KEYWORD: &str = "octoscope";

/// Why a picture could not be made.
#[derive(Debug, Error)]
pub enum PngError {
    /// It could not be drawn.
    #[error(transparent)]
    Pixels(#[from] PixelsError),
    /// The pixels could not be compressed or written.
    #[error("the picture could not be written: {0}")]
    Encode(#[from] EncodingError),
}

/// PNG file of a figure; a page unit is as many pixels as the scale says, in
/// whatever unit.
///
/// # Errors
/// Refuses sizes without pixels or with far too many.
pub fn png(figure: &Figure, options: &FileOptions) -> Result<Vec<u8>, PngError> {
    Ok(png_of_pixels(&Pixels::of(figure, options)?, options.title, options.scenario)?)
}

/// PNG file of pixels, with a title and a scenario inside, or none if empty.
///
/// # Errors
/// Refuses another number of bytes than 4 · width · height.
pub fn png_of_pixels(
    pixels: &Pixels,
    title: &str,
    scenario: &str,
) -> Result<Vec<u8>, EncodingError> {
    let mut file = Vec::new();
    let mut writer = encoder(&mut file, pixels, title, scenario)?.write_header()?;
    writer.write_image_data(&pixels.rgba)?;
    writer.finish()?;
    Ok(file)
}

fn encoder<'a, W: Write>(
    out: W,
    pixels: &Pixels,
    title: &str,
    scenario: &str,
) -> Result<Encoder<'a, W>, EncodingError> {
    let mut encoder = Encoder::new(out, pixels.width, pixels.height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    for (keyword, text) in [("Title", title), (KEYWORD, scenario)] {
        if !text.is_empty() {
            encoder.add_itxt_chunk(keyword.to_owned(), text.to_owned())?;
        }
    }
    Ok(encoder)
}

/// An animated PNG that is being written.
pub struct Apng<W: Write> {
    writer: png::Writer<W>,
    before: Pixels,
}

impl<W: Write> Apng<W> {
    /// Begins with the first of `n_frames` frames, each of which is shown for
    /// `pause_secs`, over and over again.
    ///
    /// # Errors
    /// Says what could not be written.
    pub fn begin(
        out: W,
        first: Pixels,
        n_frames: u32,
        pause_secs: f64,
        options: &FileOptions,
    ) -> Result<Self, EncodingError> {
        let mut encoder = encoder(out, &first, options.title, options.scenario)?;
        encoder.set_animated(n_frames, 0)?;
        encoder.set_frame_delay((pause_secs * 1000.0).round().clamp(1.0, 65e3) as u16, 1000)?;
        encoder.set_blend_op(BlendOp::Source)?;
        encoder.set_dispose_op(DisposeOp::None)?;
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&first.rgba)?;
        Ok(Self { writer, before: first })
    }

    /// Appends a frame: what has changed.
    ///
    /// # Errors
    /// Says what could not be written.
    pub fn frame(&mut self, pixels: Pixels) -> Result<(), EncodingError> {
        // Every frame has at least one pixel.
        let part = pixels.changed_from(&self.before).unwrap_or([0, 0, 1, 1]);
        let [left, top, width, height] = part;
        self.writer.reset_frame_position()?;
        self.writer.set_frame_dimension(width, height)?;
        self.writer.set_frame_position(left, top)?;
        self.writer.write_image_data(&pixels.part(part))?;
        self.before = pixels;
        Ok(())
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Says what could not be written; frames that are missing, too.
    pub fn finish(self) -> Result<(), EncodingError> {
        self.writer.finish()
    }
}
