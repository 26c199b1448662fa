//! The triangles of the coarse mesh that may contain the farthest points of a cell.
//!
//! A distance is 1-Lipschitz, so its values at the corners bound it in a triangle. If all corners have the same
//! pseudo-source, it is convex, so a corner is the farthest point.
//!
//! Cost: the triangles along the border of the cell.

use super::{
    super::{TIE, cells::Cells, visit_stamps::VisitStamps, voronoi::Voronoi},
    bounds::{cone_sag, lipschitz_bound},
    corner_paths::CornerPaths,
    pieces::Pieces,
};
use crate::{
    distance::PathEnd,
    min_max::{fast_max, fast_min},
    rank::{descending, sort_by_rank},
    triangulation::NONE,
};

/// Initial capacity for triangles: enough for most searches.
const CAPACITY: usize = 64;

/// A triangle that may contain a farthest point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    /// Index of the triangle in the coarse mesh.
    pub(super) triangle: u32,
    /// Upper bound for the distance of its points to their nearest site.
    pub(super) upper_bound: f64,
}

/// Finds candidate triangles.
pub(super) struct CandidateTriangles {
    /// For each site, the triangle of the coarse mesh that contains it.
    home: Vec<u32>,
    /// The triangles that the current search has visited.
    visited: VisitStamps,
}

impl CandidateTriangles {
    pub(super) fn new(triangles: usize) -> Self {
        Self { home: Vec::new(), visited: VisitStamps::new(triangles) }
    }

    /// Adds the next site, in a triangle of the coarse mesh.
    pub(super) fn insert(&mut self, home: usize) {
        self.home.push(home as u32);
    }

    /// The triangles that may contain a point of a cell at least as far as its farthest coarse sample, at distance
    /// `sample`. Sorted by descending upper bound.
    ///
    /// The path from a site to a point of its cell stays in the cell, so the triangles that a cell enters are
    /// connected. Triangles with samples of the cell are skipped if they are not far enough and do not lead to
    /// triangles without such samples.
    pub(super) fn find(&mut self, voronoi: &Voronoi, pieces: &Pieces, site: usize, sample: f64) -> Vec<Candidate> {
        let least = sample * (1.0 - TIE);
        let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
        self.visited.clear();
        let mut stack = Vec::with_capacity(CAPACITY);
        let home = self.home[site];
        self.visited.mark(home);
        stack.push(home);
        for at in cells.of(site) {
            let is_inner =
                || coarse.graph.neighbours(at).iter().all(|&other| cells.nearest[other as usize] == site as u32);
            if cells.distance[at] + coarse.reach[at] >= least || !is_inner() {
                stack.extend(coarse.fan(at).iter().filter(|&&t| self.visited.mark(t)));
            }
        }
        let mut found = Vec::with_capacity(CAPACITY);
        while let Some(triangle) = stack.pop() {
            let is_own = coarse.mesh.triangles[triangle as usize].map(|at| cells.nearest[at as usize] == site as u32);
            if !(is_own.contains(&true) || may_enter(voronoi, pieces, site, triangle)) {
                continue;
            }
            for k in (0..3).filter(|&k| !is_own[k] && !is_own[(k + 1) % 3]) {
                let neighbour = coarse.mesh.neighbours[triangle as usize][k];
                if neighbour != NONE && self.visited.mark(neighbour) {
                    stack.push(neighbour);
                }
            }
            let upper_bound = upper_bound(voronoi, pieces, triangle, least);
            if upper_bound >= least {
                found.push(Candidate { triangle, upper_bound });
            }
        }
        sort_by_rank(&mut found, |one| [descending(one.upper_bound), one.triangle.into()]);
        found
    }
}

/// Whether a site's cell may enter a triangle that has none of its samples.
fn may_enter(voronoi: &Voronoi, pieces: &Pieces, site: usize, triangle: u32) -> bool {
    if let Some(piece) = pieces.of_triangle(triangle) {
        return piece.has(site);
    }
    let (coarse, rest) = (voronoi.coarse, voronoi.sites[site].rest);
    let corners = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
    let points = corners.map(|at| coarse.mesh.vertices[at]);
    // A lower bound first: the straight line, which is also the path in most cases.
    let straight = points.map(|p| rest.distance(p));
    if !may_be_lowest(voronoi, corners, straight, straight) {
        return false;
    }
    let nav_triangles = corners.map(|at| coarse.nav_triangles[at]);
    let paths = CornerPaths::new(&voronoi.fields[site].distances, &points, &nav_triangles);
    let [Some(a), Some(b), Some(c)] = paths.0 else { return false };
    let paths = [a, b, c];
    let is_one_cone = paths.iter().all(|path| path.pseudo_source == a.pseudo_source);
    let to_apex = |path: PathEnd| if is_one_cone { path.distance - path.offset } else { 0.0 };
    may_be_lowest(voronoi, corners, paths.map(|path| path.distance), paths.map(to_apex))
}

/// Whether a cone may be the lowest one somewhere in a triangle. `values` are its values at the corners, and `to_apex`
/// the distances of the corners to its apex.
fn may_be_lowest(voronoi: &Voronoi, corners: [usize; 3], values: [f64; 3], to_apex: [f64; 3]) -> bool {
    let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
    let longest = corners.iter().map(|&at| coarse.reach[at]).fold(0.0, f64::max);
    let mut over = (0..3).map(|k| values[k] - cells.distance[corners[k]]);
    let apart = to_apex.into_iter().fold(f64::INFINITY, fast_min);
    over.clone().all(|over| over <= 2.0 * longest)
        && (!have_one_cone(cells, corners) || over.any(|over| over <= cone_sag(longest, apart)))
}

/// An upper bound for the distance of a triangle's points to their nearest site. Refined only if it is at least
/// `least`.
fn upper_bound(voronoi: &Voronoi, pieces: &Pieces, triangle: u32, least: f64) -> f64 {
    if let Some(piece) = pieces.of_triangle(triangle) {
        return piece.upper_bound;
    }
    let (coarse, cells) = (voronoi.coarse, &voronoi.cells);
    let corners = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
    let distances = corners.map(|at| cells.distance[at]);
    let reach = corners.map(|at| coarse.reach[at]);
    let upper_bound = (0..3).map(|k| distances[k] + reach[k]).fold(f64::INFINITY, fast_min);
    if upper_bound < least {
        return upper_bound;
    }
    // A cone is convex, so it is greatest at a corner.
    let better = if have_one_cone(cells, corners) {
        distances.into_iter().fold(0.0, fast_max)
    } else {
        lipschitz_bound(&distances, reach.into_iter().fold(0.0, fast_max))
    };
    fast_min(better, upper_bound)
}

/// Whether three samples have the same nearest site and the same pseudo-source.
fn have_one_cone(cells: &Cells, samples: [usize; 3]) -> bool {
    let [a, b, c] = samples.map(|at| (cells.nearest[at], cells.pseudo_source[at]));
    a == b && b == c
}
