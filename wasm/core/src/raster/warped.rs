//! The result of a warp.

/// A warped picture.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Warped {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Position of the picture's upper left corner in the result, in pixels: `[0, 0]` unless the canvas has grown.
    pub origin: [u32; 2],
    /// `width × height × 4` bytes of straight (not premultiplied) RGBA, in rows from top to bottom.
    pub rgba: Vec<u8>,
}

impl Warped {
    /// Removes empty rows and columns outside the picture's own rectangle, whose size is `(width, height)`.
    pub(super) fn trimmed(self, (width, height): (u32, u32)) -> Self {
        let [left, top] = self.origin;
        let pixel = |x: u32, y: u32| (y as usize * self.width as usize + x as usize) * 4;
        let empty = |x: u32, y: u32| self.rgba[pixel(x, y) + 3] == 0;
        let row = |&y: &u32| (0..self.width).all(|x| empty(x, y));
        let column = |&x: &u32| (0..self.height).all(|y| empty(x, y));
        let first_x = (0..left).take_while(column).count() as u32;
        let first_y = (0..top).take_while(row).count() as u32;
        let end_x = self.width - (left + width..self.width).rev().take_while(column).count() as u32;
        let end_y = self.height - (top + height..self.height).rev().take_while(row).count() as u32;
        if [first_x, first_y, end_x, end_y] == [0, 0, self.width, self.height] {
            return self;
        }
        let rows = (first_y..end_y).map(|y| &self.rgba[pixel(first_x, y)..pixel(end_x, y)]);
        Self {
            width: end_x - first_x,
            height: end_y - first_y,
            origin: [left - first_x, top - first_y],
            rgba: rows.collect::<Vec<_>>().concat(),
        }
    }
}
