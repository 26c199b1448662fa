//! Tests of playback along clips: where the rigid mode would jump between frames, the picture moves on.

use std::f64::consts::TAU;

use c2warp::{
    Solution,
    clip::Playback,
    project::{Clip, Ease, Handle, Key, Looping, PoseMode, Project, Rotation, Support, Track},
};
use glam::DVec2;

use crate::scenes::{project, solved};

/// Frames a second.
const RATE: f64 = 60.0;
/// Seconds.
const DURATION: f64 = 1.5;

/// A solved scene of point handles and a clip that moves them.
struct Scene {
    project: Project,
    solution: Solution,
    clip: Clip,
}

impl Scene {
    /// Handles at these places, each on its way. Ways are functions of a fraction of the clip.
    fn new(ring: &[(f64, f64)], rest: &[(f64, f64)], way: impl Fn(f64, usize, DVec2) -> DVec2) -> Self {
        let ring = ring.iter().copied().map(DVec2::from).collect();
        let mut project = project(&[ring], &[], Support::Smooth);
        (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
        let rest: Vec<DVec2> = rest.iter().copied().map(DVec2::from).collect();
        project.handles = (0..rest.len())
            .map(|id| {
                Handle::point(format!("h{id}"), rest[id]).posed_at([way(0.0, id, rest[id])]).turned(Rotation::Auto)
            })
            .collect();
        let track = |id: usize| {
            let key = |frame: i32| {
                let time = f64::from(frame) / RATE;
                Key::new(time, Ease::Linear).posed_at([way(time / DURATION, id, rest[id])])
            };
            Track::new(format!("h{id}"), (0..=(DURATION * RATE) as i32).map(key))
        };
        let clip = Clip::new("way", DURATION, Looping::None).with_tracks((0..rest.len()).map(track));
        let solution = solved(&project).expect("a valid scene");
        Self { project, solution, clip }
    }

    fn playback(&self) -> Playback {
        Playback::new(self.solution.poser().clone(), self.clip.clone(), self.project.handles.clone())
    }

    /// The plain vertices of a frame.
    fn plain(&self, playback: &Playback, time: f64) -> Vec<DVec2> {
        let pose = self.solution.poser().pose(&playback.handles(time), self.project.pose.blend).expect("finite");
        self.solution.posed_vertices(&pose)
    }

    fn frame(&self, playback: &mut Playback, time: f64) -> Vec<DVec2> {
        self.solution.posed_vertices(&playback.pose(time, self.project.pose.blend).expect("finite"))
    }

    /// The largest step of a vertex between frames, plain and along the clip, and of a handle.
    fn steps(&self) -> Steps {
        let mut playback = self.playback();
        let mut steps = Steps { plain: 0.0, along: 0.0, handles: 0.0 };
        let mut before: Option<[Vec<DVec2>; 3]> = None;
        for frame in 0..=(DURATION * RATE) as i32 {
            let time = f64::from(frame) / RATE;
            let posed = playback.handles(time).iter().map(|handle| handle.shape.posed()[0]).collect();
            let here = [self.plain(&playback, time), self.frame(&mut playback, time), posed];
            if let Some(before) = &before {
                let step = |of: usize| farthest(&before[of], &here[of]);
                steps.plain = steps.plain.max(step(0));
                steps.along = steps.along.max(step(1));
                steps.handles = steps.handles.max(step(2));
            }
            before = Some(here);
        }
        steps
    }
}

#[derive(Debug)]
struct Steps {
    plain: f64,
    along: f64,
    handles: f64,
}

fn farthest(a: &[DVec2], b: &[DVec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

const STRIP: [(f64, f64); 4] = [(40.0, 160.0), (360.0, 160.0), (360.0, 240.0), (40.0, 240.0)];
const SQUARE: [(f64, f64); 4] = [(50.0, 50.0), (350.0, 50.0), (350.0, 350.0), (50.0, 350.0)];

/// The middle of a strip is dragged past one end.
fn middle_that_passes() -> Scene {
    Scene::new(&STRIP, &[(60.0, 200.0), (200.0, 200.0), (340.0, 200.0)], |t, id, rest| {
        if id == 1 { rest + t * DVec2::new(200.0, 3.0) } else { rest }
    })
}

/// One end of a strip turns once.
fn end_that_turns() -> Scene {
    Scene::new(&STRIP, &[(60.0, 200.0), (80.0, 200.0), (320.0, 200.0), (340.0, 200.0)], |t, id, rest| {
        let centre = DVec2::new(330.0, 200.0);
        if id > 1 { centre + DVec2::from_angle(TAU * t).rotate(rest - centre) } else { rest }
    })
}

/// Two handles of a square change places around a third one.
fn handles_that_swap() -> Scene {
    Scene::new(&SQUARE, &[(100.0, 200.0), (200.0, 200.0), (300.0, 200.0)], |t, id, rest| {
        rest + [150.0, 0.0, -150.0][id] * t * DVec2::X + [5.0, 0.0, -5.0][id] * DVec2::Y
    })
}

/// Places on a cross with arms of 160 px, turned by a quarter each.
fn cross(place: DVec2) -> [(f64, f64); 4] {
    [0.0, 1.0, 2.0, 3.0]
        .map(|quarter: f64| (DVec2::splat(200.0) + DVec2::from_angle(quarter * TAU / 4.0).rotate(place)).round().into())
}

/// One arm of a cross is dragged over the opposite one.
fn arm_over_another() -> Scene {
    let arms = [(-40.0, -40.0), (-40.0, -160.0), (40.0, -160.0)].map(|place| cross(place.into()));
    let ring: Vec<(f64, f64)> = (0..4).flat_map(|quarter| arms.map(|places| places[quarter])).collect();
    Scene::new(
        &ring,
        &cross(DVec2::new(0.0, -145.0)),
        |t, id, rest| {
            if id == 0 { rest + t * DVec2::new(20.0, 330.0) } else { rest }
        },
    )
}

/// Two handles of a square turn it as a whole: its corners move 6 times as far as they.
fn square_that_turns() -> Scene {
    Scene::new(&SQUARE, &[(180.0, 200.0), (220.0, 200.0)], |t, id, rest| {
        let centre = DVec2::new(180.0, 200.0);
        if id == 1 { centre + DVec2::from_angle(TAU * t).rotate(rest - centre) } else { rest }
    })
}

#[test]
fn jumps_between_frames_become_motion() {
    for (name, scene) in [("middle", middle_that_passes()), ("end", end_that_turns()), ("arm", arm_over_another())] {
        let steps = scene.steps();
        eprintln!("{name}: {steps:.2?}");
        assert!(steps.plain > 20.0 * steps.handles, "{name}: {steps:?}");
        assert!(steps.along < steps.plain / 3.0, "{name}: {steps:?}");
    }
}

impl Scene {
    /// The same ways there and back, over and over.
    fn repeated(mut self) -> Self {
        let Clip { duration, tracks, .. } = &self.clip;
        let tracks = tracks.iter().map(|track| {
            let at = |time: f64, key: &Key| {
                let mut key = key.clone();
                key.time = time;
                key
            };
            let there = track.keys.iter().map(|key| at(key.time / 2.0, key));
            let back = track.keys.iter().rev().skip(1).map(|key| at(duration - key.time / 2.0, key));
            Track::new(track.handle.clone(), there.chain(back))
        });
        self.clip = Clip::new("there and back", *duration, Looping::Repeat).with_tracks(tracks);
        self
    }

    /// The largest step of a vertex over the seam of two rounds, and between all other frames. Without a lead, the
    /// first frame is plain.
    fn seam(&self, has_lead: bool) -> [f64; 2] {
        let mut clip = self.clip.clone();
        if !has_lead {
            clip.looping = Looping::None;
        }
        let mut playback = Playback::new(self.solution.poser().clone(), clip, self.project.handles.clone());
        let frames = (self.clip.duration * RATE).round() as u32;
        let frames: Vec<_> = (0..frames).map(|frame| self.frame(&mut playback, f64::from(frame) / RATE)).collect();
        let inside = frames.windows(2).map(|pair| farthest(&pair[0], &pair[1])).fold(0.0, f64::max);
        [farthest(&frames[frames.len() - 1], &frames[0]), inside]
    }
}

#[test]
fn clips_that_repeat_do_not_jump_at_their_seam() {
    for (name, scene) in [("middle", middle_that_passes()), ("end", end_that_turns()), ("arm", arm_over_another())] {
        let scene = scene.repeated();
        let [alone, led] = [false, true].map(|has_lead| scene.seam(has_lead));
        eprintln!("{name}: seam and inside: {alone:.2?}, after a round before: {led:.2?}");
        let [seam, inside] = led;
        assert!(seam <= inside, "{name}: {led:?}");
        if name == "end" {
            assert!(alone[0] > 5.0 * seam, "the first frame alone is far from the last: {alone:?} {led:?}");
        }
    }
}

#[test]
fn frames_follow_their_handles() {
    // The far corners of the square that turns move 5.7 times as far as its handles.
    for (name, scene, most) in [("turn", square_that_turns(), 6.0), ("swap", handles_that_swap(), 3.0)] {
        let steps = scene.steps();
        eprintln!("{name}: {steps:.2?}");
        assert!(steps.along <= most * steps.handles, "{name}: {steps:?}");
    }
}

#[test]
fn scrubbing_shows_the_frames_of_playing() {
    let scene = middle_that_passes();
    // Between the steps as well.
    let times: Vec<f64> = (0..=72).map(|frame| f64::from(frame) / 48.0).collect();
    let mut playback = scene.playback();
    let played: Vec<_> = times.iter().map(|&time| scene.frame(&mut playback, time)).collect();
    let mut scrubbed = scene.playback();
    for at in (0..times.len()).map(|k| (k * 31 + 60) % times.len()) {
        assert!(scene.frame(&mut scrubbed, times[at]) == played[at], "at {} s", times[at]);
    }
}
