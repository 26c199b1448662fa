//! Rounding of poses as the editor stores them: the fold guard must test the pose that is kept.

use glam::DVec2;

/// Numbers of at least this size are not rounded, because their hundredths are insignificant.
const BEYOND: f64 = 1e12;

/// The nearest integer; half way, the greater one, like `Math.round` in JavaScript.
fn nearest_integer(value: f64) -> f64 {
    let low = value.floor();
    if value - low < 0.5 { low } else { low + 1.0 }
}

/// Rounds to hundredths of a pixel or degree; never −0.
pub(super) fn rounded(value: f64) -> f64 {
    if value.abs() < BEYOND { nearest_integer(value * 100.0) / 100.0 + 0.0 } else { value }
}

/// Rounds to ten-thousandths: hundredths would lose small steps of a small scale.
pub(super) fn rounded_scale(scale: f64) -> f64 {
    nearest_integer(scale * 1e4) / 1e4
}

pub(super) fn rounded_point(p: DVec2) -> DVec2 {
    DVec2::new(rounded(p.x), rounded(p.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_rounded_up_as_in_javascript() {
        let values = [1.125, -1.125, 0.004_999, -0.004, 12.3, 3e12 + 0.123, f64::INFINITY];
        let expected = [1.13, -1.12, 0.0, 0.0, 12.3, 3e12 + 0.123, f64::INFINITY];
        assert_eq!(values.map(rounded), expected);
        assert!(rounded(-0.004).is_sign_positive());
        assert!(rounded(f64::NAN).is_nan());
        assert_eq!(rounded_scale(0.123_45), 0.1235);
    }
}
