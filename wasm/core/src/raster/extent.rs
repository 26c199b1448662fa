//! The rectangle of a result, relative to that of the picture.

use crate::{
    error::Error,
    limits::{MAX_PIXELS, MAX_SIDE},
};

/// A rectangle of pixels, relative to the picture's own.
///
/// ```
/// use c2warp::Extent;
///
/// let [left, right] = [[5, 0], [0, 3]].map(|origin| Extent { origin, width: 30, height: 20 });
/// assert_eq!(left.union(right)?, Extent { origin: [5, 3], width: 35, height: 23 });
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// The position of the picture's upper left corner in this rectangle.
    pub origin: [i32; 2],
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
}

impl Extent {
    /// The smallest rectangle around two rectangles, such as those of two frames of a film.
    ///
    /// # Errors
    /// [`Error::Canvas`] if it is larger than a picture may be.
    pub fn union(self, other: Self) -> Result<Self, Error> {
        let sides = |extent: Self| [extent.width, extent.height];
        let (mut origin, mut size) = ([0; 2], [0; 2]);
        for axis in 0..2 {
            let end = |extent: Self| i64::from(sides(extent)[axis]) - i64::from(extent.origin[axis]);
            origin[axis] = self.origin[axis].max(other.origin[axis]);
            size[axis] = end(self).max(end(other)).abs_diff(-i64::from(origin[axis]));
        }
        check_size(size)?;
        let [width, height] = size.map(|side| side as u32);
        Ok(Self { origin, width, height })
    }
}

/// # Errors
/// [`Error::Canvas`] for a size beyond the largest one of a picture.
pub(super) fn check_size([width, height]: [u64; 2]) -> Result<(), Error> {
    let is_supported = width.max(height) <= u64::from(MAX_SIDE) && width * height <= MAX_PIXELS;
    if is_supported { Ok(()) } else { Err(Error::Canvas { width, height }) }
}

#[cfg(test)]
mod tests {
    use super::Extent;
    use crate::error::Error;

    #[test]
    fn union_holds_both() {
        let inner = Extent { origin: [2, 3], width: 10, height: 12 };
        let outer = Extent { origin: [4, 4], width: 20, height: 20 };
        assert_eq!(inner.union(outer), Ok(outer));
        assert_eq!(outer.union(inner), Ok(outer));
        assert_eq!(inner.union(inner), Ok(inner));
        // The picture may lie outside of a rectangle.
        let apart = Extent { origin: [-30, 0], width: 10, height: 5 };
        assert_eq!(inner.union(apart), Ok(Extent { origin: [2, 3], width: 42, height: 12 }));
    }

    #[test]
    fn union_beyond_the_largest_picture_is_refused() {
        let at = |x: i32| Extent { origin: [x, 0], width: 100, height: 100 };
        assert_eq!(at(0).union(at(20_000)), Err(Error::Canvas { width: 20_100, height: 100 }));
    }
}
