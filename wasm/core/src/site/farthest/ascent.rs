//! The farthest points of a cell in a triangle, by ascent of the distance.
//!
//! The distance to a site is the minimum of a few cones `offset + |p − pseudo_source|`. In a triangle a cell's farthest point
//! lies where cones intersect: three of them, or two on an edge; or at a corner. A sequence of linear programs (each cone
//! replaced by its tangent plane, as in successive linear programming) finds it: each step ascends one of the site's cones as
//! far as, by the tangent planes, it remains the minimum. It converges as Newton's method does.
//!
//! So the places of virtual sites hardly depend on where the coarse samples happen to lie.
//!
//! Cost: for each of about five steps all pairs of cones, or for more than [`MAX_SIDES_IN_PAIRS`] cones a few passes over
//! them.

use glam::DVec2;

use crate::min_max::fast_max;

/// A cone `offset + |p − apex|`: the length of the paths that bend last at one pseudo-source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cone {
    pub(super) apex: DVec2,
    pub(super) offset: f64,
}

impl Cone {
    /// The tangent plane at a place.
    fn tangent(&self, p: DVec2) -> Tangent {
        Tangent { value: self.offset + p.distance(self.apex), gradient: (p - self.apex).normalize_or_zero() }
    }
}

/// The tangent plane of a cone.
struct Tangent {
    value: f64,
    gradient: DVec2,
}

/// The cones at a place.
#[derive(Debug)]
pub(super) struct Cones {
    /// Cones of the cell's own site.
    pub(super) own: Vec<Cone>,
    /// Cones of other sites.
    pub(super) others: Vec<Cone>,
}

/// Initial capacity for cones; usually only a few meet.
const CAPACITY: usize = 16;
/// Greatest number of steps. Three meeting cones take five; more are spent only where cones touch.
const MAX_STEPS: usize = 16;
/// A step shorter than this share of the longest edge ends the ascent.
const CONVERGED: f64 = 1e-12;
/// Where cones meet at a small angle, rounding keeps steps longer than that; an ascent whose last step is longer than this
/// share has failed.
const ACCEPTED: f64 = 1e-6;

/// Ascends a cell's own cones where they are the minimum of all, in a triangle of positive orientation. `cones_at` lists the
/// cones at a place. Where two ascents lead equally far, as from an axis of symmetry, it follows both. Empty where none
/// converges.
pub(super) fn ascend(corners: &[DVec2; 3], from: DVec2, mut cones_at: impl FnMut(DVec2, &mut Cones)) -> Vec<DVec2> {
    let first = ascend_once(corners, from, &mut cones_at, Fork::First);
    let other = first.filter(|&(_, forked)| forked).and_then(|_| ascend_once(corners, from, &mut cones_at, Fork::Last));
    first.into_iter().chain(other).map(|(maximum, _)| maximum).collect()
}

/// Which of several equally good steps is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fork {
    First,
    Last,
}

/// One ascent, and whether there was another.
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
    let mut sides = Vec::with_capacity(2 * CAPACITY);
    let mut last = f64::INFINITY;
    for _ in 0..MAX_STEPS {
        cones.own.clear();
        cones.others.clear();
        cones_at(p, &mut cones);
        // Of several own cones the one whose step leads farthest: they meet where paths on both sides of a hole are equally
        // long.
        let mut best: Option<(f64, DVec2, bool)> = None;
        for cone in &cones.own {
            let tangent = cone.tangent(p);
            let others = cones.others.iter().chain(&cones.own).filter(|other| *other != cone);
            constrain(&mut sides, corners, p, &tangent, others.map(|other| other.tangent(p)));
            let Some((step, other)) = farthest_step(tangent.gradient, &sides, longest, fork) else { continue };
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

/// Sets the constraints of a step from `p` up a cone: by the tangent planes it stays below the other cones, and in the triangle.
fn constrain(
    sides: &mut Vec<Constraint>,
    corners: &[DVec2; 3],
    p: DVec2,
    own: &Tangent,
    others: impl Iterator<Item = Tangent>,
) {
    let up = own.gradient;
    // The greatest component of a step within the triangle in a direction.
    let extent = |normal: DVec2| corners.iter().map(|&v| normal.dot(v - p)).fold(f64::NEG_INFINITY, fast_max);
    let below = others.map(|other| Constraint::new(up, up - other.gradient, other.value - own.value));
    sides.clear();
    sides.extend(below.filter(|side| side.limit < extent(side.normal)));
    let [a, b, c] = *corners;
    sides.extend([(a, b), (b, c), (c, a)].map(|(from, to)| {
        let normal = -(to - from).normalize().perp();
        Constraint::new(up, normal, normal.dot(from - p))
    }));
}

/// The constraint `normal · step ≤ limit`.
#[derive(Debug, Clone, Copy)]
struct Constraint {
    normal: DVec2,
    limit: f64,
    /// Constraint of the ascent direction on which the normal lies: positive to the left.
    turn: f64,
}

impl Constraint {
    fn new(direction: DVec2, normal: DVec2, limit: f64) -> Self {
        Self { normal, limit, turn: direction.perp_dot(normal) }
    }
}

/// Constraints count as left or right of the direction by their normal; within this sine of it, as both.
const ALONG_SINE: f64 = 1e-5;
/// Steps differ by more than this share of the reach; gains are equal within the other.
const SAME_STEP: f64 = 1e-6;
const SAME_GAIN: f64 = 1e-12;

/// Constraints are satisfied within this share of the reach.
const FEASIBLE: f64 = 1e-12;
/// Normals that span a smaller area count as parallel.
const PARALLEL_AREA: f64 = 1e-9;
/// With more constraints than this, the active ones are selected first, by an incremental linear program. Pieces with many
/// sites are subdivided, so this happens only where many sites lie on one circle.
const MAX_SIDES_IN_PAIRS: usize = 32;

/// The step that goes farthest in a direction under all constraints: the best vertex of the feasible polygon, and whether
/// another is equally good. The last three sides are those of a triangle.
fn farthest_step(direction: DVec2, sides: &[Constraint], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    if sides.len() > MAX_SIDES_IN_PAIRS {
        best_corner(direction, &active_constraints(direction, sides, reach)?, reach, fork)
    } else {
        best_corner(direction, sides, reach, fork)
    }
}

/// The best vertex, by trying all pairs of constraints. Cost: the number of pairs, and a pass over all constraints for each
/// candidate.
fn best_corner(direction: DVec2, sides: &[Constraint], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    let slack = FEASIBLE * reach;
    let mut best: Option<(f64, DVec2, bool)> = None;
    for (i, a) in sides.iter().enumerate() {
        for b in &sides[i + 1..] {
            let area = a.normal.perp_dot(b.normal);
            // A vertex is optimal where the direction lies between the normals of its two constraints.
            let (right, left) = if area > 0.0 { (a, b) } else { (b, a) };
            if area.abs() < PARALLEL_AREA || right.turn > ALONG_SINE || left.turn < -ALONG_SINE {
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

/// The intersection of two constraint lines.
fn corner(a: &Constraint, b: &Constraint) -> DVec2 {
    (a.limit * -b.normal.perp() + b.limit * a.normal.perp()) / a.normal.perp_dot(b.normal)
}

/// Of many constraints, in their order, those that bound the best vertex and its two edges, and a few more: equivalent to
/// all. `None` where no step satisfies all.
///
/// An incremental linear program: from the best corner of the triangle, the most violated constraint is added until none is
/// violated. Cost: a pass over all constraints for each added, usually a handful.
fn active_constraints(direction: DVec2, sides: &[Constraint], reach: f64) -> Option<Vec<Constraint>> {
    let slack = FEASIBLE * reach;
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
        // The best vertex with one more constraint lies on that constraint.
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

/// The two of `others` that bound the edge on a constraint, first the one to the right of its normal. `None` where no point
/// of the edge satisfies all others.
fn edge(sides: &[Constraint], side: usize, others: impl Iterator<Item = usize>, slack: f64) -> Option<[usize; 2]> {
    let Constraint { normal, limit, .. } = sides[side];
    let (from, along) = (normal * (limit / normal.length_squared()), normal.perp());
    let (mut low, mut high) = ((f64::NEG_INFINITY, None), (f64::INFINITY, None));
    for at in others {
        let rise = sides[at].normal.dot(along);
        let end = (sides[at].limit + slack - sides[at].normal.dot(from)) / rise;
        if rise >= PARALLEL_AREA && end < high.0 {
            high = (end, Some(at));
        } else if rise <= -PARALLEL_AREA && end > low.0 {
            low = (end, Some(at));
        }
    }
    if low.0 <= high.0 { Some([low.1?, high.1?]) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The maxima found in a triangle, the first cone being the cell's own.
    fn maxima(corners: [(f64, f64); 3], from: (f64, f64), cones: &[Cone]) -> Vec<DVec2> {
        ascend(&corners.map(DVec2::from), from.into(), |_, seen| {
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
            let found = maxima([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
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
            let found = maxima([(-5.0, -5.0), (15.0, 0.0), (0.0, 15.0)], (6.0, 2.0), &cones);
            assert!(!found.is_empty() && found.iter().all(|maximum| maximum.distance(centre) < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn few_constraints_are_active_and_the_best_corner_is_that_of_all() {
        let mut seed = 1_u32;
        let mut share = move || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24)
        };
        let mut most = 0;
        for round in 0..200 {
            let direction = unit(7.0 * share());
            // In every other round all sources are nearly on one circle, with the step at its centre; in every fourth round
            // one constraint is level.
            let spread = if round % 2 == 0 { 1.0 } else { 1e-13 };
            let mut sides: Vec<Constraint> = (0..60)
                .map(|_| Constraint::new(direction, direction - unit(7.0 * share()), spread * share() + 0.05))
                .collect();
            if round % 4 == 0 {
                sides[7] = Constraint::new(direction, direction, 0.06);
            }
            for corner in [(1.0, 0.2), (-0.5, 0.9), (-0.5, -0.9)] {
                sides.push(Constraint::new(direction, DVec2::from(corner).normalize(), 1.0));
            }
            let few = active_constraints(direction, &sides, 3.0).expect("all limits are above 0");
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
    fn a_cell_ends_where_a_neighbour_is_as_near_though_distances_go_on_to_rise() {
        let found =
            maxima([(3.0, 0.0), (8.0, 0.0), (4.0, 0.5)], (4.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        // 3 + s = √(s² + 25), and s = 16 / 6, which lies before the edge begins: nothing of the cell is in the triangle.
        assert!(found.is_empty(), "{found:?}");
        let found =
            maxima([(1.0, 0.0), (8.0, 0.0), (2.0, 0.5)], (2.0, 0.1), &[cone(0.0, 0.0, 3.0), cone(0.0, 5.0, 0.0)]);
        assert!(found.len() == 1 && found[0].distance(DVec2::new(16.0 / 6.0, 0.0)) < 1e-12, "{found:?}");
    }

    #[test]
    fn alone_a_cone_is_farthest_in_a_corner() {
        let found = maxima([(3.0, 0.0), (8.0, 1.0), (4.0, 2.0)], (5.0, 1.0), &[cone(0.0, 0.0, 0.0)]);
        assert_eq!(found, [DVec2::new(8.0, 1.0)]);
    }
}
