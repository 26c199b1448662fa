//! Rings: closed chains of points.

use glam::DVec2;

/// A closed chain of at least three points. The first point is not repeated.
///
/// In a [`Domain`](super::Domain), outer rings have a positive signed area and holes a negative one. Along such a
/// ring in the y-down image, the domain is on the right. A ring from a caller may have either orientation.
pub type Ring = Vec<DVec2>;

/// Signed area of a ring: positive for an outer ring, negative for a hole.
pub(crate) fn signed_area(ring: &[DVec2]) -> f64 {
    let Some(&origin) = ring.first() else { return 0.0 };
    edges(ring).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum::<f64>() / 2.0
}

/// The edges of a ring, the closing one last.
pub(crate) fn edges(ring: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| (a, b))
}

/// The corners of a ring, each between its neighbours.
pub(crate) fn corners_between<T: Copy>(ring: &[T]) -> impl Iterator<Item = [T; 3]> + '_ {
    let n = ring.len();
    (0..n).map(move |i| [i + n - 1, i, i + 1].map(|at| ring[at % n]))
}

/// Whether a point lies inside a ring, by the even-odd rule.
pub(crate) fn contains(ring: &[DVec2], p: DVec2) -> bool {
    edges(ring).fold(false, |inside, (a, b)| {
        let crosses = (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        inside != crosses
    })
}
