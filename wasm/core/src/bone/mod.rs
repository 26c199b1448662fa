//! Bones: the straight pieces of bar and polygon handles (paper, section V-D).
//!
//! A bar or polygon is cut where its line turns, where it meets another, and where it leaves the domain; what remains are
//! bones. Each moves by one map, so a straight bar stays straight between its sites too. Bones that meet do so in a joint,
//! and all that meet, directly or by way of others, are one body.
//!
//! One rule for what is shared: a joint goes to the mean of the places that the handles there ask for, and each of them
//! bends there. Where they agree nothing bends.

mod clip;
mod cut;
mod embedded_segment;
mod motion;
mod polyline;

use std::{cmp::Ordering, collections::HashMap};

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::{distance::Navigation, domain::Domain, error::Error, segment::segment_distance};

use clip::Part;
use cut::Piece;
pub(crate) use embedded_segment::EmbeddedSegment;
pub(crate) use motion::BoneMotion;
pub use polyline::OutsidePart;
pub(crate) use polyline::Polyline;

/// Places this near to a bone, in pixels, are on it: above rounding, far below what handles are apart.
const ON_BONE: f64 = 1e-6;

/// A place on the line of a handle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Anchor {
    pub(crate) handle: u32,
    /// The piece between corners `segment` and `segment + 1`.
    pub(crate) segment: u32,
    /// How much of the piece lies before: 0 to 1, without 1 where another piece follows.
    pub(crate) share: f64,
}

/// A straight piece of a handle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Bone {
    pub(crate) handle: u32,
    /// The piece of the handle that it is of, between corners `segment` and `segment + 1`.
    segment: u32,
    pub(crate) rest: [DVec2; 2],
    /// Whether it is a side of a polygon.
    pub(crate) of_loop: bool,
    joints: [u32; 2],
    /// From each joint to the end, along the piece and as a share of it: the outline may cut off a little that leaves the bone joined.
    beyond: [f64; 2],
    /// The same across it, in pixels: bones of one joint may end beside one another, and do so when posed.
    beside: [f64; 2],
    /// Number of the connected bones that it is one of.
    pub(crate) body: u32,
}

/// All bones of a scene, in an order that does not depend on that of the handles.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Skeleton {
    pub(crate) bones: Vec<Bone>,
    /// What each joint is made of.
    joints: Vec<Vec<Anchor>>,
}

impl Skeleton {
    /// Cuts lines into bones. Also tells which parts of them lie outside the domain, or too near to its held boundary.
    ///
    /// # Errors
    /// [`Error::BarTooShort`], [`Error::BarsOverlap`]; [`Error::HandleOutside`] and [`Error::OnHeldBoundary`] for a line of
    /// which nothing is left.
    pub(crate) fn new(
        lines: &[Polyline],
        domain: &Domain,
        navigation: &Navigation,
        held: bool,
    ) -> Result<(Self, Vec<OutsidePart>), Error> {
        // Rounding depends on the order of lines, which must not be that of the handles.
        let mut lines: Vec<&Polyline> = lines.iter().collect();
        lines.sort_by(|a, b| lexical(a.coordinates(), b.coordinates()));
        let cuts = cut::Cuts::new(&lines)?;
        let corners: HashMap<u32, &[DVec2]> = lines.iter().map(|line| (line.handle, &line.corners[..])).collect();
        let places: Vec<DVec2> = cuts.joints.iter().map(|anchors| place(anchors, |handle| corners[&handle])).collect();
        let mut skeleton = Self { bones: Vec::new(), joints: cuts.joints };
        let mut outside = Vec::new();
        // Pieces come line by line, and every line has some.
        for (line, pieces) in lines.into_iter().zip(cuts.pieces.chunk_by(|one, next| one.handle == next.handle)) {
            let bones = skeleton.bones.len();
            for piece in pieces {
                let parts = clip::kept(domain, navigation, piece.ends(line), held);
                skeleton.lay(line, piece, &parts, &places, &mut outside);
            }
            if skeleton.bones.len() == bones {
                let (id, DVec2 { x, y }) = (line.id.clone(), line.corners[0]);
                let is_inside = |piece: &Piece| !clip::kept(domain, navigation, piece.ends(line), false).is_empty();
                let on_boundary = pieces.iter().any(is_inside);
                return Err(if on_boundary { Error::OnHeldBoundary { id } } else { Error::HandleOutside { id, x, y } });
            }
        }
        let key = |bone: &Bone| {
            let [a, b] = bone.rest;
            let swap = (b.y, b.x) < (a.y, a.x);
            let [a, b] = if swap { [b, a] } else { [a, b] };
            [a.y, a.x, b.y, b.x]
        };
        skeleton.bones.sort_by(|a, b| lexical(key(a).into_iter(), key(b).into_iter()));
        skeleton.number_bodies();
        Ok((skeleton, outside))
    }

    /// Adds the bones of a piece, of which `parts` are kept; `places` are those of the joints between pieces.
    fn lay(
        &mut self,
        line: &Polyline,
        piece: &Piece,
        parts: &[Part],
        places: &[DVec2],
        outside: &mut Vec<OutsidePart>,
    ) {
        let [a, b] = piece.ends(line);
        let [from, to] = piece.shares;
        let (first, last) = line.segment(piece.segment as usize);
        let along = last - first;
        let off_joints = [0, 1].map(|k| [a, b][k] - places[piece.joints[k] as usize]);
        let off_along = off_joints.map(|off| off.dot(along) / along.length_squared());
        let mut leave_out = |from: f64, to: f64| {
            if from < to {
                let [from, to] = [from, to].map(|share| a.lerp(b, share));
                outside.push(OutsidePart { handle: line.id.clone(), from, to });
            }
        };
        let mut end = 0.0;
        for part in parts {
            let mut bone = Bone {
                handle: piece.handle,
                segment: piece.segment,
                rest: part.shares.map(|share| a.lerp(b, share)),
                of_loop: line.closed,
                joints: piece.joints,
                beyond: [0, 1].map(|k| off_along[k] + (part.shares[k] - k as f64) * (to - from)),
                beside: off_joints.map(|off| along.perp_dot(off) / along.length()),
                body: 0,
            };
            for k in (0..2).filter(|&k| !part.joined[k]) {
                let share = from + part.shares[k] * (to - from);
                self.joints.push(vec![Anchor { handle: piece.handle, segment: piece.segment, share }]);
                bone.joints[k] = self.joints.len() as u32 - 1;
                (bone.beyond[k], bone.beside[k]) = (0.0, 0.0);
            }
            self.bones.push(bone);
            leave_out(end, if part.joined[0] { 0.0 } else { part.shares[0] });
            end = if part.joined[1] { 1.0 } else { part.shares[1] };
        }
        leave_out(end, 1.0);
    }

    /// Numbers the bodies in the order of their first bones.
    fn number_bodies(&mut self) {
        let mut ending: Vec<Vec<usize>> = vec![Vec::new(); self.joints.len()];
        for (at, bone) in self.bones.iter_mut().enumerate() {
            bone.body = u32::MAX;
            bone.joints.iter().for_each(|&joint| ending[joint as usize].push(at));
        }
        let mut bodies = 0;
        for seed in 0..self.bones.len() {
            if self.bones[seed].body != u32::MAX {
                continue;
            }
            let mut stack = vec![seed];
            while let Some(at) = stack.pop() {
                self.bones[at].body = bodies;
                // Once a joint has been passed, all its bones are known.
                let meeting =
                    self.bones[at].joints.iter().flat_map(|&joint| std::mem::take(&mut ending[joint as usize]));
                stack.extend(meeting.filter(|&other| self.bones[other].body == u32::MAX));
            }
            bodies += 1;
        }
    }

    /// Whether all is as [`new`](Self::new) makes it, for so many handles: to be asked of what came from elsewhere. What it says of
    /// their corners is asked by [`fits`](Self::fits).
    pub(crate) fn is_consistent(&self, handles: usize) -> bool {
        let anchor = |anchor: &Anchor| (anchor.handle as usize) < handles && anchor.share.is_finite();
        self.bones.iter().all(|bone| {
            (bone.handle as usize) < handles
                && bone.joints.iter().all(|&joint| self.joints.get(joint as usize).is_some_and(|j| !j.is_empty()))
        }) && self.joints.iter().flatten().all(anchor)
    }

    /// For each bone, whether several bones of its body share out what that weighs.
    pub(crate) fn shares_body(&self) -> Vec<bool> {
        let mut of_body = vec![0_u32; self.bones.len()];
        self.bones.iter().for_each(|bone| of_body[bone.body as usize] += 1);
        self.bones.iter().map(|bone| of_body[bone.body as usize] > 1).collect()
    }

    /// Whether the straight way between two places crosses a bone that neither lies on. Its ends count.
    pub(crate) fn separates(&self, p: DVec2, q: DVec2) -> bool {
        self.bones.iter().any(|bone| {
            let [a, b] = bone.rest;
            let (along, way) = (b - a, q - p);
            // Most bones have both on one side.
            if (along.perp_dot(p - a) > 0.0) == (along.perp_dot(q - a) > 0.0) {
                return false;
            }
            // Distances from the line of the bone, and of its ends from the way.
            let [side_p, side_q] = [p, q].map(|place| along.perp_dot(place - a) / along.length());
            let [side_a, side_b] = [a, b].map(|end| way.perp_dot(end - p) / way.length());
            let across = |from: f64, to: f64, least: f64| from.min(to) < -least && from.max(to) > least;
            across(side_p, side_q, ON_BONE) && across(side_a, side_b, -ON_BONE)
        })
    }
}

/// The mean of the places of anchors on the corners of their handles, the same in any order.
fn place<'a>(anchors: &[Anchor], corners: impl Fn(u32) -> &'a [DVec2]) -> DVec2 {
    let place = |anchor: &Anchor| {
        let [from, to] = ends(corners(anchor.handle), anchor.segment);
        from.lerp(to, anchor.share)
    };
    let mut places: Vec<DVec2> = anchors.iter().map(place).collect();
    places.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    places.iter().sum::<DVec2>() / places.len() as f64
}

/// The corners between which a piece of a handle is.
fn ends(corners: &[DVec2], segment: u32) -> [DVec2; 2] {
    let segment = segment as usize;
    [corners[segment], corners[(segment + 1) % corners.len()]]
}

fn lexical(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> Ordering {
    a.zip(b).fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
}

impl Bone {
    pub(crate) fn length(&self) -> f64 {
        self.rest[0].distance(self.rest[1])
    }

    /// Whether both end in the same joint.
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.joints.iter().any(|joint| other.joints.contains(joint))
    }

    /// Straight distance to a place.
    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        segment_distance(p, self.rest[0], self.rest[1])
    }

    /// How far a place is off the bone, in square pixels, and the gradient: zero on it and nowhere else, twice
    /// continuously differentiable, and about the squared distance far away. What is on it but for rounding is on it: which bone of a
    /// joint is nearest there is chance, and gradients relative to so little are noise.
    pub(crate) fn falloff(&self, p: DVec2) -> (f64, DVec2) {
        let [a, b] = self.rest;
        let length = self.length();
        let along = (b - a) / length;
        let x = (p - a).dot(along);
        let across = (p - a) - along * x;
        // The squared distance has a jump in its second derivative where an end begins to be nearest; e³ / (e + length) has not.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Picture;

    #[test]
    fn bones_that_meet_by_way_of_others_are_one_body_and_share_what_it_weighs() {
        let domain = Domain::new(None, &Picture::new(100, 100, &[255; 40_000]).unwrap()).unwrap();
        let line = |handle: u32, corners: &[(f64, f64)]| {
            let corners = corners.iter().map(|&corner| corner.into()).collect();
            Polyline { handle, id: handle.to_string(), corners, closed: false }
        };
        let lines = [
            line(0, &[(10.0, 95.0), (90.0, 95.0)]),
            line(1, &[(10.0, 10.0), (50.0, 10.0), (50.0, 40.0)]),
            line(2, &[(20.0, 70.0), (80.0, 20.0)]),
            line(3, &[(20.0, 65.0), (50.0, 40.0)]),
        ];
        let (skeleton, _) = Skeleton::new(&lines, &domain, &Navigation::new(&domain), false).unwrap();
        // From top to bottom: the line with a corner and the one that ends there, the one beside them, the lowest.
        let bodies = skeleton.bones.iter().map(|bone| [bone.handle, bone.body]).collect::<Vec<_>>();
        assert_eq!(bodies, [[1, 0], [1, 0], [2, 1], [3, 0], [0, 2]]);
        assert_eq!(skeleton.shares_body(), [true, true, false, true, false]);
    }
}
