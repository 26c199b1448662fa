//! The line of a bar or polygon at rest, and its parts outside the domain (section V-D).

use glam::DVec2;

/// The corners of a bar or polygon, with a straight segment from each to the next.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polyline {
    /// Index of the handle in the project.
    pub(crate) handle: u32,
    /// Id of the handle.
    pub(crate) id: String,
    pub(crate) corners: Vec<DVec2>,
    /// Whether a segment leads from the last corner to the first: a polygon.
    pub(crate) closed: bool,
}

impl Polyline {
    /// All coordinates in order, y before x.
    pub(super) fn coordinates(&self) -> impl Iterator<Item = f64> + '_ {
        self.corners.iter().flat_map(|corner| [corner.y, corner.x])
    }

    /// Number of segments.
    pub(crate) fn segments(&self) -> usize {
        if self.closed { self.corners.len() } else { self.corners.len() - 1 }
    }

    /// The ends of a segment.
    pub(crate) fn segment(&self, at: usize) -> (DVec2, DVec2) {
        (self.corners[at], self.corners[(at + 1) % self.corners.len()])
    }
}

/// A part of a bar or polygon that lies outside the domain, or on its held boundary. It moves nothing.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct OutsidePart {
    /// Id of the handle.
    pub handle: String,
    /// Start of the part at rest, in image pixels.
    #[cfg_attr(feature = "schema", schemars(with = "(f64, f64)"))]
    pub from: DVec2,
    /// End of the part at rest, in image pixels.
    #[cfg_attr(feature = "schema", schemars(with = "(f64, f64)"))]
    pub to: DVec2,
}
