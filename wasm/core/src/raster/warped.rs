//! The result of a warp.

/// A warped picture.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Warped {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Position of the picture's upper left corner in the result, in pixels: `[0, 0]` on the picture's own canvas.
    pub origin: [i32; 2],
    /// `width × height × 4` bytes of straight (not premultiplied) RGBA, in rows from top to bottom.
    pub rgba: Vec<u8>,
}
