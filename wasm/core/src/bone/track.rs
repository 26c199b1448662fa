//! Intrinsic distance to a bone, from its parts in the triangles of the navigation mesh.

use glam::DVec2;

use super::Bone;
use crate::{
    distance::{DistanceField, NavTriangle, Navigation},
    triangulation::OUTLINE_TOLERANCE,
};

/// A bone on the navigation mesh.
#[derive(Debug, Clone)]
pub(crate) struct Track {
    pub(crate) island: usize,
    pieces: Vec<(NavTriangle, DVec2, DVec2)>,
}

impl Track {
    /// Cost: a look at every triangle of the navigation mesh.
    pub(crate) fn new(navigation: &Navigation, bone: &Bone) -> Self {
        let [a, b] = bone.rest;
        let middle = navigation.triangle_at(a.midpoint(b)).expect("bones lie in the domain");
        let pieces = navigation.triangles().filter_map(|(triangle, corners)| {
            let [from, to] = within_triangle(a, b, corners)?;
            Some((triangle, a.lerp(b, from), a.lerp(b, to)))
        });
        Self { island: navigation.island_of(middle), pieces: pieces.collect() }
    }

    /// Distance from a field's source to the bone, infinite beyond the field's bound.
    pub(crate) fn distance(&self, field: &DistanceField) -> f64 {
        let distances = self.pieces.iter().map(|&(triangle, a, b)| field.distance_to_segment(triangle, a, b));
        distances.fold(f64::INFINITY, f64::min)
    }
}

/// The part of a segment in a triangle, as shares of the segment.
fn within_triangle(a: DVec2, b: DVec2, corners: [DVec2; 3]) -> Option<[f64; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for k in 0..3 {
        let (corner, side) = (corners[k], corners[(k + 1) % 3] - corners[k]);
        let (at_a, at_b) = (side.perp_dot(a - corner), side.perp_dot(b - corner));
        // Along the outline a bone may lie beside it by what counts as on it.
        if at_a.max(at_b) < -OUTLINE_TOLERANCE * side.length() {
            return None;
        }
        if at_a.max(at_b) < 0.0 {
            continue;
        }
        let share = at_a / (at_a - at_b);
        if at_a < 0.0 {
            from = from.max(share);
        } else if at_b < 0.0 {
            to = to.min(share);
        }
    }
    (from <= to).then_some([from, to])
}
