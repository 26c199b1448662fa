//! Embedded files: the project in a PNG, and the picture in a project. `web/docs/editor.md` describes both.

use std::io::Cursor;
use std::path::Path;

use data_url::DataUrl;
use image::ImageFormat;
use png::{Decoder, Limits};

use crate::error::CliError;

/// Keyword of the `iTXt` chunk (PNG, 3rd edition, §11.3.3.4) that holds the project.
const KEYWORD: &str = "c2warp";

/// Memory limit for the chunks of a PNG. The editor reads projects of at most 100 MB.
const CHUNK_BYTES: usize = 256 << 20;

/// Returns the text of a project file, or of the project that a PNG contains.
pub(crate) fn project_text(file: Vec<u8>, path: &Path) -> Result<String, CliError> {
    if image::guess_format(&file).is_ok_and(|format| format == ImageFormat::Png) {
        text_of_png(&file).ok_or_else(|| CliError::NoProject { path: path.to_owned() })
    } else {
        String::from_utf8(file).map_err(|_| CliError::ProjectEncoding { path: path.to_owned() })
    }
}

/// Returns the project in a PNG. Pixels are not decoded.
fn text_of_png(file: &[u8]) -> Option<String> {
    let mut reader = Decoder::new_with_limits(Cursor::new(file), Limits { bytes: CHUNK_BYTES }).read_info().ok()?;
    // A chunk may also follow the pixels. If these are damaged, the chunks before them count.
    let _ = reader.finish();
    reader.info().utf8_text.iter().find(|chunk| chunk.keyword == KEYWORD)?.get_text().ok()
}

/// Whether an address is a `data:` URL, which contains the file itself (RFC 2397).
pub(crate) fn is_data_url(address: &str) -> bool {
    address.trim_start().get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:"))
}

/// Returns the bytes in a `data:` URL.
pub(crate) fn data_url_bytes(address: &str, path: &Path) -> Result<Vec<u8>, CliError> {
    let damaged = || CliError::PictureUrl { path: path.to_owned() };
    let (bytes, _fragment) =
        DataUrl::process(address).map_err(|_| damaged())?.decode_to_vec().map_err(|_| damaged())?;
    Ok(bytes)
}
