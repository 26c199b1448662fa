//! Checks of the rings that a project draws: finite, inside the picture, simple and disjoint.
//!
//! Cost: a sweep over the edges sorted by their left ends; quadratic only where very many edges overlap in x.

use glam::DVec2;

use super::{Ring, edges, signed_area};
use crate::error::Error;

/// Rings that enclose less, in square pixels, enclose nothing.
const LEAST_AREA: f64 = 1e-6;

/// # Errors
/// The first ring, or pair of rings, that breaks the rules.
pub(super) fn check(rings: &[Ring], width: u32, height: u32) -> Result<(), Error> {
    let size = DVec2::new(f64::from(width), f64::from(height));
    for (ring, points) in rings.iter().enumerate() {
        if points.len() < 3 {
            return Err(Error::RingShort { ring, points: points.len() });
        }
        for (point, p) in points.iter().enumerate() {
            if !p.is_finite() {
                return Err(Error::RingNotFinite { ring, point });
            }
            if p.cmplt(DVec2::ZERO).any() || p.cmpgt(size).any() {
                return Err(Error::RingOutsidePicture { ring, point, x: p.x, y: p.y, width, height });
            }
        }
    }
    check_simple(rings)?;
    let flat = rings.iter().position(|ring| signed_area(ring).abs() < LEAST_AREA);
    flat.map_or(Ok(()), |ring| Err(Error::RingFlat { ring }))
}

/// # Errors
/// The first pair of points that coincide, or of edges that cross or touch.
pub(super) fn check_simple(rings: &[Ring]) -> Result<(), Error> {
    check_distinct(rings)?;
    check_crossings(rings)
}

fn check_distinct(rings: &[Ring]) -> Result<(), Error> {
    let mut points: Vec<(DVec2, usize, usize)> = Vec::new();
    for (ring, ring_points) in rings.iter().enumerate() {
        points.extend(ring_points.iter().enumerate().map(|(point, &p)| (p, ring, point)));
    }
    points.sort_by(|(a, ..), (b, ..)| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    match points.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => {
            let ((_, a_ring, a_point), (_, b_ring, b_point)) = (pair[0], pair[1]);
            let (first, second) = ((a_ring, a_point).min((b_ring, b_point)), (a_ring, a_point).max((b_ring, b_point)));
            Err(Error::RingDuplicate { ring: second.0, point: second.1, other_ring: first.0, other_point: first.1 })
        }
        None => Ok(()),
    }
}

/// An edge from point `point` of ring `ring` to the next of `points`.
struct Edge {
    from: DVec2,
    to: DVec2,
    ring: usize,
    point: usize,
    points: usize,
}

impl Edge {
    fn follows(&self, other: &Self) -> bool {
        self.ring == other.ring && (other.point + 1) % other.points == self.point
    }
}

fn check_crossings(rings: &[Ring]) -> Result<(), Error> {
    let mut all: Vec<Edge> = Vec::new();
    for (ring, points) in rings.iter().enumerate() {
        let ring_edges = edges(points).enumerate();
        all.extend(ring_edges.map(|(point, (from, to))| Edge { from, to, ring, point, points: points.len() }));
    }
    all.sort_by(|a, b| a.from.x.min(a.to.x).total_cmp(&b.from.x.min(b.to.x)));
    for (at, edge) in all.iter().enumerate() {
        let right = edge.from.x.max(edge.to.x);
        for other in all[at + 1..].iter().take_while(|other| other.from.x.min(other.to.x) <= right) {
            if conflict(edge, other) {
                let (second, first) =
                    if (edge.ring, edge.point) < (other.ring, other.point) { (other, edge) } else { (edge, other) };
                return Err(Error::RingsCross {
                    ring: second.ring,
                    point: second.point,
                    other_ring: first.ring,
                    other_point: first.point,
                });
            }
        }
    }
    Ok(())
}

/// Whether two edges meet anywhere but in the point that neighbours share.
fn conflict(a: &Edge, b: &Edge) -> bool {
    if a.follows(b) {
        return folds_back(b.from, a.from, a.to);
    }
    if b.follows(a) {
        return folds_back(a.from, b.from, b.to);
    }
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let (a1, a2) = (side(a.from, a.to, b.from), side(a.from, a.to, b.to));
    let (b1, b2) = (side(b.from, b.to, a.from), side(b.from, b.to, a.to));
    let boxes_overlap = a.from.y.min(a.to.y) <= b.from.y.max(b.to.y) && b.from.y.min(b.to.y) <= a.from.y.max(a.to.y);
    boxes_overlap && a1 * a2 <= 0.0 && b1 * b2 <= 0.0
}

/// Whether the chain p → q → r returns onto itself.
fn folds_back(p: DVec2, q: DVec2, r: DVec2) -> bool {
    (q - p).perp_dot(r - q) == 0.0 && (q - p).dot(r - q) < 0.0
}
