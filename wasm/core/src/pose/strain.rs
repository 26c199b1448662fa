//! The stretch around a site, as a logarithm.

use std::ops::{Add, Mul};

use glam::{DMat2, DVec2};

/// The least stretch of a length: its logarithm must be finite.
const MIN_STRETCH: f64 = 1e-9;

/// The logarithm of a stretch: a symmetric matrix [xx xy; xy yy].
///
/// Stretches blend as sums of their logarithms, so a blend of stretches is again a stretch: lengths remain above 0, and
/// nothing is rotated or inverted (log-Euclidean means: Arsigny et al. 2007).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Strain {
    /// Along x.
    pub xx: f64,
    /// The component between the axes.
    pub xy: f64,
    /// Along y.
    pub yy: f64,
}

impl Strain {
    /// A uniform stretch.
    pub(crate) fn uniform(scale: f64) -> Self {
        let log = libm::log(scale);
        Self { xx: log, xy: 0.0, yy: log }
    }

    /// A stretch by `along` in a unit direction and by `across` at right angles to it; at least 1e-9 each.
    pub(crate) fn of_bone(direction: DVec2, along: f64, across: f64) -> Self {
        // Written so that NaN is passed on.
        let log = |stretch: f64| libm::log(if stretch < MIN_STRETCH { MIN_STRETCH } else { stretch });
        let (along, across) = (log(along), log(across));
        let DVec2 { x, y } = direction;
        // ln(along) uuᵀ + ln(across) nnᵀ, written so that equal ones give an exact multiple of the identity.
        let excess = along - across;
        Self { xx: across + excess * x * x, xy: excess * x * y, yy: across + excess * y * y }
    }

    /// The stretch: the exponential in closed form, exact for a multiple of the identity.
    #[must_use]
    pub fn stretch(&self) -> DMat2 {
        // The most frequent case by far.
        if *self == Self::default() {
            return DMat2::IDENTITY;
        }
        // With mean m and trace-free part D, D² = r² I: exp(m I + D) = eᵐ (cosh r I + (sinh r / r) D).
        let (mean, half) = (self.mean(), (self.xx - self.yy) / 2.0);
        let r = libm::hypot(half, self.xy);
        let (even, odd) = (libm::cosh(r), if r == 0.0 { 1.0 } else { libm::sinh(r) / r });
        let across = odd * self.xy;
        libm::exp(mean) * DMat2::from_cols_array(&[even + odd * half, across, across, even - odd * half])
    }

    /// The stretch with its smaller principal stretch raised to at least `ratio` times the larger one, but not above
    /// 1.
    pub(crate) fn shrunk_by_at_most(&self, ratio: f64) -> Self {
        let (mean, half) = (self.mean(), (self.xx - self.yy) / 2.0);
        let r = libm::hypot(half, self.xy);
        let (long, short) = (mean + r, mean - r);
        let least = (long + libm::log(ratio)).min(0.0);
        // Written so that NaN is passed on.
        if short >= least || r == 0.0 {
            return *self;
        }
        let (middle, excess) = (f64::midpoint(long, least), (long - least) / (2.0 * r));
        Self { xx: middle + excess * half, xy: excess * self.xy, yy: middle - excess * half }
    }

    /// The logarithm of the uniform scale with the same change of area.
    pub(crate) fn mean(&self) -> f64 {
        (self.xx + self.yy) / 2.0
    }
}

impl Add for Strain {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { xx: self.xx + other.xx, xy: self.xy + other.xy, yy: self.yy + other.yy }
    }
}

impl Mul<Strain> for f64 {
    type Output = Strain;

    fn mul(self, strain: Strain) -> Strain {
        Strain { xx: self * strain.xx, xy: self * strain.xy, yy: self * strain.yy }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::motion::turn;

    #[test]
    fn a_uniform_strain_is_a_multiple_of_the_identity_to_the_last_bit() {
        for scale in [1e-6, 0.3, 1.0, 1.7, 1e9] {
            let scaled = libm::exp(libm::log(scale));
            assert_eq!(Strain::uniform(scale).stretch(), DMat2::from_diagonal(DVec2::splat(scaled)));
            let bone = Strain::of_bone(turn(0.7), scale, scale);
            assert_eq!(bone.stretch(), DMat2::from_diagonal(DVec2::splat(scaled)));
        }
    }

    #[test]
    fn a_bone_is_stretched_along_itself_and_across() {
        for (angle, along, across) in [(0.0, 2.0, 1.0), (0.4, 3.0, 0.5), (2.0, 1e-3, 1.0), (-1.2, 1.0, 1.0 + 1e-9)] {
            let u = turn(angle);
            let stretch = Strain::of_bone(u, along, across).stretch();
            assert!((stretch * u).distance(along * u) < 1e-12, "{stretch}");
            assert!((stretch * u.perp()).distance(across * u.perp()) < 1e-12, "{stretch}");
        }
    }

    #[test]
    fn zero_length_bone_keeps_a_positive_stretch() {
        let stretch = Strain::of_bone(DVec2::X, 0.0, 1.0).stretch();
        assert!((stretch.determinant() - 1e-9).abs() < 1e-15);
        assert!(Strain::of_bone(DVec2::X, f64::NAN, 1.0).stretch().is_nan());
    }

    #[test]
    fn a_shrunk_stretch_keeps_a_least_ratio_and_a_grown_one_stays() {
        let u = turn(0.9);
        for (along, across, least) in
            [(0.0, 1.0, 0.1), (1e-4, 3.0, 0.3), (0.0, 30.0, 1.0), (0.2, 1.0, 0.2), (50.0, 1.0, 1.0)]
        {
            let stretch = Strain::of_bone(u, along, across).shrunk_by_at_most(0.1).stretch();
            let expected = if along < across { (least, across) } else { (along, across) };
            assert!((stretch * u).distance(expected.0 * u) < 1e-9, "{along} {across}: {stretch}");
            assert!((stretch * u.perp()).distance(expected.1 * u.perp()) < 1e-9, "{along} {across}: {stretch}");
        }
        assert_eq!(Strain::uniform(1e-3).shrunk_by_at_most(0.1), Strain::uniform(1e-3));
    }

    #[test]
    fn strains_along_one_bone_multiply() {
        let u = turn(0.9);
        let [twice, thrice] = [2.0, 3.0].map(|along| Strain::of_bone(u, along, 1.0));
        let six = Strain::of_bone(u, 6.0, 1.0).stretch();
        assert!((twice + thrice).stretch().abs_diff_eq(six, 1e-12));
        assert!((0.5 * Strain::of_bone(u, 9.0, 1.0)).stretch().abs_diff_eq(thrice.stretch(), 1e-12));
    }
}
