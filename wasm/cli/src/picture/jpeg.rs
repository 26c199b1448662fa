//! The end of a JPEG file, found by its markers (ITU-T T.81, annex B).
//!
//! Decoders fill missing parts with grey and report no error, so the file must be checked. Segments are skipped by
//! their length. Scan data ends at the next marker, because it never contains one.
//!
//! Some cameras omit the marker "end of image", or write their own data instead. Such a file is complete if its scans
//! are complete. Scan data has no length, so a decoder must find out: see [`probes`].

use std::collections::HashMap;

const START_OF_SCAN: u8 = 0xda;
const END_OF_IMAGE: u8 = 0xd9;
/// Each probe decodes to different blocks. Decoders take missing bits for 0.
const FILLERS: [&[u8]; 2] = [&[0x33; 64], &[0xcc; 64]];

/// The end of a JPEG file.
#[derive(Debug, PartialEq)]
pub(super) enum End {
    /// The file has a marker "end of image".
    Marked,
    /// The file has no such marker. Its last scan ends at this position, with or without all of its data.
    Unmarked(usize),
    /// The file ends before its last scan.
    Missing,
}

/// Walks to the end of the image. Data after its marker is ignored.
pub(super) fn end(file: &[u8]) -> End {
    let mut bits = MissingBits::default();
    let (mut at, mut in_scan, mut last_scan) = (0, false, None);
    loop {
        let marker = next_marker(file, at);
        if in_scan && bits.is_empty() {
            last_scan = last_scan.or(Some(marker.map_or(file.len(), |(start, _)| start)));
        }
        match marker {
            Some((_, END_OF_IMAGE)) => return End::Marked,
            Some((start, code)) => {
                let Some((segment, next)) = segment(file, start) else { break };
                in_scan = code == START_OF_SCAN;
                if in_scan {
                    bits.scan(segment);
                } else if is_frame(code) {
                    bits.frame(segment);
                }
                at = next;
            }
            None => break,
        }
    }
    last_scan.map_or(End::Missing, End::Unmarked)
}

/// Files that end with a marker. They decode to the same pixels if the last scan of an unmarked file is complete.
///
/// In all files but the first, filler follows the scan. Decoders ignore it after they have decoded every block.
pub(super) fn probes(file: &[u8], end_of_scan: usize) -> [Vec<u8>; 3] {
    let [one, other] = FILLERS;
    [&[], one, other].map(|filler| [&file[..end_of_scan], filler, &[0xff, END_OF_IMAGE]].concat())
}

/// Returns the position and code of the next marker that is neither a stuffed byte of a scan nor a restart.
fn next_marker(file: &[u8], from: usize) -> Option<(usize, u8)> {
    let mut at = from;
    loop {
        let start = at + file.get(at..)?.iter().position(|&byte| byte == 0xff)?;
        let code = start + file[start..].iter().position(|&byte| byte != 0xff)?;
        // 0 marks a stuffed byte 0xff of a scan. 0xd0 to 0xd7 restart a scan, 0xd8 starts the image, 1 is for temporary
        // use.
        if !matches!(file[code], 0 | 1 | 0xd0..=0xd8) {
            return Some((start, file[code]));
        }
        at = code + 1;
    }
}

/// Returns the contents of the segment whose marker starts at a position, and the position after it. `None` if the file
/// ends earlier.
fn segment(file: &[u8], marker: usize) -> Option<(&[u8], usize)> {
    let length = marker + 1 + file[marker + 1..].iter().position(|&byte| byte != 0xff)? + 1;
    let size = usize::from(u16::from_be_bytes([*file.get(length)?, *file.get(length + 1)?])).max(2);
    Some((file.get(length + 2..length + size)?, length + size))
}

/// Whether a marker is SOF0 to SOF15. DHT, JPG and DAC have codes in the same range.
fn is_frame(code: u8) -> bool {
    matches!(code, 0xc0..=0xcf) && !matches!(code, 0xc4 | 0xc8 | 0xcc)
}

/// The low bits that no scan has provided yet, for each component of the frame and each of its 64 coefficients.
///
/// A sequential scan provides all bits. A progressive scan provides some coefficients, at first without their lowest
/// bits.
#[derive(Default)]
struct MissingBits {
    components: HashMap<u8, [u8; 64]>,
}

impl MissingBits {
    fn is_empty(&self) -> bool {
        !self.components.is_empty() && self.components.values().flatten().all(|&bits| bits == 0)
    }

    /// Reads a frame header (B.2.2).
    fn frame(&mut self, segment: &[u8]) {
        let components = segment.get(6..).unwrap_or_default().chunks_exact(3);
        self.components.extend(components.map(|component| (component[0], [u8::MAX; 64])));
    }

    /// Reads a scan header (B.2.3).
    fn scan(&mut self, segment: &[u8]) {
        let Some((&count, rest)) = segment.split_first() else { return };
        let Some((components, &[first, last, bits])) = rest.split_at_checked(usize::from(count) * 2) else { return };
        for component in components.chunks_exact(2) {
            let Some(missing) = self.components.get_mut(&component[0]) else { continue };
            for coefficient in missing.iter_mut().take(usize::from(last) + 1).skip(usize::from(first)) {
                *coefficient = bits & 15;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{End, end, probes};

    /// A start, a segment that looks like an end, and a frame of one component.
    const START: &[u8] = b"\xff\xd8\xff\xe0\0\x04\xff\xd9\xff\xc0\0\x0b\x08\0\x01\0\x01\x01\x07\x11\0";
    /// A scan with a stuffed byte and a restart.
    const SCAN: &[u8] = b"\xff\xda\0\x08\x01\x07\0\0\x3f\0abc\xff\0\xff\xd3def";
    const END: &[u8] = b"\xff\xff\xd9";

    #[test]
    fn marker_ends_the_image() {
        let file = [START, SCAN, END].concat();
        assert_eq!(end(&file), End::Marked);
        assert_eq!(end(&[&file, &b"trailing data"[..]].concat()), End::Marked);
        for length in 0..file.len() {
            assert_ne!(end(&file[..length]), End::Marked, "{length}");
        }
        assert_eq!(end(START), End::Missing);
    }

    #[test]
    fn without_a_marker_the_last_scan_ends_the_image() {
        let file = [START, SCAN].concat();
        for trailer in [&b""[..], b"data of the camera", b"\xff\xe5\0\x04ab", b"\xff\xe5\xff"] {
            let first_marker = trailer.iter().position(|&byte| byte == 0xff).unwrap_or(trailer.len());
            assert_eq!(end(&[&file, trailer].concat()), End::Unmarked(file.len() + first_marker), "{trailer:?}");
        }
        let probed = probes(&[&file, &b"\xff\xe5"[..]].concat(), file.len());
        let fillers = [&b""[..], &[0x33; 64], &[0xcc; 64]];
        assert_eq!(probed, fillers.map(|filler| [&file, filler, b"\xff\xd9"].concat()));
    }

    #[test]
    fn progressive_image_needs_the_scans_of_all_bits() {
        let scan =
            |first: u8, last: u8, bits: u8| [b"\xff\xda\0\x08\x01\x07\0", &[first, last, bits][..], b"data"].concat();
        let scans = [scan(0, 0, 0x01), scan(1, 63, 0x02), scan(0, 0, 0x10), scan(1, 63, 0x21), scan(1, 63, 0x10)];
        for count in 0..scans.len() {
            assert_eq!(end(&[START, &scans[..count].concat()].concat()), End::Missing, "{count}");
        }
        let file = [START, &scans.concat()].concat();
        assert_eq!(end(&file), End::Unmarked(file.len()));
    }
}
