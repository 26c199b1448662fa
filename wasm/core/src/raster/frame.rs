//! The rectangle of the result, relative to the picture's own rectangle.

use std::ops::Range;

use super::extent::{Extent, check_size};
use super::facet::Facet;
use crate::error::Error;

/// Columns and rows of a frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Area {
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

impl Area {
    pub(super) const EMPTY: Self = Self { columns: 0..0, rows: 0..0 };

    pub(super) fn is_empty(&self) -> bool {
        self.columns.is_empty() || self.rows.is_empty()
    }

    pub(super) fn include(&mut self, columns: Range<usize>, row: usize) {
        if self.is_empty() {
            *self = Self { columns, rows: row..row + 1 };
            return;
        }
        self.columns = self.columns.start.min(columns.start)..self.columns.end.max(columns.end);
        self.rows = self.rows.start.min(row)..self.rows.end.max(row + 1);
    }
}

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    /// The picture's upper left corner, in pixels from the upper left corner of the frame.
    pub(super) origin: [i64; 2],
    /// Width and height in pixels.
    pub(super) size: [usize; 2],
}

impl Frame {
    /// The picture's own rectangle.
    pub(super) fn of_picture((width, height): (u32, u32)) -> Self {
        Self { origin: [0; 2], size: [width as usize, height as usize] }
    }

    /// A given frame.
    ///
    /// # Errors
    /// [`Error::Canvas`] if it exceeds the largest size of a picture, [`Error::NothingDrawn`] if it is empty.
    pub(super) fn of_extent(Extent { origin, width, height }: Extent) -> Result<Self, Error> {
        if width == 0 || height == 0 {
            return Err(Error::NothingDrawn);
        }
        check_size([width.into(), height.into()])?;
        Ok(Self { origin: origin.map(i64::from), size: [width as usize, height as usize] })
    }

    /// The rectangle of this frame.
    pub(super) fn extent(self) -> Extent {
        let [width, height] = self.size.map(|side| side as u32);
        Extent { origin: self.origin.map(|side| side as i32), width, height }
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
        let origin = least.map(|side| -side);
        let size = [0, 1].map(|axis| greatest[axis].abs_diff(least[axis]));
        check_size(size)?;
        Ok(Self { origin, size: size.map(|side| side as usize) })
    }

    /// The rectangle of an area of this frame.
    pub(super) fn of_area(self, Area { columns, rows }: &Area) -> Self {
        let [x, y] = self.origin;
        Self { origin: [x - columns.start as i64, y - rows.start as i64], size: [columns.len(), rows.len()] }
    }

    /// The area of this frame in which the picture's own rectangle of `size` lies.
    pub(super) fn area_of_picture(self, (width, height): (u32, u32)) -> Area {
        let [x, y] = self.origin.map(|side| side as usize);
        Area { columns: x..x + width as usize, rows: y..y + height as usize }
    }
}
