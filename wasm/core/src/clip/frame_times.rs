//! The times of the frames of a film.

use std::ops::Range;

use crate::{
    error::Error,
    limits::{MAX_FRAME_RATE, MAX_FRAMES},
    project::{Clip, Looping},
};

/// The times of the frames of a film: a clip, or a part of it, at a steady rate.
///
/// Frame k is k / rate after the beginning. A film that repeats ends one frame before it starts again. A film that
/// alternates runs forwards and backwards, and shows each end once. A film that runs once ends at the end of its part,
/// even if that is slightly earlier or later than the rate implies.
///
/// ```
/// use c2warp::{clip::FrameTimes, project::{Clip, Looping}};
///
/// let times = |looping, range| FrameTimes::new(&Clip::new("nod", 1.0, looping), 2.0, range);
/// assert_eq!(times(Looping::Repeat, None)?.seconds(), [0.0, 0.5]);
/// assert_eq!(times(Looping::Alternate, None)?.seconds(), [0.0, 0.5, 1.0, 0.5]);
/// assert_eq!(times(Looping::None, None)?.seconds(), [0.0, 0.5, 1.0]);
/// assert_eq!(times(Looping::None, Some(0.4..0.9))?.seconds(), [0.4, 0.9]);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FrameTimes {
    seconds: Vec<f64>,
    repeats: bool,
}

impl FrameTimes {
    /// Takes the frame rate, and the part of the clip to show, in seconds. `None` is the whole clip.
    ///
    /// # Errors
    /// - [`Error::FrameRate`] for a rate of 0 or less, or above [`MAX_FRAME_RATE`].
    /// - [`Error::FrameRange`] for a part that is empty or reaches beyond the clip.
    /// - [`Error::TooManyFrames`] for more than [`MAX_FRAMES`].
    pub fn new(clip: &Clip, rate: f64, range: Option<Range<f64>>) -> Result<Self, Error> {
        // NaN is refused, too.
        if !(rate > 0.0 && rate <= MAX_FRAME_RATE) {
            return Err(Error::FrameRate { rate });
        }
        let Clip { name, duration, looping, .. } = clip;
        let Range { start, end } = range.unwrap_or(0.0..*duration);
        if !(0.0 <= start && start < end && end <= *duration) {
            return Err(Error::FrameRange { clip: name.clone(), from: start, to: end, duration: *duration });
        }
        let steps = ((end - start) * rate).round().max(1.0);
        let frames = match looping {
            Looping::Repeat => steps,
            Looping::Alternate => 2.0 * steps,
            Looping::None => steps + 1.0,
        };
        if frames > f64::from(MAX_FRAMES) {
            return Err(Error::TooManyFrames { clip: name.clone(), frames });
        }
        let steps = steps as u32;
        let second = |step: u32| if step == steps { end } else { start + f64::from(step) / rate };
        let seconds = match looping {
            Looping::Repeat => (0..steps).map(second).collect(),
            Looping::Alternate => (0..=steps).chain((1..steps).rev()).map(second).collect(),
            Looping::None => (0..=steps).map(second).collect(),
        };
        Ok(Self { seconds, repeats: *looping != Looping::None })
    }

    /// The time of each frame within the clip, in seconds.
    #[must_use]
    pub fn seconds(&self) -> &[f64] {
        &self.seconds
    }

    /// The number of frames, from 1 to [`MAX_FRAMES`].
    #[must_use]
    pub fn count(&self) -> u32 {
        self.seconds.len() as u32
    }

    /// Whether the film repeats after its last frame.
    #[must_use]
    pub fn repeats(&self) -> bool {
        self.repeats
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::FrameTimes;
    use crate::{
        error::Error,
        limits::MAX_FRAMES,
        project::{Clip, Looping},
    };

    const LOOPS: [Looping; 3] = [Looping::Repeat, Looping::Alternate, Looping::None];

    #[test]
    fn the_last_frame_is_the_end_or_leads_to_the_first() {
        let seconds = |looping| FrameTimes::new(&Clip::new("nod", 1.5, looping), 2.0, None).unwrap().seconds().to_vec();
        assert_eq!(seconds(Looping::Repeat), [0.0, 0.5, 1.0]);
        assert_eq!(seconds(Looping::Alternate), [0.0, 0.5, 1.0, 1.5, 1.0, 0.5]);
        assert_eq!(seconds(Looping::None), [0.0, 0.5, 1.0, 1.5]);
    }

    #[test]
    fn a_clip_shorter_than_a_frame_has_one() {
        let seconds = |looping| FrameTimes::new(&Clip::new("blink", 0.01, looping), 2.0, None).unwrap().count();
        assert_eq!(LOOPS.map(seconds), [1, 2, 2]);
    }

    #[test]
    fn films_have_a_greatest_length() {
        let count = |duration, looping, rate| {
            FrameTimes::new(&Clip::new("long", duration, looping), rate, None).map(|times| times.count())
        };
        let most = f64::from(MAX_FRAMES) / 60.0;
        assert_eq!(count(most, Looping::Repeat, 60.0), Ok(MAX_FRAMES));
        assert_eq!(count(most / 2.0, Looping::Alternate, 60.0), Ok(MAX_FRAMES));
        let refused = Error::TooManyFrames { clip: "long".into(), frames: f64::from(MAX_FRAMES) + 1.0 };
        assert_eq!(count(most, Looping::None, 60.0), Err(refused));
        let hour = Error::TooManyFrames { clip: "long".into(), frames: 864_000.0 };
        assert_eq!(count(3600.0, Looping::Repeat, 240.0), Err(hour));
    }

    #[test]
    fn rates_and_parts_beyond_their_limits_are_named() {
        let clip = Clip::new("nod", 1.5, Looping::Repeat);
        for rate in [0.0, -1.0, 241.0, f64::NAN, f64::INFINITY] {
            let refused = FrameTimes::new(&clip, rate, None).unwrap_err();
            assert!(matches!(refused, Error::FrameRate { .. }), "{rate}: {refused}");
        }
        for (from, to) in [(-0.1, 1.0), (0.0, 1.6), (0.5, 0.5), (1.0, 0.5), (f64::NAN, 1.0), (0.0, f64::NAN)] {
            let refused = FrameTimes::new(&clip, 30.0, Some(from..to)).unwrap_err();
            assert!(matches!(refused, Error::FrameRange { .. }), "{from} to {to}: {refused}");
        }
        let refused = FrameTimes::new(&clip, 30.0, Some(0.5..3.0)).unwrap_err();
        let expected = "clip “nod”: expected a range within 0 to 1.5 seconds that ends after it begins, found 0.5..3";
        assert_eq!(refused.to_string(), expected);
    }

    /// A clip with a loop, a rate, and a part of the clip.
    fn film() -> impl Strategy<Value = (Clip, f64, [f64; 2])> {
        let looping = prop_oneof![Just(Looping::Repeat), Just(Looping::Alternate), Just(Looping::None)];
        (0.01..60.0_f64, looping, 0.1..240.0_f64, 0.0..0.9_f64, 0.01..1.0_f64).prop_map(
            |(duration, looping, rate, start, length)| {
                let start = start * duration;
                let end = start + length * (duration - start);
                (Clip::new("any", duration, looping), rate, [start, end.min(duration)])
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn frames_are_evenly_spaced_within_their_part((clip, rate, [start, end]) in film()) {
            let times = FrameTimes::new(&clip, rate, Some(start..end)).unwrap();
            let seconds = times.seconds();
            prop_assert_eq!(seconds[0], start);
            prop_assert!(seconds.iter().all(|second| (start..=end).contains(second)));
            // Only the last stretch before the end is up to half a frame shorter or longer.
            for pair in seconds.windows(2) {
                let step = (pair[1] - pair[0]).abs() * rate;
                let to_end = pair.contains(&end);
                prop_assert!((step - 1.0).abs() < 1e-9 || to_end && step < 1.5 + 1e-9, "{step} frames");
            }
            let frames = (end - start) * rate * if clip.looping == Looping::Alternate { 2.0 } else { 1.0 };
            prop_assert!((f64::from(times.count()) - frames).abs() <= 2.0, "{} for {frames}", times.count());
        }

        #[test]
        fn repeated_films_never_show_a_frame_twice((clip, rate, [start, end]) in film()) {
            let times = FrameTimes::new(&clip, rate, Some(start..end)).unwrap();
            let seconds = times.seconds();
            prop_assert_eq!(times.repeats(), clip.looping != Looping::None);
            match clip.looping {
                Looping::Repeat => prop_assert!(seconds.iter().all(|&second| second < end)),
                Looping::Alternate => {
                    // There and back: the ends once, all others twice, in opposite order.
                    let back: Vec<f64> = seconds[1..].iter().rev().copied().collect();
                    prop_assert_eq!(&seconds[1..], &back);
                    prop_assert_eq!(seconds.iter().filter(|&&second| second == start || second == end).count(), 2);
                }
                Looping::None => prop_assert_eq!(seconds.last(), Some(&end)),
            }
        }

        #[test]
        fn whole_clip_is_its_widest_range((clip, rate, _) in film()) {
            let all = FrameTimes::new(&clip, rate, None);
            prop_assert_eq!(all, FrameTimes::new(&clip, rate, Some(0.0..clip.duration)));
        }
    }
}
