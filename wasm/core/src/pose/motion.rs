//! T_i: the map of the points around a site.

use glam::{DMat2, DVec2};

use super::Strain;
use crate::limits::MAX_POSED;

/// A stretch and then a rotation about the site's rest position, and a translation: T(p) = posed + R(angle) exp(strain)
/// (p − rest).
///
/// It is stored as logarithms, which blend as sums (eq. 4): opposite rotations cannot cancel out, unlike the paper's
/// quaternions, and more than half a turn remains more than half a turn. Blending about the site's own position makes
/// the result independent of the picture's origin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Motion {
    /// Rotation in radians, from x towards y, not limited to one turn.
    pub angle: f64,
    /// Logarithm of the stretch, in the rest frame.
    pub strain: Strain,
    /// Posed position minus rest position, in pixels.
    pub translation: DVec2,
    /// Drawing order where the picture covers itself: greater is nearer.
    pub depth: f64,
}

/// Least stretch over the greatest: a site may flatten its surroundings, but not invert them.
const MIN_STRETCH_RATIO: f64 = 0.1;

impl Motion {
    /// Angle; strain xx, xy, yy; translation x, y; depth.
    #[must_use]
    pub fn numbers(&self) -> [f64; 7] {
        let Self { angle, strain, translation, depth } = *self;
        [angle, strain.xx, strain.xy, strain.yy, translation.x, translation.y, depth]
    }

    /// The motion of [`numbers`](Self::numbers).
    #[must_use]
    pub fn from_numbers(&[angle, xx, xy, yy, x, y, depth]: &[f64; 7]) -> Self {
        Self { angle, strain: Strain { xx, xy, yy }, translation: DVec2::new(x, y), depth }
    }

    /// A rotation and a scale above 0: the motion of a point.
    pub(crate) fn similarity(angle: f64, scale: f64, translation: DVec2, depth: f64) -> Self {
        Self { angle, strain: Strain::uniform(scale), translation, depth }
    }

    /// The motion of a bone: a stretch by `along` in a unit `direction` of the rest frame and by `across` at
    /// right angles to it, then a rotation. Stretches below 1e-9 are set to 1e-9.
    pub(crate) fn of_bone(
        angle: f64,
        direction: DVec2,
        along: f64,
        across: f64,
        translation: DVec2,
        depth: f64,
    ) -> Self {
        Self { angle, strain: Strain::of_bone(direction, along, across), translation, depth }
    }

    /// The same map relative to a point at the offset `from`, with the linear part `linear`.
    pub(crate) fn seen_from(&self, from: DVec2, linear: DMat2) -> Self {
        Self { translation: self.translation + linear * from - from, ..*self }
    }

    /// The motion used in blends: a bar that is posed to zero length flattens its surroundings, but does not collapse
    /// them.
    pub(crate) fn passed_on(&self) -> Self {
        Self { strain: self.strain.shrunk_by_at_most(MIN_STRETCH_RATIO), ..*self }
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

    /// Whether all numbers computed from the motion remain far from overflow. False for NaN.
    pub(crate) fn is_in_bounds(&self) -> bool {
        let linear = self.linear();
        let stretch = linear.x_axis.length() + linear.y_axis.length();
        stretch <= MAX_POSED && self.translation.length() <= MAX_POSED && self.depth.abs() <= MAX_POSED
    }
}

/// Cosine and sine of an angle: the rotation as a complex number.
pub(crate) fn turn(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}

/// The least stretch of a map over its greatest.
const LEAST_RATIO: f64 = 1e-3;

/// Polar decomposition: the rotation nearest to a map, and the logarithm of the remaining stretch, at least
/// [`LEAST_RATIO`] of its greatest.
pub(super) fn polar(map: DMat2) -> (f64, Strain) {
    let [a, b, c, d] = map.to_cols_array();
    let (cos, sin) = (a + d, b - c);
    // The stretch is mean · I + D with D symmetric and trace-free: mean and |D| are invariant under rotation.
    let mean = libm::hypot(cos, sin) / 2.0;
    if mean <= f64::MIN_POSITIVE {
        return (0.0, Strain::default());
    }
    let back = DVec2::new(cos, -sin) / (2.0 * mean);
    let [x, y] = [map.x_axis, map.y_axis].map(|axis| back.rotate(axis));
    let (half, across) = ((x.x - y.y) / 2.0, f64::midpoint(x.y, y.x));
    let radius = libm::hypot(half, across);
    let most = mean + radius;
    let (long, short) = (libm::log(most), libm::log((mean - radius).max(LEAST_RATIO * most)));
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
    fn no_map_is_inverted() {
        for (x, y) in [(1.0, -9.0), (0.0, 0.0), (-2.0, 2.0)] {
            let (angle, strain) = polar(DMat2::from_diagonal(DVec2::new(x, y)));
            let motion = Motion { angle, strain, ..Motion::default() };
            assert!(motion.linear().determinant() > 0.0, "{motion:?}");
        }
    }
}
