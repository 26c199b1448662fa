//! The rigid blend: rigid motions blend to a rigid motion, by dual complex numbers.
//!
//! A rotation by θ with a translation, y = p² x + 2pq with p = exp(iθ/2), is the dual complex number p + qε; the
//! blend is their weighted sum, normalised to |p| = 1 (Matsuda, Kaji and Ochiai, "Anti-commutative dual complex
//! numbers and 2D rigid transformation", 2014; in space: dual quaternion skinning, Kavan et al. 2008). For one point
//! x that sites take to y_i this is
//!
//! ```text
//! y = Σ w_i p̄_i y_i / Σ w_i p̄_i
//! ```
//!
//! a mean with complex weights, so it does not depend on the origin. Stretches only affect the y_i: at each point, a
//! motion counts as the rotation by θ_i that takes the point to y_i.
//!
//! Guaranteed: equal motions blend to that motion; a site with all the weight moves its point; a point that all
//! motions take to one place goes there. Without stretches, and with angles within 240° of one another, a point moves
//! by a rigid motion. Two motions with a common pivot rotate the point about that pivot. The result depends smoothly
//! (C²) on positions, weights and angles, through any number of turns.
//!
//! Limits: weights change from point to point, and with them the rigid motion, so a picture still bends. Beyond 240°
//! the sum P = Σ w p may come near 0, where no choice of a rigid motion is continuous: as one of two angles makes a
//! full turn, the blend has to follow it at one weight and return at another. From |P|² = 1/4 to 0, the result changes
//! over to the linear blend, which shrinks rotated parts. Angles a whole turn apart (P = 0 at equal weights) are the
//! same rotation, whose linear blend is rigid.
//!
//! Cost: one complex and one matrix product for each site that moves the point, and one division.

use std::ops::{Add, Mul};

use glam::{DMat2, DVec2};

use crate::pose::{Motion, turn};

/// The blend is rigid above this |P|²: cos² of 60°, the least for angles within 240°.
const RIGID: f64 = 0.25;

/// A motion with half its rotation. Complex numbers are vectors, with [`DVec2::rotate`] as product.
#[derive(Debug, Clone, Copy)]
pub(super) struct Dual {
    rest: DVec2,
    posed: DVec2,
    linear: DMat2,
    /// p = exp(iθ/2).
    half: DVec2,
}

impl Dual {
    pub(super) fn new(rest: DVec2, motion: &Motion) -> Self {
        Self { rest, posed: rest + motion.translation, linear: motion.linear(), half: half_turn(motion.angle) }
    }

    /// The site's term of the sums at a point, for a weight of 1.
    pub(super) fn term(&self, p: DVec2) -> Sums {
        let posed = self.posed + self.linear * (p - self.rest);
        Sums { posed, half: self.half, moved: conjugate(self.half).rotate(posed - p) }
    }
}

/// Weighted sums over the sites that move a point p; all but `posed` are relative to p.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sums {
    /// Σ w y_i: the linear blend.
    posed: DVec2,
    /// P = Σ w exp(iθ/2).
    half: DVec2,
    /// Σ w p̄_i (y_i − p).
    moved: DVec2,
}

impl Sums {
    /// The posed position of p.
    pub(super) fn place(&self, p: DVec2) -> DVec2 {
        self.place_along(p, &[]).0
    }

    /// The posed position of p, and its derivatives along the variables that `changes` holds the derivatives of the
    /// sums for.
    fn place_along<const N: usize>(&self, p: DVec2, changes: &[Self; N]) -> (DVec2, [DVec2; N]) {
        let Self { posed, half, moved } = *self;
        // The rigid blend minus the linear one, times P̄.
        let apart = moved - conjugate(half).rotate(posed - p);
        let square = half.length_squared();
        let back = half * reciprocal(square);
        let along = |change: &Self| {
            let d_apart =
                change.moved - conjugate(change.half).rotate(posed - p) - conjugate(half).rotate(change.posed);
            let d_back =
                change.half * reciprocal(square) + half * (reciprocal_slope(square) * 2.0 * half.dot(change.half));
            change.posed + d_apart.rotate(back) + apart.rotate(d_back)
        };
        (posed + apart.rotate(back), changes.each_ref().map(along))
    }
}

/// The posed position of p and the Jacobian there, from each site's weight and its gradient. `slopes` are those of p
/// itself, which depends on the point at which weights are evaluated.
pub(super) fn mapped<'a>(
    p: DVec2,
    slopes: DMat2,
    sites: impl Iterator<Item = (&'a Dual, f64, DVec2)>,
) -> (DVec2, DMat2) {
    let (mut sums, mut changes) = (Sums::default(), [Sums::default(); 2]);
    for (dual, weight, gradient) in sites {
        let term = dual.term(p);
        sums = sums + weight * term;
        // Gradients sum to zero: relative to p, fewer digits are lost to cancellation.
        let relative = Sums { posed: term.posed - p, ..term };
        let along = [(slopes.x_axis, gradient.x), (slopes.y_axis, gradient.y)];
        for (change, (way, slope)) in changes.iter_mut().zip(along) {
            *change = *change + slope * relative;
            // Values relative to p do not change as the point moves away from p.
            let moved = dual.linear * way;
            change.posed += weight * moved;
            change.moved += weight * conjugate(dual.half).rotate(moved);
        }
    }
    let (place, [x, y]) = sums.place_along(p, &changes);
    (place, DMat2::from_cols(x, y))
}

/// 1/s, continued below [`RIGID`] by its second-order Taylor polynomial: C², and never above 3/[`RIGID`].
fn reciprocal(s: f64) -> f64 {
    let u = s / RIGID;
    if u >= 1.0 { 1.0 / s } else { (3.0 - 3.0 * u + u * u) / RIGID }
}

/// The derivative of [`reciprocal`].
fn reciprocal_slope(s: f64) -> f64 {
    let u = s / RIGID;
    if u >= 1.0 { -1.0 / (s * s) } else { (2.0 * u - 3.0) / (RIGID * RIGID) }
}

/// exp(iθ/2) with its sign: angles are not limited to one turn.
pub(super) fn half_turn(angle: f64) -> DVec2 {
    turn(angle / 2.0)
}

fn conjugate(z: DVec2) -> DVec2 {
    DVec2::new(z.x, -z.y)
}

impl Add for Sums {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { posed: self.posed + other.posed, half: self.half + other.half, moved: self.moved + other.moved }
    }
}

impl Mul<Sums> for f64 {
    type Output = Sums;

    fn mul(self, sums: Sums) -> Sums {
        Sums { posed: self * sums.posed, half: self * sums.half, moved: self * sums.moved }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::pose::Strain;

    const POINTS: [DVec2; 4] = [DVec2::new(3.0, 4.0), DVec2::new(900.0, -20.0), DVec2::new(-50.0, 333.0), DVec2::ZERO];

    fn rigid(rest: DVec2, angle: f64, translation: DVec2) -> Dual {
        Dual::new(rest, &Motion { angle, translation, ..Motion::default() })
    }

    /// A rotation about a pivot, as the motion of a site elsewhere.
    fn about(pivot: DVec2, rest: DVec2, angle: f64) -> Dual {
        let turn = half_turn(2.0 * angle);
        rigid(rest, angle, pivot + turn.rotate(rest - pivot) - rest)
    }

    fn blend(p: DVec2, duals: &[(Dual, f64)]) -> DVec2 {
        duals.iter().fold(Sums::default(), |sums, (dual, weight)| sums + *weight * dual.term(p)).place(p)
    }

    #[test]
    fn one_motion_of_all_sites_is_the_motion_of_every_point() {
        let strain = Strain::of_bone(half_turn(1.0), 1.6, 0.7);
        for angle in [0.0, 2.0, -3.5 * TAU, 40.25 * TAU] {
            let motion = Motion { angle, strain, translation: DVec2::new(5.0, -7.0), depth: 0.0 };
            let rest = DVec2::new(40.0, 30.0);
            for p in POINTS {
                let expected = rest + motion.translation + motion.linear() * (p - rest);
                // The same motion at another site of the same place, one turn further or not.
                let further = Dual::new(rest, &Motion { angle: angle + TAU, ..motion });
                for other in [Dual::new(rest, &motion), further] {
                    let found = blend(p, &[(Dual::new(rest, &motion), 0.4), (other, 0.6)]);
                    assert!(found.distance(expected) < 1e-9, "{p} goes to {found}, not {expected}");
                }
            }
        }
    }

    #[test]
    fn a_site_with_all_the_weight_moves_its_point() {
        let (rest, translation) = (DVec2::new(512.0, 100.0), DVec2::new(0.25, 3.0));
        assert_eq!(rigid(rest, 2.4, translation).term(rest).place(rest), rest + translation);
    }

    #[test]
    fn two_motions_keep_their_pivot_and_all_distances() {
        let (pivot, rests) = (DVec2::new(120.0, 80.0), [DVec2::ZERO, DVec2::new(300.0, 10.0)]);
        for (a, b) in [(0.0, 1.0), (-1.9, 2.2), (7.0 * TAU, 7.6 * TAU), (0.3, 0.3 + TAU * 2.0 / 3.0)] {
            for weight in [0.1, 0.5, 0.83] {
                let duals = [(about(pivot, rests[0], a), weight), (about(pivot, rests[1], b), 1.0 - weight)];
                assert!(blend(pivot, &duals).distance(pivot) < 1e-9);
                for p in POINTS {
                    assert!((blend(p, &duals).distance(pivot) - p.distance(pivot)).abs() < 1e-9, "{a} and {b} at {p}");
                }
            }
        }
    }

    #[test]
    fn many_rigid_motions_within_240_degrees_blend_to_a_rigid_one() {
        let duals = [(0.4, -2.0), (0.1, 2.1), (0.3, 0.4), (0.2, 2.0)].map(|(weight, angle)| {
            (rigid(DVec2::new(70.0 * angle, 9.0), angle, DVec2::new(angle * angle, 20.0 * angle)), weight)
        });
        for [p, q] in POINTS.windows(2).map(|pair| [pair[0], pair[1]]) {
            assert!((blend(p, &duals).distance(blend(q, &duals)) - p.distance(q)).abs() < 1e-9);
        }
    }

    #[test]
    fn result_is_continuous_through_many_turns() {
        let (step, radius) = (0.002, 100.0);
        for weight in [0.02, 0.3, 0.5, 0.501, 0.9] {
            // One site rotates beside one at rest, and two rotate in opposite directions.
            for opposite in [0.0, -1.0] {
                let at = |angle: f64| {
                    let still = rigid(DVec2::ZERO, opposite * angle, DVec2::new(30.0, 0.0));
                    let turning = rigid(DVec2::new(radius, 0.0), angle, DVec2::ZERO);
                    blend(DVec2::new(radius / 2.0, radius), &[(turning, weight), (still, 1.0 - weight)])
                };
                let mut before = at(-20.0 * TAU);
                for tick in 1..=(40.0 * TAU / step) as u32 {
                    let now = at(f64::from(tick) * step - 20.0 * TAU);
                    // No faster than 10 times a point that rotates rigidly.
                    assert!(now.distance(before) < 10.0 * step * radius, "{before} to {now}");
                    before = now;
                }
            }
        }
    }

    #[test]
    fn jacobian_is_the_derivative_of_the_position() {
        // Weights of three sites that change from point to point, and sum to 1.
        let weights = |p: DVec2| {
            let raw = [0.3 + 0.001 * p.x, 0.5 - 0.0007 * p.y, 0.2 + 0.000_01 * p.x * p.y];
            raw.map(|w| w / raw.iter().sum::<f64>())
        };
        for spread in [0.5, 2.0, 3.2, 5.0] {
            let duals = [-1.0, 0.2, 1.1].map(|k| {
                let strain = Strain::of_bone(half_turn(k), 1.0 + 0.3 * k, 1.2);
                let translation = DVec2::new(30.0 * k, 10.0);
                Dual::new(DVec2::new(200.0 * k, 50.0), &Motion { angle: spread * k, strain, translation, depth: 0.0 })
            });
            let place = |p: DVec2| blend(p, &std::array::from_fn::<_, 3, _>(|i| (duals[i], weights(p)[i])));
            let step = 1e-4;
            let slope =
                |f: &dyn Fn(DVec2) -> DVec2, p: DVec2, axis| (f(p + step * axis) - f(p - step * axis)) / (2.0 * step);
            for p in [DVec2::new(40.0, 70.0), DVec2::new(-90.0, 10.0)] {
                let gradient = |i: usize| {
                    let weight = |p: DVec2| DVec2::new(weights(p)[i], 0.0);
                    DVec2::new(slope(&weight, p, DVec2::X).x, slope(&weight, p, DVec2::Y).x)
                };
                let (at, derivative) =
                    mapped(p, DMat2::IDENTITY, (0..3).map(|i| (&duals[i], weights(p)[i], gradient(i))));
                assert!(at.distance(place(p)) < 1e-9);
                let expected = DMat2::from_cols(slope(&place, p, DVec2::X), slope(&place, p, DVec2::Y));
                assert!(derivative.abs_diff_eq(expected, 1e-5), "{derivative} is not {expected} at {spread}");
            }
        }
    }
}
