//! Distances to line segments, and between them.

use glam::DVec2;

/// The point of the segment from `a` to `b` nearest to `p`. The segment may have length 0.
pub(crate) fn nearest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let along = b - a;
    let t = (p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
    a + along * t.clamp(0.0, 1.0)
}

/// The distance of `p` to the segment from `a` to `b`.
pub(crate) fn segment_distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    p.distance(nearest_on_segment(p, a, b))
}

/// The distance between two segments: 0 if they cross.
pub(crate) fn distance_between([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let are_separated = |p: DVec2, q: DVec2, r: DVec2, s: DVec2| {
        let along = q - p;
        along.perp_dot(r - p) * along.perp_dot(s - p) < 0.0
    };
    if are_separated(a, b, c, d) && are_separated(c, d, a, b) {
        return 0.0;
    }
    let of_ends =
        [segment_distance(a, c, d), segment_distance(b, c, d), segment_distance(c, a, b), segment_distance(d, a, b)];
    of_ends.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_between_segments_is_that_of_their_nearest_points() {
        let apart = |one: [(f64, f64); 2], other: [(f64, f64); 2]| {
            let [one, other] = [one, other].map(|ends| ends.map(DVec2::from));
            [distance_between(one, other), distance_between(other, one)]
        };
        let level = [(0.0, 0.0), (10.0, 0.0)];
        assert_eq!(apart(level, [(4.0, -3.0), (5.0, 100.0)]), [0.0; 2]);
        assert_eq!(apart(level, [(4.0, 3.0), (5.0, 100.0)]), [3.0; 2]);
        assert_eq!(apart(level, [(13.0, 4.0), (13.0, 50.0)]), [5.0; 2]);
        assert_eq!(apart(level, [(-20.0, 2.0), (30.0, 2.0)]), [2.0; 2]);
        assert_eq!(apart(level, [(12.0, 0.0), (15.0, 0.0)]), [2.0; 2]);
    }
}
