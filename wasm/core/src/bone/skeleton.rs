//! All bones of a scene, and the joints that connect them into bodies (section V-D).
//!
//! Cost: see `cut` and `clip`.

use std::{cmp::Ordering, collections::HashMap};

use glam::DVec2;

use super::{
    Anchor, Bone, ON_BONE,
    clip::{Part, clip},
    cut::{Cuts, Span},
    mean_position,
    polyline::{OutsidePart, Polyline},
};
use crate::{
    distance::Navigation,
    domain::Domain,
    error::Error,
    rank::{from_top, sort_by_rank},
};

/// All bones of a scene, in an order that does not depend on that of the handles.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Skeleton {
    pub(crate) bones: Vec<Bone>,
    /// Joints: the anchors that meet in each.
    pub(crate) joints: Vec<Vec<Anchor>>,
}

impl Skeleton {
    /// Cuts bars and polygons into bones. Also returns their parts outside the domain, or too near to its `held`
    /// boundary.
    ///
    /// # Errors
    /// [`Error::BarTooShort`], [`Error::BarsOverlap`], [`Error::TooManySites`]; [`Error::HandleOutside`] or
    /// [`Error::OnHeldBoundary`] if no part of a handle is left.
    pub(crate) fn new(
        polylines: &[Polyline],
        domain: &Domain,
        navigation: &Navigation,
        held: bool,
    ) -> Result<(Self, Vec<OutsidePart>), Error> {
        // Rounding depends on the order of polylines, and must not depend on the order of the handles.
        let polylines = in_order(polylines);
        let Cuts { spans, joints } = Cuts::new(&polylines)?;
        let corners: HashMap<u32, &[DVec2]> =
            polylines.iter().map(|polyline| (polyline.handle, &polyline.corners[..])).collect();
        let positions: Vec<DVec2> =
            joints.iter().map(|anchors| mean_position(anchors, |handle| corners[&handle])).collect();
        let mut skeleton = Self { bones: Vec::new(), joints };
        let mut outside = Vec::new();
        // Spans come polyline by polyline, and every polyline has at least one.
        for (polyline, spans) in polylines.into_iter().zip(spans.chunk_by(|one, next| one.handle == next.handle)) {
            let bones = skeleton.bones.len();
            for span in spans {
                let parts = clip(domain, navigation, span.ends(polyline), held);
                skeleton.add_bones(polyline, span, &parts, &positions, &mut outside);
            }
            if skeleton.bones.len() == bones {
                let (id, DVec2 { x, y }) = (polyline.id.clone(), polyline.corners[0]);
                let is_inside = |span: &Span| !clip(domain, navigation, span.ends(polyline), false).is_empty();
                let on_boundary = spans.iter().any(is_inside);
                return Err(if on_boundary { Error::OnHeldBoundary { id } } else { Error::HandleOutside { id, x, y } });
            }
        }
        let ends = |bone: &Bone| {
            let [a, b] = bone.rest;
            if (b.y, b.x) < (a.y, a.x) { [b, a] } else { [a, b] }
        };
        // By the first end, and then by the second.
        sort_by_rank(&mut skeleton.bones, |bone| from_top(ends(bone)[1]));
        sort_by_rank(&mut skeleton.bones, |bone| from_top(ends(bone)[0]));
        skeleton.number_bodies();
        Ok((skeleton, outside))
    }

    /// Adds a bone for each of the `parts` of a span. `positions` are those of the joints between spans. The rest of
    /// the span is added to `outside`.
    fn add_bones(
        &mut self,
        polyline: &Polyline,
        span: &Span,
        parts: &[Part],
        positions: &[DVec2],
        outside: &mut Vec<OutsidePart>,
    ) {
        let [a, b] = span.ends(polyline);
        let [from, to] = span.fractions;
        let (first, last) = polyline.segment(span.segment as usize);
        let along = last - first;
        let off_joints = [0, 1].map(|k| [a, b][k] - positions[span.joints[k] as usize]);
        let off_along = off_joints.map(|off| off.dot(along) / along.length_squared());
        let mut leave_out = |from: f64, to: f64| {
            if from < to {
                let [from, to] = [from, to].map(|fraction| a.lerp(b, fraction));
                outside.push(OutsidePart { handle: polyline.id.clone(), from, to });
            }
        };
        let mut end = 0.0;
        for part in parts {
            let mut bone = Bone {
                handle: span.handle,
                segment: span.segment,
                rest: part.ends.map(|fraction| a.lerp(b, fraction)),
                of_loop: polyline.closed,
                joints: span.joints,
                beyond: [0, 1].map(|k| off_along[k] + (part.ends[k] - k as f64) * (to - from)),
                beside: off_joints.map(|off| along.perp_dot(off) / along.length()),
                body: 0,
            };
            for k in (0..2).filter(|&k| !part.connected[k]) {
                let fraction = from + part.ends[k] * (to - from);
                self.joints.push(vec![Anchor { handle: span.handle, segment: span.segment, fraction }]);
                bone.joints[k] = self.joints.len() as u32 - 1;
                (bone.beyond[k], bone.beside[k]) = (0.0, 0.0);
            }
            self.bones.push(bone);
            leave_out(end, if part.connected[0] { 0.0 } else { part.ends[0] });
            end = if part.connected[1] { 1.0 } else { part.ends[1] };
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
                // After the first visit of a joint, all its bones are known.
                let meeting =
                    self.bones[at].joints.iter().flat_map(|&joint| std::mem::take(&mut ending[joint as usize]));
                stack.extend(meeting.filter(|&other| self.bones[other].body == u32::MAX));
            }
            bodies += 1;
        }
    }

    /// Whether all indices and numbers are valid for a given number of handles, for skeletons read from bytes.
    /// [`fits`](Self::fits) checks the corners of the handles.
    pub(crate) fn is_consistent(&self, handles: usize) -> bool {
        let anchor = |anchor: &Anchor| (anchor.handle as usize) < handles && anchor.fraction.is_finite();
        self.bones.iter().all(|bone| {
            (bone.handle as usize) < handles
                && bone.joints.iter().all(|&joint| self.joints.get(joint as usize).is_some_and(|j| !j.is_empty()))
        }) && self.joints.iter().flatten().all(anchor)
    }

    /// Bones: whether the body of each has several bones.
    pub(crate) fn shares_body(&self) -> Vec<bool> {
        let mut of_body = vec![0_u32; self.bones.len()];
        self.bones.iter().for_each(|bone| of_body[bone.body as usize] += 1);
        self.bones.iter().map(|bone| of_body[bone.body as usize] > 1).collect()
    }

    /// Whether the straight line between two points crosses a bone, including its ends. A bone through one of the
    /// points does not count.
    pub(crate) fn separates(&self, p: DVec2, q: DVec2) -> bool {
        self.bones.iter().any(|bone| {
            let [a, b] = bone.rest;
            let (along, way) = (b - a, q - p);
            // Most bones have both points on one side.
            if (along.perp_dot(p - a) > 0.0) == (along.perp_dot(q - a) > 0.0) {
                return false;
            }
            // Distances of the points from the line of the bone, and of its ends from the line between the points.
            let [side_p, side_q] = [p, q].map(|point| along.perp_dot(point - a) / along.length());
            let [side_a, side_b] = [a, b].map(|end| way.perp_dot(end - p) / way.length());
            let across = |from: f64, to: f64, least: f64| from.min(to) < -least && from.max(to) > least;
            across(side_p, side_q, ON_BONE) && across(side_a, side_b, -ON_BONE)
        })
    }
}

/// Polylines in the order of their coordinates.
fn in_order(polylines: &[Polyline]) -> Vec<&Polyline> {
    let mut ordered: Vec<&Polyline> = Vec::with_capacity(polylines.len());
    for polyline in polylines {
        let is_before = |other: &&Polyline| lexicographic(other.coordinates(), polyline.coordinates()).is_le();
        ordered.insert(ordered.partition_point(is_before), polyline);
    }
    ordered
}

fn lexicographic(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> Ordering {
    a.zip(b).fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Picture;

    #[test]
    fn connected_bones_form_one_body() {
        let domain = Domain::new(None, &Picture::new(100, 100, &[255; 40_000]).unwrap()).unwrap();
        let polyline = |handle: u32, corners: &[(f64, f64)]| {
            let corners = corners.iter().map(|&corner| corner.into()).collect();
            Polyline { handle, id: handle.to_string(), corners, closed: false }
        };
        let polylines = [
            polyline(0, &[(10.0, 95.0), (90.0, 95.0)]),
            polyline(1, &[(10.0, 10.0), (50.0, 10.0), (50.0, 40.0)]),
            polyline(2, &[(20.0, 70.0), (80.0, 20.0)]),
            polyline(3, &[(20.0, 65.0), (50.0, 40.0)]),
        ];
        let (skeleton, _) = Skeleton::new(&polylines, &domain, &Navigation::new(&domain), false).unwrap();
        // From top to bottom: the bar with a corner, the bar beside it, the bar that ends where the first ends, the
        // lowest bar.
        let bodies = skeleton.bones.iter().map(|bone| [bone.handle, bone.body]).collect::<Vec<_>>();
        assert_eq!(bodies, [[1, 0], [1, 0], [2, 1], [3, 0], [0, 2]]);
        assert_eq!(skeleton.shares_body(), [true, true, false, true, false]);
    }
}
