//! What a pose continues.

use c2warp::{
    Error, Solution,
    clip::Playback,
    deform::Pose,
    project::{Project, clip_from_json},
};
use wasm_bindgen::prelude::*;

/// How a pose is found, unless by its handles alone.
#[wasm_bindgen]
#[derive(Debug)]
pub struct History(Kind);

#[derive(Debug)]
enum Kind {
    /// A clip as JSON, and a time in seconds.
    Moment { clip: String, time: f64 },
    /// The numbers of [`Pose::motion_numbers`].
    Motions(Vec<f64>),
}

#[wasm_bindgen]
impl History {
    /// The way along a clip, given as JSON, from its beginning to a time in seconds.
    #[must_use]
    pub fn of_clip(clip: String, time: f64) -> Self {
        Self(Kind::Moment { clip, time })
    }

    /// The frames before a pose that [`Session::next_pose`](crate::Session::next_pose) returned.
    #[must_use]
    pub fn of_motions(numbers: Vec<f64>) -> Self {
        Self(Kind::Motions(numbers))
    }
}

impl History {
    /// The pose of a solution's handles.
    pub(crate) fn pose(self, solution: &Solution, project: &Project) -> Result<Pose, Error> {
        let (poser, blend) = (solution.poser(), project.pose.blend);
        match self.0 {
            Kind::Moment { clip, time } => {
                let clip = clip_from_json(&clip, &project.handles)?;
                Playback::new(poser.clone(), clip, project.handles.clone()).pose(time, blend)
            }
            Kind::Motions(numbers) => poser.pose_of_numbers(&numbers, blend),
        }
    }
}
