//! How much a map distorts: the symmetric Dirichlet energy of its derivative J, |J|² + |J⁻¹|² (Smith and Schaefer 2015).
//!
//! It is least for rotations. Near one it counts strains as as-rigid-as-possible does, but it also rises beyond all bounds where
//! J loses an axis, so what it shapes does not collapse. As |J⁻¹|² = |J|² / det² in the plane, it is made finite, and steep
//! towards recovery, where J has turned over: det gives way to χ(det) = (det + √(det² + δ²)) / 2 > 0 (Garanzha et al. 2021).

use glam::DMat2;

/// The energy for one softness δ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distortion {
    /// δ².
    softness: f64,
    /// Of the second term: without it the softer det would make the least a little larger than a rotation.
    factor: f64,
    /// The energy of a rotation.
    least: f64,
}

/// The energy of one J, and its derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Height {
    pub(super) energy: f64,
    pub(super) by_det: f64,
    pub(super) by_square: f64,
    pub(super) by_det_twice: f64,
    pub(super) by_both: f64,
}

impl Distortion {
    /// `softness` must be below 1.
    pub(super) fn new(softness: f64) -> Self {
        let softness = softness * softness;
        let root = (1.0 + softness).sqrt();
        let chi = (1.0 + root) / 2.0;
        // Where the derivative by a uniform scale is 0 at a scale of 1; χ′ = χ / √(det² + δ²).
        let factor = chi * chi / (2.0 / root - 1.0);
        Self { softness, factor, least: 2.0 * (1.0 + factor / (chi * chi)) }
    }

    /// The energy by det J and |J|², scaled and shifted so that a J near a rotation R has about |J − R|² / 2.
    pub(super) fn of(&self, det: f64, square: f64) -> Height {
        let root = (det * det + self.softness).sqrt();
        let chi = (det + root) / 2.0;
        // One division for all.
        let share = 1.0 / (chi * chi * root);
        let (inverse, by_root) = (self.factor * share * root, share * chi * chi);
        Height {
            energy: ((1.0 + inverse) * square - self.least) / 8.0,
            by_det: -0.25 * inverse * by_root * square,
            by_square: (1.0 + inverse) / 8.0,
            by_det_twice: 0.25 * inverse * by_root * by_root * square * (2.0 + det * by_root),
            by_both: -0.25 * inverse * by_root,
        }
    }
}

/// The gradient by J, from the derivatives by its det and square.
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

    const SOFTNESS: [f64; 3] = [0.01, 0.2, 0.5];

    fn energy(distortion: &Distortion, j: DMat2) -> f64 {
        distortion.of(j.determinant(), square(j)).energy
    }

    fn slope(distortion: &Distortion, j: DMat2) -> DMat2 {
        let Height { by_det, by_square, .. } = distortion.of(j.determinant(), square(j));
        gradient(j, by_det, by_square)
    }

    #[test]
    fn rotations_have_none() {
        for (softness, angle) in SOFTNESS.into_iter().zip([0.3, 2.0, -3.0]) {
            let (distortion, rotation) = (Distortion::new(softness), DMat2::from_angle(angle));
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
        for distortion in SOFTNESS.map(Distortion::new) {
            let of = |x| energy(&distortion, DMat2::from_diagonal(DVec2::new(1.0, x)));
            let energies = [1.0, 0.5, 0.2, 0.0, -0.2, -0.5].map(of);
            assert!(energies.windows(2).all(|pair| pair[0] < pair[1] && pair[1].is_finite()), "{energies:?}");
        }
    }
}
