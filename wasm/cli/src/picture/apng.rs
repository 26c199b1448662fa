//! The first frame of an animated PNG whose default picture is not part of the animation.
//!
//! Such a default picture is for programs that do not support animation, and often only says so. Browsers never show
//! it.

use std::io::Cursor;

use image::codecs::png::PngDecoder;
use image::{AnimationDecoder, ImageResult, RgbaImage};

/// Returns the first frame on the whole canvas. `None` if the default picture is the first frame, or the only picture.
pub(super) fn first_frame(file: &[u8]) -> Option<ImageResult<RgbaImage>> {
    let reader = png::Decoder::new(Cursor::new(file)).read_info().ok()?;
    let info = reader.info();
    if info.animation_control.is_none() || info.frame_control.is_some() {
        return None;
    }
    let frames = PngDecoder::new(Cursor::new(file)).and_then(PngDecoder::apng).map(AnimationDecoder::into_frames);
    let first = frames.map(|mut frames| frames.next()).transpose()?;
    Some(first.and_then(|frame| frame.map(image::Frame::into_buffer)))
}

#[cfg(test)]
mod tests {
    use super::first_frame;

    /// Encodes a grey default picture and an animation of one white frame that covers the right half.
    fn animation(is_default_separate: bool) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 2, 1);
        encoder.set_animated(1, 0).unwrap();
        encoder.set_sep_def_img(is_default_separate).unwrap();
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&[128, 128]).unwrap();
        if is_default_separate {
            writer.set_frame_dimension(1, 1).unwrap();
            writer.set_frame_position(1, 0).unwrap();
            writer.write_image_data(&[255]).unwrap();
        }
        writer.finish().unwrap();
        file
    }

    #[test]
    fn first_frame_replaces_a_separate_default_picture() {
        let frame = first_frame(&animation(true)).unwrap().unwrap();
        assert_eq!(frame.into_raw(), [[0, 0, 0, 0], [255; 4]].concat());
        assert!(first_frame(&animation(false)).is_none());
        assert!(first_frame(b"no PNG").is_none());
    }
}
