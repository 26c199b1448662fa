//! The map of a bone in a pose: it rotates, stretches along itself, and moves (section V-D).
//!
//! Cost: O(1) for each bone, and O(n) in the anchors of all joints.

use std::f64::consts::TAU;

use glam::DVec2;

use super::{Bone, mean_position, segment_ends, skeleton::Skeleton};
use crate::project::{Handle, Rotation, Shape};

/// A posed bone shorter than this, in pixels, counts as having no length, because its direction would be noise.
const NO_LENGTH: f64 = 1e-9;

/// The map of a bone: it moves `rest` to `posed`, and rotates and stretches around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoneMotion {
    /// The start of the bone at rest.
    pub(crate) rest: DVec2,
    /// The start of the bone in the pose.
    pub(crate) posed: DVec2,
    /// Unit direction of the bone at rest.
    pub(crate) along: DVec2,
    /// Rotation in radians, not limited to one turn.
    pub(crate) angle: f64,
    /// Stretch along the bone, 0 or more.
    pub(crate) stretch: f64,
    /// Stretch across the bone.
    pub(crate) across: f64,
}

impl Skeleton {
    /// The maps of all bones. Each handle must have as many corners as in the solve.
    pub(crate) fn motions(&self, handles: &[Handle]) -> Vec<BoneMotion> {
        let posed = |handle: u32| handles[handle as usize].shape.posed();
        let joints: Vec<DVec2> = self.joints.iter().map(|anchors| mean_position(anchors, posed)).collect();
        let rotations: Vec<f64> = handles.iter().map(whole_rotation).collect();
        let motion = |bone: &Bone| {
            let [a, b] = bone.rest;
            let [from, to] = segment_ends(posed(bone.handle), bone.segment);
            let across = handles[bone.handle as usize].scale;
            let sideways = across * (to - from).normalize_or_zero().perp();
            let end =
                |k: usize| joints[bone.joints[k] as usize] + bone.beyond[k] * (to - from) + bone.beside[k] * sideways;
            let [c, d] = [end(0), end(1)];
            let before = b - a;
            let after = if c.distance(d) < NO_LENGTH { DVec2::ZERO } else { d - c };
            // A bone without length has the rotation of its handle.
            let whole = rotations[bone.handle as usize];
            let angle = libm::atan2(before.perp_dot(after), before.dot(after));
            let angle = if after == DVec2::ZERO { whole } else { angle + TAU * libm::round((whole - angle) / TAU) };
            BoneMotion {
                rest: a,
                posed: c,
                along: before.normalize(),
                angle,
                stretch: after.length() / before.length(),
                across,
            }
        };
        self.bones.iter().map(motion).collect()
    }

    /// Whether handles have the corners that bones and anchors refer to.
    pub(crate) fn fits(&self, handles: &[Handle]) -> bool {
        let has = |handle: u32, segment: u32| match &handles[handle as usize].shape {
            Shape::Point { .. } => false,
            Shape::Bar { posed, .. } | Shape::Polygon { posed, .. } => (segment as usize) < posed.len(),
        };
        self.joints.iter().flatten().all(|anchor| has(anchor.handle, anchor.segment))
            && self.bones.iter().all(|bone| has(bone.handle, bone.segment))
    }
}

/// The rotation of a handle as a whole, in radians. Each of its bones rotates by the equivalent angle nearest to it.
///
/// An automatic rotation is the best fit of the posed corners in the least-squares sense.
fn whole_rotation(handle: &Handle) -> f64 {
    let (rest, posed) = match &handle.shape {
        Shape::Point { .. } => return 0.0,
        Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => (rest, posed),
    };
    if let Rotation::Degrees(degrees) = handle.rotation {
        return degrees.to_radians();
    }
    best_rotation(rest, posed)
}

/// The rotation of points that fits best in the least-squares sense, in radians.
pub(crate) fn best_rotation(rest: &[DVec2], posed: &[DVec2]) -> f64 {
    let mean = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len() as f64;
    let (from, to) = (mean(rest), mean(posed));
    let (cos, sin) = rest
        .iter()
        .zip(posed)
        .fold((0.0, 0.0), |(cos, sin), (&p, &q)| (cos + (p - from).dot(q - to), sin + (p - from).perp_dot(q - to)));
    libm::atan2(sin, cos)
}
