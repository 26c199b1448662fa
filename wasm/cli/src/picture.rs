//! A picture file as straight RGBA, upright, with the colour profile that its numbers are meant by.
//!
//! The type is detected from the contents, not from the name. The size is checked before any pixel is decoded. As in a
//! browser, the orientation recorded by the camera is applied. A profile is not: it goes with the picture, so that no colour is
//! lost.

use std::io::{Cursor, Read};
use std::path::Path;

use c2warp::Picture;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, RgbaImage};

use crate::error::CliError;
use crate::{input, jpeg, profile};

/// Memory limit of decoders: enough for the largest picture at 16 bits a channel, and a decoder's own copy of it.
const DECODER_BYTES: u64 = 2 << 30;
/// More than any type is known by.
const SIGNATURE_BYTES: u64 = 64;

/// A picture that was read.
#[derive(Debug)]
pub(crate) struct PictureFile {
    pub(crate) pixels: RgbaImage,
    /// An ICC profile of RGB colours; `None` for sRGB, and for CMYK, which became RGB in decoding.
    pub(crate) profile: Option<Vec<u8>>,
}

/// Reads a picture.
pub(crate) fn read(path: &Path) -> Result<PictureFile, CliError> {
    let (format, bytes) = contents(path)?;
    if format == ImageFormat::Jpeg {
        jpeg::find_end(&bytes[..]).map_err(|reason| damaged(path, reason.into()))?;
    }
    let refusal = |reason| match reason {
        ImageError::Unsupported(_) if !format.reading_enabled() => {
            CliError::PictureType { path: path.to_owned(), format }
        }
        reason => damaged(path, reason),
    };

    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(DECODER_BYTES);
    let mut reader = ImageReader::with_format(Cursor::new(&bytes), format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(refusal)?;
    let (width, height) = decoder.dimensions();
    Picture::check_size(width, height).map_err(CliError::refused(path))?;
    // Invalid metadata is no reason to refuse a picture.
    let orientation = decoder.orientation().ok();
    let held = decoder.icc_profile().ok().flatten();
    let mut image = DynamicImage::from_decoder(decoder).map_err(refusal)?;
    if let Some(orientation) = orientation {
        image.apply_orientation(orientation);
    }
    let described = if format == ImageFormat::Png { profile::of_png(Cursor::new(&bytes)) } else { None };
    let profile = described.or_else(|| profile::of_rgb(held?));
    Ok(PictureFile { pixels: image.into_rgba8(), profile })
}

/// The type of a picture and its file, of which no more is read than it takes to tell that it is no picture.
fn contents(path: &Path) -> Result<(ImageFormat, Vec<u8>), CliError> {
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
