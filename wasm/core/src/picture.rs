//! The picture to warp: its size and its borrowed pixels.

use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE, MIN_SIDE},
};

/// A picture in straight (not premultiplied) 8-bit RGBA, rows from top to bottom: what the bytes of an `RgbaImage` of the crate
/// `image` are.
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a> {
    width: u32,
    height: u32,
    rgba: &'a [u8],
}

impl<'a> Picture<'a> {
    /// Borrows a picture: its size in pixels, and `width × height × 4` bytes.
    ///
    /// # Errors
    /// Those of [`check_size`](Self::check_size); [`Error::PictureBytes`] where the pixels do not fill it.
    pub fn new(width: u32, height: u32, rgba: &'a [u8]) -> Result<Self, Error> {
        Self::check_size(width, height)?;
        let expected = width as usize * height as usize * 4;
        if rgba.len() != expected {
            return Err(Error::PictureBytes { width, height, expected, found: rgba.len() });
        }
        Ok(Self { width, height, rgba })
    }

    /// Whether a picture of this size can be warped: a check before its pixels are decoded.
    ///
    /// # Errors
    /// [`Error::PictureSide`] and [`Error::PictureArea`], by [`MIN_SIDE`], [`MAX_SIDE`] and [`MAX_PIXELS`].
    pub fn check_size(width: u32, height: u32) -> Result<(), Error> {
        let sides = MIN_SIDE..=MAX_SIDE;
        if !sides.contains(&width) || !sides.contains(&height) {
            return Err(Error::PictureSide { width, height });
        }
        if u64::from(width) * u64::from(height) > MAX_PIXELS {
            return Err(Error::PictureArea { width, height });
        }
        Ok(())
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// `width × height × 4` bytes.
    #[must_use]
    pub fn rgba(&self) -> &'a [u8] {
        self.rgba
    }

    /// Whether any pixel is not fully opaque.
    #[must_use]
    pub fn has_transparency(&self) -> bool {
        self.rgba.chunks_exact(4).any(|pixel| pixel[3] != u8::MAX)
    }
}
