//! T_i: what a site does to the points around it.

use glam::{DMat2, DVec2};

use super::Strain;

/// A stretch and then a rotation about the site's own rest place, and a translation: T(p) = posed + R(angle) exp(strain) (p − rest).
///
/// Kept as logarithms, which is how motions blend (eq. 4): angles and logarithms of stretches have no length to lose, so
/// opposite rotations cannot cancel to nothing as the quaternions of the paper can, and more than half a turn stays more
/// than half a turn. Blending about the site's own place makes the result independent of where the picture's corner is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Turn in radians, from x towards y, of any number of turns.
    pub angle: f64,
    /// Logarithm of the stretch, in the rest frame.
    pub strain: Strain,
    /// Where the site goes, less where it was, in pixels.
    pub translation: DVec2,
    /// What lies over what: more is nearer.
    pub depth: f64,
}

/// Greatest stretch, translation in pixels, and depth.
const BOUND: f64 = 1e12;
/// Least stretch, as a share of the greatest: a site may flatten what is around it, but not turn it over.
const LEAST: f64 = 0.1;

impl Motion {
    /// A turn and a scale above 0, the motion of a point.
    #[must_use]
    pub fn similarity(angle: f64, scale: f64, translation: DVec2, depth: f64) -> Self {
        Self { angle, strain: Strain::uniform(scale), translation, depth }
    }

    /// A turn of what was stretched by `along` in a `direction` of the rest frame, of length 1, and by `across` at right angles
    /// to it: the motion of a bone. Stretches below 1e-9 count as that.
    #[must_use]
    pub fn of_bone(angle: f64, direction: DVec2, along: f64, across: f64, translation: DVec2, depth: f64) -> Self {
        Self { angle, strain: Strain::of_bone(direction, along, across), translation, depth }
    }

    /// The same motion as one about a place `from` away, where its linear part is `linear`.
    pub(crate) fn seen_from(&self, from: DVec2, linear: DMat2) -> Self {
        Self { translation: self.translation + linear * from - from, ..*self }
    }

    /// What there is of it in other motions: a bar that is drawn to nothing flattens what is around it, and does not take it along
    /// into nothing.
    pub(crate) fn passed_on(&self) -> Self {
        Self { strain: self.strain.shrunk_by_at_most(LEAST), ..*self }
    }

    /// The weighted sum of motions.
    pub(crate) fn blended(motions: impl Iterator<Item = (Self, f64)>) -> Self {
        motions.fold(Self::default(), |sum, (motion, weight)| Self {
            angle: sum.angle + weight * motion.angle,
            strain: sum.strain + weight * motion.strain,
            translation: sum.translation + weight * motion.translation,
            depth: sum.depth + weight * motion.depth,
        })
    }

    /// The linear part, R(angle) exp(strain).
    pub(crate) fn linear(&self) -> DMat2 {
        let turn = turn(self.angle);
        DMat2::from_cols(turn, turn.perp()) * self.strain.stretch()
    }

    /// Whether everything computed from the motion stays far from overflow. NaN is not in bounds.
    pub(crate) fn is_in_bounds(&self) -> bool {
        let linear = self.linear();
        let stretch = linear.x_axis.length() + linear.y_axis.length();
        stretch <= BOUND && self.translation.length() <= BOUND && self.depth.abs() <= BOUND
    }
}

/// Cosine and sine of an angle: the turn by it, as a complex number.
pub(super) fn turn(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}

/// The rotation nearest to a map, and the logarithm of the stretch that is left, at least [`LEAST`] of its greatest.
pub(super) fn polar(map: DMat2) -> (f64, Strain) {
    let [a, b, c, d] = map.to_cols_array();
    let (cos, sin) = (a + d, b - c);
    // The stretch is mean · I + D, with D symmetric and of trace 0: both mean and |D| are invariant under rotation.
    let mean = libm::hypot(cos, sin) / 2.0;
    if mean <= f64::MIN_POSITIVE {
        return (0.0, Strain::default());
    }
    let back = DVec2::new(cos, -sin) / (2.0 * mean);
    let [x, y] = [map.x_axis, map.y_axis].map(|axis| back.rotate(axis));
    let (half, across) = ((x.x - y.y) / 2.0, f64::midpoint(x.y, y.x));
    let radius = libm::hypot(half, across);
    let most = mean + radius;
    let (long, short) = (libm::log(most), libm::log((mean - radius).max(LEAST * most)));
    let middle = f64::midpoint(long, short);
    let excess = if radius > 0.0 { (long - short) / (2.0 * radius) } else { 0.0 };
    let strain = Strain { xx: middle + excess * half, xy: excess * across, yy: middle - excess * half };
    (libm::atan2(sin, cos), strain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_is_its_rotation_and_stretch() {
        let expected = Motion { angle: 2.5, strain: Strain { xx: 0.3, xy: -0.2, yy: -0.6 }, ..Motion::default() };
        let (angle, strain) = polar(expected.linear());
        let found = Motion { angle, strain, ..Motion::default() };
        assert!((found.linear() - expected.linear()).abs_diff_eq(DMat2::ZERO, 1e-12), "{found:?}");
        assert!((angle - 2.5).abs() < 1e-12, "{angle}");
    }

    #[test]
    fn no_map_turns_over() {
        for (x, y) in [(1.0, -9.0), (0.0, 0.0), (-2.0, 2.0)] {
            let (angle, strain) = polar(DMat2::from_diagonal(DVec2::new(x, y)));
            let motion = Motion { angle, strain, ..Motion::default() };
            assert!(motion.linear().determinant() > 0.0, "{motion:?}");
        }
    }
}
