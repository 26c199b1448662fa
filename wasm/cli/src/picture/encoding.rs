//! The text of an XML file in the encoding that it declares (XML 1.0, appendix F). Names are those of the Encoding
//! Standard. `web/src/io/formats/xml_text.ts` reads files alike.

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};

/// Why a file has no text.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum NoText {
    /// The declared encoding is unknown.
    Unknown(String),
    /// Some bytes mean nothing in the encoding.
    Malformed(&'static str),
}

/// The text of an XML file.
pub(super) fn text_of(bytes: &[u8]) -> Result<String, NoText> {
    let (encoding, mark) = match Encoding::for_bom(bytes) {
        Some(marked) => marked,
        None => (declared(bytes)?, 0),
    };
    let text = encoding.decode_without_bom_handling_and_without_replacement(&bytes[mark..]);
    text.map(Into::into).ok_or(NoText::Malformed(encoding.name()))
}

/// The encoding of a file whose declaration is not read. Its first bytes are `<` or white space, if it is XML.
pub(super) fn unmarked(bytes: &[u8]) -> &'static Encoding {
    match bytes {
        [0, b'<' | b' ' | b'\t' | b'\r' | b'\n', ..] => UTF_16BE,
        [b'<' | b' ' | b'\t' | b'\r' | b'\n', 0, ..] => UTF_16LE,
        _ => UTF_8,
    }
}

fn declared(bytes: &[u8]) -> Result<&'static Encoding, NoText> {
    let unmarked = unmarked(bytes);
    let Some(label) = label(bytes).filter(|_| unmarked == UTF_8) else { return Ok(unmarked) };
    let encoding = Encoding::for_label_no_replacement(label)
        .ok_or_else(|| NoText::Unknown(String::from_utf8_lossy(label).into()))?;
    // A file whose declaration can be read byte by byte is not in UTF-16.
    Ok(encoding.output_encoding())
}

/// The name in `<?xml version="1.0" encoding="NAME"?>`.
fn label(bytes: &[u8]) -> Option<&[u8]> {
    let rest = bytes.strip_prefix(b"<?xml")?;
    let declaration = &rest[..rest.iter().position(|&byte| byte == b'>')?];
    let at = declaration.windows(8).position(|word| word == b"encoding")?;
    let value = declaration[at + 8..].trim_ascii_start().strip_prefix(b"=")?.trim_ascii_start();
    let (quote, rest) = value.split_first()?;
    let end = rest.iter().position(|byte| byte == quote)?;
    matches!(quote, b'"' | b'\'').then_some(&rest[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn texts_are_read_in_the_encoding_of_their_mark_or_declaration() {
        let drawing = "<svg id=\"Größe ☂\"/>";
        let marked = format!("\u{feff}{drawing}");
        for bytes in [
            drawing.as_bytes().to_vec(),
            marked.as_bytes().to_vec(),
            utf16(&marked, u16::to_le_bytes),
            utf16(&marked, u16::to_be_bytes),
            utf16(drawing, u16::to_le_bytes),
            utf16(drawing, u16::to_be_bytes),
        ] {
            assert_eq!(text_of(&bytes).as_deref(), Ok(drawing));
        }
        let declared = |label: &str, rest: &[u8]| {
            let start = format!("<?xml version='1.0' encoding = \"{label}\" ?>");
            text_of(&[start.as_bytes(), rest].concat()).map(|text| text.split_once("?>").unwrap().1.to_owned())
        };
        for (label, byte, character) in [
            ("ISO-8859-1", 0xf6, "ö"),
            ("latin1", 0x80, "€"),
            ("windows-1252", 0x80, "€"),
            ("ISO-8859-2", 0xb1, "ą"),
            ("iso-8859-15", 0xa4, "€"),
            ("KOI8-R", 0xc1, "а"),
            ("macintosh", 0x9a, "ö"),
            // A declaration in single bytes cannot be in UTF-16.
            ("UTF-16", b'o', "o"),
        ] {
            assert_eq!(declared(label, &[byte]).as_deref(), Ok(character), "{label}");
        }
        assert_eq!(declared("UTF-8", b"\xf6"), Err(NoText::Malformed("UTF-8")));
        assert_eq!(declared("Klingon", b"a"), Err(NoText::Unknown("Klingon".to_owned())));
    }
}
