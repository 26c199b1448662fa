//! Names of file types that the command does not read, for error messages. `web/src/io/formats/signature.ts` has the
//! same list.

use super::encoding;

/// Bytes of a file that [`name`] examines.
pub(super) const SIGNATURE_BYTES: usize = 256;

const SIGNATURES: &[(&[u8], &str)] = &[
    (b"GIF87a", "a GIF picture"),
    (b"GIF89a", "a GIF picture"),
    (b"BM", "a BMP picture"),
    (b"\0\0\x01\0", "an icon"),
    (b"II*\0", "a TIFF picture"),
    (b"MM\0*", "a TIFF picture"),
    (b"8BPS", "a Photoshop document"),
    (b"%PDF-", "a PDF document"),
    (b"%!PS", "a PostScript document"),
    (b"\xff\x0a", "a JPEG XL picture"),
    (b"\0\0\0\x0cJXL ", "a JPEG XL picture"),
    (b"\0\0\0\x0cjP  ", "a JPEG 2000 picture"),
    (GZIP, "a compressed file"),
];

/// First bytes of gzip files (RFC 1952), such as drawings in .svgz.
pub(super) const GZIP: &[u8] = b"\x1f\x8b\x08";

/// Names by brands of ISO base media files (ISO/IEC 14496-12, section 4.3). AVIF files may name brands of HEIC as well.
const BRANDS: &[(&[&[u8; 4]], &str)] = &[
    (&[b"avif", b"avis"], "an AVIF picture"),
    (&[b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1"], "a HEIC picture"),
];

/// The beginnings of SVG drawings, in any letter case.
const DRAWINGS: &[&str] = &["<?xml", "<!--", "<!doctype svg", "<svg"];

/// Returns the type of a file by its first [`SIGNATURE_BYTES`], with an article.
pub(super) fn name(start: &[u8]) -> Option<&'static str> {
    let signature = SIGNATURES.iter().find(|(signature, _)| start.starts_with(signature));
    signature.map(|&(_, name)| name).or_else(|| media_name(start))
}

fn media_name(start: &[u8]) -> Option<&'static str> {
    let (size, rest) = start.split_first_chunk()?;
    let length = (u32::from_be_bytes(*size) as usize).min(start.len());
    let brands = rest.get(..length.checked_sub(4)?)?.strip_prefix(b"ftyp")?;
    let has = |wanted: &[&[u8; 4]]| brands.chunks_exact(4).any(|brand| wanted.iter().any(|&name| name == brand));
    BRANDS.iter().find(|(wanted, _)| has(wanted)).map(|&(_, name)| name)
}

/// Returns whether a file is an SVG drawing, in any encoding.
pub(super) fn is_drawing(start: &[u8]) -> bool {
    let (text, ..) = encoding::unmarked(start).decode(start);
    let text = text.trim_start().to_ascii_lowercase();
    DRAWINGS.iter().any(|word| text.starts_with(word))
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn file_types_are_named() {
        for (start, expected) in [
            (&b"MM\0*\0\0\0\x08"[..], Some("a TIFF picture")),
            (b"8BPS\0\x01", Some("a Photoshop document")),
            (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", Some("a HEIC picture")),
            (b"\0\0\0\x1cftypmif1\0\0\0\0mif1avifmiaf", Some("an AVIF picture")),
            (b"\0\0\0\x18ftypisom\0\0\0\0isomavif", Some("an AVIF picture")),
            (b"\0\0\0\x14ftypisom\0\0\0\0isomavif", None),
            (b"\x1f\x8b\x08\0", Some("a compressed file")),
            (b"once upon a time", None),
            (b"", None),
            (b"\0\0\0\0", None),
        ] {
            assert_eq!(name(start), expected, "{}", start.escape_ascii());
        }
    }
}
