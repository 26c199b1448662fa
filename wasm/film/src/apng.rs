//! Animated PNG: lossless, with full alpha. Programs without support for animation show the first frame.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, Write};

use png::{BitDepth, ColorType, Compression, Encoder as PngEncoder, Info, Writer};

use crate::png_error::png_error;
use crate::{Encoder, Film, Plays};

/// Units of delays: a fraction of two 16-bit numbers cannot express every rate.
const MILLISECONDS: u32 = 1000;

/// An animated PNG that is being written.
pub struct Apng<W: Write> {
    film: Film,
    writer: Writer<W>,
    added: u32,
}

impl<W: Write> fmt::Debug for Apng<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Apng").field("film", &self.film).field("added", &self.added).finish_non_exhaustive()
    }
}

impl<W: Write> Apng<W> {
    /// Begins a film.
    ///
    /// # Errors
    /// If the output fails.
    pub fn new(film: Film, output: W) -> io::Result<Self> {
        let mut info = Info::with_size(film.width, film.height);
        (info.color_type, info.bit_depth) = (ColorType::Rgba, BitDepth::Eight);
        info.icc_profile = film.profile.clone().map(Cow::Owned);
        let mut encoder = PngEncoder::with_info(output, info).map_err(png_error)?;
        encoder.set_compression(Compression::Fast);
        let plays = match film.plays {
            Plays::Once => 1,
            Plays::Endlessly => 0,
        };
        encoder.set_animated(film.frames, plays).map_err(png_error)?;
        Ok(Self { writer: encoder.write_header().map_err(png_error)?, film, added: 0 })
    }
}

impl<W: Write> Encoder for Apng<W> {
    fn add(&mut self, rgba: &[u8]) -> io::Result<()> {
        self.film.check(rgba)?;
        let delay = self.film.delay(self.added, MILLISECONDS).min(u16::MAX.into()) as u16;
        self.writer.set_frame_delay(delay, MILLISECONDS as u16).map_err(png_error)?;
        self.writer.write_image_data(rgba).map_err(png_error)?;
        self.added += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        self.writer.finish().map_err(png_error)
    }
}
