//! The rectangle that a warped picture shows.

use super::Warped;
use super::facet::Facet;
use crate::error::Error;
use crate::picture::{MAX_PIXELS, MAX_SIDE};

/// How much of a warped picture is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Canvas {
    /// The picture's own rectangle; what is bent beyond it is cut off.
    #[default]
    Picture,
    /// The picture's own rectangle, grown on every side to where nothing more is drawn.
    Grown,
}

/// The result in drawing: pixels around the picture's own rectangle, and in all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    /// Of the picture's upper left corner, in the result.
    pub(super) origin: [usize; 2],
    pub(super) size: [usize; 2],
}

impl Frame {
    /// The picture's own rectangle.
    pub(super) fn of_picture((width, height): (u32, u32)) -> Self {
        Self { origin: [0; 2], size: [width as usize, height as usize] }
    }

    /// Grown to hold triangles whose corners are relative to the picture's rectangle.
    ///
    /// # Errors
    /// [`Error::Canvas`].
    pub(super) fn around(self, facets: &[Facet]) -> Result<Self, Error> {
        let (mut least, mut greatest) = ([0; 2], self.size.map(|side| side as i64));
        for facet in facets {
            let (from, to) = facet.bounds();
            for axis in 0..2 {
                least[axis] = least[axis].min(from[axis]);
                greatest[axis] = greatest[axis].max(to[axis]);
            }
        }
        let origin = least.map(|side| side.unsigned_abs() as usize);
        let size = [0, 1].map(|axis| greatest[axis].abs_diff(least[axis]));
        if size.into_iter().any(|side| side > u64::from(MAX_SIDE)) || size[0] * size[1] > MAX_PIXELS {
            return Err(Error::Canvas { width: size[0], height: size[1] });
        }
        Ok(Self { origin, size: size.map(|side| side as usize) })
    }
}

/// Takes away the rows and columns around a picture's rectangle, which is of this size, in which nothing is drawn.
pub(super) fn trimmed(warped: Warped, (width, height): (u32, u32)) -> Warped {
    let [left, top] = warped.origin;
    let pixel = |x: u32, y: u32| (y as usize * warped.width as usize + x as usize) * 4;
    let empty = |x: u32, y: u32| warped.rgba[pixel(x, y) + 3] == 0;
    let row = |&y: &u32| (0..warped.width).all(|x| empty(x, y));
    let column = |&x: &u32| (0..warped.height).all(|y| empty(x, y));
    let first_x = (0..left).take_while(column).count() as u32;
    let first_y = (0..top).take_while(row).count() as u32;
    let end_x = warped.width - (left + width..warped.width).rev().take_while(column).count() as u32;
    let end_y = warped.height - (top + height..warped.height).rev().take_while(row).count() as u32;
    if [first_x, first_y, end_x, end_y] == [0, 0, warped.width, warped.height] {
        return warped;
    }
    let rows = (first_y..end_y).map(|y| &warped.rgba[pixel(first_x, y)..pixel(end_x, y)]);
    Warped {
        width: end_x - first_x,
        height: end_y - first_y,
        origin: [left - first_x, top - first_y],
        rgba: rows.collect::<Vec<_>>().concat(),
    }
}
