//! Distortion of a map: the symmetric Dirichlet energy of its Jacobian J, |J|² + |J⁻¹|² (Smith and Schaefer 2015).
//!
//! Rotations have the least energy. Near a rotation it measures strain like the as-rigid-as-possible energy, but it
//! also grows without bound where J becomes singular, so shapes do not collapse. In the plane |J⁻¹|² = |J|² / det². It
//! replaces det by χ(det) = (det + √(det² + ε²)) / 2 > 0 (Garanzha et al. 2021). So it is also finite for an inverted
//! J, with a steep gradient towards recovery.
//!
//! Cost: one square root and one division for each evaluation.

use wide::f64x4;

use super::{super::numeric::Jet, jacobians::Jacobians};

/// The energy for one regularisation ε, as f(det J) |J|² − [`least`](Self::least): about |J − R|² / 2 near a rotation
/// R.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distortion {
    /// ε².
    regularisation: f64,
    /// Factor of |J|² / χ².
    inverse: f64,
    /// Subtracted so that a rotation has zero energy.
    pub(super) least: f64,
}

/// The square of a strain counts four times in the symmetric Dirichlet energy.
const SCALE: f64 = 1.0 / 8.0;

impl Distortion {
    /// `regularisation` is ε, below 1.
    pub(super) fn new(regularisation: f64) -> Self {
        let regularisation = regularisation * regularisation;
        let root = (1.0 + regularisation).sqrt();
        let chi = (1.0 + root) / 2.0;
        // Chosen so that the derivative with respect to a uniform scale is 0 at scale 1, as χ′ = χ / √(det² + ε²):
        // with 1 in its place, χ would shift the minimum to a scale a little above 1.
        let factor = chi * chi / (2.0 / root - 1.0);
        Self { regularisation, inverse: SCALE * factor, least: SCALE * 2.0 * (1.0 + factor / (chi * chi)) }
    }

    /// f at the determinants of several J.
    #[inline]
    pub(super) fn factor(&self, det: f64x4) -> Jet<f64x4> {
        let root = (det * det + self.regularisation).sqrt();
        let chi = 0.5 * (det + root);
        // One division for all.
        let reciprocal = 1.0 / (chi * chi * root);
        let (inverse, by_root) = (self.inverse * reciprocal * root, reciprocal * chi * chi);
        let around = by_root * (1.0 + det * by_root);
        let first = -2.0 * inverse * by_root;
        Jet { value: SCALE + inverse, first, second: -first * (by_root + around), third: 3.0 * first * around * around }
    }
}

/// The gradient of the energy with respect to J, from f at its determinant and |J|².
#[inline]
pub(super) fn gradient(j: &Jacobians, factor: &Jet<f64x4>, square: f64x4) -> Jacobians {
    2.0 * factor.value * *j + factor.first * square * j.cofactors()
}

#[cfg(test)]
mod tests {
    use glam::{DMat2, DVec2};

    use super::*;

    const REGULARISATIONS: [f64; 3] = [0.01, 0.2, 0.5];

    fn energy(distortion: &Distortion, j: DMat2) -> f64 {
        let j = Jacobians::new([j; 4]);
        (distortion.factor(j.det()).value * j.square()).to_array()[0] - distortion.least
    }

    fn slope(distortion: &Distortion, j: DMat2) -> DMat2 {
        let j = Jacobians::new([j; 4]);
        gradient(&j, &distortion.factor(j.det()), j.square()).to_array()[0]
    }

    #[test]
    fn rotations_have_no_energy() {
        for (regularisation, angle) in REGULARISATIONS.into_iter().zip([0.3, 2.0, -3.0]) {
            let (distortion, rotation) = (Distortion::new(regularisation), DMat2::from_angle(angle));
            let (energy, gradient) = (energy(&distortion, rotation), slope(&distortion, rotation));
            assert!(energy.abs() < 1e-15 && gradient.abs_diff_eq(DMat2::ZERO, 1e-15), "{energy} {gradient}");
        }
    }

    #[test]
    fn small_strains_count_as_in_as_rigid_as_possible() {
        let strain = DMat2::from_cols_array(&[2e-4, -1e-4, -1e-4, 3e-4]);
        let energy = energy(&Distortion::new(0.01), DMat2::from_angle(1.0) * (DMat2::IDENTITY + strain));
        let expected = (4.0 + 1.0 + 1.0 + 9.0) * 1e-8 / 2.0;
        // The next order of the energy is of the size of the strain.
        assert!((energy / expected - 1.0).abs() < 1e-3, "{energy} in place of {expected}");
    }

    #[test]
    fn gradient_matches_the_energy_even_if_inverted() {
        let step = 1e-6;
        for entries in [[1.2, 0.4, -0.3, 0.8], [0.3, 0.1, 0.2, 0.1], [1.0, 0.0, 0.0, -0.4], [0.0; 4]] {
            let distortion = Distortion::new(0.2);
            let gradient = slope(&distortion, DMat2::from_cols_array(&entries));
            for (at, found) in gradient.to_cols_array().into_iter().enumerate() {
                let by = |by: f64| {
                    let mut moved = entries;
                    moved[at] += by;
                    energy(&distortion, DMat2::from_cols_array(&moved))
                };
                let slope = (by(step) - by(-step)) / (2.0 * step);
                assert!((slope - found).abs() < 1e-4 * (1.0 + slope.abs()), "{slope} and {found} at {entries:?}");
            }
        }
    }

    #[test]
    fn derivatives_of_the_factor_are_those_of_its_values() {
        for distortion in REGULARISATIONS[1..].iter().map(|&regularisation| Distortion::new(regularisation)) {
            for det in [-0.6, -0.05, 0.0, 0.3, 1.0, 2.5] {
                let factor = |det: f64| distortion.factor(det.into()).map(|lanes| lanes.to_array()[0]);
                // The next but one derivative times the square of the step.
                Jet::assert_slopes(factor, det, 1e-5);
            }
        }
    }

    #[test]
    fn inversion_costs_more_than_compression() {
        for distortion in REGULARISATIONS.map(Distortion::new) {
            let of = |x| energy(&distortion, DMat2::from_diagonal(DVec2::new(1.0, x)));
            let energies = [1.0, 0.5, 0.2, 0.0, -0.2, -0.5].map(of);
            assert!(energies.windows(2).all(|pair| pair[0] < pair[1] && pair[1].is_finite()), "{energies:?}");
        }
    }
}
