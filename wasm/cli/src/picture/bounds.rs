//! Limits colour profiles of PNG files before a decoder decompresses them: two megabytes can contain gigabytes.
//!
//! All other parts are no longer than in the file, or have the size of the picture.

use fdeflate::BoundedDecompressionError::OutputTooLarge;

use crate::png_chunks::chunks;

/// Largest profile that is kept, in bytes. Those of printing presses, with tables, have up to 4 MB.
pub(super) const MAX_PROFILE_BYTES: usize = 8 << 20;

/// Removes the profiles of a PNG that unfold to more than [`MAX_PROFILE_BYTES`]. Returns whether there were any.
pub(super) fn remove_large_profiles(file: &mut Vec<u8>) -> bool {
    let profiles = chunks(file).filter(|chunk| chunk.name == *b"iCCP" && is_too_large(&file[chunk.data()]));
    let large: Vec<_> = profiles.map(|chunk| chunk.whole).collect();
    // From the end, so that the positions before stay.
    large.iter().rev().for_each(|whole| drop(file.drain(whole.clone())));
    !large.is_empty()
}

/// Whether the data of a chunk iCCP (PNG, 3rd edition, §11.3.2.3) unfold to too many bytes: name, 0, method, profile.
fn is_too_large(data: &[u8]) -> bool {
    let name = data.iter().position(|&byte| byte == 0).unwrap_or(data.len());
    let deflated = data.get(name + 2..).unwrap_or_default();
    // The decoder of PNG unfolds by the same code.
    matches!(fdeflate::decompress_to_vec_bounded(deflated, MAX_PROFILE_BYTES), Err(OutputTooLarge { .. }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A PNG of one grey pixel with a profile of this many zeros.
    fn with_profile(bytes: usize) -> Vec<u8> {
        let mut file = Vec::new();
        let mut info = png::Info::with_size(1, 1);
        info.icc_profile = Some(vec![0; bytes].into());
        let mut writer = png::Encoder::with_info(&mut file, info).unwrap().write_header().unwrap();
        writer.write_image_data(&[0]).unwrap();
        writer.finish().unwrap();
        file
    }

    #[test]
    fn profiles_up_to_the_limit_stay() {
        let plain = with_profile(MAX_PROFILE_BYTES);
        let mut file = plain.clone();
        assert!(!remove_large_profiles(&mut file) && file == plain);
        let mut file = with_profile(MAX_PROFILE_BYTES + 1);
        assert!(remove_large_profiles(&mut file));
        let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        assert!(reader.info().icc_profile.is_none());
    }

    #[test]
    fn damaged_files_are_left_to_the_decoder() {
        let plain = with_profile(9);
        for length in 0..plain.len() {
            let mut file = plain[..length].to_vec();
            assert!(!remove_large_profiles(&mut file) && file.len() == length);
        }
        assert!(!remove_large_profiles(&mut vec![0xff; 20]));
    }
}
