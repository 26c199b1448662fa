//! Renders an SVG drawing, and keeps it. Only fonts of the system are loaded from outside the file, and only for
//! drawings with text.

use std::path::Path;

use c2warp::Picture;
use c2warp_vector::{Drawing, MAX_BYTES, VectorError};
use image::{ImageEncoder, ImageFormat, RgbaImage};

use super::PictureFile;
use super::encoding::{self, NoText};
use crate::error::{self, CliError};

/// The longer side of pictures of small drawings, as in the editor: handles need room.
const LEAST_SIDE: f64 = 1024.0;
/// The longer side of pictures of large drawings, as in the editor.
const MOST_SIDE: f64 = 4096.0;

/// Renders a drawing at the size of the project's picture, or between the least and the greatest side. A drawing with
/// other proportions gets the project's width and its own height. Reports on standard error which parts are left out.
pub(super) fn rendered(bytes: &[u8], path: &Path, size: Option<(u32, u32)>) -> Result<PictureFile, CliError> {
    let refused = |reason| CliError::Drawing { path: path.to_owned(), reason };
    if bytes.len() > MAX_BYTES {
        return Err(refused(VectorError::TooLarge { most: MAX_BYTES }));
    }
    let text = encoding::text_of(bytes).map_err(|reason| match reason {
        NoText::Malformed(encoding) => CliError::DrawingText { path: path.to_owned(), encoding },
        NoText::Unknown(label) => CliError::DrawingEncoding { path: path.to_owned(), label },
    })?;
    let drawing = read(&text).map_err(refused)?;
    for remark in drawing.remarks() {
        error::print(format_args!("{}: {remark}", path.display()));
    }
    let (width, height) = size_in_pixels(drawing.size(), size);
    Picture::check_size(width, height).map_err(CliError::refused(path))?;
    let rgba = drawing.pixels(width, height).map_err(refused)?;
    let pixels = RgbaImage::from_raw(width, height, rgba).expect("four bytes a pixel");
    let mut bytes = Vec::new();
    let encoder = image::codecs::png::PngEncoder::new(&mut bytes);
    let encoded = encoder.write_image(&pixels, width, height, image::ExtendedColorType::Rgba8);
    encoded.map_err(|reason| CliError::PictureDamaged { path: path.to_owned(), reason })?;
    Ok(PictureFile { pixels, profile: None, format: ImageFormat::Png, bytes, drawing: Some(drawing) })
}

fn size_in_pixels([own_width, own_height]: [f64; 2], size: Option<(u32, u32)>) -> (u32, u32) {
    let whole = |length: f64| length.round().clamp(1.0, f64::from(u32::MAX)) as u32;
    let Some((width, height)) = size else {
        let side = own_width.max(own_height);
        let scale = side.clamp(LEAST_SIDE, MOST_SIDE) / side;
        return (whole(own_width * scale), whole(own_height * scale));
    };
    let own = f64::from(width) * own_height / own_width;
    // A picture of the drawing may have been rounded by a pixel.
    (width, if (own - f64::from(height)).abs() > 1.0 { whole(own) } else { height })
}

#[cfg(not(target_family = "wasm"))]
fn read(text: &str) -> Result<Drawing, VectorError> {
    if text.contains("<text") || text.contains(":text") {
        return Drawing::read_with_fonts(text, std::sync::Arc::new(super::fonts::of_system()));
    }
    Drawing::read(text)
}

/// WebAssembly has no fonts.
#[cfg(target_family = "wasm")]
fn read(text: &str) -> Result<Drawing, VectorError> {
    Drawing::read(text)
}
