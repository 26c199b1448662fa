//! Bones: the straight parts of bar and polygon handles in the domain (section V-D).
//!
//! A bar or polygon is cut at its corners (`cut`), where it meets another, and where it leaves the domain (`clip`). The
//! parts in the domain are bones. Each bone moves by one map (`motion`), so a straight bar also remains straight
//! between its sites. Bones that meet share a joint, and all bones that are connected by joints form a body
//! (`skeleton`).
//!
//! The handles that meet in a joint may require different positions. The joint then moves to their mean, and each
//! handle bends there. If they agree, nothing bends.
//!
//! Cost: see `cut` and `clip`; for a pose, O(1) for each bone.

mod clip;
mod cut;
mod embedded_segment;
mod motion;
mod polyline;
mod skeleton;

use glam::DVec2;

use crate::{
    rank::{ascending, sort_by_rank},
    segment::segment_distance,
};

pub(crate) use embedded_segment::EmbeddedSegment;
pub(crate) use motion::{BoneMotion, best_rotation};
pub use polyline::OutsidePart;
pub(crate) use polyline::Polyline;
pub(crate) use skeleton::Skeleton;

/// Points this close to a bone, in pixels, lie on it. Rounding errors are far smaller, and the minimum distance between
/// handles is far greater.
const ON_BONE: f64 = 1e-6;

/// A point on the polyline of a handle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Anchor {
    /// Index of the handle in the project.
    pub(crate) handle: u32,
    /// The segment between corners `segment` and `segment + 1`.
    pub(crate) segment: u32,
    /// The position along the segment, from 0 to 1. It is 1 only at the end of an open polyline.
    pub(crate) fraction: f64,
}

/// A straight part of a handle.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Bone {
    /// Index of the handle in the project.
    pub(crate) handle: u32,
    /// The segment that contains the bone, between corners `segment` and `segment + 1` of the handle.
    pub(crate) segment: u32,
    /// The ends at rest, in pixels.
    pub(crate) rest: [DVec2; 2],
    /// Whether it is part of a polygon.
    pub(crate) of_loop: bool,
    /// The joints at the ends.
    pub(crate) joints: [u32; 2],
    /// Offset of each end from its joint along the segment, as a fraction of the segment. The outline may cut off a
    /// short part and leave the bone connected.
    pub(crate) beyond: [f64; 2],
    /// Offset of each end from its joint across the segment, in pixels. Bones of one joint may end beside each other,
    /// at rest and in a pose.
    pub(crate) beside: [f64; 2],
    /// Number of the body that the bone belongs to.
    pub(crate) body: u32,
}

impl Bone {
    /// Length at rest, in pixels.
    pub(crate) fn length(&self) -> f64 {
        self.rest[0].distance(self.rest[1])
    }

    /// Whether both bones end in the same joint.
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.joints.iter().any(|joint| other.joints.contains(joint))
    }

    /// Straight distance to a point, in pixels.
    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        segment_distance(p, self.rest[0], self.rest[1])
    }

    /// How far a point is from the bone, in square pixels, and the gradient.
    ///
    /// It is zero only on the bone, C², and about the squared distance far away. A point within [`ON_BONE`] lies on the
    /// bone. Near a joint, rounding determines which of two bones is nearer, and gradients relative to such small
    /// distances are noise.
    pub(crate) fn falloff(&self, p: DVec2) -> (f64, DVec2) {
        let [a, b] = self.rest;
        let length = self.length();
        let along = (b - a) / length;
        let x = (p - a).dot(along);
        let across = (p - a) - along * x;
        // Where an end begins to be nearest, the second derivative of the squared distance jumps. That of e³ / (e +
        // length), with e beyond the end, does not.
        let (beyond, outwards) = if x < 0.0 { (-x, -along) } else { ((x - length).max(0.0), along) };
        if across.length_squared() + beyond * beyond <= ON_BONE * ON_BONE {
            return (0.0, DVec2::ZERO);
        }
        let sum = beyond + length;
        let value = across.length_squared() + beyond * beyond * beyond / sum;
        let slope = beyond * beyond * (2.0 * beyond + 3.0 * length) / (sum * sum);
        (value, 2.0 * across + slope * outwards)
    }
}

/// The mean of the positions of anchors on the corners of their handles. It does not depend on the order of the
/// anchors.
fn mean_position<'a>(anchors: &[Anchor], corners: impl Fn(u32) -> &'a [DVec2]) -> DVec2 {
    let position = |anchor: &Anchor| {
        let [from, to] = segment_ends(corners(anchor.handle), anchor.segment);
        from.lerp(to, anchor.fraction)
    };
    let mut positions: Vec<DVec2> = anchors.iter().map(position).collect();
    sort_by_rank(&mut positions, |p| [ascending(p.x), ascending(p.y)]);
    positions.iter().sum::<DVec2>() / positions.len() as f64
}

/// The corners at the ends of a segment.
fn segment_ends(corners: &[DVec2], segment: u32) -> [DVec2; 2] {
    let segment = segment as usize;
    [corners[segment], corners[(segment + 1) % corners.len()]]
}
