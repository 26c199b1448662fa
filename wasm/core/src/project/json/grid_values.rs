//! The values of a grid over the picture: its size, and the bytes of all entries in base64.

use std::ops::RangeInclusive;

use base64::{Engine, encoded_len, engine::general_purpose::STANDARD};

use super::cursor::{Cursor, Object};
use crate::project::{ProjectError, validate};

/// Reads `width` and `height`.
pub(super) fn read_sides(grid: &Object<'_>, range: &RangeInclusive<u32>) -> Result<[u32; 2], ProjectError> {
    let [width, height] = ["width", "height"].map(|side| {
        let at = grid.required(side)?;
        let entries = at.whole_number(range)?;
        if range.contains(&entries) { Ok(entries) } else { at.expected(validate::whole_numbers(range)) }
    });
    Ok([width?, height?])
}

/// Reads `each` bytes for each entry of a grid. `entries` is their name in errors.
pub(super) fn read_bytes(
    values: Cursor<'_>,
    sides: [u32; 2],
    each: usize,
    entries: &str,
) -> Result<Vec<u8>, ProjectError> {
    let [width, height] = sides;
    let text = values.string()?;
    // The length is known before any memory is taken.
    let bytes = each * validate::entries(sides);
    let (expected, found) = (encoded_len(bytes, true).unwrap_or(usize::MAX), text.len());
    if expected != found {
        return values.refuse(format_args!(
            "expected {expected} characters of base64 for {width} × {height} {entries}, found {found}"
        ));
    }
    match STANDARD.decode(text) {
        Ok(values) if values.len() == bytes => Ok(values),
        _ if each == 1 => values.refuse(format_args!("expected {width} × {height} bytes in base64 with its padding")),
        _ => values.refuse(format_args!("expected {width} × {height} × {each} bytes in base64 with its padding")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_one_text() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!((STANDARD.encode(bytes), encoded_len(bytes.len(), true)), (text.to_owned(), Some(text.len())));
            assert_eq!(STANDARD.decode(text), Ok(bytes.as_bytes().to_vec()));
        }
        for text in ["Zg", "Zg=", "Zh==", "Zm9=", "Z===", "====", "Zg==Zg==", "Zm 9", "Zm-_", "Zmä"] {
            assert!(STANDARD.decode(text).is_err(), "{text}");
        }
    }
}
