//! The farthest points of cells, where Algorithm 1 inserts its sites (section IV-A).
//!
//! They are those of the cell itself, not of the coarse samples in it, and are looked for only in cells that may be the worst, in three steps:
//!
//! - `triangles`: which triangles of the coarse samples' mesh may contain them;
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
use crate::{distance::NavTriangle, min_max::fast_max};

pub(crate) use pieces::Pieces;

/// Points no farther apart than this share of their distance are one point found twice.
pub(super) const SAME_POINT: f64 = 1e-8;

/// A point of the domain, its triangle of the outline, and the distance to the nearest site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FarPoint {
    pub(super) at: DVec2,
    pub(super) triangle: NavTriangle,
    pub(super) distance: f64,
}

/// State of the search for a cell's farthest points.
pub(super) enum Far {
    /// No farther than this.
    Within(f64),
    /// No farther than `farthest_sample`, the farthest coarse sample when this was found, or in one of `triangles`, each with an upper bound,
    /// descending.
    InTriangles { farthest_sample: f64, triangles: Vec<(u32, f64)> },
    /// These, all at the same distance from the site: at least one.
    Known(Vec<FarPoint>),
}

impl Regions<'_> {
    /// Takes the search for a cell's farthest points one step further: first the triangles that may contain them, then the
    /// points.
    pub(super) fn refine_farthest(&mut self, site: usize) {
        let radius = self.sampled_radius(site);
        self.far[site] = match std::mem::replace(&mut self.far[site], Far::Within(f64::INFINITY)) {
            // If the cell has lost its farthest coarse sample since, the points may be in other triangles.
            Far::InTriangles { farthest_sample, triangles } if farthest_sample <= radius => {
                Far::Known(self.farthest_points(site, &triangles))
            }
            Far::Within(_) | Far::InTriangles { .. } => {
                Far::InTriangles { farthest_sample: radius, triangles: self.triangles_of(site, radius) }
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
            Far::InTriangles { farthest_sample, triangles } => {
                triangles.first().map_or(*farthest_sample, |&(_, upper_bound)| fast_max(upper_bound, *farthest_sample))
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
