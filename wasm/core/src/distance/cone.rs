//! Cones of directions, and their rays on the edges of triangles.

use glam::DVec2;

/// Sines of angles and differences of distances in pixels count as zero below this. Rounding errors are two orders of
/// magnitude smaller.
pub(super) const EPSILON: f64 = 1e-12;
/// A source lies on an edge if it is at most this far from it, in pixels.
pub(super) const ON_EDGE: f64 = 1e-9;

/// The directions from the unit vector `first`, turning positively, to the unit vector `last`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cone {
    pub(super) first: DVec2,
    pub(super) last: DVec2,
}

impl Cone {
    /// Whether a direction lies in a cone narrower than π, or on one of its rays.
    pub(super) fn contains(self, direction: DVec2) -> bool {
        self.first.perp_dot(direction) >= -EPSILON
            && direction.perp_dot(self.last) >= -EPSILON
            && (self.first + self.last).dot(direction) >= 0.0
    }
}

/// The intersection of a ray with an edge that it crosses.
pub(super) fn ray_on_edge(source: DVec2, ray: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let along = b - a;
    let t = ray.perp_dot(a - source) / along.perp_dot(ray);
    // A ray along the edge has all of its points: the window has no width there.
    if t.is_finite() { a + along * t.clamp(0.0, 1.0) } else { a }
}

/// Whether a point of a triangle lies on its edge from `a` to `b`, or beyond it.
pub(super) fn is_on_edge(p: DVec2, a: DVec2, b: DVec2) -> bool {
    let along = b - a;
    let (across, t) = (along.perp_dot(p - a), along.dot(p - a));
    let slack = ON_EDGE * along.length();
    across <= slack && t >= -slack && t <= along.length_squared() + slack
}
