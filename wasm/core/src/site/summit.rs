//! The farthest points of a cell: the triangles of the scouts' mesh that may contain them, then a best-first search over
//! [pieces](super::piece) of these.
//!
//! A distance is 1-Lipschitz, so its values at the corners bound it in a triangle; where all corners have the same
//! pseudo-source, it is convex and greatest at a corner. So a search looks into a few triangles only, and finds the farthest
//! point however few scouts there are.
//!
//! Cost: the triangles along the border of the cell, and the pieces that the search opens.

use super::{
    Site,
    piece::{Pieces, cone_sag, path_ends},
    regions::{Far, FarPoint, Regions},
    virtual_sites::{SAME_POINT, TIE},
};
use crate::{distance::PathEnd, triangulation::NONE};

/// Initial capacity for triangles: enough for most searches.
const CAPACITY: usize = 64;

impl Regions<'_> {
    /// Takes the search for a cell's farthest points one step further: first the triangles that may contain them, then the
    /// points.
    pub(crate) fn refine_farthest(&mut self, site: usize) {
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

    /// The triangles that may contain a point of the cell as far as its farthest `scout`, each with an upper bound,
    /// descending.
    ///
    /// A path to the site stays in its cell, so the triangles that the cell enters are connected. Of those with scouts of the
    /// cell only the ones are visited that may be far enough, or that lead to triangles without such scouts.
    fn triangles_of(&mut self, site: usize, scout: f64) -> Vec<(u32, f64)> {
        let least = scout * (1.0 - TIE);
        let Self { scouts, cells, searched, .. } = self;
        searched.clear();
        let mut stack = Vec::with_capacity(CAPACITY);
        let home = self.home[site];
        searched.mark(home);
        stack.push(home);
        for at in cells.of(site) {
            let is_inner = || scouts.graph.of(at).iter().all(|&other| cells.nearest[other as usize] == site as u32);
            if cells.distance[at] + scouts.reach[at] >= least || !is_inner() {
                stack.extend(scouts.fan(at).iter().filter(|&&t| searched.mark(t)));
            }
        }
        let mut found = Vec::with_capacity(CAPACITY);
        while let Some(t) = stack.pop() {
            let mesh = &self.scouts.mesh;
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

    /// Whether a site's cell may enter a triangle that has none of its scouts.
    fn may_enter(&self, site: usize, triangle: u32) -> bool {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.has(site);
        }
        let Self { scouts, sites, .. } = self;
        let Site { rest, field, .. } = &sites[site];
        let corners = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let points = corners.map(|at| scouts.mesh.vertices[at]);
        // A lower bound first: the straight line, which is also the path in most cases.
        let straight = points.map(|p| rest.distance(p));
        if !self.is_low(corners, straight, straight) {
            return false;
        }
        let places = corners.map(|at| scouts.places[at]);
        let [Some(a), Some(b), Some(c)] = path_ends(field, &points, &places) else { return false };
        let paths = [a, b, c];
        let is_one_cone = paths.iter().all(|path| path.pseudo_source == a.pseudo_source);
        let to_apex = |path: PathEnd| if is_one_cone { path.distance - path.offset } else { 0.0 };
        self.is_low(corners, paths.map(|path| path.distance), paths.map(to_apex))
    }

    /// Whether a cone may be the lowest one somewhere in a triangle, from its values at the corners and the distances of
    /// these to its apex.
    fn is_low(&self, corners: [usize; 3], values: [f64; 3], to_apex: [f64; 3]) -> bool {
        let longest = corners.iter().map(|&at| self.scouts.reach[at]).fold(0.0, f64::max);
        let mut over = (0..3).map(|k| values[k] - self.cells.distance[corners[k]]);
        let apart = to_apex.into_iter().fold(f64::INFINITY, f64::min);
        over.clone().all(|over| over <= 2.0 * longest)
            && (!self.is_of_one_cone(corners) || over.any(|over| over <= cone_sag(longest, apart)))
    }

    /// An upper bound for the distance of a triangle's points to their nearest site; refined only if it is at least `least`.
    fn upper_bound(&self, triangle: u32, least: f64) -> f64 {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.upper_bound;
        }
        let Self { scouts, cells, .. } = self;
        let corners = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let distances = corners.map(|at| cells.distance[at]);
        let upper_bound = (0..3).map(|k| distances[k] + scouts.reach[corners[k]]).fold(f64::INFINITY, f64::min);
        // A cone is convex, so it is greatest at a corner.
        if upper_bound >= least && self.is_of_one_cone(corners) {
            distances.into_iter().fold(0.0, f64::max)
        } else {
            upper_bound
        }
    }

    /// Whether three scouts have the same nearest site and the same pseudo-source.
    fn is_of_one_cone(&self, corners: [usize; 3]) -> bool {
        let [a, b, c] = corners.map(|at| (self.cells.nearest[at], self.cells.pseudo_source[at]));
        a == b && b == c
    }

    /// The farthest points of a site's cell, at least one, searched in `triangles`.
    fn farthest_points(&mut self, site: usize, triangles: &[(u32, f64)]) -> Vec<FarPoint> {
        let tied = |distance: f64, greatest: f64| distance >= greatest * (1.0 - TIE);
        let radius = self.sampled_radius(site);
        let of_scouts = self.cells.of(site).filter(|&at| tied(self.cells.distance[at], radius));
        let mut found: Vec<FarPoint> = of_scouts.map(|at| self.far_point(at)).collect();
        let mut pieces = std::mem::take(&mut self.pieces);
        let mut greatest = radius;
        let mut search = Search { triangles, open: Vec::new() };
        while let Some(at) = search.next(&mut pieces, self, site) {
            let piece = pieces.piece(at);
            if !tied(piece.upper_bound, greatest) {
                break;
            }
            let mut maxima = Vec::new();
            if piece.is_flat() {
                if piece.upper_bound_of(site).is_none_or(|upper_bound| !tied(upper_bound, greatest)) {
                    continue;
                }
                maxima = piece.maxima(self, site, greatest);
            }
            if maxima.is_empty() {
                let parts = pieces.parts(self, at);
                search.open.extend(parts.filter(|&part| pieces.piece(part).has(site)));
            }
            greatest = maxima.iter().map(|point| point.distance).fold(greatest, f64::max);
            found.extend(maxima);
        }
        self.pieces = pieces;
        let mut points: Vec<FarPoint> = Vec::new();
        for point in found {
            if tied(point.distance, greatest)
                && points.iter().all(|known| known.at.distance(point.at) > SAME_POINT * greatest)
            {
                points.push(point);
            }
        }
        if points.is_empty() {
            // The cell contains no other point: the site itself.
            let site = &self.sites[site];
            points.push(FarPoint { at: site.rest, place: site.place, distance: 0.0 });
        }
        points
    }

    /// A scout as a far point.
    fn far_point(&self, scout: usize) -> FarPoint {
        let (at, place) = (self.scouts.mesh.vertices[scout], self.scouts.places[scout]);
        FarPoint { at, place, distance: self.cells.distance[scout] }
    }
}

/// The triangles and pieces that may still contain a farthest point.
struct Search<'a> {
    /// Triangles not opened yet, each with an upper bound, descending.
    triangles: &'a [(u32, f64)],
    /// Pieces of opened triangles that the cell may enter.
    open: Vec<u32>,
}

impl Search<'_> {
    /// Removes and returns the piece with the greatest upper bound.
    fn next(&mut self, pieces: &mut Pieces, regions: &Regions, site: usize) -> Option<u32> {
        loop {
            let upper_bound = |at: usize| pieces.piece(self.open[at]).upper_bound;
            let farthest =
                (0..self.open.len()).reduce(|best, at| if upper_bound(at) > upper_bound(best) { at } else { best });
            match (farthest, self.triangles) {
                (farthest, &[(triangle, bound), ref others @ ..])
                    if farthest.is_none_or(|at| bound > upper_bound(at)) =>
                {
                    self.triangles = others;
                    let root = pieces.root(regions, triangle);
                    if pieces.piece(root).has(site) {
                        self.open.push(root);
                    }
                }
                (farthest, _) => return farthest.map(|at| self.open.swap_remove(at)),
            }
        }
    }
}
