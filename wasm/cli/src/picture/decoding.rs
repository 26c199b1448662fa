//! Decodes the pixels of a picture. If a decoder panics on damaged bytes, the picture is rejected.

use std::{
    cell::Cell,
    panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook},
    sync::Once,
};

use image::{
    DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageResult,
    error::{DecodingError, ImageFormatHint},
};

thread_local! {
    static IS_DECODING: Cell<bool> = const { Cell::new(false) };
}

/// Decodes the pixels of a picture.
///
/// # Errors
/// The errors of the decoder, and [`ImageError::Decoding`] if it panics. A panic prints nothing.
pub(super) fn decoded(decoder: impl ImageDecoder, format: ImageFormat) -> ImageResult<DynamicImage> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            // WebAssembly ends at a panic.
            if !IS_DECODING.get() || cfg!(panic = "abort") {
                usual(panic);
            }
        }));
    });
    IS_DECODING.set(true);
    // The decoder is gone after a panic, so nobody sees it half-changed.
    let result = catch_unwind(AssertUnwindSafe(|| DynamicImage::from_decoder(decoder)));
    IS_DECODING.set(false);
    result.unwrap_or_else(|_| {
        let reason = "the decoder failed";
        Err(ImageError::Decoding(DecodingError::new(ImageFormatHint::Exact(format), reason)))
    })
}

#[cfg(test)]
mod tests {
    use image::ColorType;

    use super::*;

    struct Broken;

    impl ImageDecoder for Broken {
        fn dimensions(&self) -> (u32, u32) {
            (2, 2)
        }

        fn color_type(&self) -> ColorType {
            ColorType::L8
        }

        fn read_image(self, _: &mut [u8]) -> ImageResult<()> {
            panic!("never printed")
        }

        fn read_image_boxed(self: Box<Self>, bytes: &mut [u8]) -> ImageResult<()> {
            self.read_image(bytes)
        }
    }

    #[test]
    fn decoder_that_panics_refuses_the_picture() {
        let error = decoded(Broken, ImageFormat::Jpeg).expect_err("no pixels").to_string();
        assert!(error.contains("the decoder failed") && !error.contains('\n'), "{error:?}");
        assert!(!IS_DECODING.get());
    }
}
