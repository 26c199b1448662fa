//! Drags of one handle in the rigid mode, as in the editor: each frame follows the one before.

use c2warp::{
    Error,
    deform::Pose,
    pose::Poser,
    project::{Blend, Handle},
};
use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::clock::Clock;

/// A straight drag of a point handle from its rest position.
#[derive(Debug, Clone, PartialEq)]
pub struct Drag {
    /// The index of the handle.
    pub handle: usize,
    /// Where the drag ends, in pixels.
    pub to: DVec2,
}

/// The times of drags, in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DragTimes {
    /// The median of the frames.
    pub frame: f64,
    /// The time that 1 % of the frames exceed.
    pub slow_frame: f64,
    /// The first pose of a poser, at the end of a drag.
    pub first: f64,
    /// The release at the end of a drag.
    pub settle: f64,
    /// The same pose in the harmonic mode.
    pub harmonic: f64,
}

impl Drag {
    /// Returns the handles at a share of the way.
    #[must_use]
    pub fn handles_at(&self, handles: &[Handle], share: f64) -> Vec<Handle> {
        let mut handles = handles.to_vec();
        let shape = &mut handles[self.handle].shape;
        let rest = shape.rest()[0];
        shape.posed_mut()[0] = rest.lerp(self.to, share);
        handles
    }

    /// Returns the handles in `count` frames between two shares of the way, without the first share.
    pub fn frames(&self, handles: &[Handle], [from, to]: [f64; 2], count: u32) -> impl Iterator<Item = Vec<Handle>> {
        (1..=count).map(move |frame| {
            let done = f64::from(frame) / f64::from(count);
            self.handles_at(handles, from + (to - from) * done)
        })
    }
}

/// Follows the handles of each frame from a pose. Calls `on_frame` with each pose and its milliseconds. Returns the
/// last pose.
///
/// # Errors
/// If the handles or the pose contradict the poser.
pub fn follow(
    clock: Clock,
    poser: &Poser,
    mut pose: Pose,
    frames: impl Iterator<Item = Vec<Handle>>,
    mut on_frame: impl FnMut(&Pose, f64),
) -> Result<Pose, Error> {
    for handles in frames {
        let (next, ms) = timed(clock, || poser.follow(&pose, &handles))?;
        on_frame(&next, ms);
        pose = next;
    }
    Ok(pose)
}

/// Returns the first pose of a new poser, and its milliseconds.
///
/// # Errors
/// If the handles contradict the poser.
pub fn first_pose(clock: Clock, new: &Poser, handles: &[Handle]) -> Result<(Pose, f64), Error> {
    // The first pose computes what later ones keep.
    let new = new.clone();
    timed(clock, || new.pose(handles, Blend::Linear))
}

/// Returns the result of a run, and its milliseconds.
fn timed<T>(clock: Clock, run: impl FnOnce() -> Result<T, Error>) -> Result<(T, f64), Error> {
    let start = clock();
    Ok((run()?, clock() - start))
}

/// Returns the value that a share of all values exceeds, or NaN if there are no values.
#[must_use]
pub fn exceeded_by(share: f64, values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(|a, b| b.total_cmp(a));
    sorted.get((share * sorted.len() as f64) as usize).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_of_values_exceed_percentiles() {
        let values: Vec<f64> = (1..=200).map(f64::from).collect();
        assert_eq!(exceeded_by(0.01, &values), 198.0);
        assert_eq!(exceeded_by(0.5, &values), 100.0);
        assert!(exceeded_by(0.5, &[]).is_nan());
    }

    #[test]
    fn frames_lead_from_one_share_of_the_way_to_another() {
        let drag = Drag { handle: 1, to: DVec2::new(8.0, 4.0) };
        let handles = [Handle::point("a", [1.0, 1.0]), Handle::point("b", [0.0, 0.0])];
        let posed = |share: [f64; 2]| -> Vec<DVec2> {
            drag.frames(&handles, share, 2).map(|handles| handles[1].shape.posed()[0]).collect()
        };
        assert_eq!(posed([0.0, 1.0]), [DVec2::new(4.0, 2.0), drag.to]);
        assert_eq!(posed([1.0, 0.0]), [DVec2::new(4.0, 2.0), DVec2::ZERO]);
    }
}
