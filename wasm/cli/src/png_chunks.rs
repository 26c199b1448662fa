//! The chunks of a PNG file (3rd edition, section 5.3), without their contents being read.

use std::ops::Range;

/// Signature in front of the first chunk.
const SIGNATURE: usize = 8;
/// Length and name.
const HEAD: usize = 8;
const CHECKSUM: usize = 4;

/// A chunk by its place in the file.
pub(crate) struct Chunk {
    pub(crate) name: [u8; 4],
    /// All of it, with its length, its name and its checksum.
    pub(crate) whole: Range<usize>,
}

impl Chunk {
    pub(crate) fn data(&self) -> Range<usize> {
        self.whole.start + HEAD..self.whole.end - CHECKSUM
    }

    /// Whether the checksum is that of the name and the data.
    pub(crate) fn is_intact(&self, file: &[u8]) -> bool {
        let Range { start, end } = self.data();
        file[end..].starts_with(&crc32fast::hash(&file[start - 4..end]).to_be_bytes())
    }
}

/// Returns the chunks up to the end of the picture, or up to the first that is cut short.
pub(crate) fn chunks(file: &[u8]) -> impl Iterator<Item = Chunk> {
    let mut at = Some(SIGNATURE);
    std::iter::from_fn(move || {
        let start = at?;
        let (length, rest) = file.get(start..)?.split_first_chunk()?;
        let name = *rest.first_chunk()?;
        let end = start.checked_add(HEAD + CHECKSUM)?.checked_add(u32::from_be_bytes(*length) as usize)?;
        at = Some(end).filter(|_| name != *b"IEND");
        (end <= file.len()).then_some(Chunk { name, whole: start..end })
    })
}
