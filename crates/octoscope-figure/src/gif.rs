//! Pixels as animated GIF.

use crate::Pixels;
use crate::colours::FewColours;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use std::borrow::Cow;
use std::io::Write;
use thiserror::Error;

/// Why a GIF could not be made.
#[derive(Debug, Error)]
pub enum GifError {
    /// It could not be compressed or written.
    #[error("the GIF could not be written: {0}")]
    Encode(#[from] EncodingError),
    /// It could not be ended.
    #[error("the GIF could not be written: {0}")]
    Write(#[from] std::io::Error),
}

/// A GIF that is being written: the same colours in all frames, and of every
/// frame what has changed.
pub struct Gif<W: Write> {
    encoder: Encoder<W>,
    colours: FewColours,
    before: Option<Pixels>,
    pause: u16,
}

/// Number that stands for what is transparent or unchanged.
const CLEAR: u8 = 255;

impl<W: Write> Gif<W> {
    /// Begins a GIF whose frames are shown for `pause_secs` each, over and over
    /// again. `samples` are some of them, from which the colours are taken.
    ///
    /// # Errors
    /// Says what could not be written.
    pub fn begin(out: W, samples: &[Pixels], pause_secs: f64) -> Result<Self, GifError> {
        let colours = FewColours::of(samples);
        // Pictures have at most 16 384 pixels along a side.
        let [width, height] =
            samples.first().map_or([1; 2], |first| [first.width, first.height].map(|n| n as u16));
        let mut palette = colours.palette();
        palette.resize(3 * 256, 0);
        let mut encoder = Encoder::new(out, width, height, &palette)?;
        encoder.set_repeat(Repeat::Infinite)?;
        let pause = (pause_secs * 100.0).round().clamp(2.0, 65e3) as u16;
        Ok(Self { encoder, colours, before: None, pause })
    }

    /// Appends a frame.
    ///
    /// # Errors
    /// Says what could not be written.
    pub fn frame(&mut self, pixels: Pixels) -> Result<(), GifError> {
        let whole = [0, 0, pixels.width, pixels.height];
        let is_clear = pixels.rgba.chunks_exact(4).any(|pixel| pixel[3] < 128);
        // What is transparent must not show the frame before.
        let before = self.before.take().filter(|_| !is_clear);
        let part = match &before {
            Some(before) => pixels.changed_from(before).unwrap_or([0, 0, 1, 1]),
            None => whole,
        };
        let then = before.map(|before| before.part(part));
        let now = pixels.part(part);
        let numbers = now.chunks_exact(4).enumerate().map(|(index, pixel)| {
            let is_same = then.as_ref().is_some_and(|then| then[4 * index..][..4] == *pixel);
            if is_same || pixel[3] < 128 {
                CLEAR
            } else {
                self.colours.number([pixel[0], pixel[1], pixel[2]])
            }
        });
        let numbers: Vec<u8> = numbers.collect();
        let [left, top, width, height] = part.map(|side| side as u16);
        let dispose = if is_clear { DisposalMethod::Background } else { DisposalMethod::Keep };
        self.encoder.write_frame(&Frame {
            delay: self.pause,
            dispose,
            transparent: Some(CLEAR),
            left,
            top,
            width,
            height,
            buffer: Cow::Owned(numbers),
            ..Frame::default()
        })?;
        self.before = Some(pixels);
        Ok(())
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Says what could not be written.
    pub fn finish(self) -> Result<(), GifError> {
        self.encoder.into_inner()?;
        Ok(())
    }
}
