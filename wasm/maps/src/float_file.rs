//! OpenEXR files with 32-bit floats.
//!
//! The channels are R, G, B and A, in blocks of 16 rows with lossless compression. The attribute `comments` describes
//! the map.

use std::io::Cursor;
use std::ops::Range;
use std::sync::Mutex;

use c2warp::Drawing;
use exr::image::write::WritableImage;
use exr::image::{Encoding, Image, SpecificChannels};
use exr::math::Vec2;
use exr::prelude::Text;

use crate::error::MapError;

/// The most recently computed rows.
struct Band {
    rows: Range<u32>,
    values: Vec<[f32; 4]>,
}

/// Encodes a picture whose rows are computed in bands, from top to bottom.
pub(crate) fn encode(
    [width, height]: [u32; 2],
    about: &str,
    rows: impl Fn(Range<u32>) -> Vec<[f32; 4]> + Sync,
    on_progress: &mut dyn FnMut(f64),
) -> Result<Vec<u8>, MapError> {
    let band = Mutex::new(Band { rows: 0..0, values: Vec::new() });
    let channels = SpecificChannels::rgba(|Vec2(x, y): Vec2<usize>| {
        let (x, y) = (x as u32, y as u32);
        let mut band = band.lock().expect("making rows does not panic");
        if !band.rows.contains(&y) {
            let start = y / Drawing::BAND_ROWS * Drawing::BAND_ROWS;
            band.rows = start..height.min(start + Drawing::BAND_ROWS);
            band.values = rows(band.rows.clone());
        }
        let [r, g, b, a] = band.values[((y - band.rows.start) * width + x) as usize];
        (r, g, b, a)
    });
    let mut image = Image::from_channels((width as usize, height as usize), channels);
    image.layer_data.encoding = Encoding::SMALL_LOSSLESS;
    image.layer_data.attributes.comments = Text::new_or_none(latin(about));
    image.layer_data.attributes.software_name = Text::new_or_none("c2warp");
    let mut file = Cursor::new(Vec::new());
    image.write().on_progress(on_progress).to_buffered(&mut file)?;
    Ok(file.into_inner())
}

/// Header text has one byte per character. Other characters are written as escapes.
fn latin(text: &str) -> String {
    let character = |c: char| if c.is_ascii() { c.to_string() } else { c.escape_unicode().to_string() };
    text.chars().map(character).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    #[test]
    fn rows_are_made_once_and_a_band_at_a_time() {
        let made = Mutex::new(Vec::new());
        let rows = |band: Range<u32>| {
            made.lock().unwrap().push(band.clone());
            vec![[0.5; 4]; band.len() * 3]
        };
        let mut reported = Vec::new();
        encode([3, 40], "a map", rows, &mut |part| reported.push(part)).unwrap();
        assert_eq!(*made.lock().unwrap(), [0..16, 16..32, 32..40]);
        assert!(reported.is_sorted() && reported.last() == Some(&1.0), "{reported:?}");
    }
}
