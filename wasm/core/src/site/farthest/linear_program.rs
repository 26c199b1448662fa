//! The linear program of one ascent step: the step that goes farthest in a direction under linear constraints.
//!
//! Cost: up to [`MAX_CONSTRAINTS_IN_PAIRS`] constraints, all pairs of them, and a pass over all for each candidate.
//! With more, first a few passes that select the active ones.

use glam::DVec2;

use crate::rank::sort_by_rank;

/// Selects one of several equally good steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fork {
    First,
    Last,
}

/// The constraint `normal · step ≤ limit`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constraint {
    pub(super) normal: DVec2,
    pub(super) limit: f64,
    /// Sine of the angle from the ascent direction to the normal, times their lengths: positive to the left.
    turn: f64,
}

impl Constraint {
    /// A constraint on steps in an ascent direction.
    pub(super) fn new(direction: DVec2, normal: DVec2, limit: f64) -> Self {
        Self { normal, limit, turn: direction.perp_dot(normal) }
    }
}

/// Constraints count as left or right of the direction by their normal; within this sine of it, as both.
const ALONG_SINE: f64 = 1e-5;
/// Two steps differ if they are farther apart than this, relative to the reach.
const SAME_STEP: f64 = 1e-6;
/// Two gains are equal if they differ by no more than this, relative to the reach.
const SAME_GAIN: f64 = 1e-12;
/// Constraints may be violated by this, relative to the reach.
const FEASIBLE: f64 = 1e-12;
/// Normals that span a smaller area count as parallel.
const PARALLEL_AREA: f64 = 1e-9;
/// With more constraints than this, an incremental linear program first selects the active ones. Pieces with many sites
/// are subdivided, so this happens only if many sites lie on one circle.
const MAX_CONSTRAINTS_IN_PAIRS: usize = 32;

/// The step that goes farthest in a direction under all constraints, and whether another step is equally good.
///
/// It is the best vertex of the feasible polygon. The last three constraints are the edges of a triangle with edges no
/// longer than `reach`. `None` if no step satisfies all.
pub(super) fn farthest_step(
    direction: DVec2,
    constraints: &[Constraint],
    reach: f64,
    fork: Fork,
) -> Option<(DVec2, bool)> {
    if constraints.len() > MAX_CONSTRAINTS_IN_PAIRS {
        best_vertex(direction, &active_constraints(direction, constraints, reach)?, reach, fork)
    } else {
        best_vertex(direction, constraints, reach, fork)
    }
}

/// The best vertex, by trying all pairs of constraints. Cost: the number of pairs, and a pass over all constraints for
/// each candidate.
fn best_vertex(direction: DVec2, constraints: &[Constraint], reach: f64, fork: Fork) -> Option<(DVec2, bool)> {
    let slack = FEASIBLE * reach;
    let mut best: Option<(f64, DVec2, bool)> = None;
    for (i, a) in constraints.iter().enumerate() {
        for b in &constraints[i + 1..] {
            let area = a.normal.perp_dot(b.normal);
            // A vertex is optimal if the direction lies between the normals of its two constraints.
            let (right, left) = if area > 0.0 { (a, b) } else { (b, a) };
            if area.abs() < PARALLEL_AREA || right.turn > ALONG_SINE || left.turn < -ALONG_SINE {
                continue;
            }
            let step = intersection(a, b);
            let gain = direction.dot(step);
            let tie = SAME_GAIN * reach;
            let worse = best.is_some_and(|(known, ..)| gain < known - tie);
            if worse || constraints.iter().any(|other| other.normal.dot(step) > other.limit + slack) {
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

/// The intersection of the lines of two constraints.
fn intersection(a: &Constraint, b: &Constraint) -> DVec2 {
    (a.limit * -b.normal.perp() + b.limit * a.normal.perp()) / a.normal.perp_dot(b.normal)
}

/// A subset of many constraints, in their order, with the same best vertex and the same two edges there. `None` if no
/// step satisfies all.
///
/// An incremental linear program. From the best corner of the triangle, it adds the most violated constraint until none
/// is violated. Cost: a pass over all constraints for each one added, usually a handful.
fn active_constraints(direction: DVec2, constraints: &[Constraint], reach: f64) -> Option<Vec<Constraint>> {
    let slack = FEASIBLE * reach;
    let first = constraints.len() - 3;
    let gain = |&[i, j]: &[usize; 2]| direction.dot(intersection(&constraints[i], &constraints[j]));
    let mut chosen: Vec<usize> = (first..constraints.len()).collect();
    let of_triangle = [[first, first + 1], [first + 1, first + 2], [first, first + 2]];
    let mut best = of_triangle.into_iter().max_by(|one, other| gain(one).total_cmp(&gain(other)))?;
    loop {
        let step = intersection(&constraints[best[0]], &constraints[best[1]]);
        let violation = |&at: &usize| constraints[at].normal.dot(step) - constraints[at].limit;
        let worst = (0..constraints.len()).max_by(|one, other| violation(one).total_cmp(&violation(other)))?;
        if violation(&worst) <= slack || chosen.contains(&worst) {
            break;
        }
        // With one more constraint, the best vertex lies on that constraint.
        let [low, high] = edge(constraints, worst, chosen.iter().copied(), slack)?;
        best = [worst, if direction.dot(constraints[worst].normal.perp()) > 0.0 { high } else { low }];
        chosen.push(worst);
    }
    for at in best {
        chosen.extend(edge(constraints, at, 0..constraints.len(), slack).into_iter().flatten());
    }
    sort_by_rank(&mut chosen, |&at| [at as i64, 0]);
    chosen.dedup();
    Some(chosen.into_iter().map(|at| constraints[at]).collect())
}

/// The two of `others` that bound the edge on constraint `at`, first the one to the right of its normal. `None` if no
/// point of the edge satisfies all others.
fn edge(constraints: &[Constraint], at: usize, others: impl Iterator<Item = usize>, slack: f64) -> Option<[usize; 2]> {
    let Constraint { normal, limit, .. } = constraints[at];
    let (from, along) = (normal * (limit / normal.length_squared()), normal.perp());
    let (mut low, mut high) = ((f64::NEG_INFINITY, None), (f64::INFINITY, None));
    for other in others {
        let rise = constraints[other].normal.dot(along);
        let end = (constraints[other].limit + slack - constraints[other].normal.dot(from)) / rise;
        if rise >= PARALLEL_AREA && end < high.0 {
            high = (end, Some(other));
        } else if rise <= -PARALLEL_AREA && end > low.0 {
            low = (end, Some(other));
        }
    }
    if low.0 <= high.0 { Some([low.1?, high.1?]) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn active_constraints_have_the_same_best_vertex() {
        let mut seed = 1_u32;
        let mut random = move || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24)
        };
        let unit = |angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            DVec2::new(cos, sin)
        };
        let mut most = 0;
        for round in 0..200 {
            let direction = unit(7.0 * random());
            // In every other round all sources lie nearly on one circle, and the step is at its centre. In every fourth
            // round one constraint is level.
            let spread = if round % 2 == 0 { 1.0 } else { 1e-13 };
            let mut constraints: Vec<Constraint> = (0..60)
                .map(|_| Constraint::new(direction, direction - unit(7.0 * random()), spread * random() + 0.05))
                .collect();
            if round % 4 == 0 {
                constraints[7] = Constraint::new(direction, direction, 0.06);
            }
            for corner in [(1.0, 0.2), (-0.5, 0.9), (-0.5, -0.9)] {
                constraints.push(Constraint::new(direction, DVec2::from(corner).normalize(), 1.0));
            }
            let few = active_constraints(direction, &constraints, 3.0).expect("all limits are above 0");
            most = most.max(few.len());
            for fork in [Fork::First, Fork::Last] {
                let [all, found] =
                    [&constraints, &few].map(|list| best_vertex(direction, list, 3.0, fork).expect("a step"));
                let [gain, same] = [all, found].map(|(step, _)| direction.dot(step));
                assert!((gain - same).abs() < 1e-11, "{all:?} and {found:?} in round {round}");
                assert!(round % 2 == 1 || all.0.distance(found.0) < 1e-9 && all.1 == found.1, "round {round}");
            }
        }
        assert!(most <= 16, "{most} constraints are kept");
    }
}
