//! The times of frames in a clip.

use c2warp::project::{Clip, Looping};
use c2warp_film::Plays;

use crate::error::CliError;

/// Frames a second at most.
const MOST_RATE: f64 = 240.0;
/// Frames at most: ten minutes at 60 a second.
const MOST_FRAMES: u32 = 36_000;

/// The times of all frames, and how often the film runs.
#[derive(Debug, PartialEq)]
pub(super) struct Timing {
    pub(super) times: Vec<f64>,
    pub(super) plays: Plays,
}

pub(super) fn check_rate(rate: f64) -> Result<(), CliError> {
    if rate > 0.0 && rate <= MOST_RATE { Ok(()) } else { Err(CliError::Rate { found: rate, most: MOST_RATE }) }
}

impl Timing {
    /// Frame k is at k / rate. A film that repeats ends before the clip does, with which it begins again. One that
    /// alternates goes there and back. One that runs once ends with the last pose.
    pub(super) fn new(clip: &Clip, rate: f64) -> Result<Self, CliError> {
        let steps = (clip.duration * rate).round().max(1.0);
        let both_ways = if clip.looping == Looping::Alternate { 2.0 } else { 1.0 };
        if both_ways * steps >= f64::from(MOST_FRAMES) {
            let frames = both_ways * steps;
            return Err(CliError::TooManyFrames { clip: clip.name.clone(), frames, most: MOST_FRAMES });
        }
        let steps = steps as u32;
        let time = |step: u32| if step == steps { clip.duration } else { f64::from(step) / rate };
        Ok(match clip.looping {
            Looping::Repeat => Self { times: (0..steps).map(time).collect(), plays: Plays::Endlessly },
            Looping::Alternate => {
                let there_and_back = (0..=steps).chain((1..steps).rev());
                Self { times: there_and_back.map(time).collect(), plays: Plays::Endlessly }
            }
            _ => Self { times: (0..=steps).map(time).collect(), plays: Plays::Once },
        })
    }
}

#[cfg(test)]
mod tests {
    use c2warp::project::{Clip, Looping};

    use super::Timing;

    #[test]
    fn the_last_frame_is_the_end_or_leads_to_the_first() {
        let times = |looping| Timing::new(&Clip::new("nod", 1.5, looping), 2.0).unwrap().times;
        assert_eq!(times(Looping::Repeat), [0.0, 0.5, 1.0]);
        assert_eq!(times(Looping::Alternate), [0.0, 0.5, 1.0, 1.5, 1.0, 0.5]);
        assert_eq!(times(Looping::None), [0.0, 0.5, 1.0, 1.5]);
        let short = Timing::new(&Clip::new("blink", 0.01, Looping::Repeat), 2.0).unwrap();
        assert_eq!(short.times, [0.0]);
    }

    #[test]
    fn films_have_a_greatest_length() {
        assert!(Timing::new(&Clip::new("hour", 3600.0, Looping::None), 240.0).is_err());
        assert!(Timing::new(&Clip::new("minutes", 300.0, Looping::None), 60.0).is_ok());
    }
}
