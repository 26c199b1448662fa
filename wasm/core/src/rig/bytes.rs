//! Numbers as bytes.
//!
//! Integers are varints: seven bits per byte from the lowest, with the top bit set on all bytes but the last. Signed
//! ones are zigzag varints: 0, −1, 1, −2, … are 0, 1, 2, 3, …

use super::error::{RigError, RigPart};

#[derive(Debug, Default)]
pub(super) struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    pub(super) fn byte(&mut self, byte: u8) {
        self.bytes.push(byte);
    }

    pub(super) fn varint(&mut self, mut number: u32) {
        while number >= 0x80 {
            self.bytes.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.bytes.push(number as u8);
    }

    pub(super) fn signed(&mut self, number: i32) {
        self.varint((number << 1 ^ number >> 31) as u32);
    }

    pub(super) fn count(&mut self, count: usize) {
        self.varint(u32::try_from(count).expect("counts of a solution have 32 bits"));
    }

    pub(super) fn number(&mut self, number: f64) {
        self.bytes.extend(number.to_le_bytes());
    }

    pub(super) fn text(&mut self, text: &str) {
        self.count(text.len());
        self.bytes.extend(text.as_bytes());
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}

/// The remaining bytes of a part.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    part: RigPart,
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    pub(super) fn new(part: RigPart, bytes: &'a [u8]) -> Self {
        Self { part, rest: bytes }
    }

    /// An error about this part.
    pub(super) fn wrong(&self, reason: &'static str) -> RigError {
        RigError::Part { part: self.part, reason }
    }

    pub(super) fn expect(&self, is_right: bool, reason: &'static str) -> Result<(), RigError> {
        if is_right { Ok(()) } else { Err(self.wrong(reason)) }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], RigError> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or_else(|| self.wrong("ends too early"))?;
        self.rest = rest;
        Ok(taken)
    }

    pub(super) fn byte(&mut self) -> Result<u8, RigError> {
        Ok(self.take(1)?[0])
    }

    pub(super) fn varint(&mut self) -> Result<u32, RigError> {
        let mut number = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            number |= u32::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                self.expect(shift < 28 || byte < 0x10, "contains a number of more than 32 bits")?;
                return Ok(number);
            }
        }
        Err(self.wrong("contains a number of more than 32 bits"))
    }

    pub(super) fn signed(&mut self) -> Result<i32, RigError> {
        let number = self.varint()?;
        Ok((number >> 1) as i32 ^ -((number & 1) as i32))
    }

    /// Reads a number of items of at least `bytes` bytes each, and checks that the part is long enough.
    pub(super) fn count(&mut self, bytes: usize) -> Result<usize, RigError> {
        let count = self.varint()? as usize;
        self.expect(count <= self.rest.len() / bytes, "ends too early")?;
        Ok(count)
    }

    /// Whether this many items of at least one byte each may follow.
    pub(super) fn has(&self, count: Option<usize>) -> bool {
        count.is_some_and(|count| count <= self.rest.len())
    }

    pub(super) fn number(&mut self) -> Result<f64, RigError> {
        let bytes = self.take(8)?.try_into().expect("eight bytes");
        Ok(f64::from_le_bytes(bytes))
    }

    pub(super) fn text(&mut self) -> Result<String, RigError> {
        let count = self.count(1)?;
        let text = std::str::from_utf8(self.take(count)?);
        Ok(text.map_err(|_| self.wrong("contains text that is not UTF-8"))?.to_owned())
    }

    pub(super) fn end(self) -> Result<(), RigError> {
        self.expect(self.rest.is_empty(), "continues after its expected end")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_return_as_written() {
        let mut writer = Writer::default();
        let numbers = [0, 1, -1, 63, -64, 64, 8191, -8192, i32::MAX, i32::MIN];
        numbers.iter().for_each(|&number| writer.signed(number));
        writer.varint(u32::MAX);
        writer.text("β");
        writer.number(-0.5);
        let bytes = writer.into_bytes();
        let mut reader = Reader::new(RigPart::Head, &bytes);
        for number in numbers {
            assert_eq!(reader.signed(), Ok(number));
        }
        assert_eq!(reader.varint(), Ok(u32::MAX));
        assert_eq!((reader.text(), reader.number()), (Ok("β".to_owned()), Ok(-0.5)));
        assert_eq!(reader.end(), Ok(()));
    }

    #[test]
    fn too_large_numbers_are_refused() {
        for bytes in [&[0xff, 0xff, 0xff, 0xff, 0x10][..], &[0x80; 5], &[0x80; 6], &[0x80]] {
            assert!(Reader::new(RigPart::Head, bytes).varint().is_err(), "{bytes:x?}");
        }
    }
}
