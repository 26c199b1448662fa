//! The map of a bone when its handle is posed: it rotates, stretches along itself, and moves.

use std::f64::consts::TAU;

use glam::DVec2;

use super::{Bone, Skeleton, ends, place};
use crate::project::{Handle, Rotation, Shape};

/// A bone posed to a length below this, in pixels, has no length: its direction would be rounding.
const NO_LENGTH: f64 = 1e-9;

/// The map of a bone: `rest` goes to `posed`, and the surroundings are rotated and stretched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoneMotion {
    pub(crate) rest: DVec2,
    pub(crate) posed: DVec2,
    /// Unit direction of the bone at rest.
    pub(crate) along: DVec2,
    /// Rotation in radians, not limited to one turn.
    pub(crate) angle: f64,
    /// Stretch along the bone, 0 or more.
    pub(crate) stretch: f64,
    /// Stretch across it.
    pub(crate) across: f64,
}

impl Skeleton {
    /// The maps of all bones. Handles must have as many corners as when they were solved.
    pub(crate) fn motions(&self, handles: &[Handle]) -> Vec<BoneMotion> {
        let joints: Vec<DVec2> =
            self.joints.iter().map(|anchors| place(anchors, |handle| handles[handle as usize].shape.posed())).collect();
        let turns: Vec<f64> = handles.iter().map(whole_turn).collect();
        let motion = |bone: &Bone| {
            let [a, b] = bone.rest;
            let [from, to] = ends(handles[bone.handle as usize].shape.posed(), bone.segment);
            let across = handles[bone.handle as usize].scale;
            let sideways = across * (to - from).normalize_or_zero().perp();
            let end =
                |k: usize| joints[bone.joints[k] as usize] + bone.beyond[k] * (to - from) + bone.beside[k] * sideways;
            let [c, d] = [end(0), end(1)];
            let before = b - a;
            let after = if c.distance(d) < NO_LENGTH { DVec2::ZERO } else { d - c };
            // A bone without length has the rotation of its handle.
            let turn = turns[bone.handle as usize];
            let angle = libm::atan2(before.perp_dot(after), before.dot(after));
            let angle = if after == DVec2::ZERO { turn } else { angle + TAU * libm::round((turn - angle) / TAU) };
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

/// The rotation of a handle as a whole, in radians: each of its bones is rotated by the equivalent angle nearest to it. For
/// an automatic rotation, the one that fits the corners best.
fn whole_turn(handle: &Handle) -> f64 {
    let (rest, posed) = match &handle.shape {
        Shape::Point { .. } => return 0.0,
        Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => (rest, posed),
    };
    if let Rotation::Degrees(degrees) = handle.rotation {
        return degrees.to_radians();
    }
    let mean = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len() as f64;
    let (from, to) = (mean(rest), mean(posed));
    let (cos, sin) = rest
        .iter()
        .zip(posed)
        .fold((0.0, 0.0), |(cos, sin), (&p, &q)| (cos + (p - from).dot(q - to), sin + (p - from).perp_dot(q - to)));
    libm::atan2(sin, cos)
}
