//! The symmetric Dirichlet energy of a pose at a point.

use c2warp::{Solution, deform::Pose};
use glam::{DMat2, DVec2};

/// Cap of the energy, for points squeezed to a tenth or flipped.
pub(crate) const MAX_ENERGY: f64 = 100.0;

/// Returns |J|² + |J⁻¹|² − 4 at a point, or `None` if the domain does not surround it. It is 0 for a rigid motion.
pub(crate) fn energy_at(solution: &Solution, pose: &Pose, p: DVec2) -> Option<f64> {
    let step = 1e-3;
    let at = |p: DVec2| solution.map(pose, p).map(|mapped| mapped.posed);
    let [right, left, down, up] = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|axis| at(p + step * axis));
    let jacobian = DMat2::from_cols((right? - left?) / (2.0 * step), (down? - up?) / (2.0 * step));
    let square = |m: DMat2| m.x_axis.length_squared() + m.y_axis.length_squared();
    let energy = square(jacobian) + square(jacobian.inverse()) - 4.0;
    Some(if jacobian.determinant() > 0.0 { energy.min(MAX_ENERGY) } else { MAX_ENERGY })
}
