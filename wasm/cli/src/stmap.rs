//! The map of a warp for compositors, as an OpenEXR picture: what Nuke, Fusion and Blender call an ST map or a UV map.
//!
//! Red and green tell where a pixel comes from: u to the right and v upwards, from 0 to 1 across the picture, the middle of its lower
//! left pixel at half a pixel. Blue is the determinant of the Jacobian, by which areas grow, for masks of what is stretched; alpha the
//! share of the pixel that is covered.

use std::io::Cursor;

use c2warp::{Picture, Source, Warped};
use exr::image::write::WritableImage;
use exr::image::{Encoding, Image, SpecificChannels};
use exr::math::Vec2;

/// The file.
pub(crate) fn exr(picture: &Picture<'_>, warped: &Warped, sources: &[Source]) -> exr::error::Result<Vec<u8>> {
    let [width, height] = [warped.width, warped.height].map(|side| side as usize);
    let [across, down] = [picture.width(), picture.height()].map(f64::from);
    let channels = SpecificChannels::rgba(|Vec2(x, y)| {
        let Source { rest: [x, y], det, coverage, .. } = sources[y * width + x];
        // Where nothing is drawn nothing is told.
        let v = if coverage > 0.0 { 1.0 - f64::from(y) / down } else { 0.0 };
        ((f64::from(x) / across) as f32, v as f32, det, coverage)
    });
    let mut image = Image::from_channels((width, height), channels);
    image.layer_data.encoding = Encoding::SMALL_LOSSLESS;
    let mut file = Cursor::new(Vec::new());
    image.write().non_parallel().to_buffered(&mut file)?;
    Ok(file.into_inner())
}
