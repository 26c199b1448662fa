//! Maps single points between rest and pose: from a posed point to the point of the picture drawn there, and back.
//!
//! Within a triangle the map of the mesh is affine, so its inverse is exact. Triangles are searched from the last drawn
//! to the first, which finds the visible triangle if the picture covers itself.
//!
//! Cost: linear in the triangles, nearly all of which are ruled out by their bounding box.

use glam::DVec2;

use super::triangle::{Corners, barycentric, corners, interpolate, nearest_similarity};

/// A point of the picture and its drawn position, in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Correspondence {
    /// The point at rest.
    pub rest: DVec2,
    /// The position in the posed picture.
    pub posed: DVec2,
    /// Rotation, in degrees, of the similarity nearest to the map from rest to pose.
    pub rotation: f64,
    /// Scale of that similarity.
    pub scale: f64,
}

impl Correspondence {
    /// The located point in a triangle with these corners at rest and posed.
    pub(super) fn new(rest: DVec2, posed: DVec2, [from, to]: [Corners; 2]) -> Self {
        let (rotation, scale) = nearest_similarity(from, to);
        Self { rest, posed, rotation, scale }
    }
}

/// The triangles whose bounding box is at most `slack` away from a point, last drawn first.
pub(super) fn triangles_near<'a>(
    drawn: &'a [[u32; 3]],
    points: &'a [DVec2],
    at: DVec2,
    slack: f64,
) -> impl Iterator<Item = [u32; 3]> + 'a {
    let (low, high) = (at - slack, at + slack);
    let is_near = move |triangle: &[u32; 3]| {
        let [a, b, c] = corners(points, *triangle);
        let is_beside = |p: f64, q: f64, r: f64, low: f64, high: f64| {
            (p < low && q < low && r < low) || (p > high && q > high && r > high)
        };
        !is_beside(a.x, b.x, c.x, low.x, high.x) && !is_beside(a.y, b.y, c.y, low.y, high.y)
    };
    drawn.iter().rev().copied().filter(is_near)
}

/// The last drawn triangle around a point, and the barycentric coordinates there.
pub(super) fn triangle_at(drawn: &[[u32; 3]], points: &[DVec2], at: DVec2) -> Option<([u32; 3], [f64; 3])> {
    triangles_near(drawn, points, at, 0.0)
        .find_map(|triangle| Some((triangle, barycentric(corners(points, triangle), at)?)))
}

/// The point of the picture that is drawn at a point; `None` beside the picture.
pub(super) fn locate(rest: &[DVec2], posed: &[DVec2], drawn: &[[u32; 3]], at: DVec2) -> Option<Correspondence> {
    let (triangle, coordinates) = triangle_at(drawn, posed, at)?;
    let both = [rest, posed].map(|points| corners(points, triangle));
    Some(Correspondence::new(interpolate(both[0], coordinates), at, both))
}

/// Like [`locate`]; beside the picture, the similarity at the nearest vertex is continued. `None` without triangles.
pub(super) fn locate_near(rest: &[DVec2], posed: &[DVec2], drawn: &[[u32; 3]], at: DVec2) -> Option<Correspondence> {
    if let Some(inside) = locate(rest, posed, drawn, at) {
        return Some(inside);
    }
    let mut nearest = None;
    let mut least = f64::INFINITY;
    for &triangle in drawn {
        for vertex in triangle {
            let away = posed[vertex as usize].distance_squared(at);
            if away < least {
                (nearest, least) = (Some((triangle, vertex as usize)), away);
            }
        }
    }
    let (triangle, vertex) = nearest?;
    let both = [rest, posed].map(|points| corners(points, triangle));
    Some(similar(Correspondence::new(rest[vertex], posed[vertex], both), at))
}

/// The point that is drawn at a point if the similarity of another point is continued there.
pub(super) fn similar(near: Correspondence, at: DVec2) -> Correspondence {
    let (sin, cos) = libm::sincos(-near.rotation.to_radians());
    let back = DVec2::new(cos, sin) / near.scale.max(f64::EPSILON);
    Correspondence { rest: near.rest + back.rotate(at - near.posed), posed: at, ..near }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A unit square of two triangles.
    const SQUARE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    const TRIANGLES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

    /// Doubled and turned by a quarter about the origin, then moved by (10, 0).
    fn turned(p: DVec2) -> DVec2 {
        2.0 * p.perp() + DVec2::new(10.0, 0.0)
    }

    fn assert_near(found: Option<Correspondence>, rest: [f64; 2]) {
        let found = found.expect("a place of the picture");
        assert!(found.rest.distance(rest.into()) < 1e-12, "{found:?}");
        assert!((found.rotation - 90.0).abs() < 1e-9 && (found.scale - 2.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn locate_inverts_the_map_and_returns_its_similarity() {
        let posed = SQUARE.map(turned);
        let at = turned(DVec2::new(0.25, 0.75));
        assert_near(locate(&SQUARE, &posed, &TRIANGLES, at), [0.25, 0.75]);
        assert_eq!(locate(&SQUARE, &posed, &TRIANGLES, DVec2::new(2.0, 2.0)), None);
    }

    #[test]
    fn locate_near_extrapolates_the_nearest_part() {
        let posed = SQUARE.map(turned);
        let at = turned(DVec2::new(3.0, 0.5));
        assert_near(locate_near(&SQUARE, &posed, &TRIANGLES, at), [3.0, 0.5]);
        assert_eq!(locate_near(&SQUARE, &posed, &[], at), None);
    }

    #[test]
    fn locate_finds_the_last_drawn_triangle() {
        let rest = [SQUARE.as_slice(), &[DVec2::splat(5.0)]].concat();
        let posed = [SQUARE.as_slice(), &[DVec2::new(0.0, 0.5)]].concat();
        let found = locate(&rest, &posed, &[[0, 1, 2], [0, 2, 3], [4, 1, 2]], DVec2::new(0.9, 0.5));
        assert!(found.is_some_and(|found| found.rest.x > 1.0), "{found:?}");
    }
}
