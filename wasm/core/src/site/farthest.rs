//! The farthest points of a cell, between the samples too.
//!
//! Around a sample the distance to a site is the least of a few cones `offset + |p − pseudo_source|`. A cell's farthest point
//! lies where cones meet: three of them, or two on the outline. From a sample near it a sequence of linear programs finds it:
//! each step climbs one of the site's cones as far as the tangent planes say that it stays the least of all. It converges as
//! Newton's method does.
//!
//! So the places of virtual sites hardly depend on where the samples happen to lie.

use glam::DVec2;

/// A cone `offset + |p − apex|`: the distance by way of one pseudo-source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cone {
    pub(super) apex: DVec2,
    pub(super) offset: f64,
}

impl Cone {
    fn value(&self, p: DVec2) -> f64 {
        self.offset + p.distance(self.apex)
    }

    fn gradient(&self, p: DVec2) -> DVec2 {
        (p - self.apex).normalize_or_zero()
    }
}

/// Steps at most. Three meeting cones take five; more are only spent where cones touch.
const STEPS: usize = 16;
/// A step shorter than this share of the way allowed ends the climb.
const CONVERGED: f64 = 1e-12;

/// A piece of the outline; the domain lies on the side of its `perp`.
pub(super) type Wall = (DVec2, DVec2);

/// Climbs a cone where it is the least of all `cones`, within a square of half side `reach` around `start` and, as if they
/// had no ends, behind the `walls`. Where two ways lead as far, as they do from an axis of symmetry, it goes both.
pub(super) fn climb(cone: &Cone, cones: &[Cone], walls: &[Wall], start: DVec2, reach: f64) -> (DVec2, Option<DVec2>) {
    let (first, forked) = climb_one(cone, cones, walls, start, reach, Fork::First);
    (first, forked.then(|| climb_one(cone, cones, walls, start, reach, Fork::Last).0))
}

/// Which of several steps that go as far is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fork {
    First,
    Last,
}

/// One way up, and whether there was another.
fn climb_one(cone: &Cone, cones: &[Cone], walls: &[Wall], start: DVec2, reach: f64, fork: Fork) -> (DVec2, bool) {
    let (mut p, mut forked) = (start, false);
    let mut sides = Vec::with_capacity(cones.len() + 4);
    for _ in 0..STEPS {
        let (value, gradient) = (cone.value(p), cone.gradient(p));
        let others = cones.iter().filter(|other| *other != cone);
        // How far a step within the square goes in a direction, at most.
        let (low, high) = (start - p - reach, start - p + reach);
        let room = |normal: DVec2| (normal * low).max(normal * high).element_sum();
        let side = |other: &Cone| {
            let side = Side::new(gradient, gradient - other.gradient(p), other.value(p) - value);
            (side.limit < room(side.normal)).then_some(side)
        };
        sides.clear();
        sides.extend(others.filter_map(side));
        let square = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
        sides.extend(square.map(|normal| Side::new(gradient, normal, reach - normal.dot(p - start))));
        sides.extend(walls.iter().map(|&(a, b)| {
            let normal = -(b - a).normalize().perp();
            Side::new(gradient, normal, normal.dot(a - p))
        }));
        let Some((step, other)) = farthest_step(gradient, &sides, reach, fork) else { break };
        forked |= other;
        p += step;
        if step.length() <= CONVERGED * reach {
            break;
        }
    }
    (p, forked)
}

/// Climbs a cone along the segment from `a` to `b` where it is the least of all `cones`. It begins in the middle: an end may
/// be the apex of a cone, a corner that paths bend at, where the cone has no tangent.
pub(super) fn climb_along(cone: &Cone, cones: &[Cone], a: DVec2, b: DVec2) -> DVec2 {
    let length = a.distance(b);
    let along = (b - a) / length;
    let mut s = length / 2.0;
    for _ in 0..STEPS {
        let p = a + along * s;
        let (value, slope) = (cone.value(p), cone.gradient(p).dot(along));
        let (mut low, mut high) = (-s, length - s);
        for other in cones.iter().filter(|other| *other != cone) {
            let (rise, limit) = (slope - other.gradient(p).dot(along), other.value(p) - value);
            if rise > 0.0 {
                high = high.min(limit / rise);
            } else if rise < 0.0 {
                low = low.max(limit / rise);
            }
        }
        if low > high {
            break;
        }
        let step = if slope >= 0.0 { high } else { low };
        s += step;
        if step.abs() <= CONVERGED * length {
            break;
        }
    }
    a + along * s
}

/// The condition `normal · step ≤ limit`.
#[derive(Debug, Clone, Copy)]
struct Side {
    normal: DVec2,
    limit: f64,
    /// On which side of the direction of the climb the normal stands: positive to the left.
    turn: f64,
}

impl Side {
    fn new(direction: DVec2, normal: DVec2, limit: f64) -> Self {
        Self { normal, limit, turn: direction.perp_dot(normal) }
    }
}

/// Sides whose normals stand to the left and to the right of a direction; along it within this sine, both.
const ALONG: f64 = 1e-5;
/// Steps differ, and gains do not, by this share of the reach.
const SAME_STEP: f64 = 1e-6;
const SAME_GAIN: f64 = 1e-12;

/// The step that goes farthest in a direction under all conditions: the best of the corners that two of them make. Also tells
/// whether another goes as far.
fn farthest_step(direction: DVec2, sides: &[Side], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    let slack = 1e-12 * reach;
    let mut best: Option<(f64, DVec2, bool)> = None;
    for (i, a) in sides.iter().enumerate() {
        for b in &sides[i + 1..] {
            let area = a.normal.perp_dot(b.normal);
            // A corner is the best where the direction lies between the normals of its sides.
            let (right, left) = if area > 0.0 { (a, b) } else { (b, a) };
            if area.abs() < 1e-9 || right.turn > ALONG || left.turn < -ALONG {
                continue;
            }
            let step = (a.limit * -b.normal.perp() + b.limit * a.normal.perp()) / area;
            let gain = direction.dot(step);
            let tie = SAME_GAIN * reach;
            let worse = best.is_some_and(|(known, ..)| gain < known - tie);
            if worse || sides.iter().any(|side| side.normal.dot(step) > side.limit + slack) {
                continue;
            }
            best = match best {
                Some((known, other, forked)) if gain <= known + tie => {
                    let forked = forked || step.distance(other) > SAME_STEP * reach;
                    if fork == Fork::Last { Some((gain, step, forked)) } else { Some((known, other, forked)) }
                }
                _ => Some((gain, step, false)),
            };
        }
    }
    best.map(|(_, step, forked)| (step, forked))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_sources_meet_at_the_centre_of_their_circle() {
        let centre = DVec2::new(3.0, 4.0);
        let on_circle = |x: f64, y: f64| Cone { apex: centre + 50.0 * DVec2::new(x, y), offset: 0.0 };
        let cones = [on_circle(1.0, 0.0), on_circle(-0.6, 0.8), on_circle(-0.6, -0.8)];
        for cone in &cones {
            let (top, _) = climb(cone, &cones, &[], centre + DVec2::new(2.0, -1.5), 10.0);
            assert!(top.distance(centre) < 1e-12);
        }
    }

    #[test]
    fn two_ways_that_lead_as_far_are_both_gone() {
        let cones = [(0.0, 0.0), (0.0, 100.0), (-60.0, 30.0), (60.0, 30.0)];
        let cones = cones.map(|apex| Cone { apex: apex.into(), offset: 0.0 });
        let (one, other) = climb(&cones[0], &cones, &[], DVec2::new(0.0, 45.0), 30.0);
        let other = other.expect("two ways");
        assert!(one.distance(DVec2::new(-other.x, other.y)) < 1e-9 && one.x.abs() > 5.0, "{one} and {other}");
    }

    #[test]
    fn two_sources_meet_halfway_along_a_wall() {
        let cones = [0.0, 10.0].map(|x| Cone { apex: DVec2::new(x, 5.0), offset: 0.0 });
        let top = climb_along(&cones[0], &cones, DVec2::new(4.0, 0.0), DVec2::new(7.0, 0.0));
        assert!(top.distance(DVec2::new(5.0, 0.0)) < 1e-12);
    }

    #[test]
    fn a_cell_ends_where_a_neighbour_is_as_near_though_distances_go_on_to_rise() {
        let bent = Cone { apex: DVec2::ZERO, offset: 3.0 };
        let above = Cone { apex: DVec2::new(0.0, 5.0), offset: 0.0 };
        let top = climb_along(&bent, &[bent, above], DVec2::ZERO, DVec2::new(8.0, 0.0));
        // 3 + s = √(s² + 25)
        assert!(top.distance(DVec2::new(16.0 / 6.0, 0.0)) < 1e-12);
    }
}
