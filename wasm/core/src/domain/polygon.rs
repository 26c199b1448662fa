//! Checks of a project's rings: they must be inside the picture, simple and disjoint.
//!
//! Orientations are computed exactly, as in the triangulation. In addition, rings must keep [`RING_CLEARANCE`] from
//! themselves and from one another. Samples along their edges are rounded, and must remain disjoint.
//!
//! Cost: a sweep over the edges sorted by their left ends. It is quadratic only if very many edges overlap in x.

use glam::DVec2;
use robust::{Coord, orient2d};

use super::ring::{Ring, edges, signed_area};
use crate::{
    error::Error,
    rank::{ascending, sort_by_rank},
    segment::segment_distance,
};

/// Least area of a ring, in square pixels.
const MIN_AREA: f64 = 1e-6;
/// Points closer than this coincide, and edges closer than this touch, in pixels. Consecutive edges overlap if the sine
/// of their angle is smaller.
///
/// This is twice the rounding of samples at the greatest coordinate, a million pixels.
const RING_CLEARANCE: f64 = 1e-9;

/// Checks rings in a picture. Each ring must have at least three points, all finite.
///
/// # Errors
/// The error of the first offending ring or pair of rings.
pub(super) fn check(rings: &[Ring], width: u32, height: u32) -> Result<(), Error> {
    let size = DVec2::new(f64::from(width), f64::from(height));
    for (ring, points) in rings.iter().enumerate() {
        for (point, p) in points.iter().enumerate() {
            if p.cmplt(DVec2::ZERO).any() || p.cmpgt(size).any() {
                return Err(Error::RingOutsidePicture { ring, point, x: p.x, y: p.y, width, height });
            }
        }
    }
    check_rings(rings)
}

/// Checks rings without a picture. Each ring must have at least three points, all finite.
///
/// # Errors
/// The error of the first offending ring or pair of rings.
pub(super) fn check_rings(rings: &[Ring]) -> Result<(), Error> {
    check_simple(rings)?;
    let flat = rings.iter().position(|ring| signed_area(ring).abs() < MIN_AREA);
    flat.map_or(Ok(()), |ring| Err(Error::RingFlat { ring }))
}

/// Checks that rings are simple and disjoint.
///
/// # Errors
/// The error of the first pair of coinciding points, or of edges that cross or touch.
pub(super) fn check_simple(rings: &[Ring]) -> Result<(), Error> {
    check_distinct(rings)?;
    check_crossings(rings)
}

fn check_distinct(rings: &[Ring]) -> Result<(), Error> {
    let mut points: Vec<(DVec2, usize, usize)> = Vec::new();
    for (ring, ring_points) in rings.iter().enumerate() {
        points.extend(ring_points.iter().enumerate().map(|(point, &p)| (p, ring, point)));
    }
    sort_by_rank(&mut points, |(p, ..)| [ascending(p.x), ascending(p.y)]);
    for (at, &(p, ring, point)) in points.iter().enumerate() {
        let mut beside = points[at + 1..].iter().take_while(|(q, ..)| q.x - p.x < RING_CLEARANCE);
        if let Some(&(_, other_ring, other_point)) = beside.find(|(q, ..)| p.distance(*q) < RING_CLEARANCE) {
            let ((other_ring, other_point), (ring, point)) =
                ((ring, point).min((other_ring, other_point)), (ring, point).max((other_ring, other_point)));
            return Err(Error::RingDuplicate { ring, point, other_ring, other_point });
        }
    }
    Ok(())
}

/// An edge of a ring.
struct Edge {
    from: DVec2,
    to: DVec2,
    /// Index of the ring.
    ring: usize,
    /// Index of the first point.
    point: usize,
    /// Number of points of the ring.
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
    sort_by_rank(&mut all, |edge| [ascending(edge.from.x.min(edge.to.x)), 0]);
    for (at, edge) in all.iter().enumerate() {
        let right = edge.from.x.max(edge.to.x) + RING_CLEARANCE;
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

/// Whether two edges meet or nearly meet, except at the common point of neighbours. Their boxes must overlap in x.
fn conflict(a: &Edge, b: &Edge) -> bool {
    if a.follows(b) {
        return folds_back(b.from, a.from, a.to);
    }
    if b.follows(a) {
        return folds_back(a.from, b.from, b.to);
    }
    let (a_low, a_high) = (a.from.y.min(a.to.y), a.from.y.max(a.to.y));
    let (b_low, b_high) = (b.from.y.min(b.to.y), b.from.y.max(b.to.y));
    if a_low - b_high > RING_CLEARANCE || b_low - a_high > RING_CLEARANCE {
        return false;
    }
    let (a1, a2) = (side(a.from, a.to, b.from), side(a.from, a.to, b.to));
    let (b1, b2) = (side(b.from, b.to, a.from), side(b.from, b.to, a.to));
    let crosses = a1 * a2 < 0.0 && b1 * b2 < 0.0;
    crosses
        || [b.from, b.to].iter().any(|&end| segment_distance(end, a.from, a.to) < RING_CLEARANCE)
        || [a.from, a.to].iter().any(|&end| segment_distance(end, b.from, b.to) < RING_CLEARANCE)
}

/// The side of r on the line from p through q: 1, 0 or −1, without rounding.
///
/// Returns a sign rather than an area, because the product of two tiny areas may underflow to 0.
fn side(p: DVec2, q: DVec2, r: DVec2) -> f64 {
    let [p, q, r] = [p, q, r].map(|DVec2 { x, y }| Coord { x, y });
    let area = orient2d(p, q, r);
    if area == 0.0 { 0.0 } else { area.signum() }
}

/// Whether the chain p → q → r folds back onto itself.
fn folds_back(p: DVec2, q: DVec2, r: DVec2) -> bool {
    let (before, after) = (q - p, r - q);
    before.dot(after) < 0.0 && before.perp_dot(after).abs() <= RING_CLEARANCE * (before.length() * after.length())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(rings: &[&[[f64; 2]]]) -> Option<Error> {
        let rings: Vec<Ring> = rings.iter().map(|ring| ring.iter().map(|&p| p.into()).collect()).collect();
        check(&rings, 100, 100).err()
    }

    #[test]
    fn apex_beyond_an_edge_by_rounding_crosses_it() {
        let edge = [[8.676_470_058_428_729, 20.407_480_568_925_045], [76.093_982_495_697_9, 41.446_550_677_428_22]];
        let ring = [edge[0], edge[1], [90.0, 90.0], [10.0, 90.0]];
        let apex = [45.146_904_038_154_07, 31.788_855_966_021_476];
        // The sweep finds the edge to the apex from the left first.
        let crossing = Some(Error::RingsCross { ring: 1, point: 2, other_ring: 0, other_point: 0 });
        assert_eq!(refused(&[&ring, &[apex, [60.0, 5.0], [40.0, 5.0]]]), crossing);
        // An apex that close to the edge is refused as well: samples along the edge are rounded.
        let beside = |by: f64| refused(&[&ring, &[[apex[0], apex[1] - by], [60.0, 5.0], [40.0, 5.0]]]);
        assert_eq!(beside(1e-13), crossing);
        assert_eq!(beside(1e-8), None);
    }

    #[test]
    fn points_that_differ_by_rounding_coincide() {
        for hair in [1e-10, 1e-50, 1e-200] {
            let duplicate = Some(Error::RingDuplicate { ring: 0, point: 3, other_ring: 0, other_point: 0 });
            assert_eq!(refused(&[&[[3.0, 0.0], [10.0, 5.0], [0.0, 5.0], [3.0, hair]]]), duplicate);
        }
        assert_eq!(refused(&[&[[3.0, 0.0], [10.0, 5.0], [0.0, 5.0], [3.0, 1e-8]]]), None);
    }

    #[test]
    fn needle_without_width_folds_back() {
        let needle = |width: f64| refused(&[&[[10.0, 10.0], [90.0, 10.0], [50.0, 10.0 + width], [50.0, 50.0]]]);
        assert_eq!(needle(1e-10), Some(Error::RingsCross { ring: 0, point: 1, other_ring: 0, other_point: 0 }));
        assert_eq!(needle(1e-6), None);
    }
}
