//! NPY, NumPy's file format for one array, version 1.0.
//!
//! Numbers are 64-bit floats, little-endian, with the last index varying fastest.

/// The length of the header and its prefix is a multiple of this.
const ALIGNMENT: usize = 64;
/// The bytes before the header: the signature, the version, and the length of the header.
const PREFIX: usize = 10;

/// The bytes before the numbers of an array.
pub(crate) fn header(shape: &[usize]) -> Vec<u8> {
    let sides: String = shape.iter().map(|side| format!("{side}, ")).collect();
    let dictionary = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}), }}", sides.trim_end());
    let length = (PREFIX + dictionary.len() + 1).next_multiple_of(ALIGNMENT) - PREFIX;
    let mut header = b"\x93NUMPY\x01\x00".to_vec();
    header.extend((length as u16).to_le_bytes());
    header.extend(format!("{dictionary:<width$}\n", width = length - 1).into_bytes());
    header
}

#[cfg(test)]
mod tests {
    use super::header;

    #[test]
    fn header_is_that_of_numpy() {
        let bytes = header(&[3, 105]);
        assert_eq!(bytes.len(), 128);
        assert_eq!(bytes[..10], *b"\x93NUMPY\x01\x00\x76\x00");
        let text = String::from_utf8(bytes[10..].to_vec()).unwrap();
        assert_eq!(text.trim_end(), "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 105,), }");
        assert!(text.ends_with(" \n") && header(&[7]).len().is_multiple_of(64));
        assert!(String::from_utf8_lossy(&header(&[7])).contains("'shape': (7,), }"));
    }
}
