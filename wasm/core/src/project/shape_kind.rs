//! The kind of a handle and its number of corners. A pose must match both.

use std::fmt;

use super::shape::Shape;

/// The kind of a handle and its number of corners, without their positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum ShapeKind {
    /// A point.
    Point,
    /// A bar.
    Bar {
        /// Number of corners: two or more.
        corners: usize,
    },
    /// A polygon.
    Polygon {
        /// Number of corners: three or more.
        corners: usize,
    },
}

impl ShapeKind {
    /// The kinds of a handle at rest and posed. They are equal for a handle read from a project.
    pub(crate) fn of(shape: &Shape) -> [Self; 2] {
        match shape {
            Shape::Point { .. } => [Self::Point; 2],
            Shape::Bar { rest, posed } => [rest, posed].map(|points| Self::Bar { corners: points.len() }),
            Shape::Polygon { rest, posed } => [rest, posed].map(|points| Self::Polygon { corners: points.len() }),
        }
    }
}

impl fmt::Display for ShapeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point => f.write_str("a point"),
            Self::Bar { corners } => write!(f, "a bar of {corners} corners"),
            Self::Polygon { corners } => write!(f, "a polygon of {corners} corners"),
        }
    }
}
