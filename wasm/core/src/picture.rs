//! The picture to warp: its size, and its borrowed pixels.

use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE, MIN_SIDE},
};

/// A picture in straight (not premultiplied) 8-bit RGBA, rows from top to bottom.
///
/// An `RgbaImage` of the crate `image` has the same layout.
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a> {
    width: u32,
    height: u32,
    rgba: &'a [u8],
}

impl<'a> Picture<'a> {
    /// A picture of the given size in pixels, with `width × height × 4` bytes.
    ///
    /// # Errors
    /// The errors of [`check_size`](Self::check_size), and [`Error::PictureBytes`] for a wrong number of bytes.
    pub fn new(width: u32, height: u32, rgba: &'a [u8]) -> Result<Self, Error> {
        Self::check_size(width, height)?;
        let expected = width as usize * height as usize * 4;
        if rgba.len() != expected {
            return Err(Error::PictureBytes { width, height, expected, found: rgba.len() });
        }
        Ok(Self { width, height, rgba })
    }

    /// Checks the size of a picture, for example before its pixels are decoded.
    ///
    /// # Errors
    /// - [`Error::PictureSide`] for a side outside [`MIN_SIDE`] to [`MAX_SIDE`].
    /// - [`Error::PictureArea`] for more pixels than [`MAX_PIXELS`].
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

    /// The pixels: `width × height × 4` bytes.
    #[must_use]
    pub fn rgba(&self) -> &'a [u8] {
        self.rgba
    }

    /// One pixel in straight RGBA, by its column and row.
    pub(crate) fn pixel(&self, x: usize, y: usize) -> [u8; 4] {
        self.rgba.as_chunks().0[y * self.width as usize + x]
    }

    /// Whether any pixel is not fully opaque.
    #[must_use]
    pub fn has_transparency(&self) -> bool {
        self.rgba.chunks_exact(4).any(|pixel| pixel[3] != u8::MAX)
    }
}
