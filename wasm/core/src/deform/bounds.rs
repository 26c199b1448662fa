//! Axis-aligned bounding boxes.

use glam::DVec2;

/// The smallest box around some points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The least coordinates.
    pub min: DVec2,
    /// The greatest coordinates.
    pub max: DVec2,
}

impl Bounds {
    /// The box of points, `None` if there are none. Coordinates that are NaN are ignored.
    pub(super) fn new(points: &[DVec2]) -> Option<Self> {
        let &first = points.first()?;
        // In place of `f64::min`, which is a function call in WebAssembly.
        let extend = |Self { mut min, mut max }: Self, p: &DVec2| {
            for axis in 0..2 {
                if p[axis] < min[axis] {
                    min[axis] = p[axis];
                }
                if p[axis] > max[axis] {
                    max[axis] = p[axis];
                }
            }
            Self { min, max }
        };
        Some(points.iter().fold(Self { min: first, max: first }, extend))
    }

    /// The box of two boxes.
    pub(super) fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }
}
