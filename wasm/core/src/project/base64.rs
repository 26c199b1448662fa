//! Bytes as text: base64 with the standard alphabet and padding (RFC 4648, section 4).

use serde::Serializer;

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Number of characters for so many bytes.
pub(super) fn length(bytes: usize) -> usize {
    bytes.div_ceil(3) * 4
}

pub(super) fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&encoded(bytes))
}

fn encoded(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(length(bytes.len()));
    for chunk in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, k| bits << 8 | u32::from(chunk.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            let is_padding = k > chunk.len();
            text.push(if is_padding { '=' } else { char::from(ALPHABET[(bits >> (18 - 6 * k)) as usize & 63]) });
        }
    }
    text
}

/// The bytes; `None` if the text is not what [`encoded`] writes for some bytes.
pub(super) fn decoded(text: &str) -> Option<Vec<u8>> {
    let (chunks, []) = text.as_bytes().as_chunks::<4>() else { return None };
    let mut bytes = Vec::with_capacity(chunks.len() * 3);
    for (at, chunk) in chunks.iter().enumerate() {
        let padding = chunk.iter().rev().take_while(|&&letter| letter == b'=').count();
        if padding > 2 || padding > 0 && at + 1 < chunks.len() {
            return None;
        }
        let mut bits = 0;
        for letter in &chunk[..4 - padding] {
            bits = bits << 6 | u32::from(value(*letter)?);
        }
        bits <<= 6 * padding;
        let all = bits.to_be_bytes();
        // Bits that no byte holds are 0, so that a value has one text.
        if all[4 - padding..].iter().any(|&byte| byte != 0) {
            return None;
        }
        bytes.extend(&all[1..4 - padding]);
    }
    Some(bytes)
}

fn value(letter: u8) -> Option<u8> {
    ALPHABET.iter().position(|&known| known == letter).map(|at| at as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_that_of_the_standard() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!((encoded(bytes.as_bytes()), length(bytes.len())), (text.to_owned(), text.len()));
            assert_eq!(decoded(text), Some(bytes.as_bytes().to_vec()));
        }
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(decoded(&encoded(&all)), Some(all));
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["Zg", "Zg=", "Zh==", "Zm9=", "Z===", "====", "Zg==Zg==", "Zm 9", "Zm-_", "Zmä"] {
            assert_eq!(decoded(text), None, "{text}");
        }
    }
}
