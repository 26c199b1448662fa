//! GIF: 255 colours for the whole film, and pixels that are either opaque or transparent.
//!
//! The palette is that of the first frame: a warp moves the colours of one picture, so all frames have them. Colours
//! between those of the palette are mixed by a fixed pattern. So parts that rest look the same in every frame, and do
//! not flicker.

use std::borrow::Cow;
use std::fmt;
use std::io::{self, Write};

use ::gif::{DisposalMethod, Encoder as GifEncoder, EncodingError, Frame, Repeat};

use crate::palette::Dithering;
use crate::{Encoder, Film, Plays};

/// Frames a second at most: viewers show shorter delays than two hundredths of a second as ten.
pub const MOST_GIF_RATE: f64 = 50.0;

/// Units of delays in a second.
const HUNDREDTHS: u32 = 100;
/// The index of the transparent colour.
const TRANSPARENT: u8 = 255;
/// Least alpha of an opaque pixel, without a matte and on one. On a matte, soft edges blend with it.
const LEAST_ALPHA: [u8; 2] = [128, 16];

/// A GIF in the making.
pub struct Gif<W: Write> {
    film: Film,
    matte: Option<[u8; 3]>,
    added: u32,
    state: State<W>,
}

enum State<W: Write> {
    /// Before the first frame.
    Waiting(Option<W>),
    Writing(Box<(GifEncoder<W>, Dithering)>),
}

impl<W: Write> fmt::Debug for Gif<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Gif").field("film", &self.film).field("added", &self.added).finish_non_exhaustive()
    }
}

impl<W: Write> Gif<W> {
    /// Begins a film. Soft edges blend with the colour `matte`, or else are cut at half their alpha.
    ///
    /// # Errors
    /// For a width or height above 65,535 pixels.
    pub fn new(film: Film, matte: Option<[u8; 3]>, output: W) -> io::Result<Self> {
        if film.width.max(film.height) > u16::MAX.into() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "a GIF has at most 65,535 pixels a side"));
        }
        Ok(Self { film, matte, added: 0, state: State::Waiting(Some(output)) })
    }

    /// The pixels that are shown: opaque ones on the matte, `None` for transparent ones.
    fn opaque(&self, rgba: &[u8]) -> Vec<Option<[u8; 3]>> {
        let least = LEAST_ALPHA[usize::from(self.matte.is_some())];
        let pixel = |&[r, g, b, alpha]: &[u8; 4]| {
            let blend = |colour: u8, matte: u8| {
                let (colour, matte, alpha) = (u32::from(colour), u32::from(matte), u32::from(alpha));
                ((colour * alpha + matte * (255 - alpha) + 127) / 255) as u8
            };
            let colour = [r, g, b];
            (alpha >= least).then(|| match self.matte {
                Some(matte) => std::array::from_fn(|k| blend(colour[k], matte[k])),
                None => colour,
            })
        };
        rgba.as_chunks::<4>().0.iter().map(pixel).collect()
    }
}

impl<W: Write> Encoder for Gif<W> {
    fn add(&mut self, rgba: &[u8]) -> io::Result<()> {
        self.film.check(rgba)?;
        let pixels = self.opaque(rgba);
        let (width, height) = (self.film.width as u16, self.film.height as u16);
        if let State::Waiting(output) = &mut self.state
            && let Some(output) = output.take()
        {
            let dithering = Dithering::new(pixels.iter().flatten().copied());
            let mut encoder = GifEncoder::new(output, width, height, dithering.palette()).map_err(io_error)?;
            if self.film.plays == Plays::Endlessly {
                encoder.set_repeat(Repeat::Infinite).map_err(io_error)?;
            }
            self.state = State::Writing(Box::new((encoder, dithering)));
        }
        let State::Writing(writing) = &mut self.state else {
            return Err(io::Error::other("the GIF failed before"));
        };
        let (encoder, dithering) = &mut **writing;
        let place = |at: usize| [at % usize::from(width), at / usize::from(width)];
        let index = |(at, pixel): (usize, &Option<[u8; 3]>)| {
            pixel.map_or(TRANSPARENT, |colour| dithering.index(colour, place(at)))
        };
        let buffer: Vec<u8> = pixels.iter().enumerate().map(index).collect();
        let frame = Frame {
            delay: self.film.delay(self.added, HUNDREDTHS).min(u16::MAX.into()) as u16,
            dispose: DisposalMethod::Background,
            transparent: Some(TRANSPARENT),
            width,
            height,
            buffer: Cow::Owned(buffer),
            ..Frame::default()
        };
        encoder.write_frame(&frame).map_err(io_error)?;
        self.added += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        match self.state {
            State::Waiting(_) => Err(io::Error::new(io::ErrorKind::InvalidInput, "the film has no frames")),
            State::Writing(writing) => writing.0.into_inner().map_err(io_error)?.flush(),
        }
    }
}

fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        error => io::Error::other(error),
    }
}
