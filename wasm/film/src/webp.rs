//! Animated WebP of lossless frames, with full alpha.
//!
//! The container follows the WebP specification (RFC 9649, section 2.7).

use std::fmt;
use std::io::{self, Cursor, Seek, SeekFrom, Write};

use image_webp::{ColorType, EncodingError, WebPEncoder};

use crate::{Encoder, Film, Plays};

const MILLISECONDS: u32 = 1000;
/// Maximum number of pixels of a side.
const MOST_SIDE: u32 = 1 << 14;

/// Bits of the header VP8X.
const ANIMATION: u8 = 0x02;
const ALPHA: u8 = 0x10;
const PROFILE: u8 = 0x20;
/// Bit of a frame: it replaces the previous frame instead of being drawn over it.
const REPLACES: u8 = 0x02;
/// Bytes of a frame before its picture: position, size, delay and bits.
const FRAME_HEADER: usize = 16;

/// An animated WebP that is being written. The writer seeks once, to write the length of the file at its beginning.
pub struct WebP<W: Write + Seek> {
    film: Film,
    output: W,
    added: u32,
}

impl<W: Write + Seek> fmt::Debug for WebP<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WebP").field("film", &self.film).field("added", &self.added).finish_non_exhaustive()
    }
}

impl<W: Write + Seek> WebP<W> {
    /// Begins a film at the beginning of an output.
    ///
    /// # Errors
    /// For a width or height above 16,384 pixels, and if the output fails.
    pub fn new(film: Film, mut output: W) -> io::Result<Self> {
        if film.width.max(film.height) > MOST_SIDE {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "a WebP has at most 16,384 pixels a side"));
        }
        output.write_all(b"RIFF\0\0\0\0WEBP")?;
        let profile = if film.profile.is_some() { PROFILE } else { 0 };
        let size = [film.width - 1, film.height - 1].map(three_bytes).concat();
        write_chunk(&mut output, b"VP8X", &[&[ANIMATION | ALPHA | profile, 0, 0, 0][..], &size].concat())?;
        if let Some(profile) = &film.profile {
            write_chunk(&mut output, b"ICCP", profile)?;
        }
        let plays: u16 = match film.plays {
            Plays::Once => 1,
            Plays::Endlessly => 0,
        };
        write_chunk(&mut output, b"ANIM", &[&[0; 4][..], &plays.to_le_bytes()].concat())?;
        Ok(Self { film, output, added: 0 })
    }
}

impl<W: Write + Seek> Encoder for WebP<W> {
    fn add(&mut self, rgba: &[u8]) -> io::Result<()> {
        self.film.check(rgba)?;
        let Film { width, height, .. } = self.film;
        let mut file = Cursor::new(Vec::new());
        WebPEncoder::new(&mut file).encode(rgba, width, height, ColorType::Rgba8).map_err(io_error)?;
        let picture = chunk(file.get_ref(), b"VP8L").ok_or_else(|| io::Error::other("the encoder wrote no picture"))?;
        let delay = three_bytes(self.film.delay(self.added, MILLISECONDS));
        let mut frame = Vec::with_capacity(FRAME_HEADER + picture.len());
        frame.extend([0; 6]);
        frame.extend([width - 1, height - 1].map(three_bytes).concat());
        frame.extend(delay);
        frame.push(REPLACES);
        frame.extend(picture);
        write_chunk(&mut self.output, b"ANMF", &frame)?;
        self.added += 1;
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> io::Result<()> {
        let end = self.output.stream_position()?;
        let length = u32::try_from(end - 8).map_err(|_| io::Error::other("a WebP file has at most 4 GiB"))?;
        self.output.seek(SeekFrom::Start(4))?;
        self.output.write_all(&length.to_le_bytes())?;
        self.output.seek(SeekFrom::Start(end))?;
        self.output.flush()
    }
}

/// The low three bytes of a number, from the lowest.
fn three_bytes(number: u32) -> [u8; 3] {
    let [a, b, c, _] = number.to_le_bytes();
    [a, b, c]
}

fn write_chunk(output: &mut impl Write, name: &[u8; 4], contents: &[u8]) -> io::Result<()> {
    output.write_all(name)?;
    output.write_all(&(contents.len() as u32).to_le_bytes())?;
    output.write_all(contents)?;
    // Chunks have an even size.
    if contents.len() % 2 == 1 { output.write_all(&[0]) } else { Ok(()) }
}

/// A chunk of a WebP file with its name, size and padding.
fn chunk<'a>(file: &'a [u8], name: &[u8; 4]) -> Option<&'a [u8]> {
    let mut at = 12;
    loop {
        let size = u32::from_le_bytes(file.get(at + 4..at + 8)?.try_into().ok()?) as usize;
        let end = at + 8 + size + size % 2;
        if file.get(at..at + 4)? == name {
            return file.get(at..end);
        }
        at = end;
    }
}

fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        error => io::Error::other(error),
    }
}
