//! The rounds of Algorithm 1, as they can be replayed (section IV-A, figure 3).
//!
//! Cost: for each point of a round, a visit of every site and one path, far less than its insertion. Memory: a round
//! inserts at least one site, so the limit of sites bounds it.

use glam::DVec2;

/// The state of Algorithm 1 before a round, and the points that the round inserts. The last round has no points.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Round {
    /// The score δ / r_d of the worst cell. Here δ is r_d minus the greatest allowed radius of the cell, instead of r_d
    /// − r_h.
    pub score: f64,
    /// The number of sites before the round. The sites that it inserts follow them.
    pub sites: usize,
    /// The farthest points of the worst cells.
    pub points: Vec<RoundPoint>,
}

/// A point where a round divides a cell.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct RoundPoint {
    /// The point, in image pixels.
    #[cfg_attr(feature = "schema", schemars(with = "(f64, f64)"))]
    pub at: DVec2,
    /// The site whose cell it divides.
    pub owner: usize,
    /// Its distance from the owner, in pixels: the radius r_d of the cell if it is the farthest point.
    pub distance: f64,
    /// The greatest allowed radius of the cell, in pixels.
    pub limit: f64,
    /// The vertices of the shortest path from the owner to the point.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<(f64, f64)>"))]
    pub path: Vec<DVec2>,
}
