//! Distortion of a map: the symmetric Dirichlet energy of its Jacobian J, |J|² + |J⁻¹|² (Smith and Schaefer 2015).
//!
//! Rotations have the least energy. Near a rotation it measures strain as as-rigid-as-possible does, but it also grows
//! without bound where J becomes singular, so shapes do not collapse. In the plane |J⁻¹|² = |J|² / det². To be finite for an
//! inverted J too, with a steep gradient towards recovery, it has χ(det) = (det + √(det² + ε²)) / 2 > 0 in place of det
//! (Garanzha et al. 2021).
//!
//! Cost: one square root and one division for each evaluation.

use glam::DMat2;

/// The energy for one regularisation ε.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distortion {
    /// ε².
    regularisation: f64,
    /// Factor of the second term: without it, χ in place of det would shift the minimum to a scale a little above 1.
    factor: f64,
    /// The energy of a rotation.
    least: f64,
}

/// The energy of one J, and its derivatives with respect to det J and |J|².
#[derive(Debug, Clone, Copy)]
pub(super) struct EnergyDerivatives {
    pub(super) energy: f64,
    pub(super) by_det: f64,
    pub(super) by_square: f64,
    pub(super) by_det_twice: f64,
    pub(super) by_both: f64,
}

impl Distortion {
    /// `regularisation` is ε, below 1.
    pub(super) fn new(regularisation: f64) -> Self {
        let regularisation = regularisation * regularisation;
        let root = (1.0 + regularisation).sqrt();
        let chi = (1.0 + root) / 2.0;
        // Chosen so that the derivative with respect to a uniform scale is 0 at scale 1; χ′ = χ / √(det² + ε²).
        let factor = chi * chi / (2.0 / root - 1.0);
        Self { regularisation, factor, least: 2.0 * (1.0 + factor / (chi * chi)) }
    }

    /// The energy as a function of det J and |J|², scaled and shifted to about |J − R|² / 2 near a rotation R.
    pub(super) fn of(&self, det: f64, square: f64) -> EnergyDerivatives {
        let root = (det * det + self.regularisation).sqrt();
        let chi = (det + root) / 2.0;
        // One division for all.
        let share = 1.0 / (chi * chi * root);
        let (inverse, by_root) = (self.factor * share * root, share * chi * chi);
        EnergyDerivatives {
            energy: ((1.0 + inverse) * square - self.least) / 8.0,
            by_det: -0.25 * inverse * by_root * square,
            by_square: (1.0 + inverse) / 8.0,
            by_det_twice: 0.25 * inverse * by_root * by_root * square * (2.0 + det * by_root),
            by_both: -0.25 * inverse * by_root,
        }
    }
}

/// The gradient with respect to J, from the derivatives with respect to det J and |J|².
pub(super) fn gradient(j: DMat2, by_det: f64, by_square: f64) -> DMat2 {
    let by_square = 2.0 * by_square;
    DMat2::from_cols(
        by_square * j.x_axis - by_det * j.y_axis.perp(), //
        by_square * j.y_axis + by_det * j.x_axis.perp(),
    )
}

/// |J|².
pub(super) fn square(j: DMat2) -> f64 {
    j.x_axis.length_squared() + j.y_axis.length_squared()
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    const REGULARISATIONS: [f64; 3] = [0.01, 0.2, 0.5];

    fn energy(distortion: &Distortion, j: DMat2) -> f64 {
        distortion.of(j.determinant(), square(j)).energy
    }

    fn slope(distortion: &Distortion, j: DMat2) -> DMat2 {
        let EnergyDerivatives { by_det, by_square, .. } = distortion.of(j.determinant(), square(j));
        gradient(j, by_det, by_square)
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
    fn the_gradient_is_that_of_the_energy_turned_over_or_not() {
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
    fn what_turns_over_costs_more_than_what_is_squeezed() {
        for distortion in REGULARISATIONS.map(Distortion::new) {
            let of = |x| energy(&distortion, DMat2::from_diagonal(DVec2::new(1.0, x)));
            let energies = [1.0, 0.5, 0.2, 0.0, -0.2, -0.5].map(of);
            assert!(energies.windows(2).all(|pair| pair[0] < pair[1] && pair[1].is_finite()), "{energies:?}");
        }
    }
}
