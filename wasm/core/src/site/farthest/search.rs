//! A best-first search for the farthest points of a cell, over the pieces of the triangles that may contain them.
//!
//! It opens only a few triangles, and finds the exact farthest point for any number of coarse samples.
//!
//! Cost: the pieces that it opens, and a heap of them.

use std::collections::BinaryHeap;

use super::{
    super::{TIE, voronoi::Voronoi},
    FarPoint, SAME_POINT,
    candidates::Candidate,
    maxima::maxima,
    pieces::Pieces,
};
use crate::min_entry::MinEntry;

/// The farthest points of a site's cell, at least one, searched in candidate triangles.
pub(super) fn farthest_points(
    voronoi: &Voronoi,
    pieces: &mut Pieces,
    site: usize,
    candidates: &[Candidate],
) -> Vec<FarPoint> {
    let tied = |distance: f64, greatest: f64| distance >= greatest * (1.0 - TIE);
    let cells = &voronoi.cells;
    let radius = cells.sampled_radius(site);
    let samples = cells.of(site).filter(|&at| tied(cells.distance[at], radius));
    let mut found: Vec<FarPoint> = samples.map(|at| sample_point(voronoi, at)).collect();
    let mut greatest = radius;
    let mut search = Search { candidates, open: BinaryHeap::new() };
    while let Some(at) = search.next(voronoi, pieces, site) {
        let piece = pieces.piece(at);
        if !tied(piece.upper_bound, greatest) || pieces.are_full() {
            break;
        }
        let (mut maxima_found, mut steps) = (Vec::new(), piece.paths.len() as u64);
        if piece.is_flat() {
            let may_have = piece.upper_bound_of(site).is_some_and(|upper_bound| tied(upper_bound, greatest));
            if may_have {
                maxima_found = maxima(voronoi, piece, site, greatest, &mut steps);
            }
            pieces.count(steps);
            if !may_have {
                continue;
            }
        }
        if maxima_found.is_empty() {
            pieces.subdivide(voronoi, at).for_each(|part| search.push(pieces, part, site));
        }
        greatest = maxima_found.iter().map(|point| point.distance).fold(greatest, f64::max);
        found.extend(maxima_found);
    }
    let mut points: Vec<FarPoint> = Vec::new();
    for point in found {
        if tied(point.distance, greatest)
            && points.iter().all(|known| known.at.distance(point.at) > SAME_POINT * greatest)
        {
            points.push(point);
        }
    }
    if points.is_empty() {
        // The cell has no point but the site itself.
        let (at, triangle) = (voronoi.sites[site].rest, voronoi.fields[site].triangle);
        points.push(FarPoint { at, triangle, distance: 0.0 });
    }
    points
}

/// A coarse sample as a far point.
fn sample_point(voronoi: &Voronoi, sample: usize) -> FarPoint {
    let (at, triangle) = (voronoi.coarse.mesh.vertices[sample], voronoi.coarse.nav_triangles[sample]);
    FarPoint { at, triangle, distance: voronoi.cells.distance[sample] }
}

/// The triangles and pieces that may still contain a farthest point.
struct Search<'a> {
    /// Triangles not opened yet, sorted by descending upper bound.
    candidates: &'a [Candidate],
    /// Pieces of opened triangles that the cell may enter. The keys are their upper bounds, negated.
    open: BinaryHeap<MinEntry<u32>>,
}

impl Search<'_> {
    /// Adds a piece, if the cell may enter it.
    fn push(&mut self, pieces: &Pieces, at: u32, site: usize) {
        let piece = pieces.piece(at);
        if piece.has(site) {
            self.open.push(MinEntry { key: -piece.upper_bound, item: at });
        }
    }

    /// Removes and returns the piece with the greatest upper bound.
    fn next(&mut self, voronoi: &Voronoi, pieces: &mut Pieces, site: usize) -> Option<u32> {
        while let &[Candidate { triangle, upper_bound }, ref others @ ..] = self.candidates
            && self.open.peek().is_none_or(|farthest| upper_bound > -farthest.key)
        {
            self.candidates = others;
            let root = pieces.open(voronoi, triangle);
            self.push(pieces, root, site);
        }
        self.open.pop().map(|farthest| farthest.item)
    }
}
