//! Shapes as signed distances, positive inside, and their pixels.

use glam::DVec2;

/// Returns the alpha of each pixel: the fraction of it inside the shape, from the signed distance at its centre.
pub(crate) fn coverage(depth: impl Fn(DVec2) -> f64) -> impl Fn(u32, u32) -> u8 {
    move |x, y| {
        let centre = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
        (255.0 * (depth(centre) + 0.5).clamp(0.0, 1.0)).round() as u8
    }
}

/// A disc.
pub(crate) fn disc(centre: DVec2, radius: f64) -> impl Fn(DVec2) -> f64 {
    move |p| radius - p.distance(centre)
}

/// A stroke with round ends.
pub(crate) fn stroke(a: DVec2, b: DVec2, width: f64) -> impl Fn(DVec2) -> f64 {
    move |p| {
        let along = b - a;
        let t = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        width / 2.0 - p.distance(a + along * t)
    }
}
