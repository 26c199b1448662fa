//! Keyframes: the pose of handles at a time of a [`Clip`].
//!
//! Each value of a handle, such as one coordinate of a corner, is a separate function of time. `smooth` stretches are
//! monotone cubics: C¹ through keys, without overshoot. In clips that repeat, they are also C¹ across the seam.
//!
//! Source: Fritsch and Butland, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants" (1984).
//!
//! A pose takes time linear in the number of keys. Only the four basic operations are used, so the bits are the same on
//! every platform.
//!
//! [`Playback`] poses a solution along a clip. [`FrameTimes`] are the times of a film's frames.

mod channel;
mod clock;
mod frame_times;
mod monotone;
mod playback;

pub use self::frame_times::FrameTimes;
pub use self::playback::Playback;

use self::channel::{Channel, Knot};
use crate::deform::HandlePose;
use crate::project::{Clip, Handle, Key, Rotation, Track};

impl Clip {
    /// The poses of handles at a time in seconds, in the order of `handles`.
    ///
    /// Any time is valid: [`looping`](Self::looping) defines times after the end. Handles without a track, and values
    /// without a key, are as in `handles`. A rotation before an automatic one does not change until then. Neither does
    /// a whole depth before another one.
    ///
    /// ```
    /// use c2warp::project::{Clip, Ease, Handle, Key, Looping, Track};
    ///
    /// let hand = Handle::point("hand", [10.0, 20.0]);
    /// let keys = [(0.0, 20.0), (0.5, 0.0)].map(|(time, y)| Key::new(time, Ease::Linear).posed_at([[10.0, y]]));
    /// let wave = Clip::new("wave", 1.0, Looping::Repeat).with_tracks([Track::new("hand", keys)]);
    /// assert_eq!(wave.at(0.25, &[hand.clone()])[0].posed, [[10.0, 10.0].into()]);
    /// // The way from the last key to the first.
    /// assert_eq!(wave.at(1.75, &[hand])[0].posed, [[10.0, 10.0].into()]);
    /// ```
    #[must_use]
    pub fn at(&self, time: f64, handles: &[Handle]) -> Vec<HandlePose> {
        let time = clock::time_in_clip(time, self.duration, self.looping);
        let period = self.looping.repeats().then_some(self.duration);
        let pose = |handle: &Handle| {
            let mut pose = HandlePose::from(handle);
            if let Some(track) = self.tracks.iter().find(|track| track.handle == handle.id) {
                write_values(track, time, period, &mut pose);
            }
            pose
        };
        handles.iter().map(pose).collect()
    }

    /// Poses handles as [`at`](Self::at) a time in seconds.
    pub fn apply(&self, time: f64, handles: &mut [Handle]) {
        let poses = self.at(time, handles);
        for (handle, pose) in handles.iter_mut().zip(poses) {
            pose.write_to(handle);
        }
    }
}

/// Writes the values of a track at a time into a pose.
fn write_values(track: &Track, time: f64, period: Option<f64>, pose: &mut HandlePose) {
    let channel = |value: &dyn Fn(&Key) -> Option<Option<f64>>| {
        let knot = |key: &Key| Some(Knot { time: key.time, value: value(key)?, ease: key.ease });
        Channel::new(track.keys.iter().filter_map(knot).collect(), period)
    };
    let number = |value: &dyn Fn(&Key) -> Option<f64>| channel(&|key| value(key).map(Some)).at(time).flatten();

    for (index, corner) in pose.posed.iter_mut().enumerate() {
        let coordinate = |axis: usize| number(&|key| Some(key.posed.as_ref()?.get(index)?[axis]));
        corner.x = coordinate(0).unwrap_or(corner.x);
        corner.y = coordinate(1).unwrap_or(corner.y);
    }
    let rotation = channel(&|key| {
        key.rotation.map(|rotation| match rotation {
            Rotation::Degrees(degrees) => Some(degrees),
            Rotation::Auto => None,
        })
    })
    .at(time);
    if let Some(rotation) = rotation {
        pose.rotation = rotation.map_or(Rotation::Auto, Rotation::Degrees);
    }
    pose.scale = number(&|key| key.scale).unwrap_or(pose.scale);
    // By degrees, two parts could change their order twice between two keys.
    let depth = channel(&|key| key.depth.map(Some)).stepped_at(time).flatten();
    pose.depth = depth.unwrap_or(pose.depth);
}

#[cfg(test)]
mod tests {
    use crate::project::{Clip, Ease, Handle, Key, Looping, Rotation, Track};

    fn bar() -> Handle {
        Handle::bar("arm", [[0.0, 0.0], [4.0, 0.0]]).turned(Rotation::Auto).scaled(2.0).at_depth(3.0)
    }

    #[test]
    fn values_without_a_key_stay_as_they_are() {
        let track =
            Track::new("arm", [Key::new(0.0, Ease::Linear).scaled(1.0), Key::new(1.0, Ease::Linear).scaled(3.0)]);
        let clip = Clip::new("grow", 1.0, Looping::None).with_tracks([track]);
        let other = Handle::point("other", [9.0, 9.0]).turned(7.0);
        let poses = clip.at(0.5, &[other.clone(), bar()]);
        assert_eq!(poses[0], (&other).into());
        assert_eq!(poses[1], (&bar()).into());
        assert_eq!(clip.at(1.0, &[bar()])[0].scale, 3.0);
    }

    #[test]
    fn corners_and_turns_move_together_and_depths_step() {
        let keys = [
            Key::new(0.0, Ease::Linear).posed_at([[0.0, 0.0], [4.0, 0.0]]).turned(0.0).at_depth(0.0),
            Key::new(2.0, Ease::Linear).posed_at([[2.0, 2.0], [2.0, 6.0]]).turned(720.0).at_depth(1.0),
        ];
        let clip = Clip::new("swing", 2.0, Looping::Alternate).with_tracks([Track::new("arm", keys)]);
        let [there, back] = [0.5, 3.5].map(|time| clip.at(time, &[bar()]).remove(0));
        assert_eq!(there.posed, [[0.5, 0.5].into(), [3.5, 1.5].into()]);
        assert_eq!((there.rotation, there.depth, there.scale), (Rotation::Degrees(180.0), 0.0, 2.0));
        assert_eq!(there, back);
        assert_eq!(clip.at(2.0, &[bar()])[0].depth, 1.0);
    }
}
