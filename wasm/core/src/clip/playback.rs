//! Poses of a solution along a clip, without the jumps of the rigid mode.
//!
//! The rigid mode converges to one of several minima. A small move of the handles can lead to another minimum, and the
//! picture would jump between two frames. So the clip is followed from its beginning in steps of 1/60 s. A step usually
//! has the plain pose of its handles. If that pose differs more from the previous step than the handles account for,
//! the previous pose is continued to the nearest minimum. The continued pose is used unless it jumps too. The same rule
//! applies from the last step before a time to that time. Only coarse poses are followed: a pose is refined when it is
//! shown. A pose depends only on the clip and the time, not on earlier requests.
//!
//! A clip that repeats is first followed for two seconds before its beginning, which then continues that end. So it
//! does not jump at its seam if rounds end in the same minimum.
//!
//! Cost: a plain pose for each step that is passed for the first time. A continued step costs two to ten times as much.
//! The first pose of a clip that repeats takes two seconds of steps. After that, a pose near any step takes one or two
//! poses. Memory: one byte per step, and up to 64 MiB of motions.
//!
//! Known limits: a minimum that vanishes makes the picture jump. So does a seam if no two rounds end in the same
//! minimum.

use super::clock;
use crate::{
    deform::Pose,
    error::Error,
    pose::{Motion, Poser},
    project::{Blend, Clip, Handle},
};

/// Steps per second: the frame rate of most screens, and a multiple of most films' frame rates.
const STEPS_PER_SECOND: f64 = 60.0;

/// Steps before the seam that lead to the beginning of a clip that repeats: two seconds, over several rounds if it is
/// shorter. With more, the first frame of a clip takes longer after each edit. With one round, a strip whose end turns
/// in a second and a half jumps at its seam.
const LEADING_STEPS: usize = 120;

/// Sites may move farther than the handles carry them by this factor of the handles' move, plus the tolerance. Larger
/// moves are jumps.
const LEVER: f64 = 4.0;
/// Tolerance of a step as a fraction of the scene's extent: descents may stop an iteration earlier or later.
const TOLERANCE: f64 = 4e-3;
/// A pose is continued if its jump is then smaller, by this factor.
const GAIN: f64 = 0.8;

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
    /// The steps from the beginning that are known.
    steps: Vec<Step>,
    /// Interval between continued steps that are kept.
    stride: usize,
    /// The motions of the last step that was computed.
    last: Option<(usize, Option<Vec<Motion>>)>,
}

/// How the pose of a step is found.
#[derive(Debug)]
enum Step {
    /// The plain pose of the handles, if it exists.
    Plain,
    /// A continuation of the previous step's pose. Motions of some steps are kept.
    Continued(Option<Vec<Motion>>),
}

/// The motions of handles after those of a step, and whether they continue the step's motions.
struct Followed {
    motions: Vec<Motion>,
    is_continued: bool,
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
        let handles = self.handles(time);
        let motions = if self.poser.is_rigid() {
            let step = (time * STEPS_PER_SECOND) as usize;
            let before = self.step(step);
            let motions = if step_time(step) == time
                && let Some(motions) = before
            {
                motions
            } else {
                follow(&self.poser, &handles, before.as_deref())?.motions
            };
            self.poser.refined(&handles, motions)
        } else {
            self.poser.motions(&handles)?
        };
        Ok(self.poser.pose_of(motions, blend))
    }

    /// The motions of a step; `None` if its handles have no pose.
    fn step(&mut self, step: usize) -> Option<Vec<Motion>> {
        while self.steps.len() <= step {
            let next = self.steps.len();
            let before = if next == 0 { self.lead() } else { self.known_step(next - 1) };
            let followed = follow(&self.poser, &self.handles(step_time(next)), before.as_deref()).ok();
            let is_kept = next.is_multiple_of(self.stride);
            self.steps.push(match &followed {
                Some(Followed { motions, is_continued: true }) => Step::Continued(is_kept.then(|| motions.clone())),
                _ => Step::Plain,
            });
            self.last = Some((next, followed.map(|followed| followed.motions)));
        }
        self.known_step(step)
    }

    /// The motions at the end of a clip that repeats. `None` for other clips.
    fn lead(&self) -> Option<Vec<Motion>> {
        if !self.clip.looping.repeats() {
            return None;
        }
        // The last step is before the end, which is the beginning.
        let end = ((self.clip.duration * STEPS_PER_SECOND).ceil() as usize).max(1);
        let steps = (0..LEADING_STEPS).rev().map(|more| end - 1 - more % end);
        steps.fold(None, |before: Option<Vec<Motion>>, step| {
            let followed = follow(&self.poser, &self.handles(step_time(step)), before.as_deref()).ok()?;
            Some(followed.motions)
        })
    }

    /// The motions of a step that was passed before.
    fn known_step(&mut self, step: usize) -> Option<Vec<Motion>> {
        if let Some((last, motions)) = &self.last
            && *last == step
        {
            return motions.clone();
        }
        // Back to motions that are known, then forward.
        let from = (0..=step).rev().find(|&at| !matches!(self.steps[at], Step::Continued(None)))?;
        let mut motions = match &self.steps[from] {
            Step::Continued(motions) => motions.clone(),
            Step::Plain => self.poser.coarse_motions(&self.handles(step_time(from))).ok(),
        };
        for next in from + 1..=step {
            let handles = self.handles(step_time(next));
            motions = self.poser.settled(&handles, &self.poser.carried(&handles, &motions?)).ok();
        }
        self.last = Some((step, motions.clone()));
        motions
    }
}

fn step_time(step: usize) -> f64 {
    step as f64 / STEPS_PER_SECOND
}

/// The plain motions of handles, or the motions that continue `before` if the plain ones jump.
fn follow(poser: &Poser, handles: &[Handle], before: Option<&[Motion]>) -> Result<Followed, Error> {
    let plain = poser.coarse_motions(handles)?;
    if let Some(before) = before {
        let carried = poser.carried(handles, before);
        // Handles that others follow by long levers carry these far, with or without a turn of the whole picture.
        let jump_to = |motions: &[Motion]| {
            let [from_carried, _] = poser.apart(handles, &carried, motions);
            let [from_before, of_handles] = poser.apart(handles, before, motions);
            (from_carried.min(from_before), of_handles)
        };
        let (jump, of_handles) = jump_to(&plain);
        if jump > LEVER * of_handles + TOLERANCE * poser.extent() {
            let continued = poser.settled(handles, &carried)?;
            if jump_to(&continued).0 < GAIN * jump {
                return Ok(Followed { motions: continued, is_continued: true });
            }
        }
    }
    Ok(Followed { motions: plain, is_continued: false })
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
            let continued = playback.steps.iter().filter(|step| !matches!(step, super::Step::Plain)).count();
            (poses, continued)
        };
        let forward: Vec<f64> = (0..=40).map(|at| f64::from(at) / 80.0).collect();
        let backward: Vec<f64> = forward.iter().copied().rev().collect();
        let (all, continued) = poses(1, &forward);
        assert!(continued > 3, "{continued} steps are continued");
        assert!(poses(4, &backward) == (all, continued));
    }
}
