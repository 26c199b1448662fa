//! The part of one triangle that a pseudo-source sees: the interval of optimality of Mitchell, Mount and Papadimitriou.

use glam::DVec2;

/// Points up to this far outside a window, in pixels, count as inside.
///
/// Windows meet along rays, and a point on such a ray must lie in one of them despite rounding. A path that cuts a
/// corner by this much is shorter by at most this much.
pub(crate) const WINDOW_SLACK: f64 = 1e-9;

/// A cone of directions from a pseudo-source, within one triangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Window {
    /// The pseudo-source.
    pub(crate) source: DVec2,
    /// Distance from the field's source to the pseudo-source.
    pub(crate) offset: f64,
    /// Unit direction of the cone's first ray. The cone turns positively from it to `last`, by at most π.
    pub(crate) first: DVec2,
    /// Unit direction of the cone's last ray.
    pub(crate) last: DVec2,
    /// Minimum distance of any point in the window. It orders the windows of a triangle.
    pub(crate) nearest: f64,
}

impl Window {
    /// Whether a point lies in the cone.
    pub(super) fn sees(&self, p: DVec2) -> bool {
        let to = p - self.source;
        self.first.perp_dot(to) >= -WINDOW_SLACK && to.perp_dot(self.last) >= -WINDOW_SLACK
    }

    /// Whether the window may contain a point of a box nearer than `radius`.
    pub(crate) fn may_reach(&self, low: DVec2, high: DVec2, radius: f64) -> bool {
        let (to_low, to_high) = (low - self.source, high - self.source);
        // The corners of the box farthest to the left of the first ray, and to the right of the last.
        let left = |ray: DVec2| {
            DVec2::new(
                if ray.y > 0.0 { to_low.x } else { to_high.x }, //
                if ray.x > 0.0 { to_high.y } else { to_low.y },
            )
        };
        let nearest = DVec2::ZERO.clamp(to_low, to_high).length();
        self.first.perp_dot(left(self.first)) >= -WINDOW_SLACK
            && left(-self.last).perp_dot(self.last) >= -WINDOW_SLACK
            && self.offset + nearest < radius + WINDOW_SLACK
    }

    /// The part of a segment inside the cone, or `None` if it lies outside.
    pub(super) fn seen_part(&self, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
        let (to_a, to_b) = (a - self.source, b - self.source);
        let sides = [
            (self.first.perp_dot(to_a), self.first.perp_dot(to_b)),
            (to_a.perp_dot(self.last), to_b.perp_dot(self.last)),
        ];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (at_a, at_b) in sides.map(|(at_a, at_b)| (at_a + WINDOW_SLACK, at_b + WINDOW_SLACK)) {
            if at_a < 0.0 && at_b < 0.0 {
                return None;
            }
            if at_a < 0.0 {
                from = from.max(at_a / (at_a - at_b));
            } else if at_b < 0.0 {
                to = to.min(at_a / (at_a - at_b));
            }
        }
        (from <= to).then(|| (a.lerp(b, from), a.lerp(b, to)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn box_in_view_and_in_range_is_reachable() {
        let (low, high) = (DVec2::new(3.0, -2.0), DVec2::new(5.0, 1.0));
        let ray = |degrees: i32| {
            let (sin, cos) = libm::sincos(f64::from(degrees).to_radians());
            DVec2::new(cos, sin)
        };
        let points: Vec<DVec2> =
            (0..=20).flat_map(|i| (0..=20).map(move |j| (f64::from(i), f64::from(j)))).map(DVec2::from).collect();
        let (mut reached, mut passed) = (0, 0);
        for (from, width) in (0..360).step_by(15).flat_map(|from| [1, 20, 90, 180].map(|width| (from, width))) {
            for source in [DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(9.0, -7.0)] {
                let window = Window { source, offset: 2.0, first: ray(from), last: ray(from + width), nearest: 2.0 };
                for radius in [4.0, 6.0, 20.0] {
                    let at = |&fraction: &DVec2| low + fraction / 20.0 * (high - low);
                    let is_reached = |p: DVec2| window.sees(p) && window.offset + source.distance(p) < radius;
                    let may_reach = window.may_reach(low, high, radius);
                    assert!(may_reach || !points.iter().map(at).any(is_reached), "{source} {from} {width} {radius}");
                    *if may_reach { &mut reached } else { &mut passed } += 1;
                }
            }
        }
        assert!(reached > 100 && passed > 400, "{reached} and {passed}");
    }
}
