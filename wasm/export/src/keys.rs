//! Finds the fewest keys of a bone that keep its vertices within a distance of their baked positions.

use std::f64::consts::PI;

use glam::{DAffine2, DVec2};

use crate::chart::{Chart, Numbers, between};

/// How far a vertex may be from its baked position between keys, in pixels.
pub const KEY_TOLERANCE_PX: f64 = 0.1;
/// A larger turn between two keys would be ambiguous.
const MOST_TURN: f64 = 0.9 * PI;

/// The numbers of a bone at some times of a clip. Values between keys are interpolated linearly.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Keys {
    /// Indices of frames, including the first and the last. A bone that does not move has only the first, unless it
    /// ends the clip.
    pub(crate) frames: Vec<u32>,
    /// One for each key.
    pub(crate) numbers: Vec<Numbers>,
}

/// The keys of a bone from its maps at all frames. `corners` are the corners of the box around its vertices, relative
/// to the bone at rest. `setup` are its numbers outside clips, the reference for angles.
pub(crate) fn keys(chart: Chart, frames: &[DAffine2], corners: &[DVec2; 4], setup: &Numbers) -> Keys {
    let mut all: Vec<Numbers> = Vec::with_capacity(frames.len());
    for bone in frames {
        all.push(chart.numbers(bone, Some(all.last().unwrap_or(setup))));
    }
    let search = Search { chart, frames, all, corners };
    let keys = search.keys();
    let numbers = keys.iter().map(|&frame| search.all[frame as usize]).collect();
    Keys { frames: keys, numbers }
}

struct Search<'a> {
    chart: Chart,
    frames: &'a [DAffine2],
    all: Vec<Numbers>,
    corners: &'a [DVec2; 4],
}

impl Search<'_> {
    fn last(&self) -> usize {
        self.frames.len() - 1
    }

    /// Greedily, the last frame of each straight stretch: by doubling, and then by halving.
    fn keys(&self) -> Vec<u32> {
        if (0..self.frames.len()).all(|frame| self.is_near(&self.all[0], frame)) {
            return vec![0];
        }
        let mut keys = vec![0_u32];
        let mut key = 0;
        while key < self.last() {
            let (mut good, mut step) = (key + 1, 2);
            let mut bad = self.last() + 1;
            while good < self.last() {
                let end = (key + step).min(self.last());
                if !self.is_straight(key, end) {
                    bad = end;
                    break;
                }
                good = end;
                step *= 2;
            }
            while bad - good > 1 && good < self.last() {
                let middle = usize::midpoint(good, bad);
                if self.is_straight(key, middle) { good = middle } else { bad = middle }
            }
            key = good;
            keys.push(key as u32);
        }
        keys
    }

    fn is_straight(&self, from: usize, to: usize) -> bool {
        let [a, b] = [&self.all[from], &self.all[to]];
        let turns_too_far = (2..4).any(|k| (b[k] - a[k]).abs() > MOST_TURN);
        let along = |frame: usize| (frame - from) as f64 / (to - from) as f64;
        !turns_too_far && (from + 1..to).all(|frame| self.is_near(&between(a, b, along(frame)), frame))
    }

    /// Whether the numbers move all vertices of the bone close to their positions at a frame. The distance is greatest
    /// at a corner, because the difference of two maps is affine.
    fn is_near(&self, numbers: &Numbers, frame: usize) -> bool {
        let (found, exact) = (self.chart.map(*numbers), &self.frames[frame]);
        let distance = |q: &DVec2| found.transform_point2(*q).distance(exact.transform_point2(*q));
        self.corners.iter().all(|q| distance(q) <= KEY_TOLERANCE_PX)
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat2;

    use super::*;

    const CORNERS: [DVec2; 4] =
        [DVec2::new(-50.0, -50.0), DVec2::new(50.0, -50.0), DVec2::new(50.0, 50.0), DVec2::new(-50.0, 50.0)];

    #[test]
    fn straight_motions_have_two_keys_and_still_bones_one() {
        for chart in [Chart::Sheared, Chart::Chained] {
            let turned = |frame: u32| {
                DAffine2::from_scale_angle_translation(
                    DVec2::ONE,
                    0.01 * f64::from(frame),
                    DVec2::new(f64::from(frame), 0.0),
                )
            };
            let setup = chart.numbers(&DAffine2::IDENTITY, None);
            let moving: Vec<DAffine2> = (0..=90).map(turned).collect();
            assert_eq!(keys(chart, &moving, &CORNERS, &setup).frames, [0, 90]);
            assert_eq!(keys(chart, &[turned(7); 20], &CORNERS, &setup).frames, [0]);
        }
    }

    #[test]
    fn whole_turns_have_keys_less_than_half_a_turn_apart() {
        let turned = |frame: u32| DAffine2::from_mat2(DMat2::from_angle(0.1 * f64::from(frame)));
        let frames: Vec<DAffine2> = (0..=200).map(turned).collect();
        let setup = Chart::Sheared.numbers(&DAffine2::IDENTITY, None);
        let Keys { frames, numbers } = keys(Chart::Sheared, &frames, &CORNERS, &setup);
        assert_eq!(frames.last(), Some(&200));
        assert!(numbers.windows(2).all(|pair| (pair[1][2] - pair[0][2]).abs() <= MOST_TURN));
        assert!((numbers[numbers.len() - 1][2] - 20.0).abs() < 1e-9);
    }
}
