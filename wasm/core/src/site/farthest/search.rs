//! A best-first search for the farthest points of a cell, over the pieces of the triangles that may contain them.
//!
//! It looks into a few triangles only, and finds the farthest point however few coarse samples there are.
//!
//! Cost: the pieces that it opens, and a heap of them.

use std::collections::BinaryHeap;

use super::{
    super::{Regions, TIE},
    FarPoint, SAME_POINT,
    pieces::Pieces,
};
use crate::min_entry::MinEntry;

impl Regions<'_> {
    /// The farthest points of a site's cell, at least one, searched in `triangles`.
    pub(super) fn farthest_points(&mut self, site: usize, triangles: &[(u32, f64)]) -> Vec<FarPoint> {
        let tied = |distance: f64, greatest: f64| distance >= greatest * (1.0 - TIE);
        let radius = self.sampled_radius(site);
        let of_coarse = self.cells.of(site).filter(|&at| tied(self.cells.distance[at], radius));
        let mut found: Vec<FarPoint> = of_coarse.map(|at| self.far_point(at)).collect();
        let mut pieces = std::mem::take(&mut self.pieces);
        let mut greatest = radius;
        let mut search = Search { triangles, open: BinaryHeap::new() };
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
                parts.for_each(|part| search.open(&pieces, part, site));
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
            points.push(FarPoint { at: site.rest, triangle: site.triangle, distance: 0.0 });
        }
        points
    }

    /// A coarse sample as a far point.
    fn far_point(&self, sample: usize) -> FarPoint {
        let (at, triangle) = (self.coarse.mesh.vertices[sample], self.coarse.nav_triangles[sample]);
        FarPoint { at, triangle, distance: self.cells.distance[sample] }
    }
}

/// The triangles and pieces that may still contain a farthest point.
struct Search<'a> {
    /// Triangles not opened yet, each with an upper bound, descending.
    triangles: &'a [(u32, f64)],
    /// Pieces of opened triangles that the cell may enter, keyed by their upper bounds, negative.
    open: BinaryHeap<MinEntry<u32>>,
}

impl Search<'_> {
    /// Opens a piece, if the cell may enter it.
    fn open(&mut self, pieces: &Pieces, at: u32, site: usize) {
        let piece = pieces.piece(at);
        if piece.has(site) {
            self.open.push(MinEntry { key: -piece.upper_bound, item: at });
        }
    }

    /// Removes and returns the piece with the greatest upper bound.
    fn next(&mut self, pieces: &mut Pieces, regions: &Regions, site: usize) -> Option<u32> {
        while let &[(triangle, bound), ref others @ ..] = self.triangles
            && self.open.peek().is_none_or(|farthest| bound > -farthest.key)
        {
            self.triangles = others;
            let root = pieces.root(regions, triangle);
            self.open(pieces, root, site);
        }
        self.open.pop().map(|farthest| farthest.item)
    }
}
