//! Maps from one picture to another: by rectangles, or by the boxes and moments of outlines.

use glam::{DAffine2, DMat2, DVec2};

use super::silhouette::Silhouette;

/// A map must increase the overlap by this much over a simpler map to replace it.
const GAIN: f64 = 0.02;
/// Outlines rounder than this, as a ratio of spreads, have no longest direction.
const ROUND: f64 = 1.2;

/// Stretches one rectangle onto another.
pub(super) fn of_rectangles(from: (u32, u32), to: (u32, u32)) -> DAffine2 {
    let [from, to] = [from, to].map(|(width, height)| DVec2::new(f64::from(width), f64::from(height)));
    DAffine2::from_scale(to / from)
}

/// The map of one outline to another with the greatest overlap, from simple to complicated:
///
/// 1. Box to box. This matches a scaled copy exactly.
/// 2. The centroid and the mean spread: a translation and one scale. A single protruding part changes little.
/// 3. The centroid and all second moments, without rotation: the symmetric stretch that makes the spreads equal.
/// 4. The centroid, the mean spread and the longest axis, in either direction: a rotated copy.
pub(super) fn best(from: &Silhouette, to: &Silhouette) -> DAffine2 {
    let about_centroids = |linear: DMat2| DAffine2::from_mat2_translation(linear, to.centroid - linear * from.centroid);
    let scale = (trace(to.spread) / trace(from.spread)).sqrt();
    let stretch = (to.high - to.low) / (from.high - from.low);
    let boxes = DAffine2::from_scale(stretch);
    let boxes = DAffine2 { translation: to.low - stretch * from.low, ..boxes };
    let mut maps = vec![
        boxes,
        about_centroids(DMat2::from_diagonal(DVec2::splat(scale))),
        about_centroids(symmetric(from.spread, to.spread)),
    ];
    if let (Some(one), Some(other)) = (longest_axis(from.spread), longest_axis(to.spread)) {
        // The turn from one axis to the other, as a complex number.
        let turn = DVec2::new(one.dot(other), one.perp_dot(other));
        maps.extend(
            [turn, -turn]
                .map(|DVec2 { x, y }| about_centroids(DMat2::from_cols(DVec2::new(x, y), DVec2::new(-y, x)) * scale)),
        );
    }
    let overlaps = maps.into_iter().filter(DAffine2::is_finite).map(|map| (to.overlap(from, &map), map));
    let better = |best: (f64, DAffine2), next: (f64, DAffine2)| if next.0 > best.0 + GAIN { next } else { best };
    overlaps.reduce(better).map_or(boxes, |(_, map)| map)
}

fn trace(matrix: DMat2) -> f64 {
    matrix.x_axis.x + matrix.y_axis.y
}

/// The symmetric positive matrix A with A · from · A = to, both symmetric and positive: the optimal transport between
/// normal distributions of these covariances.
fn symmetric(from: DMat2, to: DMat2) -> DMat2 {
    let root = square_root(from);
    let inverse = root.inverse();
    inverse * square_root(root * to * root) * inverse
}

/// The square root of a symmetric positive matrix (Cayley and Hamilton).
fn square_root(matrix: DMat2) -> DMat2 {
    let root = matrix.determinant().max(0.0).sqrt();
    (matrix + DMat2::from_diagonal(DVec2::splat(root))) * (trace(matrix) + 2.0 * root).sqrt().recip()
}

/// The unit vector along the longest axis of a spread; `None` if it is round.
fn longest_axis(spread: DMat2) -> Option<DVec2> {
    let mean = trace(spread) / 2.0;
    let (half, xy) = ((spread.x_axis.x - spread.y_axis.y) / 2.0, spread.x_axis.y);
    let radius = (half * half + xy * xy).sqrt();
    let (longest, shortest) = (mean + radius, mean - radius);
    if longest < ROUND * ROUND * shortest {
        return None;
    }
    // The longer of the two eigenvectors that the rows of the matrix give.
    let [one, other] = [DVec2::new(xy, radius - half), DVec2::new(radius + half, xy)];
    (if half > 0.0 { other } else { one }).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spread(xx: f64, xy: f64, yy: f64) -> DMat2 {
        DMat2::from_cols(DVec2::new(xx, xy), DVec2::new(xy, yy))
    }

    #[test]
    fn symmetric_stretch_makes_spreads_equal() {
        for (from, to) in [
            (spread(4.0, 0.0, 9.0), spread(16.0, 0.0, 9.0)),
            (spread(3.0, 1.0, 2.0), spread(5.0, -2.0, 4.0)),
            (spread(1.0, 0.0, 1.0), spread(1.0, 0.0, 1.0)),
        ] {
            let stretch = symmetric(from, to);
            assert!((stretch.x_axis.y - stretch.y_axis.x).abs() < 1e-12);
            assert!((stretch * from * stretch).abs_diff_eq(to, 1e-12));
        }
        assert!(symmetric(spread(4.0, 0.0, 9.0), spread(16.0, 0.0, 9.0)).abs_diff_eq(spread(2.0, 0.0, 1.0), 1e-12));
    }

    #[test]
    fn longest_axis_is_the_eigenvector_of_the_greatest_eigenvalue() {
        assert_eq!(longest_axis(spread(9.0, 0.0, 1.0)), Some(DVec2::X));
        assert_eq!(longest_axis(spread(1.0, 0.0, 9.0)), Some(DVec2::Y));
        assert_eq!(longest_axis(spread(2.0, 0.1, 2.0)), None);
        let axis = longest_axis(spread(3.0, 2.0, 5.0)).unwrap();
        let image = spread(3.0, 2.0, 5.0) * axis;
        assert!(axis.perp_dot(image).abs() < 1e-12 && image.dot(axis) > 5.0);
    }
}
