//! Reads a picture file as upright, straight RGBA with its colour profile.
//!
//! The contents decide the type, not the name. The size is checked before any pixel is decoded. As in a browser, the
//! orientation recorded by the camera is applied. The colour profile is not applied but kept, so that no colour is
//! lost.

use std::io::{Cursor, Read};
use std::path::Path;

use c2warp::Picture;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, RgbaImage};

use crate::error::CliError;
use crate::{input, jpeg, profile};

/// Memory limit of decoders: enough for the largest picture at 16 bits per channel and a decoder's own copy.
const DECODER_BYTES: u64 = 2 << 30;
/// Longer than the signature of any type.
const SIGNATURE_BYTES: u64 = 64;

/// A decoded picture.
#[derive(Debug)]
pub(crate) struct PictureFile {
    pub(crate) pixels: RgbaImage,
    /// The ICC profile of RGB colours. `None` for sRGB, and for CMYK, because decoding converts it to RGB.
    pub(crate) profile: Option<Vec<u8>>,
}

/// Reads a picture.
pub(crate) fn read(path: &Path) -> Result<PictureFile, CliError> {
    let (format, bytes) = read_file(path)?;
    if format == ImageFormat::Jpeg {
        jpeg::find_end(&bytes[..]).map_err(|reason| damaged(path, reason.into()))?;
    }
    let to_error = |reason| match reason {
        ImageError::Unsupported(_) if !format.reading_enabled() => {
            CliError::PictureType { path: path.to_owned(), format }
        }
        reason => damaged(path, reason),
    };

    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(DECODER_BYTES);
    let mut reader = ImageReader::with_format(Cursor::new(&bytes), format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(to_error)?;
    let (width, height) = decoder.dimensions();
    Picture::check_size(width, height).map_err(CliError::refused(path))?;
    // Invalid metadata does not make a picture unreadable.
    let orientation = decoder.orientation().ok();
    let embedded = decoder.icc_profile().ok().flatten();
    let mut image = DynamicImage::from_decoder(decoder).map_err(to_error)?;
    if let Some(orientation) = orientation {
        image.apply_orientation(orientation);
    }
    let described = if format == ImageFormat::Png { profile::png_profile(Cursor::new(&bytes)) } else { None };
    let profile = described.or_else(|| profile::rgb_profile(embedded?));
    Ok(PictureFile { pixels: image.into_rgba8(), profile })
}

/// Reads a picture file and detects its type. Other files are rejected after the first bytes.
fn read_file(path: &Path) -> Result<(ImageFormat, Vec<u8>), CliError> {
    let mut file = input::open(path).map_err(CliError::read(path))?;
    let mut bytes = Vec::new();
    file.by_ref().take(SIGNATURE_BYTES).read_to_end(&mut bytes).map_err(CliError::read(path))?;
    if bytes.is_empty() {
        return Err(CliError::PictureEmpty { path: path.to_owned() });
    }
    let format = image::guess_format(&bytes).map_err(|_| CliError::PictureUnknown { path: path.to_owned() })?;
    file.read_to_end(&mut bytes).map_err(CliError::read(path))?;
    Ok((format, bytes))
}

fn damaged(path: &Path, reason: ImageError) -> CliError {
    CliError::PictureDamaged { path: path.to_owned(), reason }
}
