//! The farthest points of a cell in a triangle.
//!
//! The distance to a site is the least of a few cones `offset + |p − pseudo_source|`. In a triangle a cell's farthest point lies
//! where cones meet: three of them, or two on an edge; or in a corner. A sequence of linear programs finds it: each step climbs one
//! of the site's cones as far as the tangent planes say that it stays the least of all. It converges as Newton's method does.
//!
//! So the places of virtual sites hardly depend on where the scouts happen to lie.

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

/// The cones that see a place.
#[derive(Debug)]
pub(super) struct Cones {
    /// Those of the cell's own site.
    pub(super) own: Vec<Cone>,
    /// Those of others.
    pub(super) others: Vec<Cone>,
}

/// Cones that there is room for from the beginning; a few meet, as a rule.
const ROOM: usize = 16;
/// Steps at most. Three meeting cones take five; more are only spent where cones touch.
const STEPS: usize = 16;
/// A step shorter than this share of the longest edge ends the climb.
const CONVERGED: f64 = 1e-12;
/// Where cones meet at a small angle, rounding keeps steps longer than that; beyond this share the climb has failed.
const SETTLED: f64 = 1e-6;

/// Climbs a cell's own cones where they are the least of all, in a triangle that winds positively. `cones_at` puts down the cones that
/// see a place. Where two ways lead as far, as they do from an axis of symmetry, it goes both. Empty where nothing is found.
pub(super) fn climb(corners: &[DVec2; 3], from: DVec2, mut cones_at: impl FnMut(DVec2, &mut Cones)) -> Vec<DVec2> {
    let first = climb_one(corners, from, &mut cones_at, Fork::First);
    let other = first.filter(|&(_, forked)| forked).and_then(|_| climb_one(corners, from, &mut cones_at, Fork::Last));
    first.into_iter().chain(other).map(|(top, _)| top).collect()
}

/// Which of several steps that go as far is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fork {
    First,
    Last,
}

/// One way up, and whether there was another.
fn climb_one(
    corners: &[DVec2; 3],
    from: DVec2,
    cones_at: &mut impl FnMut(DVec2, &mut Cones),
    fork: Fork,
) -> Option<(DVec2, bool)> {
    let [a, b, c] = *corners;
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    let (mut p, mut forked) = (from, false);
    let mut cones = Cones { own: Vec::with_capacity(ROOM), others: Vec::with_capacity(ROOM) };
    let mut sides = Vec::with_capacity(2 * ROOM);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        cones.own.clear();
        cones.others.clear();
        cones_at(p, &mut cones);
        // Of several own cones the one on which the way leads farther: they meet where paths on both sides of a hole are as long.
        let mut best: Option<(f64, DVec2, bool)> = None;
        for cone in &cones.own {
            let (value, gradient) = (cone.value(p), cone.gradient(p));
            // How far a step within the triangle goes in a direction, at most.
            let room = |normal: DVec2| corners.iter().map(|&v| normal.dot(v - p)).fold(f64::NEG_INFINITY, f64::max);
            let side = |other: &Cone| {
                let side = Side::new(gradient, gradient - other.gradient(p), other.value(p) - value);
                (side.limit < room(side.normal)).then_some(side)
            };
            sides.clear();
            sides.extend(cones.others.iter().chain(&cones.own).filter(|other| *other != cone).filter_map(side));
            sides.extend([(a, b), (b, c), (c, a)].map(|(from, to)| {
                let normal = -(to - from).normalize().perp();
                Side::new(gradient, normal, normal.dot(from - p))
            }));
            let Some((step, other)) = farthest_step(gradient, &sides, longest, fork) else { continue };
            let reached = value + gradient.dot(step);
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
    (last <= SETTLED * longest).then_some((p, forked))
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

/// Conditions are met within this share of the reach.
const SLACK: f64 = 1e-12;
/// Normals that span less are as good as parallel.
const LEAST_AREA: f64 = 1e-9;
/// With more sides, those that decide are found before pairs are tried. As pieces with more sites are divided, there are only so many where
/// as many sites are on one circle.
const MANY: usize = 32;

/// The step that goes farthest in a direction under all conditions: the best of the corners that two of them make. Also tells
/// whether another goes as far. The last three sides are those of a triangle.
fn farthest_step(direction: DVec2, sides: &[Side], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    if sides.len() > MANY {
        best_corner(direction, &deciding(direction, sides, reach)?, reach, fork)
    } else {
        best_corner(direction, sides, reach, fork)
    }
}

/// The best corner, found by trying all pairs. Cost: their number, and for those that may be the best a look at every side.
fn best_corner(direction: DVec2, sides: &[Side], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    let slack = SLACK * reach;
    let mut best: Option<(f64, DVec2, bool)> = None;
    for (i, a) in sides.iter().enumerate() {
        for b in &sides[i + 1..] {
            let area = a.normal.perp_dot(b.normal);
            // A corner is the best where the direction lies between the normals of its sides.
            let (right, left) = if area > 0.0 { (a, b) } else { (b, a) };
            if area.abs() < LEAST_AREA || right.turn > ALONG || left.turn < -ALONG {
                continue;
            }
            let step = corner(a, b);
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

/// Where two sides meet.
fn corner(a: &Side, b: &Side) -> DVec2 {
    (a.limit * -b.normal.perp() + b.limit * a.normal.perp()) / a.normal.perp_dot(b.normal)
}

/// Of many sides, in their order, those that the best corner is made of and those that end its two edges, with some more: as good as all.
/// None where no step meets all conditions.
///
/// A linear programme: from the best corner of the triangle, the side that it is beyond most is added until it is beyond none. Cost: a look
/// at every side for each that is added, a handful as a rule.
fn deciding(direction: DVec2, sides: &[Side], reach: f64) -> Option<Vec<Side>> {
    let slack = SLACK * reach;
    let (first, gain) = (sides.len() - 3, |&[i, j]: &[usize; 2]| direction.dot(corner(&sides[i], &sides[j])));
    let mut chosen: Vec<usize> = (first..sides.len()).collect();
    let of_triangle = [[first, first + 1], [first + 1, first + 2], [first, first + 2]];
    let mut best = of_triangle.into_iter().max_by(|one, other| gain(one).total_cmp(&gain(other)))?;
    loop {
        let step = corner(&sides[best[0]], &sides[best[1]]);
        let beyond = |&at: &usize| sides[at].normal.dot(step) - sides[at].limit;
        let worst = (0..sides.len()).max_by(|one, other| beyond(one).total_cmp(&beyond(other)))?;
        if beyond(&worst) <= slack || chosen.contains(&worst) {
            break;
        }
        // The best corner of more sides is on the one that was missing.
        let [low, high] = edge(sides, worst, chosen.iter().copied(), slack)?;
        best = [worst, if direction.dot(sides[worst].normal.perp()) > 0.0 { high } else { low }];
        chosen.push(worst);
    }
    for side in best {
        chosen.extend(edge(sides, side, 0..sides.len(), slack).into_iter().flatten());
    }
    chosen.sort_unstable();
    chosen.dedup();
    Some(chosen.into_iter().map(|at| sides[at]).collect())
}

/// The two of `others` that end the edge on a side, first the one on the right of its normal. None where no point of the side meets the
/// conditions of all others.
fn edge(sides: &[Side], side: usize, others: impl Iterator<Item = usize>, slack: f64) -> Option<[usize; 2]> {
    let Side { normal, limit, .. } = sides[side];
    let (from, along) = (normal * (limit / normal.length_squared()), normal.perp());
    let (mut low, mut high) = ((f64::NEG_INFINITY, None), (f64::INFINITY, None));
    for at in others {
        let rise = sides[at].normal.dot(along);
        let end = (sides[at].limit + slack - sides[at].normal.dot(from)) / rise;
        if rise >= LEAST_AREA && end < high.0 {
            high = (end, Some(at));
        } else if rise <= -LEAST_AREA && end > low.0 {
            low = (end, Some(at));
        }
    }
    if low.0 <= high.0 { Some([low.1?, high.1?]) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where climbs in a triangle end, the first cone being the cell's own.
    fn tops(corners: [(f64, f64); 3], from: (f64, f64), cones: &[Cone]) -> Vec<DVec2> {
        climb(&corners.map(DVec2::from), from.into(), |_, seen| {
            seen.own.extend(&cones[..1]);
            seen.others.extend(&cones[1..]);
        })
    }

    fn cone(x: f64, y: f64, offset: f64) -> Cone {
        Cone { apex: DVec2::new(x, y), offset }
    }

    fn unit(angle: f64) -> DVec2 {
        let (sin, cos) = libm::sincos(angle);
        DVec2::new(cos, sin)
    }

    #[test]
    fn three_sources_meet_at_the_centre_of_their_circle() {
        let centre = DVec2::new(3.0, 4.0);
        let on_circle = |x: f64, y: f64| Cone { apex: centre + 50.0 * DVec2::new(x, y), offset: 0.0 };
        let mut cones = [on_circle(1.0, 0.0), on_circle(-0.6, 0.8), on_circle(-0.6, -0.8)];
        for _ in 0..3 {
            cones.rotate_left(1);
            let found = tops([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
            assert!(found.len() == 1 && found[0].distance(centre) < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn hundreds_of_sources_on_one_circle_meet_in_its_centre() {
        let centre = DVec2::new(3.0, 4.0);
        let around = |i: i32| Cone { apex: centre + 50.0 * unit(f64::from(i).to_radians()), offset: 0.0 };
        let mut cones: Vec<Cone> = (0..360).map(around).collect();
        for _ in 0..3 {
            cones.rotate_left(95);
            let found = tops([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
            assert!(!found.is_empty() && found.iter().all(|top| top.distance(centre) < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn few_sides_decide_and_the_best_corner_is_that_of_all() {
        let mut seed = 1_u32;
        let mut share = move || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24)
        };
        let mut most = 0;
        for round in 0..200 {
            let direction = unit(7.0 * share());
            // Every other round all are nearly of one circle, with the step at its centre; every fourth one is level.
            let spread = if round % 2 == 0 { 1.0 } else { 1e-13 };
            let mut sides: Vec<Side> = (0..60)
                .map(|_| Side::new(direction, direction - unit(7.0 * share()), spread * share() + 0.05))
                .collect();
            if round % 4 == 0 {
                sides[7] = Side::new(direction, direction, 0.06);
            }
            for corner in [(1.0, 0.2), (-0.5, 0.9), (-0.5, -0.9)] {
                sides.push(Side::new(direction, DVec2::from(corner).normalize(), 1.0));
            }
            let few = deciding(direction, &sides, 3.0).expect("all limits are above 0");
            most = most.max(few.len());
            for fork in [Fork::First, Fork::Last] {
                let [all, found] =
                    [&sides, &few].map(|sides| best_corner(direction, sides, 3.0, fork).expect("a step"));
                let [gain, same] = [all, found].map(|(step, _)| direction.dot(step));
                assert!((gain - same).abs() < 1e-11, "{all:?} and {found:?} in round {round}");
                assert!(round % 2 == 1 || all.0.distance(found.0) < 1e-9 && all.1 == found.1, "round {round}");
            }
        }
        assert!(most <= 16, "{most} sides are kept");
    }

    #[test]
    fn two_ways_that_lead_as_far_are_both_gone() {
        let cones = [cone(0.0, 0.0, 0.0), cone(0.0, 100.0, 0.0), cone(-60.0, 30.0, 0.0), cone(60.0, 30.0, 0.0)];
        let found = tops([(-40.0, 20.0), (40.0, 20.0), (0.0, 80.0)], (0.0, 45.0), &cones);
        let &[one, other] = &found[..] else { panic!("two ways: {found:?}") };
        assert!(one.distance(DVec2::new(-other.x, other.y)) < 1e-9 && one.x.abs() > 5.0, "{one} and {other}");
    }

    #[test]
    fn two_sources_meet_halfway_along_an_edge() {
        let found =
            tops([(4.0, 0.0), (7.0, 0.0), (5.0, 2.0)], (5.5, 0.5), &[cone(0.0, 5.0, 0.0), cone(10.0, 5.0, 0.0)]);
        assert!(found.len() == 1 && found[0].distance(DVec2::new(5.0, 0.0)) < 1e-12, "{found:?}");
    }

    #[test]
    fn a_cell_ends_where_a_neighbour_is_as_near_though_distances_go_on_to_rise() {
        let found = tops([(3.0, 0.0), (8.0, 0.0), (4.0, 0.5)], (4.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        // 3 + s = √(s² + 25), and s = 16 / 6, which lies before the edge begins: nothing of the cell is in the triangle.
        assert!(found.is_empty(), "{found:?}");
        let found = tops([(1.0, 0.0), (8.0, 0.0), (2.0, 0.5)], (2.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        assert!(found.len() == 1 && found[0].distance(DVec2::new(16.0 / 6.0, 0.0)) < 1e-12, "{found:?}");
    }

    #[test]
    fn alone_a_cone_is_farthest_in_a_corner() {
        let found = tops([(3.0, 0.0), (8.0, 1.0), (4.0, 2.0)], (5.0, 1.0), &[cone(0.0, 0.0, 0.0)]);
        assert_eq!(found, [DVec2::new(8.0, 1.0)]);
    }
}
