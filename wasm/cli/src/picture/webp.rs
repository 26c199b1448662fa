//! Mends WebP files that browsers read, but the decoder here does not.
//!
//! The header VP8X announces the chunks that follow. Some programs remove a chunk but leave its flag. Browsers read
//! such files, but this decoder rejects them. It would also allocate the length that a chunk claims, even beyond the
//! end of the file.

use std::ops::Range;

/// Position of the flags: behind "RIFF", a size, "WEBP", "VP8X" and a size.
const FLAGS: usize = 20;
const FIRST_CHUNK: usize = 30;

const ALPHA: u8 = 0x10;
const EXIF: u8 = 0x08;
const XMP: u8 = 0x04;
const ANIMATION: u8 = 0x02;

/// Hides the metadata that a WebP file lacks in part, and clears the flags that announce missing chunks.
pub(super) fn mend(file: &mut [u8]) {
    if file.get(12..16) != Some(b"VP8X") || file.len() < FIRST_CHUNK {
        return;
    }
    let is_cut = |(name, contents): &(&[u8], Range<usize>)| {
        [b"ICCP", b"EXIF", b"XMP "].iter().any(|metadata| name == *metadata) && contents.end > file.len()
    };
    let cut: Vec<usize> = chunks(file).filter(is_cut).map(|(_, contents)| contents.start - 8).collect();
    // Decoders ignore chunks of unknown names.
    cut.into_iter().for_each(|at| file[at..at + 4].fill(b'_'));
    let has = |names: &[&[u8; 4]]| chunks(file).any(|(name, _)| names.iter().any(|wanted| name == *wanted));
    let mut stale = 0;
    for (flag, is_stale) in [
        // The chunk VP8L has its own alpha, and so have the frames of an animation.
        (ALPHA, !has(&[b"ALPH", b"VP8L", b"ANMF"])),
        (EXIF, !has(&[b"EXIF"])),
        (XMP, !has(&[b"XMP "])),
        (ANIMATION, !has(&[b"ANIM"]) || !has(&[b"ANMF"])),
    ] {
        stale |= if is_stale { flag } else { 0 };
    }
    file[FLAGS] &= !stale;
}

/// Returns the names and contents of the chunks behind the header. A truncated chunk ends the list.
fn chunks(file: &[u8]) -> impl Iterator<Item = (&[u8], Range<usize>)> {
    let mut at = FIRST_CHUNK;
    std::iter::from_fn(move || {
        let name = file.get(at..at + 4)?;
        let size = u32::from_le_bytes(file.get(at + 4..at + 8)?.try_into().ok()?) as usize;
        let contents = at + 8..(at + 8).checked_add(size)?;
        // Chunks have an even size.
        at = contents.end.checked_add(size % 2)?;
        Some((name, contents))
    })
}

#[cfg(test)]
mod tests {
    use super::{FLAGS, mend};

    /// Returns the flags that remain in front of empty chunks.
    fn flags_kept(flags: u8, names: &[&[u8; 4]]) -> u8 {
        let chunks: Vec<u8> = names.iter().flat_map(|name| [&name[..], &[1, 0, 0, 0, 7, 0]].concat()).collect();
        let mut file = [&b"RIFF\0\0\0\0WEBPVP8X\x0a\0\0\0"[..], &[flags], &[0; 9], &chunks].concat();
        mend(&mut file);
        file[FLAGS]
    }

    #[test]
    fn flags_without_chunks_are_cleared() {
        assert_eq!(flags_kept(0x3e, &[b"VP8 "]), 0x20, "the profile has a flag that decoders do not insist on");
        assert_eq!(flags_kept(0x1c, &[b"ALPH", b"VP8 ", b"EXIF", b"XMP "]), 0x1c);
        assert_eq!(flags_kept(0x10, &[b"VP8L"]), 0x10);
        assert_eq!(flags_kept(0x12, &[b"ANIM", b"ANMF"]), 0x12);
        assert_eq!(flags_kept(0x12, &[b"ANIM", b"VP8 "]), 0);
        let mut short = b"RIFF\0\0\0\0WEBPVP8X".to_vec();
        mend(&mut short);
    }

    #[test]
    fn metadata_that_the_file_lacks_is_hidden() {
        for (length, flags) in [(2_u8, 0x08), (3, 0)] {
            let mut file =
                [&b"RIFF\0\0\0\0WEBPVP8X\x0a\0\0\0\x08"[..], &[0; 9], b"EXIF", &[length, 0, 0, 0, 7, 7]].concat();
            mend(&mut file);
            assert_eq!(file[FLAGS], flags, "{length}");
        }
    }
}
