//! The inverse map of a warp as an OpenEXR picture. Nuke and Fusion call it an ST map, Blender a UV map.
//!
//! Red and green are the source of a pixel: u to the right and v upwards, from 0 to 1 across the picture. The centre of
//! the picture's lower left pixel is half a pixel from both axes. Blue is the Jacobian determinant, for masks of
//! stretched areas. Alpha is the fraction of the pixel that is covered.

use std::io::Cursor;

use c2warp::{Picture, Source, Warped};
use exr::image::write::WritableImage;
use exr::image::{Encoding, Image, SpecificChannels};
use exr::math::Vec2;

/// Encodes the map as the bytes of an OpenEXR file.
pub(crate) fn encode_exr(picture: &Picture<'_>, warped: &Warped, sources: &[Source]) -> exr::error::Result<Vec<u8>> {
    let [width, height] = [warped.width, warped.height].map(|side| side as usize);
    let [across, down] = [picture.width(), picture.height()].map(f64::from);
    let channels = SpecificChannels::rgba(|Vec2(x, y)| {
        let Source { rest: [x, y], det, coverage, .. } = sources[y * width + x];
        // Empty pixels are 0 in every channel.
        let v = if coverage > 0.0 { 1.0 - f64::from(y) / down } else { 0.0 };
        ((f64::from(x) / across) as f32, v as f32, det, coverage)
    });
    let mut image = Image::from_channels((width, height), channels);
    image.layer_data.encoding = Encoding::SMALL_LOSSLESS;
    let mut file = Cursor::new(Vec::new());
    image.write().non_parallel().to_buffered(&mut file)?;
    Ok(file.into_inner())
}
