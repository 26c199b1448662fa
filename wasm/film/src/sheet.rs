//! A sprite sheet: all frames in one PNG, and their positions as JSON.
//!
//! The JSON has TexturePacker's hash form, with the `duration` of each frame in milliseconds, as Aseprite writes it.
//! Game engines read this format. Memory: the whole sheet.

use std::fmt;
use std::io::{self, Write};

use png::{BitDepth, ColorType, Compression, Encoder as PngEncoder};
use serde_json::{Map, Value, json};

use crate::png_error::png_error;
use crate::{Encoder, Film};

/// Maximum number of pixels of a side, the limit of graphics cards.
pub const MOST_SHEET_SIDE: u32 = 16_384;

const MILLISECONDS: u32 = 1000;

/// A sheet that is being drawn.
pub struct Sheet<W: Write> {
    film: Film,
    output: W,
    columns: u32,
    rows: u32,
    rgba: Vec<u8>,
    added: u32,
}

impl<W: Write> fmt::Debug for Sheet<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sheet").field("film", &self.film).field("added", &self.added).finish_non_exhaustive()
    }
}

impl<W: Write> Sheet<W> {
    /// Begins a sheet that is as square as whole frames allow.
    ///
    /// # Errors
    /// If it would be wider or higher than [`MOST_SHEET_SIDE`].
    pub fn new(film: Film, output: W) -> io::Result<Self> {
        let [columns, rows] = layout(&film);
        let [width, height] = [u64::from(columns) * u64::from(film.width), u64::from(rows) * u64::from(film.height)];
        if width.max(height) > MOST_SHEET_SIDE.into() {
            let message = format!(
                "{} frames of {} × {} pixels need a sheet of {width} × {height}, but a side can have at most \
                 {MOST_SHEET_SIDE}",
                film.frames, film.width, film.height
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        let rgba = vec![0; 4 * width as usize * height as usize];
        Ok(Self { film, output, columns, rows, rgba, added: 0 })
    }

    /// The JSON for a sheet with this file name. Frames are named by `name` and their number.
    #[must_use]
    pub fn json(&self, image: &str, name: &str) -> String {
        let Film { width, height, frames, .. } = self.film;
        let digits = (frames.max(2) - 1).to_string().len();
        let frame = |at: u32| {
            let [x, y] = [at % self.columns * width, at / self.columns * height];
            let value = json!({
                "frame": { "x": x, "y": y, "w": width, "h": height },
                "rotated": false,
                "trimmed": false,
                "spriteSourceSize": { "x": 0, "y": 0, "w": width, "h": height },
                "sourceSize": { "w": width, "h": height },
                "duration": self.film.delay(at, MILLISECONDS),
            });
            (format!("{name}-{at:0digits$}.png"), value)
        };
        let frames: Map<String, Value> = (0..frames).map(frame).collect();
        let size = json!({ "w": self.columns * width, "h": self.rows * height });
        let meta = json!({
            "app": "c2warp",
            "version": env!("CARGO_PKG_VERSION"),
            "image": image,
            "format": "RGBA8888",
            "size": size,
            "scale": "1",
        });
        let mut text = serde_json::to_string_pretty(&json!({ "frames": frames, "meta": meta })).unwrap_or_default();
        text.push('\n');
        text
    }
}

/// The columns and rows that make the sheet nearest to a square.
fn layout(film: &Film) -> [u32; 2] {
    let [width, height] = [film.width, film.height].map(f64::from);
    let columns = (f64::from(film.frames) * height / width).sqrt().round() as u32;
    let columns = columns.clamp(1, film.frames);
    [columns, film.frames.div_ceil(columns)]
}

impl<W: Write> Encoder for Sheet<W> {
    fn add(&mut self, rgba: &[u8]) -> io::Result<()> {
        self.film.check(rgba)?;
        if self.added == self.film.frames {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "the sheet is full"));
        }
        let row = 4 * self.film.width as usize;
        let stride = row * self.columns as usize;
        let left = (self.added % self.columns) as usize * row;
        let top = (self.added / self.columns * self.film.height) as usize;
        for (y, pixels) in rgba.chunks_exact(row).enumerate() {
            self.rgba[(top + y) * stride + left..][..row].copy_from_slice(pixels);
        }
        self.added += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> io::Result<()> {
        let Self { film, output, columns, rows, rgba, .. } = *self;
        let mut encoder = PngEncoder::new(output, columns * film.width, rows * film.height);
        encoder.set_color(ColorType::Rgba);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Fast);
        let mut writer = encoder.write_header().map_err(png_error)?;
        writer.write_image_data(&rgba).map_err(png_error)?;
        writer.finish().map_err(png_error)
    }
}

#[cfg(test)]
mod tests {
    use super::layout;
    use crate::{Film, Plays};

    #[test]
    fn sheet_is_nearly_square() {
        let film =
            |width, height, frames| Film { width, height, frames, rate: 24.0, plays: Plays::Once, profile: None };
        assert_eq!(layout(&film(100, 100, 16)), [4, 4]);
        assert_eq!(layout(&film(100, 100, 17)), [4, 5]);
        assert_eq!(layout(&film(100, 400, 16)), [8, 2]);
        assert_eq!(layout(&film(9, 9, 1)), [1, 1]);
    }
}
