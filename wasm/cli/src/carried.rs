//! Embedded files: the project in a PNG, and the picture in a project. `web/docs/editor.md` describes both.

use std::path::Path;

use c2warp::limits::MAX_PROJECT_BYTES;
use data_url::DataUrl;
use fdeflate::BoundedDecompressionError;
use image::ImageFormat;

use crate::error::CliError;
use crate::png_chunks::{Chunk, chunks};

/// Keyword of the `iTXt` chunk that holds the project, and the 0 behind it.
const KEYWORD: &[u8] = b"c2warp\0";

/// Returns the text of a project file, or of the project that a PNG contains.
pub(crate) fn project_text(file: Vec<u8>, path: &Path) -> Result<String, CliError> {
    let too_large = || CliError::ProjectSize { path: path.to_owned(), most: MAX_PROJECT_BYTES };
    let text = if image::guess_format(&file).is_ok_and(|format| format == ImageFormat::Png) {
        let text = text_of_png(&file).map_err(|TooLarge| too_large())?;
        text.ok_or_else(|| CliError::NoProject { path: path.to_owned() })?
    } else {
        file
    };
    if text.len() > MAX_PROJECT_BYTES {
        return Err(too_large());
    }
    String::from_utf8(text).map_err(|_| CliError::ProjectEncoding { path: path.to_owned() })
}

/// The project in a PNG unfolds to more bytes than projects may have.
struct TooLarge;

/// Returns the project in a PNG, or `None` if it carries none. A damaged chunk is no project.
fn text_of_png(file: &[u8]) -> Result<Option<Vec<u8>>, TooLarge> {
    let is_project = |chunk: &Chunk| chunk.name == *b"iTXt" && file[chunk.data()].starts_with(KEYWORD);
    let found = chunks(file).find(|chunk| is_project(chunk) && chunk.is_intact(file));
    let parts = found.and_then(|chunk| text_parts(&file[chunk.data()][KEYWORD.len()..]));
    match parts {
        Some((false, text)) => Ok(Some(text.to_vec())),
        Some((true, deflated)) => match fdeflate::decompress_to_vec_bounded(deflated, MAX_PROJECT_BYTES) {
            Ok(text) => Ok(Some(text)),
            Err(BoundedDecompressionError::OutputTooLarge { .. }) => Err(TooLarge),
            Err(BoundedDecompressionError::DecompressionError { .. }) => Ok(None),
        },
        None => Ok(None),
    }
}

/// Divides the data of a chunk iTXt behind its keyword (PNG, 3rd edition, §11.3.3.4). Returns whether it is compressed,
/// and the text. Between them are a method, a language, and a translated keyword.
fn text_parts(data: &[u8]) -> Option<(bool, &[u8])> {
    let ([flag, _method], rest) = data.split_first_chunk()?;
    let text = rest.splitn(3, |&byte| byte == 0).nth(2)?;
    Some((*flag != 0, text))
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
