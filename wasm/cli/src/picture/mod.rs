//! Reads a picture file as upright, straight RGBA with its colour profile.
//!
//! The contents determine the type, not the name. The size is checked before any pixel is decoded. As in the editor,
//! the orientation recorded by the camera is applied. The colour profile is kept but not applied, so that no colour is
//! lost. `web/docs/pictures.md` compares the command with the editor.

mod apng;
mod bounds;
mod decoding;
mod drawing;
mod encoding;
#[cfg(not(target_family = "wasm"))]
mod fonts;
mod jpeg;
mod kind;
mod orientation;
mod profile;
mod webp;

use std::io::{BufReader, Cursor, Read};
use std::path::Path;

use c2warp::Picture;
use c2warp_vector::{Drawing, MAX_BYTES};
use flate2::bufread::GzDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, RgbaImage};

use crate::error::{self, CliError};
use crate::input;

/// Memory limit of decoders: enough for the largest picture at 16 bits per channel and a decoder's own copy.
const DECODER_BYTES: u64 = 2 << 30;

/// Larger drawings are rejected by their size.
const MAX_DRAWING_BYTES: u64 = MAX_BYTES as u64 + 1;

/// A decoded picture.
#[derive(Debug)]
pub(crate) struct PictureFile {
    pub(crate) pixels: RgbaImage,
    /// The ICC profile of RGB colours. `None` for sRGB, and for CMYK, because decoding converts it to RGB.
    pub(crate) profile: Option<Vec<u8>>,
    pub(crate) format: ImageFormat,
    /// The bytes of the file; for a drawing, a PNG of its pixels.
    pub(crate) bytes: Vec<u8>,
    /// The drawing that was rendered to the pixels.
    pub(crate) drawing: Option<Drawing>,
}

impl PictureFile {
    /// The pixels for the solver. Errors begin with `path`.
    pub(crate) fn picture(&self, path: &Path) -> Result<Picture<'_>, CliError> {
        let pixels = &self.pixels;
        Picture::new(pixels.width(), pixels.height(), pixels.as_raw()).map_err(CliError::refused(path))
    }
}

/// Reads a picture file. A drawing is rendered at the `size` of the project's picture, or large enough for handles.
pub(crate) fn read(path: &Path, size: Option<(u32, u32)>) -> Result<PictureFile, CliError> {
    read_from(input::open(path).map_err(CliError::read(path))?, path, size)
}

/// Reads a picture. Errors begin with `path`.
pub(crate) fn read_from(file: impl Read, path: &Path, size: Option<(u32, u32)>) -> Result<PictureFile, CliError> {
    let (format, mut bytes) = match read_bytes(file, path)? {
        Contents::Pixels(format, bytes) => (format, bytes),
        Contents::Drawing(bytes) => return drawing::rendered(&bytes, path, size),
    };
    match format {
        ImageFormat::Jpeg => match jpeg::end(&bytes) {
            jpeg::End::Marked => {}
            jpeg::End::Unmarked(end_of_scan) => return read_unmarked(path, jpeg::probes(&bytes, end_of_scan)),
            jpeg::End::Missing => return Err(truncated(path)),
        },
        ImageFormat::WebP => webp::mend(&mut bytes),
        ImageFormat::Png if bounds::remove_large_profiles(&mut bytes) => warn_of_large_profile(path),
        _ => {}
    }
    decode(path, format, bytes)
}

/// Reads a JPEG without an end marker.
fn read_unmarked(path: &Path, [plain, filled @ ..]: [Vec<u8>; 3]) -> Result<PictureFile, CliError> {
    let picture = decode(path, ImageFormat::Jpeg, plain)?;
    for probe in filled {
        let is_same = decode(path, ImageFormat::Jpeg, probe).is_ok_and(|other| other.pixels == picture.pixels);
        if !is_same {
            return Err(truncated(path));
        }
    }
    Ok(picture)
}

fn decode(path: &Path, format: ImageFormat, bytes: Vec<u8>) -> Result<PictureFile, CliError> {
    let (pixels, profile) = pixels(path, format, &bytes)?;
    Ok(PictureFile { pixels, profile, format, bytes, drawing: None })
}

/// A picture file, by type.
enum Contents {
    Pixels(ImageFormat, Vec<u8>),
    Drawing(Vec<u8>),
}

/// The pixels, and the profile of their colours.
type Pixels = (RgbaImage, Option<Vec<u8>>);

fn pixels(path: &Path, format: ImageFormat, bytes: &[u8]) -> Result<Pixels, CliError> {
    let damaged = |reason| CliError::PictureDamaged { path: path.to_owned(), reason };
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(DECODER_BYTES);
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    Picture::check_size(width, height).map_err(CliError::refused(path))?;
    let orientation = orientation::recorded(&mut decoder);
    let embedded = decoder.icc_profile().ok().flatten();
    let first_frame = if format == ImageFormat::Png { apng::first_frame(bytes) } else { None };
    let mut image = match first_frame {
        Some(frame) => DynamicImage::ImageRgba8(frame.map_err(damaged)?),
        None => decoding::decoded(decoder, format).map_err(damaged)?,
    };
    if let Some(orientation) = orientation {
        image.apply_orientation(orientation);
    }
    let described = if format == ImageFormat::Png { profile::png_profile(Cursor::new(bytes)) } else { None };
    let embedded = embedded.filter(|profile| {
        let is_small = profile.len() <= bounds::MAX_PROFILE_BYTES;
        if !is_small {
            warn_of_large_profile(path);
        }
        is_small
    });
    let profile = described.or_else(|| profile::rgb_profile(embedded?));
    Ok((image.into_rgba8(), profile))
}

/// Reads a picture file and detects its type. Other files are rejected after the first bytes.
fn read_bytes(mut file: impl Read, path: &Path) -> Result<Contents, CliError> {
    let mut bytes = Vec::new();
    file.by_ref().take(kind::SIGNATURE_BYTES as u64).read_to_end(&mut bytes).map_err(CliError::read(path))?;
    if bytes.is_empty() {
        return Err(CliError::PictureEmpty { path: path.to_owned() });
    }
    if kind::is_drawing(&bytes) {
        file.take(MAX_DRAWING_BYTES).read_to_end(&mut bytes).map_err(CliError::read(path))?;
        return Ok(Contents::Drawing(bytes));
    }
    if bytes.starts_with(kind::GZIP)
        && let Some(drawing) = unpacked(Cursor::new(bytes.clone()).chain(file.by_ref()), path)?
    {
        return Ok(Contents::Drawing(drawing));
    }
    let format = image::guess_format(&bytes).ok().filter(ImageFormat::reading_enabled);
    let format = format.ok_or_else(|| match kind::name(&bytes) {
        Some(name) => CliError::PictureType { path: path.to_owned(), name },
        None => CliError::PictureUnknown { path: path.to_owned() },
    })?;
    file.read_to_end(&mut bytes).map_err(CliError::read(path))?;
    Ok(Contents::Pixels(format, bytes))
}

/// Unpacks a drawing in .svgz. `None` for any other compressed file.
fn unpacked(file: impl Read, path: &Path) -> Result<Option<Vec<u8>>, CliError> {
    let damaged = |reason| CliError::DrawingPacked { path: path.to_owned(), reason };
    let mut unpacked = GzDecoder::new(BufReader::new(file));
    let mut bytes = Vec::new();
    unpacked.by_ref().take(kind::SIGNATURE_BYTES as u64).read_to_end(&mut bytes).map_err(damaged)?;
    if !kind::is_drawing(&bytes) {
        return Ok(None);
    }
    unpacked.by_ref().take(MAX_DRAWING_BYTES).read_to_end(&mut bytes).map_err(damaged)?;
    Ok(Some(bytes))
}

fn warn_of_large_profile(path: &Path) {
    let most = bounds::MAX_PROFILE_BYTES >> 20;
    error::print(format_args!("{}: the colour profile has more than {most} MiB, and is left out", path.display()));
}

fn truncated(path: &Path) -> CliError {
    let reason = ImageError::IoError(std::io::ErrorKind::UnexpectedEof.into());
    CliError::PictureDamaged { path: path.to_owned(), reason }
}
