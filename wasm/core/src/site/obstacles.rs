//! The bones and the held outline that supports must not reach (section V-D).
//!
//! Cost: for a distance to the bones, one query for each bone that is nearer than the result.

use glam::DVec2;

use super::SiteKind;
use crate::{
    bone::{EmbeddedSegment, Skeleton},
    distance::{DistanceField, NavTriangle, Navigation, Propagation},
    domain::{Domain, corners_between},
    segment::nearest_on_segment,
};

/// The body of a held outline. Bodies of bones have lower numbers.
pub(super) const BOUNDARY: u32 = u32::MAX;

/// A point lies between two bones, or two edges of a held outline, if the cosine of the angle between the directions to
/// them is below this. Both then meet at less than 20°. At greater angles, the sites of both are close enough to bound
/// a cell between them.
const OPPOSITE_COSINE: f64 = -0.94;

/// Obstacles of supports, besides sites.
#[derive(Debug)]
pub(crate) struct Obstacles<'a> {
    skeleton: &'a Skeleton,
    /// Bones: each on the navigation mesh.
    segments: Vec<EmbeddedSegment>,
    /// The domain, if its outline is held.
    held: Option<&'a Domain>,
    /// The tips of the held outline: each sharp corner between its neighbours.
    tips: Vec<[DVec2; 3]>,
}

impl<'a> Obstacles<'a> {
    /// `held` is the domain, if its outline is held.
    ///
    /// Cost: for each bone a pass over the triangles of the navigation mesh.
    pub(crate) fn new(skeleton: &'a Skeleton, navigation: &Navigation, held: Option<&'a Domain>) -> Self {
        let segments = skeleton.bones.iter().map(|bone| EmbeddedSegment::new(navigation, bone)).collect();
        let tips = held.map_or(&[][..], Domain::rings).iter().flat_map(|ring| tips(ring)).collect();
        Self { skeleton, segments, held, tips }
    }

    pub(super) fn skeleton(&self) -> &'a Skeleton {
        self.skeleton
    }

    /// Whether there are bones, or a held outline.
    pub(super) fn has_lines(&self) -> bool {
        !self.segments.is_empty() || self.held.is_some()
    }

    /// The domain, if its outline is held.
    pub(super) fn held(&self) -> Option<&'a Domain> {
        self.held
    }

    /// The body of a site; `None` for point and virtual sites.
    pub(super) fn body(&self, kind: SiteKind) -> Option<u32> {
        match kind {
            SiteKind::Bone { bone, .. } => Some(self.skeleton.bones[bone as usize].body),
            SiteKind::Boundary => Some(BOUNDARY),
            SiteKind::Point { .. } | SiteKind::Virtual => None,
        }
    }

    /// Distance from a field's source to a bone, infinite beyond the field's bound.
    pub(super) fn distance_to_bone(&self, bone: u32, field: &DistanceField) -> f64 {
        self.segments[bone as usize].distance(field)
    }

    /// Distance from a field's source to the nearest bone of its island outside a body, or `known` if none is nearer.
    pub(super) fn distance_to_bones(&self, field: &DistanceField, island: usize, body: Option<u32>, known: f64) -> f64 {
        let bones = self.skeleton.bones.iter().zip(&self.segments);
        let others = bones.filter(|(bone, segment)| segment.island == island && Some(bone.body) != body);
        others.fold(
            known,
            |least, (bone, segment)| {
                if bone.distance(field.source) < least { least.min(segment.distance(field)) } else { least }
            },
        )
    }

    /// Whether a point lies between two bones that meet at an acute angle, or in a tip of the held outline, with both
    /// sides at intrinsic distances up to `within`.
    pub(super) fn has_acute_joint(
        &self,
        navigation: &Navigation,
        propagation: &mut Propagation,
        (triangle, p): (NavTriangle, DVec2),
        within: f64,
    ) -> bool {
        let (bones, feet) = (self.bones_around(p, within), self.feet_in_tip(p, within));
        if bones.is_empty() && feet.is_none() {
            return false;
        }
        // Exclude sides behind a hole.
        let field = propagation.field(navigation, triangle, p, within);
        let reaches =
            |foot: DVec2| navigation.locate(foot).is_some_and(|(at, foot)| field.distance(at, foot) <= within);
        let is_between = !bones.is_empty() && bones.iter().all(|&at| self.segments[at].distance(&field) <= within);
        is_between || feet.is_some_and(|feet| feet.into_iter().all(reaches))
    }

    /// The bones up to `within` from a point that meet a bone on the other side of the point.
    fn bones_around(&self, p: DVec2, within: f64) -> Vec<usize> {
        let bones = &self.skeleton.bones;
        let near: Vec<(usize, DVec2)> = bones
            .iter()
            .enumerate()
            .map(|(at, bone)| (at, nearest_on_segment(p, bone.rest[0], bone.rest[1]) - p))
            .filter(|(_, to)| to.length() <= within)
            .collect();
        let has_opposite = |&&(a, to_a): &&(usize, DVec2)| {
            near.iter().any(|&(b, to_b)| bones[a].meets(&bones[b]) && are_opposite(to_a, to_b))
        };
        near.iter().filter(has_opposite).map(|&(at, _)| at).collect()
    }

    /// The nearest points on both sides of the tip of the held outline that a point lies in, up to `within` from it.
    fn feet_in_tip(&self, p: DVec2, within: f64) -> Option<[DVec2; 2]> {
        self.tips
            .iter()
            .map(|&[before, tip, after]| [before, after].map(|end| nearest_on_segment(p, tip, end)))
            .find(|feet| feet.iter().all(|foot| foot.distance(p) <= within) && are_opposite(feet[0] - p, feet[1] - p))
    }
}

fn are_opposite(a: DVec2, b: DVec2) -> bool {
    a.dot(b) < OPPOSITE_COSINE * a.length() * b.length()
}

/// The corners of a ring that a point may lie in: see [`OPPOSITE_COSINE`].
fn tips(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 3]> + '_ {
    corners_between(ring).filter(|&[before, tip, after]| are_opposite(tip - before, after - tip))
}
