//! The line of a bar or polygon at rest, and what of it the domain has no room for.

use glam::DVec2;
use serde::Serialize;

/// A chain of corners, closed for a polygon.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Line {
    /// Index of the handle.
    pub(crate) handle: u32,
    pub(crate) id: String,
    pub(crate) corners: Vec<DVec2>,
    pub(crate) closed: bool,
}

impl Line {
    pub(super) fn coordinates(&self) -> impl Iterator<Item = f64> + '_ {
        self.corners.iter().flat_map(|corner| [corner.y, corner.x])
    }

    /// Number of segments between corners.
    pub(crate) fn segments(&self) -> usize {
        if self.closed { self.corners.len() } else { self.corners.len() - 1 }
    }

    /// The ends of a segment.
    pub(crate) fn segment(&self, at: usize) -> (DVec2, DVec2) {
        (self.corners[at], self.corners[(at + 1) % self.corners.len()])
    }
}

/// A part of a bar or polygon that lies outside the domain, or on its held boundary: it moves nothing.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Outside {
    /// Id of the handle.
    pub handle: String,
    /// Where the part begins, at rest, in image pixels.
    pub from: DVec2,
    /// Where it ends.
    pub to: DVec2,
}
