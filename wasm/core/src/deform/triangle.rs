//! Triangles by their corners: areas, barycentric coordinates and the similarity between two of them.

use glam::DVec2;

/// The corners of a triangle.
pub(super) type Corners = [DVec2; 3];

/// The corners of a triangle of a mesh.
pub(super) fn corners(points: &[DVec2], triangle: [u32; 3]) -> Corners {
    triangle.map(|vertex| points[vertex as usize])
}

/// Twice the signed area.
pub(super) fn doubled_area([a, b, c]: Corners) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Barycentric coordinates in a triangle of either orientation; `None` outside it, or if it has no area.
pub(super) fn barycentric([a, b, c]: Corners, p: DVec2) -> Option<[f64; 3]> {
    let area = doubled_area([a, b, c]);
    let (u, v) = ((b - p).perp_dot(c - p) / area, (c - p).perp_dot(a - p) / area);
    let coordinates = [u, v, 1.0 - u - v];
    // Without an area they are NaN, and no comparison holds.
    coordinates.iter().all(|&coordinate| coordinate >= 0.0).then_some(coordinates)
}

/// The point with these barycentric coordinates.
pub(super) fn interpolate([a, b, c]: Corners, [u, v, w]: [f64; 3]) -> DVec2 {
    u * a + v * b + w * c
}

/// The rotation in degrees and the scale of the similarity nearest to the affine map between two triangles.
///
/// For the Jacobian J it is [α −β; β α] with α = (J₁₁ + J₂₂)/2 and β = (J₂₁ − J₁₂)/2. The identity if `from` has no
/// area.
pub(super) fn nearest_similarity(from: Corners, to: Corners) -> (f64, f64) {
    let area = doubled_area(from);
    if area == 0.0 {
        return (0.0, 1.0);
    }
    let [[p, q], [s, t]] = [from, to].map(|[a, b, c]| [b - a, c - a]);
    let x_axis = (q.y * s - p.y * t) / area;
    let y_axis = (p.x * t - q.x * s) / area;
    let (cos, sin) = (f64::midpoint(x_axis.x, y_axis.y), (x_axis.y - y_axis.x) / 2.0);
    (libm::atan2(sin, cos).to_degrees(), libm::hypot(cos, sin))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn similarity_of_a_turned_and_scaled_triangle_is_exact() {
        let from = [[1.0, 2.0], [4.0, 2.5], [0.0, 7.0]].map(DVec2::from);
        let turn = crate::pose::turn(100_f64.to_radians());
        let to = from.map(|p| 2.5 * turn.rotate(p) + DVec2::new(30.0, -4.0));
        let (rotation, scale) = nearest_similarity(from, to);
        assert!((rotation - 100.0).abs() < 1e-9 && (scale - 2.5).abs() < 1e-12, "{rotation} {scale}");
        assert_eq!(nearest_similarity([DVec2::ONE; 3], to), (0.0, 1.0));
    }

    #[test]
    fn barycentric_coordinates_exist_inside_triangles_of_either_orientation() {
        let [a, b, c] = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(DVec2::from);
        let p = DVec2::new(1.0, 2.0);
        for corners in [[a, b, c], [a, c, b]] {
            let coordinates = barycentric(corners, p).expect("inside");
            assert_eq!(interpolate(corners, coordinates), p);
            assert_eq!(barycentric(corners, DVec2::new(3.0, 3.0)), None);
        }
        assert_eq!(barycentric([a, b, b], p), None);
    }
}
