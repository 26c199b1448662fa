//! The orientation that a camera recorded in EXIF data.

use image::{ImageDecoder, metadata::Orientation};

/// The prefix of EXIF data in JPEG files. Some programs write it to other files, too.
const PREFIX: &[u8] = b"Exif\0\0";

/// Returns the recorded orientation. Invalid data is ignored, so that the picture remains readable.
pub(super) fn recorded(decoder: &mut impl ImageDecoder) -> Option<Orientation> {
    let exif = decoder.exif_metadata().ok()??;
    Orientation::from_exif_chunk(exif.strip_prefix(PREFIX).unwrap_or(&exif))
}
