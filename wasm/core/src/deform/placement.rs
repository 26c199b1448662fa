//! Positions for handles: on the part of the picture that bends. Handles cannot be placed on the skirt around it, which
//! holds the soft edges.
//!
//! Cost: linear in the triangles.

use glam::DVec2;

use super::{
    locate::{Correspondence, triangles_near},
    triangle::{Corners, barycentric, corners, interpolate},
};

/// Least barycentric coordinate of a position on the border of a triangle: far enough inside to be safe from rounding.
const INWARDS: f64 = 0.05;

/// Returns the position itself if it bends. On the skirt beside the bending part, and up to `within` away from it,
/// returns the nearest position that bends; `None` farther away. The first `samples` vertices bend.
pub(super) fn placement(
    [rest, posed]: [&[DVec2]; 2],
    drawn: &[[u32; 3]],
    samples: usize,
    at: DVec2,
    within: f64,
) -> Option<Correspondence> {
    let bends = |triangle: &[u32; 3]| triangle.iter().all(|&vertex| (vertex as usize) < samples);
    let skirt = triangles_near(drawn, posed, at, 0.0)
        .filter(|triangle| !bends(triangle))
        .filter(|&triangle| barycentric(corners(posed, triangle), at).is_some());
    let nearest_sample = |triangle: [u32; 3]| {
        let samples = triangle.into_iter().filter(|&vertex| (vertex as usize) < samples);
        samples.map(|vertex| at.distance(posed[vertex as usize])).fold(f64::INFINITY, f64::min)
    };
    let distances = skirt.map(nearest_sample).filter(|distance| distance.is_finite());
    let radius = distances.fold(within, f64::max);
    let mut nearest: Option<([u32; 3], Nearest)> = None;
    for triangle in triangles_near(drawn, posed, at, radius).filter(bends) {
        let found = Nearest::new(corners(posed, triangle), at);
        if found.distance <= radius && nearest.as_ref().is_none_or(|(_, best)| found.distance < best.distance) {
            nearest = Some((triangle, found));
        }
    }
    let (triangle, Nearest { coordinates, distance }) = nearest?;
    let both = [rest, posed].map(|points| corners(points, triangle));
    let place = if distance == 0.0 { at } else { interpolate(both[1], coordinates) };
    Some(Correspondence::new(interpolate(both[0], coordinates), place, both))
}

/// The position in a triangle nearest to a point.
#[derive(Debug, Clone, Copy)]
struct Nearest {
    /// Barycentric; on the border moved [`INWARDS`].
    coordinates: [f64; 3],
    /// Distance from the point to the border; 0 inside.
    distance: f64,
}

impl Nearest {
    fn new(triangle: Corners, p: DVec2) -> Self {
        if let Some(coordinates) = barycentric(triangle, p) {
            return Self { coordinates, distance: 0.0 };
        }
        let mut nearest = Self { coordinates: [0.0; 3], distance: f64::INFINITY };
        for edge in 0..3 {
            let next = (edge + 1) % 3;
            let (from, along) = (triangle[edge], triangle[next] - triangle[edge]);
            let squared = along.length_squared();
            let foot = if squared == 0.0 { 0.0 } else { (p - from).dot(along) / squared };
            let fraction = foot.clamp(0.0, 1.0);
            let distance = p.distance(from + fraction * along);
            if distance < nearest.distance {
                let mut coordinates = [INWARDS; 3];
                coordinates[edge] += (1.0 - 3.0 * INWARDS) * (1.0 - fraction);
                coordinates[next] += (1.0 - 3.0 * INWARDS) * fraction;
                nearest = Self { coordinates, distance };
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A unit square of two triangles, and a skirt of one more that extends 2 beyond its right side.
    const REST: [DVec2; 5] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y, DVec2::new(3.0, 0.5)];
    const TRIANGLES: [[u32; 3]; 3] = [[1, 4, 2], [0, 1, 2], [0, 2, 3]];
    const SAMPLES: usize = 4;

    /// Twice as large, and moved by (10, 0).
    fn posed() -> [DVec2; 5] {
        REST.map(|p| 2.0 * p + DVec2::new(10.0, 0.0))
    }

    fn at(x: f64, y: f64, within: f64) -> Option<Correspondence> {
        placement([&REST, &posed()], &TRIANGLES, SAMPLES, DVec2::new(x, y), within)
    }

    #[test]
    fn bending_position_near_the_border_is_kept() {
        let found = at(11.99, 0.5, 0.0).expect("inside");
        assert_eq!(found.posed, DVec2::new(11.99, 0.5));
        assert!(found.rest.distance(DVec2::new(0.995, 0.25)) < 1e-9 && (found.scale - 2.0).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn position_on_the_skirt_moves_just_inside_the_border() {
        let found = at(13.0, 1.0, 0.0).expect("the skirt");
        assert!(found.posed.x > 11.8 && found.posed.x < 12.0, "{found:?}");
        assert!((found.rest.x - (found.posed.x - 10.0) / 2.0).abs() < 1e-9, "{found:?}");
        assert!((found.rest.y - 0.5).abs() < 0.05, "{found:?}");
    }

    #[test]
    fn position_beside_the_picture_moves_at_most_by_the_radius() {
        assert_eq!(at(9.5, 1.0, 0.4), None);
        assert!(at(9.5, 1.0, 0.6).is_some_and(|found| found.posed.x > 10.0));
        assert_eq!(at(9.0, 3.0, 1.3), None);
        let corner = at(9.0, 3.0, 1.5).expect("within the radius");
        assert!(corner.rest.x > 0.0 && corner.rest.y < 1.0, "{corner:?}");
    }

    #[test]
    fn position_under_the_skirt_is_kept() {
        let mut covered = posed();
        // The skirt folds back over the square.
        covered[4] = DVec2::new(10.0, 1.0);
        let place = DVec2::new(11.5, 1.0);
        let found = placement([&REST, &covered], &TRIANGLES, SAMPLES, place, 0.0);
        assert_eq!(found.map(|found| found.posed), Some(place));
    }
}
