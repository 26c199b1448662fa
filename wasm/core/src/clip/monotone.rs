//! Monotone cubics: slopes at knots that keep a cubic within the values of both its ends.

/// The stretch between two knots.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// Its length in time, above 0.
    pub(super) length: f64,
    /// Its mean rate of change.
    pub(super) rate: f64,
}

/// Fritsch and Butland's slope at a knot between two stretches: 0 at an extremum, otherwise a weighted harmonic mean of
/// both rates. It is at most three times the lesser rate, so neither cubic overshoots.
pub(super) fn slope(before: Stretch, after: Stretch) -> f64 {
    if before.rate * after.rate <= 0.0 {
        return 0.0;
    }
    let (w0, w1) = (2.0 * after.length + before.length, after.length + 2.0 * before.length);
    (w0 + w1) / (w0 / before.rate + w1 / after.rate)
}

/// Returns the slope nearest to `wanted` with which a cubic over a stretch does not overshoot.
pub(super) fn limited(wanted: f64, stretch: Stretch) -> f64 {
    if wanted * stretch.rate <= 0.0 {
        0.0
    } else if stretch.rate > 0.0 {
        wanted.min(3.0 * stretch.rate)
    } else {
        wanted.max(3.0 * stretch.rate)
    }
}

/// The cubic with values and slopes at both ends of a stretch, at a fraction of its length (Hermite's form).
pub(super) fn cubic(fraction: f64, length: f64, values: [f64; 2], slopes: [f64; 2]) -> f64 {
    let (t, rest) = (fraction, 1.0 - fraction);
    let [start, end] = values;
    // The part of the end is a smooth step: exact at both ends.
    start + (end - start) * (t * t * (3.0 - 2.0 * t)) + length * t * rest * (slopes[0] * rest - slopes[1] * t)
}

#[cfg(test)]
mod tests {
    use super::{Stretch, cubic, limited, slope};

    #[test]
    fn slope_is_between_both_rates_and_zero_at_an_extremum() {
        let at = |rate, length| Stretch { length, rate };
        assert_eq!(slope(at(2.0, 1.0), at(2.0, 5.0)), 2.0);
        assert_eq!(slope(at(2.0, 1.0), at(-2.0, 1.0)), 0.0);
        assert_eq!(slope(at(0.0, 1.0), at(3.0, 1.0)), 0.0);
        let unequal = slope(at(1.0, 1.0), at(10.0, 1.0));
        assert!(unequal > 1.0 && unequal < 3.0, "{unequal}");
        // Time has no direction.
        assert_eq!(slope(at(1.0, 2.0), at(4.0, 3.0)), slope(at(4.0, 3.0), at(1.0, 2.0)));
    }

    #[test]
    fn limited_slope_has_the_sign_of_the_stretch() {
        let stretch = Stretch { length: 1.0, rate: -2.0 };
        assert_eq!([-1.0, -9.0, 0.0, 4.0].map(|wanted| limited(wanted, stretch)), [-1.0, -6.0, 0.0, 0.0]);
    }

    #[test]
    fn cubic_meets_values_and_slopes_at_both_ends() {
        let at = |fraction| cubic(fraction, 2.0, [3.0, -1.0], [-4.0, 0.5]);
        assert_eq!([at(0.0), at(1.0)], [3.0, -1.0]);
        let step = 1e-6;
        assert!(((at(step) - at(0.0)) / (2.0 * step) + 4.0).abs() < 1e-4);
        assert!(((at(1.0) - at(1.0 - step)) / (2.0 * step) - 0.5).abs() < 1e-4);
    }
}
