//! What a bone does when its handle is posed: it turns, it stretches along itself, and it is carried along.

use std::f64::consts::TAU;

use glam::DVec2;

use super::{Anchor, Bone, Skeleton};
use crate::project::{Handle, Rotation, Shape};

/// What is posed to less than this, in pixels, has no length: its direction would be rounding.
const NO_LENGTH: f64 = 1e-9;

/// The map of a bone: the place `rest` goes to `posed`, and around it all is turned and stretched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoneMotion {
    pub(crate) rest: DVec2,
    pub(crate) posed: DVec2,
    /// Unit direction of the bone at rest.
    pub(crate) along: DVec2,
    /// Radians, of any number of turns.
    pub(crate) angle: f64,
    /// Growth along the bone, 0 or more.
    pub(crate) stretch: f64,
    /// Growth across it.
    pub(crate) across: f64,
}

impl Skeleton {
    /// The maps of all bones. Handles must have the corners that were solved.
    pub(crate) fn motions(&self, handles: &[Handle]) -> Vec<BoneMotion> {
        let joints: Vec<[DVec2; 2]> = self.joints.iter().map(|anchors| joint(anchors, handles)).collect();
        let turns: Vec<f64> = handles.iter().map(whole_turn).collect();
        let motion = |bone: &Bone| {
            let [a, b] = bone.rest;
            // Bones of one joint may end beside one another, and do so when posed.
            let posed = |end: DVec2, joint: u32| {
                let [rest, posed] = joints[joint as usize];
                posed + (end - rest)
            };
            let (c, d) = (posed(a, bone.joints[0]), posed(b, bone.joints[1]));
            let before = b - a;
            let after = if c.distance(d) < NO_LENGTH { DVec2::ZERO } else { d - c };
            // A bone without length has the direction of its handle.
            let turn = turns[bone.handle as usize];
            let angle = libm::atan2(before.perp_dot(after), before.dot(after));
            let angle = if after == DVec2::ZERO { turn } else { angle + TAU * libm::round((turn - angle) / TAU) };
            BoneMotion {
                rest: a,
                posed: c,
                along: before.normalize(),
                angle,
                stretch: after.length() / before.length(),
                across: handles[bone.handle as usize].scale,
            }
        };
        self.bones.iter().map(motion).collect()
    }

    /// Whether handles have the corners that anchors name.
    pub(crate) fn fits(&self, handles: &[Handle]) -> bool {
        let fits = |anchor: &Anchor| {
            let corners = corners(&handles[anchor.handle as usize]);
            let is_point = matches!(handles[anchor.handle as usize].shape, Shape::Point { .. });
            !is_point && corners.iter().all(|corners| (anchor.segment as usize) < corners.len())
        };
        self.joints.iter().flatten().all(fits)
    }
}

/// The mean of where the anchors rest, and of what they ask for, the same in any order.
fn joint(anchors: &[Anchor], handles: &[Handle]) -> [DVec2; 2] {
    let [mut rest, mut posed] = [0, 1].map(|of| {
        let place = |anchor: &Anchor| {
            let corners = corners(&handles[anchor.handle as usize])[of];
            let (from, to) = (anchor.segment as usize, (anchor.segment as usize + 1) % corners.len());
            corners[from].lerp(corners[to], anchor.share)
        };
        anchors.iter().map(place).collect::<Vec<DVec2>>()
    });
    [&mut rest, &mut posed].map(|places| {
        places.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
        places.iter().sum::<DVec2>() / places.len() as f64
    })
}

/// Where the corners rest, and where they are posed.
fn corners(handle: &Handle) -> [&[DVec2]; 2] {
    match &handle.shape {
        Shape::Point { rest, posed } => [rest, posed].map(std::slice::from_ref),
        Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => [rest, posed],
    }
}

/// How far a handle is turned as a whole, in radians: each of its bones is turned by the angle nearest to that. Of an
/// automatic one the rotation that fits its corners best.
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
