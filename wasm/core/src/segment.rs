//! Distance to a line segment.

use glam::DVec2;

/// The point of the segment from `a` to `b` that is nearest to `p`. The segment may have length 0.
pub(crate) fn nearest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let along = b - a;
    let t = (p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
    a + along * t.clamp(0.0, 1.0)
}

/// Distance of `p` to the segment from `a` to `b`.
pub(crate) fn segment_distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    p.distance(nearest_on_segment(p, a, b))
}
