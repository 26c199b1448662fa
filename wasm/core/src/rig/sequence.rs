//! The motions of a clip at all its frames, and the accuracy of stored motions.

use glam::DVec2;

use super::{
    clip::MotionBits,
    error::BakeError,
    progress::Progress,
    skin::{Skin, greatest_distance},
};
use crate::{
    clip::Playback,
    pose::Motion,
    project::{Blend, Clip, Looping, Project},
    solution::Solution,
};

/// Frame rate at which motions are compared: that of most screens.
const FRAMES_PER_SECOND: f64 = 60.0;
/// Longer clips would take minutes to bake.
const MOST_SECONDS: f64 = 600.0;
/// Frames of all clips, times sites. A motion takes 80 bytes during baking, so at most 640 MB in total.
const MOST_MOTIONS: usize = 8_000_000;
/// Number of frames for choosing steps. The other frames are checked later.
const SAMPLED: usize = 12;

/// The motions of a clip, frame by frame. A sequence of one frame is a pose.
pub(super) struct MotionSequence {
    pub(super) name: String,
    pub(super) duration: f64,
    pub(super) looping: Looping,
    /// Frames × sites.
    pub(super) frames: Vec<Vec<Motion>>,
}

impl MotionSequence {
    /// The sequences of all clips, or the pose of the handles in a project without clips.
    pub(super) fn all(
        project: &Project,
        solution: &Solution,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Self>, BakeError> {
        if project.clips.is_empty() {
            return Ok(vec![Self::still(project, solution)?]);
        }
        project.clips.iter().map(|clip| Self::of(clip, project, solution, progress)).collect()
    }

    /// The number of frames of all clips, or 1 for the pose of a project without clips.
    pub(super) fn count_frames(project: &Project, solution: &Solution) -> Result<usize, BakeError> {
        let frames = project.clips.iter().map(frames_of).sum::<Result<usize, _>>()?;
        let sites = solution.poser().sites();
        if frames * sites > MOST_MOTIONS {
            return Err(BakeError::TooManyMotions { frames, sites, most: MOST_MOTIONS });
        }
        Ok(frames.max(1))
    }

    fn still(project: &Project, solution: &Solution) -> Result<Self, BakeError> {
        let refused = |reason| BakeError::Pose { clip: String::new(), seconds: 0.0, reason };
        let motions = solution.pose(project).map_err(refused)?.motions().to_vec();
        Ok(Self { name: String::new(), duration: 0.0, looping: Looping::None, frames: vec![motions] })
    }

    fn of(clip: &Clip, project: &Project, solution: &Solution, progress: &mut Progress<'_>) -> Result<Self, BakeError> {
        let Clip { name, duration, looping, .. } = clip;
        let last = frames_of(clip)? as u32 - 1;
        let mut playback = Playback::new(solution.poser().clone(), clip.clone(), project.handles.clone());
        let motions = |frame: u32| {
            let seconds = duration * f64::from(frame) / f64::from(last);
            let refused = |reason| BakeError::Pose { clip: name.clone(), seconds, reason };
            progress.add(1);
            playback.pose(seconds, Blend::Linear).map(|pose| pose.motions().to_vec()).map_err(refused)
        };
        let frames = (0..=last).map(motions).collect::<Result<_, _>>()?;
        Ok(Self { name: name.clone(), duration: *duration, looping: *looping, frames })
    }

    /// Evenly spaced frames.
    pub(super) fn sampled(&self) -> impl Iterator<Item = &Vec<Motion>> {
        let step = self.frames.len().div_ceil(SAMPLED);
        self.frames.iter().step_by(step)
    }
}

/// The number of frames of a clip.
fn frames_of(clip: &Clip) -> Result<usize, BakeError> {
    if clip.duration > MOST_SECONDS {
        let (clip, seconds) = (clip.name.clone(), clip.duration);
        return Err(BakeError::ClipTooLong { clip, seconds, most: MOST_SECONDS });
    }
    Ok((clip.duration * FRAMES_PER_SECOND).round().max(1.0) as usize + 1)
}

/// Compares the stored motions of a sequence with the exact ones.
pub(super) struct Comparison<'a> {
    pub(super) exact: &'a Skin,
    /// The stored mesh.
    pub(super) stored: &'a Skin,
    pub(super) blend: Blend,
    pub(super) sequence: &'a MotionSequence,
    pub(super) bits: MotionBits,
    /// Frames × sites.
    pub(super) rounded: Vec<Vec<[i32; 6]>>,
}

impl Comparison<'_> {
    /// The distance of vertices from their exact positions at a frame, with stored motions at two frames around it.
    /// Pixels.
    pub(super) fn error(&self, [before, after]: [u32; 2], frame: u32) -> f64 {
        let along = if after > before { f64::from(frame - before) / f64::from(after - before) } else { 0.0 };
        let [a, b] = [before, after].map(|key| &self.rounded[key as usize]);
        let motions: Vec<Motion> = a.iter().zip(b).map(|(a, b)| self.bits.between([a, b], along)).collect();
        greatest_distance(&self.exact_places(frame), &self.stored.posed(&motions, self.blend))
    }

    fn exact_places(&self, frame: u32) -> Vec<DVec2> {
        self.exact.posed(&self.sequence.frames[frame as usize], self.blend)
    }

    fn last(&self) -> u32 {
        self.sequence.frames.len() as u32 - 1
    }

    /// The fewest frames that keep all others within a distance, in pixels, found by a greedy search. `None` if a key
    /// itself is farther away.
    ///
    /// Cost: about four blends of all vertices for each frame.
    pub(super) fn keys(&self, tolerance: f64, progress: &mut Progress<'_>) -> Option<Vec<u32>> {
        let mut keys = vec![0];
        let mut key = 0;
        loop {
            if self.error([key; 2], key) > tolerance {
                return None;
            }
            if key == self.last() {
                return Some(keys);
            }
            let next = self.next_key(key, tolerance);
            progress.add((next - key) as usize);
            key = next;
            keys.push(key);
        }
    }

    /// The last frame of a linear stretch, found by doubling and then by halving.
    fn next_key(&self, key: u32, tolerance: f64) -> u32 {
        let is_straight = |end: u32| (key + 1..end).all(|frame| self.error([key, end], frame) <= tolerance);
        let (mut good, mut step) = (key + 1, 2);
        let mut bad = loop {
            if good == self.last() {
                return good;
            }
            let end = (key + step).min(self.last());
            if !is_straight(end) {
                break end;
            }
            good = end;
            step *= 2;
        };
        while bad - good > 1 {
            let middle = u32::midpoint(good, bad);
            if is_straight(middle) { good = middle } else { bad = middle }
        }
        good
    }
}
