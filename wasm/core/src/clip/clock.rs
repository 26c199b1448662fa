//! The time within a clip.

use crate::project::Looping;

/// Returns the time within a clip, from 0 to its duration. A non-finite time counts as the beginning.
pub(super) fn time_in_clip(time: f64, duration: f64, looping: Looping) -> f64 {
    if !time.is_finite() {
        return 0.0;
    }
    match looping {
        Looping::Repeat => remainder(time, duration),
        Looping::Alternate => {
            let time = remainder(time, 2.0 * duration);
            if time > duration { 2.0 * duration - time } else { time }
        }
        Looping::None => time.clamp(0.0, duration),
    }
}

/// Returns the remainder of a division by `period`, at least 0 and less than `period`.
fn remainder(time: f64, period: f64) -> f64 {
    let remainder = time.rem_euclid(period);
    // A tiny negative time rounds to the period itself.
    if remainder < period { remainder } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::time_in_clip;
    use crate::project::Looping;

    #[test]
    fn time_repeats_alternates_or_ends() {
        let at = |looping| [-0.5, 0.0, 1.5, 2.0, 3.0, 5.0].map(|time| time_in_clip(time, 2.0, looping));
        assert_eq!(at(Looping::Repeat), [1.5, 0.0, 1.5, 0.0, 1.0, 1.0]);
        assert_eq!(at(Looping::Alternate), [0.5, 0.0, 1.5, 2.0, 1.0, 1.0]);
        assert_eq!(at(Looping::None), [0.0, 0.0, 1.5, 2.0, 2.0, 2.0]);
    }

    #[test]
    fn any_number_is_a_time() {
        for looping in [Looping::Repeat, Looping::Alternate, Looping::None] {
            for time in [f64::NAN, f64::INFINITY, f64::MAX, f64::MIN, -f64::MIN_POSITIVE, 1e300] {
                assert!((0.0..=0.7).contains(&time_in_clip(time, 0.7, looping)), "{looping:?} {time}");
            }
        }
    }
}
