//! A bone as a line segment embedded in the navigation mesh, for intrinsic distances to it (section III-A).
//!
//! Cost: embedding visits every triangle of the navigation mesh; a distance visits the windows in the triangles of the
//! bone.

use glam::DVec2;

use super::Bone;
use crate::{
    distance::{DistanceField, NavTriangle, Navigation},
    segment::distance_between,
    triangulation::OUTLINE_TOLERANCE,
};

/// A bone, cut by the triangles of the navigation mesh.
#[derive(Debug, Clone)]
pub(crate) struct EmbeddedSegment {
    /// The island that contains the bone.
    pub(crate) island: usize,
    /// The part of the bone in each triangle, by its two ends.
    parts: Vec<(NavTriangle, DVec2, DVec2)>,
}

impl EmbeddedSegment {
    pub(crate) fn new(navigation: &Navigation, bone: &Bone) -> Self {
        let [a, b] = bone.rest;
        let middle = navigation.triangle_at(a.midpoint(b)).expect("bones lie in the domain");
        let parts = navigation.triangles().filter_map(|(triangle, corners)| {
            let [from, to] = clip_to_triangle(a, b, corners)?;
            Some((triangle, a.lerp(b, from), a.lerp(b, to)))
        });
        Self { island: navigation.island_of(middle), parts: parts.collect() }
    }

    /// Distance from a field's source to the bone, in pixels; infinite beyond the field's bound.
    pub(crate) fn distance(&self, field: &DistanceField) -> f64 {
        let distances = self.parts.iter().map(|&(triangle, a, b)| field.distance_to_segment(triangle, a, b));
        distances.fold(f64::INFINITY, f64::min)
    }
}

/// The part of a segment in a triangle, as two fractions of the segment; `None` if it does not enter the triangle.
fn clip_to_triangle(a: DVec2, b: DVec2, corners: [DVec2; 3]) -> Option<[f64; 2]> {
    let (mut from, mut to, mut is_beside) = (0.0_f64, 1.0_f64, false);
    for k in 0..3 {
        let (corner, side) = (corners[k], corners[(k + 1) % 3] - corners[k]);
        let (at_a, at_b) = (side.perp_dot(a - corner), side.perp_dot(b - corner));
        if at_a.max(at_b) < -OUTLINE_TOLERANCE * side.length() {
            return None;
        }
        if at_a.max(at_b) < 0.0 {
            is_beside = true;
            continue;
        }
        let crossing = at_a / (at_a - at_b);
        if at_a < 0.0 {
            from = from.max(crossing);
        } else if at_b < 0.0 {
            to = to.min(crossing);
        }
    }
    // A bone along the outline may lie beside it, by as much as counts as on it. Beyond a sharp corner the lines are
    // near, but no edge is.
    let is_on = |k: usize| distance_between([a, b], [corners[k], corners[(k + 1) % 3]]) <= OUTLINE_TOLERANCE;
    (from <= to && (!is_beside || (0..3).any(is_on))).then_some([from, to])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_of_a_needle_ends_its_part_of_a_bone() {
        let needle = [(0.0, 0.0), (100.0, 0.0), (100.0, 1e-9)].map(DVec2::from);
        let clipped = |a: (f64, f64), b: (f64, f64)| clip_to_triangle(a.into(), b.into(), needle);
        assert_eq!(clipped((20.0, -5e-7), (60.0, -5e-7)), Some([0.0, 1.0]), "beside an edge");
        assert_eq!(clipped((20.0, -5e-6), (60.0, -5e-6)), None);
        assert_eq!(clipped((-10.0, -1e-9), (-5.0, -1e-9)), None, "near both lines");
        assert_eq!(clipped((-10.0, 0.0), (-5.0, 0.0)), None, "on a line");
    }
}
