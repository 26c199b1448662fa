//! Where the farthest points of a cell are: in which triangle of the scouts, and where in it.
//!
//! Distances grow no faster than one goes, so distances at its corners tell how far any point of a triangle can be at most; where
//! the corners are reached by way of the same pseudo-source, none is farther than they. So a search looks into a few triangles
//! only, those that may hold the farthest point first, and is sure to find it however few scouts there are.

use super::{
    Site,
    piece::{Pieces, bend, feet},
    regions::{Far, FarPoint, Regions},
    virtual_sites::{SAME, TIE},
};
use crate::{distance::Foot, triangulation::NONE};

/// Room for the triangles of most searches.
const ROOM: usize = 64;

impl Regions<'_> {
    /// Learns more of how far the farthest points of a site's cell are: first in which triangles they may be, then where they are.
    pub(crate) fn look_closer(&mut self, site: usize) {
        let radius = self.sampled_radius(site);
        self.far[site] = match std::mem::replace(&mut self.far[site], Far::Within(f64::INFINITY)) {
            // Where the cell has lost its farthest scout since, the point may be in other triangles.
            Far::InTriangles { scout, triangles } if scout <= radius => {
                Far::Known(self.farthest_points(site, &triangles))
            }
            Far::Within(_) | Far::InTriangles { .. } => {
                Far::InTriangles { scout: radius, triangles: self.triangles_of(site, radius) }
            }
            known @ Far::Known(_) => known,
        }
    }

    /// The triangles that may hold a point of a site's cell as far as its farthest scout, and how far at most; the farthest first.
    ///
    /// A path to the site stays in its cell, so the triangles that the cell enters hang together. Of those with scouts of the cell
    /// only such are looked at as may be far enough, or lead to others that have none.
    fn triangles_of(&mut self, site: usize, scout: f64) -> Vec<(u32, f64)> {
        let least = scout * (1.0 - TIE);
        let Self { scouts, cells, searched, .. } = self;
        searched.clear();
        let mut stack = Vec::with_capacity(ROOM);
        let home = self.home[site];
        searched.mark(home);
        stack.push(home);
        for at in cells.of(site) {
            let is_inner = || scouts.graph.of(at).iter().all(|&other| cells.nearest[other as usize] == site as u32);
            if cells.distance[at] + scouts.reach[at] >= least || !is_inner() {
                stack.extend(scouts.fan(at).iter().filter(|&&t| searched.mark(t)));
            }
        }
        let mut found = Vec::with_capacity(ROOM);
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
            let above = self.above(t, least);
            if above >= least {
                found.push((t, above));
            }
        }
        found.sort_by(|(t, a), (u, b)| b.total_cmp(a).then(t.cmp(u)));
        found
    }

    /// Whether a site's cell may have a point in a triangle that has none of its scouts.
    fn may_enter(&self, site: usize, triangle: u32) -> bool {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.has(site);
        }
        let Self { scouts, sites, .. } = self;
        let Site { rest, field, .. } = &sites[site];
        let corners = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let points = corners.map(|at| scouts.mesh.vertices[at]);
        // No path is shorter than the straight line, and most are no longer.
        let straight = points.map(|p| rest.distance(p));
        if !self.is_low(corners, straight, straight) {
            return false;
        }
        let places = corners.map(|at| scouts.places[at]);
        let [Some(a), Some(b), Some(c)] = feet(field, &points, &places) else { return false };
        let feet = [a, b, c];
        let is_one_cone = feet.iter().all(|foot| foot.pseudo_source == a.pseudo_source);
        let to_apex = |foot: Foot| if is_one_cone { foot.distance - foot.offset } else { 0.0 };
        self.is_low(corners, feet.map(|foot| foot.distance), feet.map(to_apex))
    }

    /// Whether a cone may be the lowest somewhere in a triangle, from its values at the corners and how far its apex is from them.
    fn is_low(&self, corners: [usize; 3], values: [f64; 3], to_apex: [f64; 3]) -> bool {
        let longest = corners.iter().map(|&at| self.scouts.reach[at]).fold(0.0, f64::max);
        let mut over = (0..3).map(|k| values[k] - self.cells.distance[corners[k]]);
        let apart = to_apex.into_iter().fold(f64::INFINITY, f64::min);
        over.clone().all(|over| over <= 2.0 * longest)
            && (!self.is_of_one_cone(corners) || over.any(|over| over <= bend(longest, apart)))
    }

    /// No point of a triangle is farther from its nearest site than this; told exactly from `least` on.
    fn above(&self, triangle: u32, least: f64) -> f64 {
        if let Some(piece) = self.pieces.known(triangle) {
            return piece.above;
        }
        let Self { scouts, cells, .. } = self;
        let corners = scouts.mesh.triangles[triangle as usize].map(|v| v as usize);
        let distances = corners.map(|at| cells.distance[at]);
        let above = (0..3).map(|k| distances[k] + scouts.reach[corners[k]]).fold(f64::INFINITY, f64::min);
        // A cone is convex.
        if above >= least && self.is_of_one_cone(corners) { distances.into_iter().fold(0.0, f64::max) } else { above }
    }

    /// Whether three scouts are nearest to one site by way of one pseudo-source.
    fn is_of_one_cone(&self, corners: [usize; 3]) -> bool {
        let [a, b, c] = corners.map(|at| (self.cells.nearest[at], self.cells.apex[at]));
        a == b && b == c
    }

    /// The farthest points of a site's cell, at least one, from the triangles that may hold one.
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
            if !tied(piece.above, greatest) {
                break;
            }
            let mut tops = Vec::new();
            if piece.is_flat() {
                if piece.above_of(site).is_none_or(|above| !tied(above, greatest)) {
                    continue;
                }
                tops = piece.tops(self, site, greatest);
            }
            if tops.is_empty() {
                let parts = pieces.parts(self, at);
                search.open.extend(parts.filter(|&part| pieces.piece(part).has(site)));
            }
            greatest = tops.iter().map(|point| point.distance).fold(greatest, f64::max);
            found.extend(tops);
        }
        self.pieces = pieces;
        let mut points: Vec<FarPoint> = Vec::new();
        for point in found {
            if tied(point.distance, greatest)
                && points.iter().all(|known| known.at.distance(point.at) > SAME * greatest)
            {
                points.push(point);
            }
        }
        if points.is_empty() {
            // Nothing is farther than the site itself.
            let site = &self.sites[site];
            points.push(FarPoint { at: site.rest, place: site.place, distance: 0.0 });
        }
        points
    }

    /// A scout and its distance to the nearest site.
    fn far_point(&self, scout: usize) -> FarPoint {
        let (at, place) = (self.scouts.mesh.vertices[scout], self.scouts.places[scout]);
        FarPoint { at, place, distance: self.cells.distance[scout] }
    }
}

/// Where a cell's farthest points may be still.
struct Search<'a> {
    /// Triangles not looked into yet, each with how far its points are at most; the farthest first.
    triangles: &'a [(u32, f64)],
    /// Pieces of the others that the cell may enter.
    open: Vec<u32>,
}

impl Search<'_> {
    /// Takes out the piece that may hold the farthest point of a site's cell.
    fn next(&mut self, pieces: &mut Pieces, regions: &Regions, site: usize) -> Option<u32> {
        loop {
            let above = |at: usize| pieces.piece(self.open[at]).above;
            let farthest = (0..self.open.len()).reduce(|best, at| if above(at) > above(best) { at } else { best });
            match (farthest, self.triangles) {
                (farthest, &[(triangle, bound), ref others @ ..]) if farthest.is_none_or(|at| bound > above(at)) => {
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
