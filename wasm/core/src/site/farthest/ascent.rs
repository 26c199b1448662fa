//! The farthest points of a cell in a triangle, by ascent of the distance.
//!
//! The distance to a site is the minimum of a few cones `offset + |p − pseudo_source|`. In a triangle, a cell's
//! farthest point is a corner or a point where cones intersect: three of them, or two on an edge. A sequence of linear
//! programs finds it, as in successive linear programming: the tangent plane replaces each cone. Each step ascends one
//! of the site's own cones as far as it remains the minimum of the tangent planes. It converges as Newton's method
//! does.
//!
//! So the positions of virtual sites hardly depend on the positions of the coarse samples.
//!
//! Cost: about five steps, each a linear program in the number of cones.

use glam::DVec2;

use super::linear_program::{Constraint, Fork, farthest_step};
use crate::min_max::fast_max;

/// A cone `offset + |p − apex|`: the length of the paths whose last bend is at one pseudo-source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cone {
    pub(super) apex: DVec2,
    pub(super) offset: f64,
}

impl Cone {
    /// The tangent plane of the cone at a point.
    fn tangent(&self, p: DVec2) -> Tangent {
        Tangent { value: self.offset + p.distance(self.apex), gradient: (p - self.apex).normalize_or_zero() }
    }
}

/// The tangent plane of a cone.
struct Tangent {
    value: f64,
    gradient: DVec2,
}

/// The cones at a point.
#[derive(Debug)]
pub(super) struct Cones {
    /// Cones of the cell's own site.
    pub(super) own: Vec<Cone>,
    /// Cones of other sites.
    pub(super) others: Vec<Cone>,
}

/// Initial capacity for cones; usually only a few meet.
const CAPACITY: usize = 16;
/// Maximum number of steps. Three intersecting cones take five; only cones that touch take more.
const MAX_STEPS: usize = 16;
/// A step shorter than this, relative to the longest edge, ends the ascent.
const CONVERGED: f64 = 1e-12;
/// If cones intersect at a small angle, rounding errors keep the steps longer than that. An ascent fails if its last
/// step is longer than this, relative to the longest edge.
const ACCEPTED: f64 = 1e-6;

/// Ascends a cell's own cones, where they are the minimum of all, in a triangle of positive orientation.
///
/// `cones_at` lists the cones at a point. If two ascents lead equally far, for example from an axis of symmetry, both
/// are followed. Empty if no ascent converges.
pub(super) fn ascend(corners: &[DVec2; 3], from: DVec2, mut cones_at: impl FnMut(DVec2, &mut Cones)) -> Vec<DVec2> {
    let first = ascend_once(corners, from, &mut cones_at, Fork::First);
    let other = first.filter(|&(_, forked)| forked).and_then(|_| ascend_once(corners, from, &mut cones_at, Fork::Last));
    first.into_iter().chain(other).map(|(maximum, _)| maximum).collect()
}

/// One ascent. Returns its maximum, and whether any step had an equally good alternative.
fn ascend_once(
    corners: &[DVec2; 3],
    from: DVec2,
    cones_at: &mut impl FnMut(DVec2, &mut Cones),
    fork: Fork,
) -> Option<(DVec2, bool)> {
    let [a, b, c] = *corners;
    let longest = fast_max(fast_max(a.distance(b), b.distance(c)), c.distance(a));
    let (mut p, mut forked) = (from, false);
    let mut cones = Cones { own: Vec::with_capacity(CAPACITY), others: Vec::with_capacity(CAPACITY) };
    let mut constraints = Vec::with_capacity(2 * CAPACITY);
    let mut last = f64::INFINITY;
    for _ in 0..MAX_STEPS {
        cones.own.clear();
        cones.others.clear();
        cones_at(p, &mut cones);
        // Own cones intersect where paths on both sides of a hole are equally long. Take the one whose step leads
        // farthest.
        let mut best: Option<(f64, DVec2, bool)> = None;
        for cone in &cones.own {
            let tangent = cone.tangent(p);
            let others = cones.others.iter().chain(&cones.own).filter(|other| *other != cone);
            constrain(&mut constraints, corners, p, &tangent, others.map(|other| other.tangent(p)));
            let Some((step, other)) = farthest_step(tangent.gradient, &constraints, longest, fork) else { continue };
            let reached = tangent.value + tangent.gradient.dot(step);
            if best.is_none_or(|(known, ..)| reached > known) {
                best = Some((reached, step, other));
            }
        }
        let (_, step, other) = best?;
        forked |= other;
        p += step;
        last = step.length();
        if last <= CONVERGED * longest {
            break;
        }
    }
    (last <= ACCEPTED * longest).then_some((p, forked))
}

/// Sets the constraints of a step from `p` up a cone. By the tangent planes, the cone stays below the other cones; the
/// step stays in the triangle.
fn constrain(
    constraints: &mut Vec<Constraint>,
    corners: &[DVec2; 3],
    p: DVec2,
    own: &Tangent,
    others: impl Iterator<Item = Tangent>,
) {
    let up = own.gradient;
    // The greatest component, in a direction, of a step within the triangle.
    let extent = |normal: DVec2| corners.iter().map(|&v| normal.dot(v - p)).fold(f64::NEG_INFINITY, fast_max);
    let below = others.map(|other| Constraint::new(up, up - other.gradient, other.value - own.value));
    constraints.clear();
    constraints.extend(below.filter(|constraint| constraint.limit < extent(constraint.normal)));
    let [a, b, c] = *corners;
    constraints.extend([(a, b), (b, c), (c, a)].map(|(from, to)| {
        let normal = -(to - from).normalize().perp();
        Constraint::new(up, normal, normal.dot(from - p))
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The maxima found in a triangle. The first cone is the cell's own.
    fn maxima(corners: [(f64, f64); 3], from: (f64, f64), cones: &[Cone]) -> Vec<DVec2> {
        ascend(&corners.map(DVec2::from), from.into(), |_, seen| {
            seen.own.extend(&cones[..1]);
            seen.others.extend(&cones[1..]);
        })
    }

    fn cone(x: f64, y: f64, offset: f64) -> Cone {
        Cone { apex: DVec2::new(x, y), offset }
    }

    #[test]
    fn three_sources_meet_at_the_centre_of_their_circle() {
        let centre = DVec2::new(3.0, 4.0);
        let on_circle = |x: f64, y: f64| Cone { apex: centre + 50.0 * DVec2::new(x, y), offset: 0.0 };
        let mut cones = [on_circle(1.0, 0.0), on_circle(-0.6, 0.8), on_circle(-0.6, -0.8)];
        for _ in 0..3 {
            cones.rotate_left(1);
            let found = maxima([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
            assert!(found.len() == 1 && found[0].distance(centre) < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn hundreds_of_sources_on_one_circle_meet_at_its_centre() {
        let centre = DVec2::new(3.0, 4.0);
        let around = |i: i32| {
            let (sin, cos) = libm::sincos(f64::from(i).to_radians());
            Cone { apex: centre + 50.0 * DVec2::new(cos, sin), offset: 0.0 }
        };
        let mut cones: Vec<Cone> = (0..360).map(around).collect();
        for _ in 0..3 {
            cones.rotate_left(95);
            let found = maxima([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
            assert!(!found.is_empty() && found.iter().all(|maximum| maximum.distance(centre) < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn two_equally_good_ascents_are_both_followed() {
        let cones = [cone(0.0, 0.0, 0.0), cone(0.0, 100.0, 0.0), cone(-60.0, 30.0, 0.0), cone(60.0, 30.0, 0.0)];
        let found = maxima([(-40.0, 20.0), (40.0, 20.0), (0.0, 80.0)], (0.0, 45.0), &cones);
        let &[one, other] = &found[..] else { panic!("two ways: {found:?}") };
        assert!(one.distance(DVec2::new(-other.x, other.y)) < 1e-9 && one.x.abs() > 5.0, "{one} and {other}");
    }

    #[test]
    fn two_sources_meet_halfway_along_an_edge() {
        let found =
            maxima([(4.0, 0.0), (7.0, 0.0), (5.0, 2.0)], (5.5, 0.5), &[cone(0.0, 5.0, 0.0), cone(10.0, 5.0, 0.0)]);
        assert!(found.len() == 1 && found[0].distance(DVec2::new(5.0, 0.0)) < 1e-12, "{found:?}");
    }

    #[test]
    fn cell_ends_at_its_neighbour_though_distances_rise_beyond() {
        let found =
            maxima([(3.0, 0.0), (8.0, 0.0), (4.0, 0.5)], (4.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        // 3 + s = √(s² + 25), so s = 16 / 6. The edge begins beyond that, so the cell has no point in the triangle.
        assert!(found.is_empty(), "{found:?}");
        let found =
            maxima([(1.0, 0.0), (8.0, 0.0), (2.0, 0.5)], (2.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        assert!(found.len() == 1 && found[0].distance(DVec2::new(16.0 / 6.0, 0.0)) < 1e-12, "{found:?}");
    }

    #[test]
    fn single_cone_is_farthest_at_a_corner() {
        let found = maxima([(3.0, 0.0), (8.0, 1.0), (4.0, 2.0)], (5.0, 1.0), &[cone(0.0, 0.0, 0.0)]);
        assert_eq!(found, [DVec2::new(8.0, 1.0)]);
    }
}
