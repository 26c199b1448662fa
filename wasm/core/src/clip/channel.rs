//! One value of a handle as a function of time.

use super::monotone::{self, Stretch};
use crate::project::Ease;

/// A value at a time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    pub(super) time: f64,
    /// `None` for an automatic rotation.
    pub(super) value: Option<f64>,
    /// The ease of the stretch that follows.
    pub(super) ease: Ease,
}

/// One value as a function of time.
#[derive(Debug)]
pub(super) struct Channel {
    knots: Vec<Knot>,
    /// The period in which knots repeat. Without it, the first and last values extend to both sides.
    period: Option<f64>,
}

impl Channel {
    /// A channel through knots in ascending order of time, all within the period.
    pub(super) fn new(mut knots: Vec<Knot>, period: Option<f64>) -> Self {
        let mut period = period;
        if let ([first, .., last], Some(length)) = (knots.as_slice(), period)
            && last.time - first.time >= length
        {
            // Knots at both ends are the same time. With other values, the value jumps there.
            if first.value == last.value {
                knots.pop();
            } else {
                period = None;
            }
        }
        Self { knots, period }
    }

    /// Returns the value at a time within the period. The outer `None` means that there are no knots.
    pub(super) fn at(&self, time: f64) -> Option<Option<f64>> {
        let following = self.following(time);
        let Some(before) = self.knot(following - 1) else {
            return self.knots.first().map(|knot| knot.value);
        };
        let Some(after) = self.knot(following) else { return Some(before.value) };
        let (Some(start), Some(end)) = (before.value, after.value) else { return Some(before.value) };
        let length = after.time - before.time;
        let fraction = (time - before.time) / length;
        Some(Some(match before.ease {
            Ease::Hold => start,
            Ease::Linear => start + (end - start) * fraction,
            Ease::Smooth => {
                let slopes = [self.slope(following - 1), self.slope(following)];
                monotone::cubic(fraction, length, [start, end], slopes)
            }
        }))
    }

    /// Like [`at`](Self::at), but between two whole numbers the value jumps at the second knot.
    pub(super) fn stepped_at(&self, time: f64) -> Option<Option<f64>> {
        let following = self.following(time);
        let whole = |number| self.knot(number).and_then(|knot| knot.value).filter(|value| value.fract() == 0.0);
        match (whole(following - 1), whole(following)) {
            (Some(before), Some(_)) => Some(Some(before)),
            _ => self.at(time),
        }
    }

    /// The number of the first knot after a time.
    fn following(&self, time: f64) -> isize {
        self.knots.partition_point(|knot| knot.time <= time) as isize
    }

    /// A knot by its number. With a period, numbers continue before the first knot and after the last one.
    fn knot(&self, number: isize) -> Option<Knot> {
        let count = self.knots.len() as isize;
        match self.period {
            Some(period) if count > 0 => {
                let knot = self.knots[number.rem_euclid(count) as usize];
                Some(Knot { time: knot.time + period * number.div_euclid(count) as f64, ..knot })
            }
            _ => usize::try_from(number).ok().and_then(|number| self.knots.get(number)).copied(),
        }
    }

    /// The stretch after a knot, and its ease. `None` beyond the ends, and beside an automatic rotation.
    fn stretch(&self, number: isize) -> Option<(Stretch, Ease)> {
        let (before, after) = (self.knot(number)?, self.knot(number + 1)?);
        let length = after.time - before.time;
        let rate = (after.value? - before.value?) / length;
        Some((Stretch { length, rate }, before.ease))
    }

    /// The slope at a knot for the smooth stretches beside it. It is 0 at the ends, and beside holds.
    fn slope(&self, number: isize) -> f64 {
        let (Some((before, ease_before)), Some((after, ease_after))) = (self.stretch(number - 1), self.stretch(number))
        else {
            return 0.0;
        };
        match (ease_before, ease_after) {
            (Ease::Hold, _) | (_, Ease::Hold) => 0.0,
            (Ease::Linear, _) => monotone::limited(before.rate, after),
            (_, Ease::Linear) => monotone::limited(after.rate, before),
            (Ease::Smooth, Ease::Smooth) => monotone::slope(before, after),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{Channel, Knot};
    use crate::project::Ease;

    const PERIOD: f64 = 4.0;

    fn channel(knots: &[(f64, f64, Ease)], period: Option<f64>) -> Channel {
        let knot = |&(time, value, ease)| Knot { time, value: Some(value), ease };
        Channel::new(knots.iter().map(knot).collect(), period)
    }

    fn value(channel: &Channel, time: f64) -> f64 {
        channel.at(time).unwrap().unwrap()
    }

    /// Knots at distinct times within the period.
    fn knots() -> impl Strategy<Value = Vec<(f64, f64, Ease)>> {
        let ease = prop_oneof![Just(Ease::Smooth), Just(Ease::Linear), Just(Ease::Hold)];
        proptest::collection::btree_map(0..=40_u32, (-9.0..9.0_f64, ease), 1..7).prop_map(|knots| {
            knots.into_iter().map(|(tenth, (value, ease))| (f64::from(tenth) / 10.0, value, ease)).collect()
        })
    }

    #[test]
    fn without_knots_there_is_no_value() {
        assert_eq!(channel(&[], None).at(1.0), None);
        assert_eq!(channel(&[], Some(PERIOD)).at(1.0), None);
    }

    #[test]
    fn values_beyond_the_ends_are_constant_unless_the_channel_repeats() {
        let knots = [(1.0, 10.0, Ease::Linear), (3.0, 20.0, Ease::Linear)];
        let once = channel(&knots, None);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 4.0].map(|time| value(&once, time)), [10.0, 10.0, 15.0, 20.0, 20.0]);
        let repeated = channel(&knots, Some(PERIOD));
        assert_eq!([0.0, 1.0, 2.0, 3.0, 3.5].map(|time| value(&repeated, time)), [15.0, 10.0, 15.0, 20.0, 17.5]);
    }

    #[test]
    fn hold_jumps_at_the_next_knot() {
        let channel = channel(&[(0.0, 1.0, Ease::Hold), (1.0, 2.0, Ease::Hold)], Some(PERIOD));
        assert_eq!([0.0, 0.999, 1.0, 3.9].map(|time| value(&channel, time)), [1.0, 1.0, 2.0, 2.0]);
    }

    #[test]
    fn equal_knots_at_both_ends_are_one() {
        let knots =
            [(0.0, 0.0, Ease::Smooth), (1.0, 3.0, Ease::Smooth), (3.0, -3.0, Ease::Smooth), (PERIOD, 0.0, Ease::Hold)];
        let channel = channel(&knots, Some(PERIOD));
        let step = 1e-7;
        let after = (value(&channel, step) - value(&channel, 0.0)) / step;
        let before = (value(&channel, 0.0) - value(&channel, PERIOD - step)) / step;
        assert!(after > 1.0 && (after - before).abs() < 1e-4, "{before} {after}");
    }

    #[test]
    fn other_values_at_both_ends_jump() {
        let knots = [(0.0, 0.0, Ease::Linear), (PERIOD, 8.0, Ease::Linear)];
        let channel = channel(&knots, Some(PERIOD));
        assert_eq!([0.0, 1.0, 3.5].map(|time| value(&channel, time)), [0.0, 2.0, 7.0]);
    }

    #[test]
    fn numbers_stay_until_an_automatic_knot() {
        let knot = |time, value| Knot { time, value, ease: Ease::Smooth };
        let channel = Channel::new(vec![knot(0.0, Some(5.0)), knot(1.0, None), knot(2.0, Some(7.0))], Some(PERIOD));
        assert_eq!([0.5, 1.5].map(|time| channel.at(time).unwrap()), [Some(5.0), None]);
        let between = channel.at(3.0).unwrap().unwrap();
        assert_eq!(between, 6.0, "from the last knot to the first");
    }

    #[test]
    fn whole_numbers_step_at_the_next_knot() {
        let knots = [(1.0, 0.0), (2.0, 2.0), (3.0, -1.0)];
        for ease in [Ease::Smooth, Ease::Linear, Ease::Hold] {
            let channel = channel(&knots.map(|(time, value)| (time, value, ease)), Some(PERIOD));
            let at = |time: f64| channel.stepped_at(time).unwrap().unwrap();
            assert_eq!([0.0, 1.0, 1.9, 2.0, 2.9, 3.0, 3.9].map(at), [-1.0, 0.0, 0.0, 2.0, 2.0, -1.0, -1.0]);
        }
    }

    #[test]
    fn fractions_do_not_step() {
        let fractions = channel(&[(0.0, 0.5, Ease::Linear), (1.0, 2.0, Ease::Linear)], None);
        assert_eq!(
            [0.0, 0.5, 1.0].map(|time| fractions.stepped_at(time).flatten()),
            [Some(0.5), Some(1.25), Some(2.0)]
        );
        assert_eq!(channel(&[], None).stepped_at(0.5), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn values_meet_knots_and_never_overshoot(knots in knots(), repeats: bool) {
            let channel = channel(&knots, repeats.then_some(PERIOD));
            let jumps = repeats && knots.len() > 1 && knots[0].0 == 0.0 && knots[knots.len() - 1].0 == PERIOD;
            for &(time, wanted, _) in &knots[..knots.len() - usize::from(jumps)] {
                prop_assert!((value(&channel, time) - wanted).abs() < 1e-12);
            }
            for pair in knots.windows(2) {
                let [(start, a, _), (end, b, _)] = pair else { unreachable!() };
                for i in 0..=20 {
                    let time = start + (end - start) * f64::from(i) / 20.0;
                    let between = value(&channel, time.min(PERIOD - 1e-9));
                    prop_assert!(between >= a.min(*b) - 1e-9 && between <= a.max(*b) + 1e-9, "{time}: {between}");
                }
            }
        }

        #[test]
        fn smooth_values_have_a_continuous_rate(knots in knots(), repeats: bool) {
            let smooth: Vec<_> = knots.iter().map(|&(time, value, _)| (time, value, Ease::Smooth)).collect();
            // Such knots require a jump at the seam.
            prop_assume!(!(repeats && smooth.len() > 1 && smooth[0].0 == 0.0 && smooth[smooth.len() - 1].0 == PERIOD));
            let channel = channel(&smooth, repeats.then_some(PERIOD));
            let at = |time: f64| value(&channel, if repeats { time.rem_euclid(PERIOD) } else { time });
            let step = 1e-6;
            for &(time, ..) in &smooth {
                let (before, after) = (at(time) - at(time - step), at(time + step) - at(time));
                // Second derivatives are below 6 × 18 / 0.1².
                prop_assert!((after - before).abs() / step < 12_000.0 * step * 4.0, "{time}: {before} {after}");
            }
        }
    }
}
