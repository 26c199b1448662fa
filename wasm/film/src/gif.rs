//! GIF: 255 colours for the whole film, and pixels that are either opaque or transparent.
//!
//! Colours between those of the palette are dithered with a fixed pattern, so parts that do not move look the same in
//! every frame, without flicker.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, Write};

use ::gif::{DisposalMethod, Encoder as GifEncoder, EncodingError, Frame, Repeat};

use crate::{Encoder, Film, GifColours, Plays};

/// Maximum frame rate: viewers treat delays below two hundredths of a second as ten hundredths.
pub const MOST_GIF_RATE: f64 = 50.0;

/// Units of delays in a second.
const HUNDREDTHS: u32 = 100;

/// A GIF that is being written.
pub struct Gif<W: Write> {
    film: Film,
    colours: GifColours,
    encoder: GifEncoder<W>,
    added: u32,
}

impl<W: Write> fmt::Debug for Gif<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Gif").field("film", &self.film).field("added", &self.added).finish_non_exhaustive()
    }
}

impl<W: Write> Gif<W> {
    /// Begins a film with these colours.
    ///
    /// # Errors
    /// For a width or height above 65,535 pixels, and if the output fails.
    pub fn new(film: Film, colours: GifColours, output: W) -> io::Result<Self> {
        let [Ok(width), Ok(height)] = [film.width, film.height].map(u16::try_from) else {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "a GIF has at most 65,535 pixels a side"));
        };
        let mut encoder = GifEncoder::new(output, width, height, colours.palette()).map_err(io_error)?;
        if film.plays == Plays::Endlessly {
            encoder.set_repeat(Repeat::Infinite).map_err(io_error)?;
        }
        Ok(Self { film, colours, encoder, added: 0 })
    }
}

impl<W: Write> Encoder for Gif<W> {
    fn add(&mut self, rgba: &[u8]) -> io::Result<()> {
        self.film.check(rgba)?;
        let (width, height) = (self.film.width as u16, self.film.height as u16);
        let frame = Frame {
            delay: self.film.delay(self.added, HUNDREDTHS).min(u16::MAX.into()) as u16,
            dispose: DisposalMethod::Background,
            transparent: Some(GifColours::TRANSPARENT),
            width,
            height,
            buffer: Cow::Owned(self.colours.indices(rgba, width.into())),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(io_error)?;
        self.added += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        self.encoder.into_inner().map_err(io_error)?.flush()
    }
}

fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        error => io::Error::other(error),
    }
}
