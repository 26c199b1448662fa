//! Mutations of bytes by a seeded generator.

use c2warp_tests::Random;

/// Most changes of one input.
const MOST_CHANGES: u64 = 6;
/// Longest input, so that each takes little time.
const MOST_BYTES: usize = 4096;
/// Bytes at which parsers and counts change their mind.
const INTERESTING: [u8; 12] = [0, 1, 0x7f, 0x80, 0xfe, 0xff, b'0', b'-', b'e', b'"', b'[', b'\\'];

/// Returns a mutation of one of some inputs: bytes are changed, left out, repeated, or taken from another input.
pub(crate) fn mutated(inputs: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut bytes: Vec<u8> = any(inputs, random).clone();
    for _ in 0..=random.below(MOST_CHANGES) {
        let other = any(inputs, random);
        change(&mut bytes, other, random);
    }
    bytes.truncate(MOST_BYTES);
    bytes
}

fn any<'a, T>(of: &'a [T], random: &mut Random) -> &'a T {
    &of[random.below(of.len() as u64) as usize]
}

fn change(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let at = random.below(bytes.len() as u64 + 1) as usize;
    let end = at + random.below((bytes.len() - at).min(32) as u64 + 1) as usize;
    match random.below(8) {
        // The most frequent change: a byte.
        0..=2 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
        3 if at < bytes.len() => bytes[at] = *any(&INTERESTING, random),
        4 => drop(bytes.drain(at..end)),
        5 => bytes.splice(at..at, bytes[at..end].to_vec()).for_each(drop),
        6 => bytes.insert(at, random.below(256) as u8),
        _ => {
            let from = random.below(other.len() as u64 + 1) as usize;
            let to = from + random.below((other.len() - from).min(64) as u64 + 1) as usize;
            bytes.splice(at..end, other[from..to].iter().copied()).for_each(drop);
        }
    }
}
