//! The points of a table of weights.

use c2warp::glam::DVec2;

/// Points of a picture, in image pixels.
#[derive(Debug, Clone, PartialEq)]
pub enum Places {
    /// Any points.
    Points(Vec<DVec2>),
    /// The centres of every `every`-th pixel in both directions, beginning with the first, row by row.
    Grid {
        /// Pixels from one point to the next.
        every: u32,
        /// Points in a row.
        columns: u32,
        /// Rows of points.
        rows: u32,
    },
}

impl Places {
    /// A grid over a picture of a size in pixels. A distance of 0 counts as 1.
    #[must_use]
    pub fn grid([width, height]: [u32; 2], every: u32) -> Self {
        let every = every.max(1);
        Self::Grid { every, columns: width.div_ceil(every), rows: height.div_ceil(every) }
    }

    /// The number of points, or the rows and columns of the grid.
    #[must_use]
    pub fn shape(&self) -> Vec<usize> {
        match self {
            Self::Points(points) => vec![points.len()],
            &Self::Grid { columns, rows, .. } => vec![rows as usize, columns as usize],
        }
    }

    /// The number of points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.shape().iter().product()
    }

    /// A point. Grid points are numbered row by row.
    pub(crate) fn at(&self, index: usize) -> DVec2 {
        match self {
            Self::Points(points) => points[index],
            &Self::Grid { every, columns, .. } => {
                let pixel = |place: usize| (place * every as usize) as f64 + 0.5;
                DVec2::new(pixel(index % columns as usize), pixel(index / columns as usize))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_has_the_centres_of_every_nth_pixel() {
        let grid = Places::grid([5, 4], 3);
        assert_eq!((grid.shape(), grid.count()), (vec![2, 2], 4));
        let points: Vec<_> = (0..4).map(|i| grid.at(i).to_array()).collect();
        assert_eq!(points, [[0.5, 0.5], [3.5, 0.5], [0.5, 3.5], [3.5, 3.5]]);
        assert_eq!(Places::grid([5, 4], 0).count(), 20);
    }
}
