//! The bytes of a picture file, as the command reads them.

use std::io::Cursor;

use c2warp::limits::{MAX_PIXELS, MAX_SIDE, MIN_SIDE};
use image::ImageReader;

use crate::promises::expect_sentence;

/// Reads a picture file. Drawings have an attack of their own.
///
/// A picture has the size that its header names, turned or not.
///
/// # Panics
/// If the size differs or is beyond the limits, or an error is not one line.
pub fn attack(bytes: &[u8]) {
    if bytes.trim_ascii_start().first().is_some_and(|&first| first == b'<') || bytes.starts_with(b"\xef\xbb\xbf") {
        return;
    }
    let picture = match c2warp_cli::read_picture(bytes) {
        Ok(picture) => picture,
        Err(line) => return expect_sentence(&line),
    };
    let (width, height) = picture.dimensions();
    assert!((MIN_SIDE..=MAX_SIDE).contains(&width) && (MIN_SIDE..=MAX_SIDE).contains(&height));
    assert!(u64::from(width) * u64::from(height) <= MAX_PIXELS);
    let header = ImageReader::new(Cursor::new(bytes)).with_guessed_format().expect("memory is read");
    // The command reads some headers that decoders refuse.
    if let Ok(named) = header.into_dimensions() {
        assert!(named == (width, height) || named == (height, width), "{named:?} is read as {width} × {height}");
    }
}
