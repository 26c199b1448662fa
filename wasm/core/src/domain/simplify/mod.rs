//! Simplification of the outline that preserves its topology.
//!
//! A point is dropped under two conditions. The chord in its place must stay within a tolerance of every original
//! point. The triangle that the outline sweeps must contain no other point of any ring. Every step is then a
//! deformation without contact, so rings remain simple and disjoint: gaps are not bridged, and thin parts are not cut.
//!
//! Of two points with the same cost, the one nearer to the centre of its ring's box goes first. Points at the same
//! distance are dropped in one round. A symmetric outline therefore remains symmetric, for any first point and either
//! orientation of its rings.
//!
//! Cost: usually O(n log n) for n contour points, with a grid over the points. Each step visits the cells that its
//! triangle touches, and the original points under its chord, but only the ends of exactly straight runs.
//!
//! Known limit: a contour may be within the tolerance of a chord over thousands of points, yet nowhere exactly
//! straight. Each of these points then costs that many visits.

mod chains;
mod point_grid;

use std::collections::BinaryHeap;

use self::chains::{Candidate, Chains};
use super::ring::Ring;

/// Simplifies rings. The rings must be simple and disjoint, and remain so.
///
/// `tolerance` is the maximum distance of an original point from the simplified outline, in pixels.
pub(super) fn simplified(rings: &[Ring], tolerance: f64) -> Vec<Ring> {
    let mut chains = Chains::new(rings, tolerance);
    let mut queue: BinaryHeap<Candidate> = (0..chains.len()).filter_map(|at| chains.candidate(at)).collect();
    let mut rounds = 0;
    while let Some(first) = queue.pop() {
        let is_tied = |other: &Candidate| other.key == first.key && other.item.0 == first.item.0;
        let mut round = vec![first];
        while queue.peek().is_some_and(is_tied) {
            round.extend(queue.pop());
        }
        rounds += 1;
        round.retain(|candidate| chains.is_current(candidate));
        for candidate in &round {
            chains.mark(candidate, rounds);
        }
        let mut around = Vec::new();
        for candidate in &round {
            if chains.is_current(candidate) {
                around.extend(chains.drop_with_neighbour(candidate, rounds));
            }
        }
        queue.extend(around.into_iter().flatten().filter_map(|at| chains.candidate(at)));
    }
    chains.rings(rings)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    /// With the tolerance of a traced outline.
    fn simplified(rings: &[Ring]) -> Vec<Ring> {
        super::simplified(rings, 0.35)
    }

    #[test]
    fn straight_edge_keeps_only_its_ends() {
        let mut ring: Ring = (0..200).map(|i| DVec2::new(f64::from(i), f64::from(i) / 2.0)).collect();
        ring.push(DVec2::new(0.0, 100.0));
        assert_eq!(simplified(&[ring])[0].len(), 3);
    }

    #[test]
    fn square_keeps_its_corners_for_any_first_point() {
        let side = |i: i32| match i.rem_euclid(40) {
            i @ 0..10 => DVec2::new(f64::from(i), 0.0),
            i @ 10..20 => DVec2::new(10.0, f64::from(i - 10)),
            i @ 20..30 => DVec2::new(f64::from(30 - i), 10.0),
            i => DVec2::new(0.0, f64::from(40 - i)),
        };
        for first in [0, 3, 19] {
            let ring: Ring = (first..first + 40).map(side).collect();
            assert_eq!(simplified(&[ring])[0].len(), 4);
        }
    }

    #[test]
    fn many_equal_rings_and_long_edges_are_fast() {
        // It would take minutes to search all tied points for each one, or all points of an edge for each dropped one.
        let diamond = |i: i32| -> Ring {
            let middle = DVec2::new(f64::from(i % 100), f64::from(i / 100)) * 20.0;
            let side = |from: DVec2, to: DVec2| (0..6).map(move |k| middle + from.lerp(to, f64::from(k) / 6.0) * 8.0);
            let corners = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
            (0..4).flat_map(|k| side(corners[k], corners[(k + 1) % 4])).collect()
        };
        let rings: Vec<Ring> = (0..10_000).map(diamond).collect();
        assert!(simplified(&rings).iter().all(|ring| ring.len() == 4));
        let edge: Ring = (0..60_000).map(|i| DVec2::new(f64::from(i), 0.0)).chain([DVec2::new(0.0, 50.0)]).collect();
        assert_eq!(simplified(&[edge])[0].len(), 3);
    }

    #[test]
    fn close_rings_stay_disjoint() {
        let bump = |y: f64| -> Ring {
            let top = (0..100).map(|i| DVec2::new(f64::from(i), y + 0.3 * f64::from(i % 2)));
            top.chain([DVec2::new(99.0, y + 50.0), DVec2::new(0.0, y + 50.0)]).collect()
        };
        // The lower edge of the first ring is straight. The teeth of the second come within 0.1 px of it.
        let rings = simplified(&[bump(0.0), bump(50.1)]);
        let lowest = rings[0].iter().map(|p| p.y).fold(f64::MIN, f64::max);
        let highest = rings[1].iter().map(|p| p.y).fold(f64::MAX, f64::min);
        assert!(lowest < highest);
        assert!(rings[1].len() < 60);
    }
}
