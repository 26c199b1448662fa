//! Poses of a solution along a clip: each continues the one before, as in a drag.
//!
//! The clip is followed from its beginning in steps of 1/60 s. So a pose depends only on the clip and the time, not on
//! earlier requests. A clip that repeats is first followed for two seconds before its beginning, which then continues
//! that end. So it does not jump at its seam if rounds end in the same pose.
//!
//! Cost: a frame of a drag for each step that is passed for the first time. After that, a pose near any step takes one
//! or two frames. Memory: up to 64 MiB of motions.
//!
//! Known limit: a clip jumps at its seam if no two rounds end in the same pose.

use super::clock;
use crate::{
    deform::Pose,
    error::Error,
    pose::{Motion, Poser},
    project::{Blend, Clip, Handle},
};

/// Steps per second: the frame rate of most screens, and a multiple of most films' frame rates. With half as many,
/// frames between them would move twice as far.
const STEPS_PER_SECOND: f64 = 60.0;

/// Least steps before the seam that lead to the beginning of a clip that repeats: two seconds, in whole rounds if it is
/// shorter. With more, the first frame of a clip takes longer after each edit. With one round, a strip whose end turns
/// in a second and a half jumps at its seam.
const LEADING_STEPS: usize = 120;

/// Memory for motions of continued steps, in bytes.
const MEMORY: usize = 64 << 20;

/// A solution's poses along a clip.
///
/// ```
/// # use c2warp::{Picture, solve};
/// use c2warp::clip::Playback;
/// use c2warp::project::{Blend, Clip, Ease, Handle, Key, Looping, Project, Track};
///
/// # let rgba = vec![255; 40 * 30 * 4];
/// let handles = [Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
/// let keys = [(0.0, 15.0), (1.0, 5.0)].map(|(time, y)| Key::new(time, Ease::Linear).posed_at([[35.0, y]]));
/// let clip = Clip::new("nod", 1.0, Looping::Alternate).with_tracks([Track::new("right", keys)]);
/// let project = Project::for_picture(40, 30).with_handles(handles.clone());
/// let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
/// let mut playback = Playback::new(solution.poser().clone(), clip, handles.to_vec());
/// let pose = playback.pose(0.5, Blend::Linear)?;
/// assert_eq!(solution.map(&pose, [35.0, 15.0].into()).unwrap().posed, [35.0, 10.0].into());
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug)]
pub struct Playback {
    poser: Poser,
    clip: Clip,
    handles: Vec<Handle>,
    /// The motions of steps from the beginning, each [`stride`](Self::stride)-th; `None` for handles without a pose.
    steps: Vec<Option<Vec<Motion>>>,
    /// Interval between steps that are kept.
    stride: usize,
    /// The last step that was computed.
    last: Option<(usize, Option<Vec<Motion>>)>,
}

impl Playback {
    /// The poses of a solution's handles along a clip. Handles without a track keep their pose.
    #[must_use]
    pub fn new(poser: Poser, clip: Clip, handles: Vec<Handle>) -> Self {
        let most = (clip.duration * STEPS_PER_SECOND).ceil() as usize * poser.sites() * size_of::<Motion>();
        Self { poser, clip, handles, steps: Vec::new(), stride: most.div_ceil(MEMORY).max(1), last: None }
    }

    /// The clip.
    #[must_use]
    pub fn clip(&self) -> &Clip {
        &self.clip
    }

    /// The handles posed at any time in seconds.
    #[must_use]
    pub fn handles(&self, time: f64) -> Vec<Handle> {
        let mut handles = self.handles.clone();
        self.clip.apply(time, &mut handles);
        handles
    }

    /// The pose at any time in seconds.
    ///
    /// # Errors
    /// The errors of [`Poser::pose`] for the handles at that time.
    pub fn pose(&mut self, time: f64, blend: Blend) -> Result<Pose, Error> {
        let time = clock::time_in_clip(time, self.clip.duration, self.clip.looping);
        let step = (time * STEPS_PER_SECOND) as usize;
        let before = self.step(step);
        let motions = match before {
            Some(motions) if step_time(step) == time => motions,
            before => self.next(before.as_deref(), time)?,
        };
        Ok(self.poser.pose_of(motions, blend))
    }

    /// The motions at a time that follows others.
    fn next(&self, before: Option<&[Motion]>, time: f64) -> Result<Vec<Motion>, Error> {
        let handles = self.handles(time);
        match before {
            Some(before) => self.poser.followed(before, &handles),
            None => self.poser.motions(&handles),
        }
    }

    /// The motions of a step; `None` if its handles have no pose.
    fn step(&mut self, step: usize) -> Option<Vec<Motion>> {
        let kept = (step / self.stride).min(self.steps.len().saturating_sub(1));
        let start = self.last.take().filter(|(last, _)| (kept * self.stride..=step).contains(last));
        let start = start.or_else(|| self.steps.get(kept).map(|motions| (kept * self.stride, motions.clone())));
        let (mut at, mut motions) = match start {
            Some(start) => start,
            None => (0, self.keep(0, self.next(self.lead().as_deref(), 0.0).ok())),
        };
        while at < step {
            at += 1;
            motions = self.next(motions.as_deref(), step_time(at)).ok();
            motions = self.keep(at, motions);
        }
        self.last = Some((at, motions.clone()));
        motions
    }

    /// Keeps the motions of a step if it is one of those that are kept.
    fn keep(&mut self, step: usize, motions: Option<Vec<Motion>>) -> Option<Vec<Motion>> {
        if step == self.steps.len() * self.stride {
            self.steps.push(motions.clone());
        }
        motions
    }

    /// The motions at the end of a clip that repeats. `None` for other clips.
    fn lead(&self) -> Option<Vec<Motion>> {
        if !self.clip.looping.repeats() {
            return None;
        }
        // The last step is before the end, which is the beginning.
        let end = ((self.clip.duration * STEPS_PER_SECOND).ceil() as usize).max(1);
        // From the beginning of a round, unless that is long ago: the pose there is the best known.
        let rounds = LEADING_STEPS.div_ceil(end) * end;
        let leading = if rounds > 2 * LEADING_STEPS { LEADING_STEPS } else { rounds };
        let steps = (0..leading).rev().map(|more| end - 1 - more % end);
        steps.fold(None, |before: Option<Vec<Motion>>, step| self.next(before.as_deref(), step_time(step)).ok())
    }
}

fn step_time(step: usize) -> f64 {
    step as f64 / STEPS_PER_SECOND
}

#[cfg(test)]
mod tests {
    use super::Playback;
    use crate::{
        Picture,
        project::{Blend, Clip, Ease, Handle, Key, Looping, PoseMode, Project, Rotation, Track},
        solve,
    };

    #[test]
    fn a_clip_without_a_length_has_its_first_pose() {
        let handles = [30.0, 100.0, 170.0].map(|x| Handle::point(format!("{x}"), [x, 20.0]).turned(Rotation::Auto));
        let mut project = Project::for_picture(200, 40).with_handles(handles);
        (project.pose.mode, project.samples) = (PoseMode::Rigid, 500);
        let solution = solve(&project, &Picture::new(200, 40, &[255; 32_000]).unwrap()).unwrap();
        let clip = Clip::new("none", 0.0, Looping::Repeat);
        let mut playback = Playback::new(solution.poser().clone(), clip, project.handles.clone());
        let plain = solution.poser().pose(&project.handles, Blend::Linear).unwrap();
        assert_eq!(playback.pose(0.0, Blend::Linear).unwrap().motions(), plain.motions());
    }

    #[test]
    fn poses_do_not_depend_on_the_steps_that_are_kept() {
        let handles = [30.0, 100.0, 170.0].map(|x| Handle::point(format!("{x}"), [x, 20.0]).turned(Rotation::Auto));
        let mut project = Project::for_picture(200, 40).with_handles(handles);
        (project.pose.mode, project.samples) = (PoseMode::Rigid, 500);
        let keys = [(0.0, 100.0), (0.5, 199.0)].map(|(time, x)| Key::new(time, Ease::Linear).posed_at([[x, 22.0]]));
        let clip = Clip::new("pass", 0.5, Looping::Alternate).with_tracks([Track::new("100", keys)]);
        let solution = solve(&project, &Picture::new(200, 40, &[255; 32_000]).unwrap()).unwrap();
        let poses = |stride: usize, times: &[f64]| {
            let playback = Playback::new(solution.poser().clone(), clip.clone(), project.handles.clone());
            let mut playback = Playback { stride, ..playback };
            let mut poses: Vec<_> = times
                .iter()
                .map(|&time| (time.to_bits(), playback.pose(time, Blend::Linear).unwrap().motions().to_vec()))
                .collect();
            poses.sort_by_key(|&(time, _)| time);
            poses
        };
        let forward: Vec<f64> = (0..=40).map(|at| f64::from(at) / 80.0).collect();
        let backward: Vec<f64> = forward.iter().copied().rev().collect();
        assert!(poses(4, &backward) == poses(1, &forward));
    }
}
