//! The six numbers that pose a bone in a format, and that are interpolated linearly.

use std::f64::consts::{PI, TAU};

use glam::{DAffine2, DMat2, DVec2};

/// x, y, two angles in radians and two scales.
pub(crate) type Numbers = [f64; 6];

/// Relative difference of the scales below which the direction of stretch is undefined.
const ISOTROPIC: f64 = 1e-9;

/// How a linear map is decomposed into angles and scales.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Chart {
    /// The angle of the x axis, the angle of the y axis against a right angle, and the lengths of both axes. Spine,
    /// DragonBones and Godot support bones with shear.
    Sheared,
    /// R(first) diag(scales) R(second): a bone with unequal scales that contains a rotated bone. glTF does not support
    /// shear.
    Chained,
}

impl Chart {
    /// The numbers of a bone, with angles as near as possible to the previous ones.
    pub(crate) fn numbers(self, bone: &DAffine2, before: Option<&Numbers>) -> Numbers {
        let DVec2 { x, y } = bone.translation;
        let [a, b] = [bone.matrix2.x_axis, bone.matrix2.y_axis];
        match self {
            Self::Sheared => {
                let turn = near(libm::atan2(a.y, a.x), before.map_or(0.0, |before| before[2]));
                let across = libm::atan2(-b.x, b.y);
                let shear = near(across - turn, before.map_or(0.0, |before| before[3]));
                [x, y, turn, shear, a.length(), b.length()]
            }
            Self::Chained => {
                let (e, f) = ((a.x + b.y) / 2.0, (a.x - b.y) / 2.0);
                let (g, h) = ((a.y + b.x) / 2.0, (a.y - b.x) / 2.0);
                let (mean, half) = (libm::hypot(e, h), libm::hypot(f, g));
                let [sum, difference] =
                    before.map_or([0.0; 2], |before| [before[2] + before[3], before[2] - before[3]]);
                let sum = near(libm::atan2(h, e), sum);
                if half <= ISOTROPIC * mean {
                    return [x, y, (sum + difference) / 2.0, (sum - difference) / 2.0, mean, mean];
                }
                let direction = libm::atan2(g, f);
                let straight = near(direction, difference);
                // Half a turn of the direction with the scales exchanged is the same stretch.
                let exchanged = near(direction + PI, difference);
                let is_exchanged = (exchanged - difference).abs() < (straight - difference).abs();
                let (difference, half) = if is_exchanged { (exchanged, -half) } else { (straight, half) };
                [x, y, (sum + difference) / 2.0, (sum - difference) / 2.0, mean + half, mean - half]
            }
        }
    }

    /// The map of a bone with the given numbers.
    pub(crate) fn map(self, [x, y, first, second, along, across]: Numbers) -> DAffine2 {
        let matrix2 = match self {
            Self::Sheared => DMat2::from_cols(along * turn(first), across * turn(first + second).perp()),
            Self::Chained => rotation(first) * DMat2::from_diagonal(DVec2::new(along, across)) * rotation(second),
        };
        DAffine2 { matrix2, translation: DVec2::new(x, y) }
    }
}

/// Linear interpolation of the numbers.
pub(crate) fn between(a: &Numbers, b: &Numbers, along: f64) -> Numbers {
    std::array::from_fn(|k| a[k] + (b[k] - a[k]) * along)
}

fn turn(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}

fn rotation(angle: f64) -> DMat2 {
    let turn = turn(angle);
    DMat2::from_cols(turn, turn.perp())
}

/// The angle plus whole turns that is nearest to another angle.
fn near(angle: f64, other: f64) -> f64 {
    angle - TAU * libm::round((angle - other) / TAU)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_restore_the_map() {
        for chart in [Chart::Sheared, Chart::Chained] {
            let mut before: Option<Numbers> = None;
            for step in 0..200 {
                let t = f64::from(step) / 20.0;
                let matrix2 = DMat2::from_cols(turn(t) * (1.0 + t / 20.0), turn(t + 1.4 + libm::sin(t) / 4.0));
                let bone = DAffine2 { matrix2, translation: DVec2::new(t, -t) };
                let numbers = chart.numbers(&bone, before.as_ref());
                let found = chart.map(numbers);
                assert!(found.abs_diff_eq(bone, 1e-12), "{chart:?} at {t}: {found} for {bone}");
                let jump = before.map_or(0.0, |before| (numbers[2] - before[2]).abs());
                assert!(jump < 0.5, "{chart:?} jumps by {jump} at {t}");
                before = Some(numbers);
            }
        }
    }

    #[test]
    fn a_bone_without_stretch_has_no_second_angle() {
        let bone = DAffine2 { matrix2: 1.5 * rotation(0.7), translation: DVec2::ZERO };
        let [_, _, first, second, along, across] = Chart::Chained.numbers(&bone, None);
        assert!((first + second - 0.7).abs() < 1e-12 && along == across);
    }
}
