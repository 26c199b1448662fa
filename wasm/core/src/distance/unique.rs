//! The distance up to which shortest paths from a source are unique: its injectivity radius.
//!
//! At the points of the cut locus, two ways around a hole are equally long. The distance to the nearest of them is half
//! the length of the shortest loop around a hole. Both paths to it are shortest, so its triangle has a window for each.
//!
//! In a triangle, the points that two windows see are a convex polygon. The greater of two distances is convex. Its
//! least value on the polygon is one of a few candidates in closed form.
//!
//! Cost: a test of every pair of windows of a triangle that are nearer than the result.

use glam::DVec2;

use super::{field::DistanceField, navigation::Navigation, window::Window};
use crate::segment::nearest_on_segment;

/// Windows meet along rays. Views that overlap by less than this, in pixels, share only a ray.
const OVERLAP: f64 = 1e-7;

impl DistanceField {
    /// The minimum distance of a point with two shortest paths. It is infinite if no such point lies within the bound.
    pub(crate) fn unique_radius(&self, navigation: &Navigation) -> f64 {
        let mut least = f64::INFINITY;
        for at in 0..self.triangles.len() {
            let windows = self.windows(self.range_at(at));
            for (i, one) in windows.iter().enumerate() {
                if one.nearest >= least {
                    break;
                }
                let others = windows[..i].iter().filter(|other| other.source != one.source);
                for other in others {
                    let corners = navigation.mesh.corners(self.triangles[at].0 as usize);
                    least = least.min(least_common_distance(one, other, corners));
                }
            }
        }
        if least <= self.bound { least } else { f64::INFINITY }
    }
}

/// The minimum distance at which both windows reach a common point of a triangle; infinite if they see no common point.
fn least_common_distance(one: &Window, other: &Window, corners: [DVec2; 3]) -> f64 {
    let mut seen: Vec<DVec2> = corners.to_vec();
    for window in [one, other] {
        seen = clipped(&seen, window.source, window.first);
        seen = clipped(&seen, window.source, -window.last);
        if seen.is_empty() {
            return f64::INFINITY;
        }
    }
    let both = |p: DVec2| [one, other].map(|window| window.offset + window.source.distance(p));
    let greater = |p: DVec2| both(p).into_iter().fold(0.0, f64::max);
    let mut least = f64::INFINITY;
    for (at, &a) in seen.iter().enumerate() {
        let b = seen[(at + 1) % seen.len()];
        let nearest = [one, other].map(|window| nearest_on_segment(window.source, a, b));
        for p in [a].into_iter().chain(nearest).chain(ties_on_segment(one, other, a, b)) {
            least = least.min(greater(p));
        }
    }
    // Halfway along the loop, if it is straight there.
    let between = one.source.distance(other.source);
    let halfway = one.source.lerp(other.source, (other.offset + between - one.offset) / (2.0 * between));
    let is_inside = (0..seen.len()).all(|at| {
        let (a, b) = (seen[at], seen[(at + 1) % seen.len()]);
        (b - a).perp_dot(halfway - a) >= 0.0
    });
    if is_inside { least.min(greater(halfway)) } else { least }
}

/// The part of a convex polygon on the positive side of a ray, by more than [`OVERLAP`].
fn clipped(polygon: &[DVec2], source: DVec2, ray: DVec2) -> Vec<DVec2> {
    let depth = |p: DVec2| ray.perp_dot(p - source) - OVERLAP;
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (at, &p) in polygon.iter().enumerate() {
        let q = polygon[(at + 1) % polygon.len()];
        let (here, there) = (depth(p), depth(q));
        if here >= 0.0 {
            part.push(p);
        }
        if (here >= 0.0) != (there >= 0.0) {
            part.push(p.lerp(q, here / (here - there)));
        }
    }
    part
}

/// The points of a segment at which both windows may reach equally far. Squaring adds spurious points.
fn ties_on_segment(one: &Window, other: &Window, a: DVec2, b: DVec2) -> impl Iterator<Item = DVec2> {
    let along = b - a;
    let (from_one, from_other) = (a - one.source, a - other.source);
    // √q₁ − √q₂ = δ, with squared distances q. So q₁ − q₂ − δ² = 2 δ √q₂, and the left side is linear.
    let delta = other.offset - one.offset;
    let slope = 2.0 * along.dot(from_one - from_other);
    let start = from_one.length_squared() - from_other.length_squared() - delta * delta;
    let factor = 4.0 * delta * delta;
    let quadratic = slope * slope - factor * along.length_squared();
    let linear = 2.0 * (slope * start - factor * along.dot(from_other));
    let constant = start * start - factor * from_other.length_squared();
    let root = (linear * linear - 4.0 * quadratic * constant).max(0.0).sqrt();
    // One of the two forms of each root is free of cancellation.
    let sum = -0.5 * (linear + root.copysign(linear));
    let roots = [sum / quadratic, constant / sum];
    roots.into_iter().filter(|t| (0.0..=1.0).contains(t)).map(move |t| a + along * t)
}

#[cfg(test)]
mod tests {
    use super::super::Propagation;
    use super::*;
    use crate::domain::Domain;

    fn square(low: f64, high: f64) -> Vec<DVec2> {
        [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec()
    }

    fn unique_radius(rings: &[Vec<DVec2>], source: (f64, f64), bound: f64) -> f64 {
        let navigation = Navigation::new(&Domain::from_rings(rings).unwrap());
        let (triangle, source) = navigation.locate(source.into()).unwrap();
        Propagation::default().field(&navigation, triangle, source, bound).unique_radius(&navigation)
    }

    #[test]
    fn paths_are_unique_up_to_half_the_shortest_loop() {
        let frame = [square(0.0, 100.0), square(30.0, 70.0)];
        // Beside the hole, at its corner, and before its corner.
        let loops = [
            ((10.0, 50.0), 2.0 * 800.0_f64.sqrt() + 120.0),
            ((30.0, 30.0), 160.0),
            ((10.0, 20.0), 3700.0_f64.sqrt() + 2900.0_f64.sqrt() + 80.0),
        ];
        for (source, length) in loops {
            let found = unique_radius(&frame, source, f64::INFINITY);
            assert!((found - length / 2.0).abs() < 1e-5, "{source:?}: {found} for {}", length / 2.0);
        }
        assert_eq!(unique_radius(&frame, (10.0, 50.0), 80.0), f64::INFINITY);
        assert_eq!(unique_radius(&frame[..1], (10.0, 50.0), f64::INFINITY), f64::INFINITY);
    }

    #[test]
    fn paths_in_a_domain_without_holes_are_unique() {
        let comb = [
            (0.0, 0.0),
            (90.0, 0.0),
            (90.0, 50.0),
            (60.0, 50.0),
            (60.0, 20.0),
            (30.0, 20.0),
            (30.0, 50.0),
            (0.0, 50.0),
        ];
        let rings = [comb.map(DVec2::from).to_vec()];
        for source in [(15.0, 45.0), (30.0, 20.0), (0.0, 20.0), (45.0, 10.0), (60.0, 50.0), (89.0, 1.0)] {
            assert_eq!(unique_radius(&rings, source, f64::INFINITY), f64::INFINITY, "{source:?}");
        }
    }
}
