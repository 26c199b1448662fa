//! The rectangle of the result, relative to the picture's own rectangle.

use super::facet::Facet;
use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE},
};

/// A rectangle of pixels around the picture's own rectangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    /// The picture's upper left corner, in pixels from the upper left corner of the frame.
    pub(super) origin: [usize; 2],
    /// Width and height in pixels.
    pub(super) size: [usize; 2],
}

impl Frame {
    /// The picture's own rectangle.
    pub(super) fn of_picture((width, height): (u32, u32)) -> Self {
        Self { origin: [0; 2], size: [width as usize, height as usize] }
    }

    /// The smallest frame around this one and `facets`, which are relative to the picture's rectangle.
    ///
    /// # Errors
    /// [`Error::Canvas`] if the frame would exceed the largest size of a picture.
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
