//! The file around the sections: header, checksum and table.

use std::collections::VecDeque;

use super::error::{BakeError, RigError, RigPart};

const MAGIC: [u8; 8] = *b"\x89C2RIG\r\n";
/// Files of a displaced picture have the latest version, so that readers of the first version do not show them wrongly.
const VERSIONS: std::ops::RangeInclusive<u32> = 1..=DISPLACED;
pub(super) const DISPLACED: u32 = 2;
/// Magic, version, length, checksum and number of sections.
const HEADER: usize = 24;
/// Tag, stored bytes and unpacked bytes.
const ROW: usize = 12;
/// Number of bytes before those covered by the checksum.
const UNCHECKED: usize = 20;
/// Greatest compression ratio of deflate.
const MOST_UNPACKED: u64 = 1032;
/// Maximum length of all deflated sections, in bytes. Eight million motions, the mesh and the shares of all handles
/// need less.
const MAX_INFLATED: u64 = 512 << 20;
/// The encoder's best compression without its exhaustive search.
const LEVEL: u8 = 9;

pub(super) type Tag = [u8; 4];

/// A section with its unpacked bytes.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) tag: Tag,
    pub(super) bytes: Vec<u8>,
}

pub(super) fn packed(version: u32, sections: &[Section]) -> Result<Vec<u8>, BakeError> {
    let size = |length: usize| u32::try_from(length).map_err(|_| BakeError::TooLarge);
    let mut table = Vec::new();
    let mut stored = Vec::new();
    let mut inflated = 0;
    for Section { tag, bytes } in sections {
        let deflated = miniz_oxide::deflate::compress_to_vec(bytes, LEVEL);
        let shorter = if deflated.len() < bytes.len() { deflated } else { bytes.clone() };
        inflated += if shorter.len() < bytes.len() { bytes.len() as u64 } else { 0 };
        table.extend(tag);
        table.extend(size(shorter.len())?.to_le_bytes());
        table.extend(size(bytes.len())?.to_le_bytes());
        stored.extend(shorter);
    }
    if inflated > MAX_INFLATED {
        return Err(BakeError::TooLarge);
    }
    let mut checked = size(sections.len())?.to_le_bytes().to_vec();
    checked.extend(table);
    checked.extend(stored);
    let mut file = MAGIC.to_vec();
    file.extend(version.to_le_bytes());
    file.extend(size(UNCHECKED + checked.len())?.to_le_bytes());
    file.extend(crc32fast::hash(&checked).to_le_bytes());
    file.extend(checked);
    Ok(file)
}

/// The version of a file, and its sections in the order of its table.
pub(super) fn unpacked(file: &[u8]) -> Result<(u32, VecDeque<Section>), RigError> {
    let word = |at: usize| {
        let bytes: [u8; 4] = file[at..at + 4].try_into().expect("four bytes");
        u32::from_le_bytes(bytes)
    };
    let wrong = |reason| RigError::Part { part: RigPart::Table, reason };
    if !file.starts_with(&MAGIC) {
        return Err(RigError::NotARig);
    }
    if file.len() < HEADER {
        return Err(RigError::Length { expected: HEADER as u32, found: file.len() });
    }
    let [version, length, checksum, count] = [8, 12, 16, 20].map(word);
    if !VERSIONS.contains(&version) {
        return Err(RigError::Version { found: version });
    }
    if length as usize != file.len() {
        return Err(RigError::Length { expected: length, found: file.len() });
    }
    if crc32fast::hash(&file[UNCHECKED..]) != checksum {
        return Err(RigError::Checksum);
    }
    if count as usize > (file.len() - HEADER) / ROW {
        return Err(wrong("is longer than the file"));
    }
    let rows = (0..count as usize).map(|row| HEADER + ROW * row);
    let inflated_lengths = rows.map(|at| [at + 4, at + 8].map(word)).filter(|[stored, length]| stored != length);
    if inflated_lengths.map(|[_, length]| u64::from(length)).sum::<u64>() > MAX_INFLATED {
        return Err(wrong("has sections of more than 512 MiB"));
    }
    let mut rest = &file[HEADER + ROW * count as usize..];
    let mut sections = VecDeque::new();
    for row in 0..count as usize {
        let at = HEADER + ROW * row;
        let tag = file[at..at + 4].try_into().expect("four bytes");
        let [stored, length] = [4, 8].map(|offset| word(at + offset));
        let (bytes, after) = rest.split_at_checked(stored as usize).ok_or(wrong(
            "lists a section beyond the end of the \
                                                                                 file",
        ))?;
        rest = after;
        sections.push_back(Section { tag, bytes: inflated(bytes, length).ok_or(wrong("has a damaged section"))? });
    }
    if !rest.is_empty() {
        return Err(wrong("does not cover the whole file"));
    }
    Ok((version, sections))
}

fn inflated(stored: &[u8], length: u32) -> Option<Vec<u8>> {
    if length as usize == stored.len() {
        return Some(stored.to_vec());
    }
    if u64::from(length) > MOST_UNPACKED * stored.len() as u64 {
        return None;
    }
    let bytes = miniz_oxide::inflate::decompress_to_vec_with_limit(stored, length as usize).ok()?;
    (bytes.len() == length as usize).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file whose sections claim to unpack to this many bytes.
    fn claiming(lengths: &[u32]) -> Vec<u8> {
        let stored = vec![0; 300_000];
        let section = |_: &u32| Section { tag: *b"CLIP", bytes: stored.clone() };
        let mut file = packed(1, &lengths.iter().map(section).collect::<Vec<_>>()).expect("a small file");
        for (row, length) in lengths.iter().enumerate() {
            let at = HEADER + ROW * row + 8;
            file[at..at + 4].copy_from_slice(&length.to_le_bytes());
        }
        let checksum = crc32fast::hash(&file[UNCHECKED..]);
        file[16..20].copy_from_slice(&checksum.to_le_bytes());
        file
    }

    #[test]
    fn sections_that_unpack_to_too_much_are_refused_by_the_table() {
        let refused = |lengths: &[u32]| unpacked(&claiming(lengths)).expect_err("refused").to_string();
        let large = "this rig is damaged: the table of sections has sections of more than 512 MiB";
        assert_eq!(refused(&[1 << 30]), large);
        assert_eq!(refused(&[300 << 20, 300 << 20]), large);
        assert_eq!(refused(&[300 << 20]), "this rig is damaged: the table of sections has a damaged section");
        assert!(unpacked(&claiming(&[300_000; 3])).is_ok());
    }
}
