//! The reach of handles: how far each vertex follows their move.
//!
//! Reach is the norm of the derivative of the posed position with respect to the move: the root of half the sum of its
//! four squared entries. A vertex of reach 1 moves as far as the handles, straight or turned; at 0 it does not move;
//! above 1 it swings farther than they do. Whole poses are compared, which works in both pose modes and for both
//! blends.
//!
//! Cost: four blends.

use glam::DVec2;

use super::Pose;
use crate::weight::SparseWeights;

/// Step of the central difference, as a fraction of the picture's diagonal.
///
/// In the rigid mode, a drag that goes on has not come to rest. Over a shorter step, that counts for more. In the
/// harmonic mode, any step gives the same result.
pub(super) const STEP: f64 = 0.005;

/// The moves of the handles whose poses [`reach`] compares, for a step of 1.
pub(super) const MOVES: [DVec2; 4] = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];

/// The reach at each position before the handles move it, from poses with the handles moved by `step` along each of
/// [`MOVES`].
pub(super) fn reach(places: &[DVec2], weights: &SparseWeights, moved: &[Pose; 4], step: f64) -> Vec<f32> {
    let at = |(row, &p): (usize, &DVec2)| {
        let [right, left, down, up] = moved.each_ref().map(|pose| pose.blended_place(p, weights.row(row)));
        let squared = right.distance_squared(left) + down.distance_squared(up);
        ((squared / 2.0).sqrt() / (2.0 * step)) as f32
    };
    places.iter().enumerate().map(at).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{pose::Motion, project::Blend};

    const STEP: f64 = 2.0;

    /// A row of points from (0, 0) to (10, 0), whose weights go over from a site at its start to one at its end.
    fn reach_along_row(blend: Blend, sites: impl Fn(DVec2) -> [(f64, DVec2); 2]) -> Vec<f32> {
        let points: Vec<DVec2> = (0..=10).map(|x| DVec2::new(f64::from(x), 0.0)).collect();
        let mut weights = SparseWeights::with_capacity(points.len());
        points.iter().for_each(|p| weights.push_row([(0, 1.0 - p.x / 10.0), (1, p.x / 10.0)].into_iter()));
        let moved = MOVES.map(|by| {
            let motions = sites(STEP * by).map(|(angle, by)| Motion::similarity(angle, 1.0, by, 0.0));
            Pose::new(Arc::new([points[0], points[10]]), motions.to_vec(), blend)
        });
        reach(&points, &weights, &moved, STEP)
    }

    fn assert_all_near(found: &[f32], expected: impl Fn(usize) -> f64) {
        for (vertex, &reach) in found.iter().enumerate() {
            assert!((f64::from(reach) - expected(vertex)).abs() < 1e-5, "{reach} at {vertex}");
        }
    }

    #[test]
    fn reach_is_1_where_all_sites_move_alike() {
        for blend in [Blend::Linear, Blend::Rigid] {
            assert_all_near(&reach_along_row(blend, |by| [(0.7, by), (0.7, by)]), |_| 1.0);
        }
    }

    #[test]
    fn reach_falls_from_a_moved_site_to_a_still_one() {
        for blend in [Blend::Linear, Blend::Rigid] {
            let found = reach_along_row(blend, |by| [(0.0, by), (0.0, DVec2::ZERO)]);
            assert_all_near(&found, |vertex| 1.0 - vertex as f64 / 10.0);
        }
    }

    #[test]
    fn reach_does_not_depend_on_the_direction_and_is_linear_in_the_move() {
        for blend in [Blend::Linear, Blend::Rigid] {
            let along = |of: fn(DVec2) -> DVec2| reach_along_row(blend, |by| [(0.3, of(by)), (-0.4, DVec2::ZERO)]);
            let straight = along(|by| by);
            assert_all_near(&along(DVec2::perp), |vertex| f64::from(straight[vertex]));
            assert_all_near(&along(|by| by / 2.0), |vertex| f64::from(straight[vertex]) / 2.0);
        }
    }

    #[test]
    fn a_point_without_weights_has_no_reach() {
        let mut weights = SparseWeights::with_capacity(1);
        weights.push_row(std::iter::empty());
        let pose = Pose::new(Arc::new([]), Vec::new(), Blend::Linear);
        assert_eq!(reach(&[DVec2::ONE], &weights, &MOVES.map(|_| pose.clone()), STEP), [0.0]);
    }
}
