//! The farthest points of cells, where Algorithm 1 inserts its sites (section IV-A).
//!
//! They are the farthest points of the cell itself, not of its coarse samples. Only cells that may be the worst are
//! searched, in three steps:
//!
//! - `candidates`: the triangles of the coarse mesh that may contain them.
//! - `search`: branch and bound, starting with the best of these. It subdivides triangles into [`pieces`]; each
//!   [`piece`] has an upper bound from the paths to its corners (`corner_paths`, `bounds`).
//! - `maxima`: in a piece that is small enough, an ascent of the distance (`ascent`, `linear_program`).
//!
//! Cost: about a third of an insertion, for the cells that it changes.

mod ascent;
mod bounds;
mod candidates;
mod corner_paths;
mod linear_program;
mod maxima;
mod piece;
mod pieces;
mod search;

use glam::DVec2;

use self::{
    candidates::{Candidate, CandidateTriangles},
    pieces::Pieces,
    search::farthest_points,
};
use super::voronoi::Voronoi;
use crate::{distance::NavTriangle, min_max::fast_max};

/// Farthest points closer than this, relative to their distance, are the same point found twice.
pub(super) const SAME_POINT: f64 = 1e-8;

/// A point of the domain with its distance to the nearest site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FarPoint {
    pub(super) at: DVec2,
    /// The triangle of the navigation mesh that contains it.
    pub(super) triangle: NavTriangle,
    /// Distance to the nearest site, in pixels.
    pub(super) distance: f64,
}

/// State of the search for a cell's farthest points.
enum SearchState {
    /// No point of the cell is farther than this.
    Within(f64),
    /// Every point farther than `sample` lies in one of `triangles`, sorted by descending upper bound. `sample` was the
    /// maximum distance of a coarse sample of the cell.
    InTriangles { sample: f64, triangles: Vec<Candidate> },
    /// At least one point; all are equally far from the site.
    Known(Vec<FarPoint>),
}

/// The farthest points of each cell, as far as they are known.
pub(super) struct FarthestPoints {
    /// Sites: the state of each cell's search.
    states: Vec<SearchState>,
    pieces: Pieces,
    candidates: CandidateTriangles,
}

impl FarthestPoints {
    /// No cells yet, over a coarse mesh of `triangles` triangles.
    pub(super) fn new(triangles: usize) -> Self {
        Self { states: Vec::new(), pieces: Pieces::new(triangles), candidates: CandidateTriangles::new(triangles) }
    }

    /// Adds the cell of the last site inserted. `coarse_triangle` contains the site, and `bound` is an upper bound of
    /// the cell radius.
    pub(super) fn insert(&mut self, voronoi: &Voronoi, coarse_triangle: usize, bound: f64) {
        self.pieces.insert(voronoi);
        self.drop_points_of_last_site(voronoi);
        self.states.push(SearchState::Within(bound));
        self.candidates.insert(coarse_triangle);
    }

    /// Advances the search for a cell's farthest points by one step: first to candidate triangles, then to the points.
    pub(super) fn refine(&mut self, voronoi: &Voronoi, site: usize) {
        let radius = voronoi.cells.sampled_radius(site);
        let unknown = SearchState::Within(f64::INFINITY);
        self.states[site] = match std::mem::replace(&mut self.states[site], unknown) {
            // If the cell has since lost its farthest sample, the points may be in other triangles.
            SearchState::InTriangles { sample, triangles } if sample <= radius => {
                SearchState::Known(farthest_points(voronoi, &mut self.pieces, site, &triangles))
            }
            SearchState::Within(_) | SearchState::InTriangles { .. } => {
                let triangles = self.candidates.find(voronoi, &self.pieces, site, radius);
                SearchState::InTriangles { sample: radius, triangles }
            }
            known @ SearchState::Known(_) => known,
        }
    }

    /// The steps of all searches so far.
    pub(super) fn steps(&self) -> u64 {
        self.pieces.steps()
    }

    /// Whether the search has reached its limit of memory or steps. Later points may be too near.
    pub(super) fn is_full(&self) -> bool {
        self.pieces.are_full()
    }

    /// The farthest points of a cell with all ties, if they are known.
    pub(super) fn known(&self, site: usize) -> Option<&[FarPoint]> {
        match &self.states[site] {
            SearchState::Known(points) => Some(points),
            SearchState::Within(_) | SearchState::InTriangles { .. } => None,
        }
    }

    /// A farthest point of a cell. Its distance is the cell radius r_d.
    pub(super) fn first(&mut self, voronoi: &Voronoi, site: usize) -> FarPoint {
        loop {
            if let Some(&[point, ..]) = self.known(site) {
                return point;
            }
            self.refine(voronoi, site);
        }
    }

    /// Upper bound of the cell radius.
    pub(super) fn radius_bound(&self, site: usize) -> f64 {
        match &self.states[site] {
            SearchState::Within(radius) => *radius,
            SearchState::InTriangles { sample, triangles } => {
                triangles.first().map_or(*sample, |candidate| fast_max(candidate.upper_bound, *sample))
            }
            SearchState::Known(points) => points[0].distance,
        }
    }

    /// Drops the farthest points that the last site has taken over.
    ///
    /// Cells only shrink. A farthest point that remains in its cell remains the farthest, and no later one is farther.
    fn drop_points_of_last_site(&mut self, voronoi: &Voronoi) {
        let (Some(site), Some(field)) = (voronoi.sites.last(), voronoi.fields.last()) else { return };
        let stays = |point: &FarPoint| {
            site.rest.distance(point.at) >= point.distance || field.distance(point.triangle, point.at) >= point.distance
        };
        for state in &mut self.states {
            if let SearchState::Known(points) = state {
                let radius = points[0].distance;
                points.retain(stays);
                if points.is_empty() {
                    *state = SearchState::Within(radius);
                }
            }
        }
    }
}
