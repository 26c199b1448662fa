//! T_i: what a site does to the points around it.

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A rotation and uniform scale about the site's own rest place, and a translation.
///
/// Kept as logarithms, which is how motions blend (eq. 4): angles and logarithms of scales have no length to lose, so
/// opposite rotations cannot cancel to nothing as the quaternions of the paper can, and more than half a turn stays more
/// than half a turn. Blending about the site's own place makes the result independent of where the picture's corner is.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// Turn in radians, from x towards y, of any number of turns.
    pub angle: f64,
    /// Natural logarithm of the scale.
    pub log_scale: f64,
    /// Where the site goes, less where it was, in pixels.
    pub translation: DVec2,
    /// What lies over what: more is nearer.
    pub depth: f64,
}

/// Greatest scale, translation in pixels, and depth.
const BOUND: f64 = 1e12;

impl Motion {
    /// The weighted sum of motions.
    pub(crate) fn blended(motions: impl Iterator<Item = (Self, f64)>) -> Self {
        motions.fold(Self::default(), |sum, (motion, weight)| Self {
            angle: sum.angle + weight * motion.angle,
            log_scale: sum.log_scale + weight * motion.log_scale,
            translation: sum.translation + weight * motion.translation,
            depth: sum.depth + weight * motion.depth,
        })
    }

    /// Scale times cosine and sine of the angle: the linear part [a −b; b a].
    pub(crate) fn linear(&self) -> DVec2 {
        let scale = libm::exp(self.log_scale);
        let (sin, cos) = libm::sincos(self.angle);
        scale * DVec2::new(cos, sin)
    }

    /// Whether everything computed from the motion stays far from overflow. NaN is not in bounds.
    pub(crate) fn is_in_bounds(&self) -> bool {
        self.linear().length() <= BOUND && self.translation.length() <= BOUND && self.depth.abs() <= BOUND
    }
}
