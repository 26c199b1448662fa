//! The triangles of the coarse samples' mesh that may contain the farthest points of a cell.
//!
//! A distance is 1-Lipschitz, so its values at the corners bound it in a triangle; where all corners have the same
//! pseudo-source, it is convex and greatest at a corner.
//!
//! Cost: the triangles along the border of the cell.

use super::{
    super::{Regions, Site, TIE},
    corner_paths::CornerPaths,
    piece::{cone_sag, lipschitz_bound},
};
use crate::{
    distance::PathEnd,
    min_max::{fast_max, fast_min},
    triangulation::NONE,
};

/// Initial capacity for triangles: enough for most searches.
const CAPACITY: usize = 64;

impl Regions<'_> {
    /// The triangles that may contain a point of the cell as far as its farthest `farthest_sample`, each with an upper bound,
    /// descending.
    ///
    /// A path to the site stays in its cell, so the triangles that the cell enters are connected. Of those with coarse samples of the
    /// cell only the ones are visited that may be far enough, or that lead to triangles without such coarse samples.
    pub(super) fn triangles_of(&mut self, site: usize, farthest_sample: f64) -> Vec<(u32, f64)> {
        let least = farthest_sample * (1.0 - TIE);
        let Self { coarse, cells, searched, .. } = self;
        searched.clear();
        let mut stack = Vec::with_capacity(CAPACITY);
        let home = self.home[site];
        searched.mark(home);
        stack.push(home);
        for at in cells.of(site) {
            let is_inner =
                || coarse.graph.neighbours(at).iter().all(|&other| cells.nearest[other as usize] == site as u32);
            if cells.distance[at] + coarse.reach[at] >= least || !is_inner() {
                stack.extend(coarse.fan(at).iter().filter(|&&t| searched.mark(t)));
            }
        }
        let mut found = Vec::with_capacity(CAPACITY);
        while let Some(t) = stack.pop() {
            let mesh = &self.coarse.mesh;
            let is_own = mesh.triangles[t as usize].map(|at| self.cells.nearest[at as usize] == site as u32);
            if !(is_own.contains(&true) || self.may_enter(site, t)) {
                continue;
            }
            for k in (0..3).filter(|&k| !is_own[k] && !is_own[(k + 1) % 3]) {
                let neighbour = mesh.neighbours[t as usize][k];
                if neighbour != NONE && self.searched.mark(neighbour) {
                    stack.push(neighbour);
                }
            }
            let upper_bound = self.upper_bound(t, least);
            if upper_bound >= least {
                found.push((t, upper_bound));
            }
        }
        found.sort_by(|(t, a), (u, b)| b.total_cmp(a).then(t.cmp(u)));
        found
    }

    /// Whether a site's cell may enter a triangle that has none of its coarse samples.
    fn may_enter(&self, site: usize, triangle: u32) -> bool {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.has(site);
        }
        let Self { coarse, sites, .. } = self;
        let Site { rest, field, .. } = &sites[site];
        let corners = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
        let points = corners.map(|at| coarse.mesh.vertices[at]);
        // A lower bound first: the straight line, which is also the path in most cases.
        let straight = points.map(|p| rest.distance(p));
        if !self.is_low(corners, straight, straight) {
            return false;
        }
        let nav_triangles = corners.map(|at| coarse.nav_triangles[at]);
        let [Some(a), Some(b), Some(c)] = CornerPaths::new(field, &points, &nav_triangles).0 else { return false };
        let paths = [a, b, c];
        let is_one_cone = paths.iter().all(|path| path.pseudo_source == a.pseudo_source);
        let to_apex = |path: PathEnd| if is_one_cone { path.distance - path.offset } else { 0.0 };
        self.is_low(corners, paths.map(|path| path.distance), paths.map(to_apex))
    }

    /// Whether a cone may be the lowest one somewhere in a triangle, from its values at the corners and the distances of
    /// these to its apex.
    fn is_low(&self, corners: [usize; 3], values: [f64; 3], to_apex: [f64; 3]) -> bool {
        let longest = corners.iter().map(|&at| self.coarse.reach[at]).fold(0.0, f64::max);
        let mut over = (0..3).map(|k| values[k] - self.cells.distance[corners[k]]);
        let apart = to_apex.into_iter().fold(f64::INFINITY, fast_min);
        over.clone().all(|over| over <= 2.0 * longest)
            && (!self.is_of_one_cone(corners) || over.any(|over| over <= cone_sag(longest, apart)))
    }

    /// An upper bound for the distance of a triangle's points to their nearest site; refined only if it is at least `least`.
    fn upper_bound(&self, triangle: u32, least: f64) -> f64 {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.upper_bound;
        }
        let Self { coarse, cells, .. } = self;
        let corners = coarse.mesh.triangles[triangle as usize].map(|v| v as usize);
        let distances = corners.map(|at| cells.distance[at]);
        let reach = corners.map(|at| coarse.reach[at]);
        let upper_bound = (0..3).map(|k| distances[k] + reach[k]).fold(f64::INFINITY, fast_min);
        if upper_bound < least {
            return upper_bound;
        }
        // A cone is convex, so it is greatest at a corner.
        let better = if self.is_of_one_cone(corners) {
            distances.into_iter().fold(0.0, fast_max)
        } else {
            lipschitz_bound(&distances, reach.into_iter().fold(0.0, fast_max))
        };
        fast_min(better, upper_bound)
    }

    /// Whether three coarse samples have the same nearest site and the same pseudo-source.
    fn is_of_one_cone(&self, corners: [usize; 3]) -> bool {
        let [a, b, c] = corners.map(|at| (self.cells.nearest[at], self.cells.pseudo_source[at]));
        a == b && b == c
    }
}
