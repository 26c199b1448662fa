//! Errors of the PNG encoder.

use std::io;

use png::EncodingError;

/// The error of the output, or the encoder's own.
pub(crate) fn png_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        error => io::Error::other(error),
    }
}
