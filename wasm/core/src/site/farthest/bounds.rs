//! Bounds of distances in a triangle, from their values at its corners.

use glam::DVec3;

/// Upper bound of a 1-Lipschitz function in a triangle with edges no longer than `longest`, from its values at the
/// corners.
pub(super) fn lipschitz_bound(values: &[f64; 3], longest: f64) -> f64 {
    // The value at a point with barycentric coordinates λ is at most Σ λᵢ (valueᵢ + distanceᵢ), with distanceᵢ to
    // cornerᵢ. By Jensen's inequality Σ λᵢ distanceᵢ is at most √Σ λᵢ distanceᵢ². That is at most longest · √Σ λᵢ λⱼ
    // over the pairs. The greatest of these sums for any λ:
    let mean = values.iter().sum::<f64>() / 3.0;
    let spread: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    mean + ((2.0 * spread + longest * longest) / 3.0).sqrt()
}

/// Greatest depth of a cone below the plane through three of its points. The edges between these are no longer than
/// `longest`, and none of the points is nearer to the apex than `distance`.
pub(super) fn cone_sag(longest: f64, distance: f64) -> f64 {
    // Along a level line the curvature of a cone is 1 / distance. The circumradius of the triangle counts up to
    // longest / √3; if it is greater, most of the circle lies outside the triangle.
    if distance > longest { longest * longest / (6.0 * (distance - longest)) } else { f64::INFINITY }
}

/// The part of a convex polygon where a linear function is non-negative.
pub(super) fn clipped(polygon: &[DVec3], height: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (height(a), height(b));
        if from >= 0.0 {
            part.push(a);
        }
        if (from < 0.0) != (to < 0.0) {
            part.push(a.lerp(b, from / (from - to)));
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn cone_sags_no_more_than_its_bound() {
        let value = |p: DVec2| p.length();
        // Triangles with edges of at most 1: the longest edge along a level line or across it, beyond the distance.
        let shapes = [
            [(0.0, 0.5), (0.0, -0.5), (0.8, 0.0)],
            [(0.0, 0.5), (0.0, -0.5), (-0.1, 0.0)],
            [(0.5, 0.0), (-0.5, 0.0), (0.0, 0.8)],
        ];
        for (distance, shape) in [2.0, 5.0, 40.0].into_iter().flat_map(|d| shapes.map(|shape| (d, shape))) {
            let corners = shape.map(|corner| DVec2::new(distance + 0.5, 0.0) + DVec2::from(corner));
            let nearest = corners.iter().map(|&corner| value(corner)).fold(f64::INFINITY, f64::min);
            for (s, t) in (0..=10).flat_map(|s| (0..=10 - s).map(move |t| (f64::from(s) / 10.0, f64::from(t) / 10.0))) {
                let barycentric = [s, t, 1.0 - s - t];
                let p = (0..3).map(|k| barycentric[k] * corners[k]).sum::<DVec2>();
                let plane = (0..3).map(|k| barycentric[k] * value(corners[k])).sum::<f64>();
                assert!(plane - value(p) <= cone_sag(1.0, nearest), "{} at {p}", plane - value(p));
            }
        }
    }

    #[test]
    fn lipschitz_bound_holds_and_is_reached_at_the_centroid() {
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.5, 0.75_f64.sqrt())].map(DVec2::from);
        let centroid = corners.iter().sum::<DVec2>() / 3.0;
        // The steepest distances are those of sites straight beyond the corners. From each corner they rise at slope 1.
        let steps =
            (0..=40).flat_map(|s| (0..=40 - s).map(move |t| [s, t, 40 - s - t].map(|part| f64::from(part) / 40.0)));
        for values in [[0.0; 3], [3.0; 3], [0.0, 0.3, 0.6], [0.0, 0.9, 0.4], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]] {
            let value = |p: DVec2| (0..3).map(|k| values[k] + corners[k].distance(p)).fold(f64::INFINITY, f64::min);
            let bound = lipschitz_bound(&values, 1.0);
            let point = |barycentric: [f64; 3]| (0..3).map(|k| barycentric[k] * corners[k]).sum();
            let greatest = steps.clone().map(|barycentric| value(point(barycentric))).fold(0.0, f64::max);
            assert!(greatest <= bound + 1e-12, "{greatest} of {bound} with {values:?}");
        }
        // Rounding of a few operations on numbers around 1.
        assert!((lipschitz_bound(&[3.0; 3], 1.0) - (3.0 + corners[0].distance(centroid))).abs() < 1e-12);
    }
}
