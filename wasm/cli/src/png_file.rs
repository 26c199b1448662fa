//! PNG files of warped pictures and textures.

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageResult};

/// The file of a picture in straight RGBA, with its colour profile.
pub(crate) fn encode_png([width, height]: [u32; 2], rgba: &[u8], profile: Option<&[u8]>) -> ImageResult<Vec<u8>> {
    let mut png = Vec::new();
    // A third of the time of the best compression, for a quarter more bytes.
    let mut encoder = PngEncoder::new_with_quality(&mut png, CompressionType::Fast, FilterType::Adaptive);
    if let Some(profile) = profile {
        encoder.set_icc_profile(profile.to_owned()).map_err(ImageError::Unsupported)?;
    }
    encoder.write_image(rgba, width, height, ExtendedColorType::Rgba8)?;
    Ok(png)
}
