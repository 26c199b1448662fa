//! The farthest points of cells, where Algorithm 1 inserts its sites (section IV-A).
//!
//! They are those of the cell itself, not of the scouts in it, and are looked for only in cells that may be the worst, in three steps:
//!
//! - `triangles`: which triangles of the scouts' mesh may contain them;
//! - `search`: the best of these first, subdivided into [`pieces`] by branch and bound, each a [`piece`] with an upper bound from the
//!   paths to its corners (`corner_paths`);
//! - `ascent`: in a piece that is small enough, up the cones of the distance to where they meet.

mod ascent;
mod corner_paths;
mod piece;
mod pieces;
mod search;
mod triangles;

use glam::DVec2;

use super::{Regions, Site};
use crate::{distance::OutlineTriangle, extremes::greater};

pub(crate) use pieces::Pieces;

/// Points no farther apart than this share of their distance are one point found twice.
pub(super) const SAME_POINT: f64 = 1e-8;

/// A point of the domain, its triangle of the outline, and the distance to the nearest site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FarPoint {
    pub(super) at: DVec2,
    pub(super) triangle: OutlineTriangle,
    pub(super) distance: f64,
}

/// State of the search for a cell's farthest points.
pub(super) enum Far {
    /// No farther than this.
    Within(f64),
    /// No farther than `scout`, the farthest scout when this was found, or in one of `triangles`, each with an upper bound,
    /// descending.
    InTriangles { scout: f64, triangles: Vec<(u32, f64)> },
    /// These, all at the same distance from the site: at least one.
    Known(Vec<FarPoint>),
}

impl Regions<'_> {
    /// Takes the search for a cell's farthest points one step further: first the triangles that may contain them, then the
    /// points.
    pub(super) fn refine_farthest(&mut self, site: usize) {
        let radius = self.sampled_radius(site);
        self.far[site] = match std::mem::replace(&mut self.far[site], Far::Within(f64::INFINITY)) {
            // If the cell has lost its farthest scout since, the points may be in other triangles.
            Far::InTriangles { scout, triangles } if scout <= radius => {
                Far::Known(self.farthest_points(site, &triangles))
            }
            Far::Within(_) | Far::InTriangles { .. } => {
                Far::InTriangles { scout: radius, triangles: self.triangles_of(site, radius) }
            }
            known @ Far::Known(_) => known,
        }
    }

    /// The farthest points of a site's cell, including ties, if known already.
    pub(super) fn known_farthest(&self, site: usize) -> Option<&[FarPoint]> {
        match &self.far[site] {
            Far::Known(points) => Some(points),
            Far::Within(_) | Far::InTriangles { .. } => None,
        }
    }

    /// Upper bound of the cell radius.
    pub(super) fn greatest_radius(&self, site: usize) -> f64 {
        match &self.far[site] {
            Far::Within(radius) => *radius,
            Far::InTriangles { scout, triangles } => {
                triangles.first().map_or(*scout, |&(_, upper_bound)| greater(upper_bound, *scout))
            }
            Far::Known(points) => points[0].distance,
        }
    }

    /// Drops the farthest points that the last site has taken over.
    ///
    /// Cells only shrink: a farthest point that stays in its cell stays the farthest, and any later one is no farther.
    pub(super) fn keep_far_points(&mut self) {
        let Some(Site { rest, field, .. }) = self.sites.last() else { return };
        let kept = |point: &FarPoint| {
            rest.distance(point.at) >= point.distance || field.distance(point.triangle, point.at) >= point.distance
        };
        for far in &mut self.far {
            if let Far::Known(points) = far {
                let radius = points[0].distance;
                points.retain(kept);
                if points.is_empty() {
                    *far = Far::Within(radius);
                }
            }
        }
    }
}
