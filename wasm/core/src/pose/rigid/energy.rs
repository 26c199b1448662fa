//! The symmetric Dirichlet energy |J|² + |J⁻¹|² of a Jacobian J (Smith and Schaefer 2015), and its derivatives.
//!
//! The Hessian can be projected to be positive semidefinite by its eigensystem in closed form (Smith, de Goes and Kim
//! 2019). With J = [a c; b d], that eigensystem is diagonal but for one 2 × 2 block in the coordinates z = ((a + d) + i
//! (b − c)) / √2, the part of J that is a similarity, and y = ((a − d) + i (b + c)) / √2, the part that is a mirrored
//! one. |J|² = |z|² + |y|², and 2 det J = |z|² − |y|².
//!
//! Between the places where it is measured, triangles may flatten unnoticed. These have an energy of [their
//! own](Law::Flatness), which is zero, with its first and second derivatives, from [`FLAT`] on.
//!
//! Where handles force a fold, det J is replaced by χ = (det + √(det² + ε²)) / 2 > 0 (Garanzha et al. 2021).
//!
//! The energy is divided by 8, and a rotation has none: near a rotation R it is |J − R|² / 2.

use glam::{DMat2, DVec2};

/// The square of a strain counts four times in the symmetric Dirichlet energy.
const SCALE: f64 = 1.0 / 8.0;

/// A triangle that keeps this fraction of its area has no energy of its own.
pub(super) const FLAT: f64 = 0.5;

/// h in the energy |J|² h(det).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Law {
    /// 1 + 1 / det².
    #[default]
    Distortion,
    /// (1 − det / [`FLAT`])³ / det², and 0 from [`FLAT`] on.
    Flatness,
}

/// The energy at one Jacobian.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    /// Derivative with respect to J.
    pub(super) gradient: DMat2,
    /// The second derivatives: `hessian[a][b]` maps a change of column `b` to that of the gradient's column
    /// `a`.
    pub(super) hessian: [[DMat2; 2]; 2],
}

/// h(det) and its derivatives, where the energy is |J|² h(det).
#[derive(Debug, Clone, Copy)]
struct Factor {
    value: f64,
    first: f64,
    second: f64,
}

impl Factor {
    /// `epsilon` is the regularisation ε, or 0 if no det is negative.
    fn at(det: f64, epsilon: f64, law: Law) -> Self {
        let root = (det * det + epsilon * epsilon).sqrt();
        let chi = chi(det, epsilon);
        // So that a rotation has the least energy for any ε.
        let strength = strength(epsilon);
        let inverse = strength / (chi * chi);
        // χ′ = χ / √(det² + ε²).
        match law {
            Law::Distortion => {
                let first = -2.0 * inverse / root;
                Self { value: 1.0 + inverse, first, second: first * (-2.0 / root - det / (root * root)) }
            }
            Law::Flatness => {
                let flat = self::chi(FLAT, epsilon);
                let left = 1.0 - chi / flat;
                if left <= 0.0 {
                    return Self { value: 0.0, first: 0.0, second: 0.0 };
                }
                let (slope, bend) = (chi / root, epsilon * epsilon / (2.0 * root * root * root));
                let (per_flat, per_chi) = (1.0 / flat, left / chi);
                let first = -inverse * left * left * (3.0 * per_flat + 2.0 * per_chi);
                let second =
                    6.0 * inverse * left * (per_flat * per_flat + 2.0 * per_flat * per_chi + per_chi * per_chi);
                Self {
                    value: inverse * left * left * left,
                    first: first * slope,
                    second: second * slope * slope + first * bend,
                }
            }
        }
    }
}

/// χ, without cancellation for a det below 0.
fn chi(det: f64, epsilon: f64) -> f64 {
    let root = (det * det + epsilon * epsilon).sqrt();
    if det > 0.0 { (det + root) / 2.0 } else { epsilon * epsilon / (2.0 * (root - det)) }
}

/// The factor of |J|² / χ².
fn strength(epsilon: f64) -> f64 {
    if epsilon == 0.0 {
        return 1.0;
    }
    let root = (1.0 + epsilon * epsilon).sqrt();
    let chi = (1.0 + root) / 2.0;
    chi * chi / (2.0 / root - 1.0)
}

/// The energy. With ε = 0 it is infinite for a Jacobian that is turned over.
pub(super) fn energy(j: DMat2, epsilon: f64, law: Law) -> f64 {
    let det = j.determinant();
    if epsilon == 0.0 && det <= 0.0 {
        return f64::INFINITY;
    }
    SCALE * (square(j) * Factor::at(det, epsilon, law).value - 2.0 * Factor::at(1.0, epsilon, law).value)
}

fn square(j: DMat2) -> f64 {
    j.x_axis.length_squared() + j.y_axis.length_squared()
}

impl Local {
    /// The derivatives of [`energy`], with second derivatives that are projected or exact.
    pub(super) fn of(j: DMat2, epsilon: f64, law: Law, is_projected: bool) -> Self {
        let [a, b, c, d] = j.to_cols_array();
        let square = square(j);
        let h = Factor::at(j.determinant(), epsilon, law);
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let (z, y) = (half * DVec2::new(a + d, b - c), half * DVec2::new(a - d, b + c));
        let (turned, mirrored) = (2.0 * h.value + square * h.first, 2.0 * h.value - square * h.first);
        let (x2, y2) = (z.length_squared(), y.length_squared());
        // The block of the lengths |z| and |y|.
        let xx = turned + 4.0 * x2 * h.first + square * h.second * x2;
        let yy = mirrored - 4.0 * y2 * h.first + square * h.second * y2;
        let xy = -square * h.second * (x2 * y2).sqrt();
        let ([xx, xy, yy], twist) = match is_projected {
            true => (positive(xx, xy, yy), turned.max(0.0)),
            false => ([xx, xy, yy], turned),
        };
        // In the directions of z and y, and across them: P = twist I + (xx − twist) ẑ ẑᵀ, and so on.
        let (zn, yn) = (z.try_normalize().unwrap_or(DVec2::X), y.try_normalize().unwrap_or(DVec2::X));
        let zz = outer(zn, zn, xx - twist) + DMat2::from_diagonal(DVec2::splat(twist));
        let yy = outer(yn, yn, yy - mirrored) + DMat2::from_diagonal(DVec2::splat(mirrored));
        let zy = outer(zn, yn, xy);
        // z = (c₀ + T c₁) / √2 and y = (c₀ − T c₁) / √2 for the columns c₀ and c₁ of J, with T a turn by −90°.
        let turn = DMat2::from_cols_array(&[0.0, -1.0, 1.0, 0.0]);
        let (into_z, into_y) = ([DMat2::IDENTITY, turn], [DMat2::IDENTITY, -1.0 * turn]);
        let block = |p: usize, q: usize| {
            let (zp, zq, yp, yq) = (into_z[p].transpose(), into_z[q], into_y[p].transpose(), into_y[q]);
            0.5 * (zp * (zz * zq + zy * yq) + yp * (zy.transpose() * zq + yy * yq))
        };
        let hessian = [[SCALE * block(0, 0), SCALE * block(0, 1)], [SCALE * block(1, 0), SCALE * block(1, 1)]];
        Self { gradient: Self::gradient(j, epsilon, law), hessian }
    }

    /// The derivative of [`energy`].
    pub(super) fn gradient(j: DMat2, epsilon: f64, law: Law) -> DMat2 {
        let [a, b, c, d] = j.to_cols_array();
        let h = Factor::at(j.determinant(), epsilon, law);
        SCALE * (2.0 * h.value * j + square(j) * h.first * DMat2::from_cols_array(&[d, -c, -b, a]))
    }

    /// The change of the gradient that a change of J makes.
    pub(super) fn change(&self, by: DMat2) -> DMat2 {
        let [[xx, xy], [yx, yy]] = self.hessian;
        DMat2::from_cols(xx * by.x_axis + xy * by.y_axis, yx * by.x_axis + yy * by.y_axis)
    }
}

fn outer(u: DVec2, v: DVec2, factor: f64) -> DMat2 {
    DMat2::from_cols(factor * v.x * u, factor * v.y * u)
}

/// The nearest positive semidefinite matrix to [xx xy; xy yy].
fn positive(xx: f64, xy: f64, yy: f64) -> [f64; 3] {
    let (mean, half) = (f64::midpoint(xx, yy), (xx - yy) / 2.0);
    let radius = (half * half + xy * xy).sqrt();
    if mean >= radius {
        return [xx, xy, yy];
    }
    let most = mean + radius;
    if most <= 0.0 || radius == 0.0 {
        return [0.0; 3];
    }
    // The projection to the eigenvector of the greater eigenvalue.
    let share = most / (2.0 * radius);
    [share * (radius + half), share * xy, share * (radius - half)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1e-6;

    fn maps() -> Vec<(DMat2, f64, Law)> {
        let of = |entries: [f64; 4]| DMat2::from_cols_array(&entries);
        let maps = [
            (of([1.0, 0.0, 0.0, 1.0]), 0.0),
            (of([0.6, -0.8, 0.8, 0.6]), 0.0),
            (of([1.7, 0.3, -0.2, 0.4]), 0.0),
            (of([0.3, 0.1, 0.2, 0.5]), 0.0),
            (of([0.3, 0.1, 0.2, 0.5]), 0.2),
            (of([0.9, 0.2, 0.1, -0.3]), 0.2),
            (of([0.9, 0.2, 0.1, -0.3]), 0.7),
        ];
        let laws = [Law::Distortion, Law::Flatness];
        maps.iter().flat_map(|&(j, epsilon)| laws.map(|law| (j, epsilon, law))).collect()
    }

    fn unit(entry: usize) -> DMat2 {
        let mut entries = [0.0; 4];
        entries[entry] = 1.0;
        DMat2::from_cols_array(&entries)
    }

    #[test]
    fn gradient_matches_differences_of_the_energy() {
        for (j, epsilon, law) in maps() {
            let gradient = Local::gradient(j, epsilon, law).to_cols_array();
            for (entry, expected) in gradient.into_iter().enumerate() {
                let by = STEP * unit(entry);
                let slope = (energy(j + by, epsilon, law) - energy(j - by, epsilon, law)) / (2.0 * STEP);
                assert!((slope - expected).abs() < 1e-5 * (1.0 + expected.abs()), "{j}: {slope}, {expected}");
            }
        }
    }

    #[test]
    fn hessian_matches_differences_of_the_gradient() {
        for (j, epsilon, law) in maps() {
            let local = Local::of(j, epsilon, law, false);
            for entry in 0..4 {
                let by = STEP * unit(entry);
                let slope =
                    (Local::gradient(j + by, epsilon, law) - Local::gradient(j - by, epsilon, law)) * (0.5 / STEP);
                let expected = local.change(unit(entry));
                let size = 1.0 + expected.to_cols_array().iter().map(|value| value.abs()).fold(0.0, f64::max);
                assert!((slope - expected).abs_diff_eq(DMat2::ZERO, 1e-4 * size), "{j}: {slope}, {expected}");
            }
        }
    }

    #[test]
    fn projected_second_derivatives_are_not_negative() {
        for (j, epsilon, law) in maps() {
            let local = Local::of(j, epsilon, law, true);
            for turn in 0..64 {
                let (a, b) = (f64::from(turn) * 0.7, f64::from(turn) * 0.3);
                let by = DMat2::from_cols(crate::pose::motion::turn(a), crate::pose::motion::turn(b));
                let change = local.change(by).to_cols_array();
                let curvature: f64 = by.to_cols_array().iter().zip(change).map(|(by, change)| by * change).sum();
                assert!(curvature > -1e-9, "{j}: {curvature}");
            }
        }
    }

    #[test]
    fn rotations_have_no_energy_and_folds_a_finite_one() {
        let turn = DMat2::from_angle(2.0);
        let fold = DMat2::from_diagonal(DVec2::new(1.0, -0.5));
        for law in [Law::Distortion, Law::Flatness] {
            assert!(energy(turn, 0.0, law).abs() < 1e-12 && energy(turn, 0.2, law).abs() < 1e-12);
            assert_eq!(energy(fold, 0.0, law), f64::INFINITY);
            assert!(energy(fold, 0.2, law).is_finite());
        }
    }
}
