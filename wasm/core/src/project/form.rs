//! The kind of a handle and its number of corners, which a pose must match.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Shape;

/// The kind of a handle and its number of corners, without their places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Form {
    /// A point.
    Point,
    /// A bar.
    Bar {
        /// Two or more.
        corners: usize,
    },
    /// A polygon.
    Polygon {
        /// Three or more.
        corners: usize,
    },
}

impl Form {
    /// The forms of a handle at rest and posed. They are equal for a handle read from a project.
    pub(crate) fn of(shape: &Shape) -> [Self; 2] {
        match shape {
            Shape::Point { .. } => [Self::Point; 2],
            Shape::Bar { rest, posed } => [rest, posed].map(|places| Self::Bar { corners: places.len() }),
            Shape::Polygon { rest, posed } => [rest, posed].map(|places| Self::Polygon { corners: places.len() }),
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point => f.write_str("a point"),
            Self::Bar { corners } => write!(f, "a bar of {corners} corners"),
            Self::Polygon { corners } => write!(f, "a polygon of {corners} corners"),
        }
    }
}
