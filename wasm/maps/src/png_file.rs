//! PNG files of maps and heat maps. The text chunk `Comment` describes the map.

use std::io::Write;
use std::ops::Range;

use c2warp::Drawing;
use png::{BitDepth, ColorType, Compression, Encoder};

use crate::error::MapError;

/// Encodes levels from 0 to 1 with 16 bits per channel. Rows are computed in bands, from top to bottom.
pub(crate) fn encode(
    size: [u32; 2],
    about: &str,
    mut rows: impl FnMut(Range<u32>) -> Vec<[f32; 4]>,
) -> Result<Vec<u8>, MapError> {
    write(size, BitDepth::Sixteen, about, |band| {
        let levels = rows(band).into_iter().flatten();
        levels.flat_map(|level| ((level * 65535.0 + 0.5) as u16).to_be_bytes()).collect()
    })
}

/// Encodes RGBA with the samples from `rows`.
pub(crate) fn write(
    [width, height]: [u32; 2],
    depth: BitDepth,
    about: &str,
    mut rows: impl FnMut(Range<u32>) -> Vec<u8>,
) -> Result<Vec<u8>, MapError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(depth);
    encoder.set_compression(Compression::Fast);
    encoder.add_itxt_chunk("Comment".to_owned(), about.to_owned())?;
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    for start in (0..height).step_by(Drawing::BAND_ROWS as usize) {
        let band = rows(start..height.min(start + Drawing::BAND_ROWS));
        stream.write_all(&band).map_err(png::EncodingError::from)?;
    }
    stream.finish()?;
    writer.finish()?;
    Ok(file)
}
