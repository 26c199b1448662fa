//! Redistributes the weight of a body among its bones, so that only its own map moves each bone (section V-D).
//!
//! Supports of connected bones overlap. But only a bone's own map may move points on the bone. So this replaces φ_j by
//!
//! ```text
//! Φ (φ_j / q_j) / Σ_k (φ_k / q_k),  Φ = Σ_k φ_k,
//! ```
//!
//! with sums over the body's sites. The [falloff](Bone::falloff) q_j of the point from the bone of site j is about its
//! squared distance.
//!
//! On a bone, its own sites have the whole of Φ; at a joint, the sites of all bones that meet there. The total of the
//! body does not change, so neither do the partition of unity and the weights of other sites. As q is C² and zero only
//! on its bone, weights are C² except at joints. At joints, the maps agree, and the body bends.
//!
//! Cost: O(n log n) for the n influences of bones at a point, regardless of the number of bones.
//!
//! Limits: gradients are unbounded at joints.

use glam::DVec2;

use super::{Influence, SparseWeights};
use crate::{
    bone::{Bone, Skeleton},
    rank::sort_by_rank,
    site::{Site, SiteKind},
};

/// The bones of all bodies with several bones.
#[derive(Debug, Clone, Default)]
pub(super) struct BodyWeights {
    bones: Vec<Bone>,
    /// For each site, its bone; `None` unless its body has several bones. Empty if no body has several.
    bone_of: Vec<Option<u32>>,
}

/// The influence of a bone whose body has several bones.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoneInfluence {
    body: u32,
    bone: u32,
    /// Index of the influence.
    influence: usize,
    /// [`Bone::falloff`] of the point, and its gradient.
    falloff: f64,
    gradient: DVec2,
}

impl BodyWeights {
    pub(super) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let shares_body = skeleton.shares_body();
        if !shares_body.contains(&true) {
            return Self::default();
        }
        let bone = |site: &Site| match site.kind {
            SiteKind::Bone { bone, .. } if shares_body[bone as usize] => Some(bone),
            _ => None,
        };
        Self { bones: skeleton.bones.clone(), bone_of: sites.iter().map(bone).collect() }
    }

    /// Redistributes the influences at a point. Their weights and gradients are those of φ, up to a common factor.
    ///
    /// `scratch` is memory to reuse.
    pub(super) fn redistribute(&self, p: DVec2, influences: &mut [Influence], scratch: &mut Vec<BoneInfluence>) {
        if self.bone_of.is_empty() {
            return;
        }
        scratch.clear();
        for (at, influence) in influences.iter().enumerate() {
            let Some(bone) = self.bone_of[influence.site] else { continue };
            let of_bone = match scratch.last() {
                // Consecutive sites are often of one bone.
                Some(last) if last.bone == bone => BoneInfluence { influence: at, ..*last },
                _ => {
                    let Bone { body, .. } = self.bones[bone as usize];
                    let (falloff, gradient) = self.bones[bone as usize].falloff(p);
                    BoneInfluence { body, bone, influence: at, falloff, gradient }
                }
            };
            scratch.push(of_bone);
        }
        // Rounding depends on the order within a body. A stable sort keeps that of the influences.
        sort_by_rank(scratch, |one| [one.body.into(), 0]);
        for of_body in scratch.chunk_by(|one, other| one.body == other.body) {
            if of_body.iter().any(|one| one.bone != of_body[0].bone) {
                redistribute_body(influences, of_body);
            }
        }
    }

    /// Like [`redistribute`](Self::redistribute), for the rows of many points.
    pub(super) fn redistribute_rows(&self, points: &[DVec2], weights: &mut SparseWeights) {
        if self.bone_of.is_empty() {
            return;
        }
        let (mut row, mut scratch): (Vec<Influence>, Vec<BoneInfluence>) = Default::default();
        for (point, &p) in points.iter().enumerate() {
            row.clear();
            let influence = |(site, weight)| Influence { site, weight, gradient: DVec2::ZERO };
            row.extend(weights.row(point).map(influence));
            self.redistribute(p, &mut row, &mut scratch);
            for (weight, influence) in weights.row_mut(point).iter_mut().zip(&row) {
                *weight = influence.weight;
            }
        }
    }
}

/// Redistributes the weights of one body among its bones.
fn redistribute_body(influences: &mut [Influence], of_body: &[BoneInfluence]) {
    // Divide all q by the least, as a common factor cancels.
    let least = of_body.iter().map(|one| one.falloff).fold(f64::INFINITY, f64::min);
    let (mut total, mut total_gradient) = (0.0, DVec2::ZERO);
    let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
    for &BoneInfluence { influence, falloff, gradient, .. } in of_body {
        let influence = &mut influences[influence];
        total += influence.weight;
        total_gradient += influence.gradient;
        // On a bone its own sites keep their fractions. There q is level, so the gradient of φ / q is that of φ.
        let (ratio, slope) = match (falloff == least, falloff > 0.0) {
            (true, true) => (1.0, gradient / falloff),
            (true, false) => (1.0, DVec2::ZERO),
            (false, _) => (least / falloff, gradient / falloff),
        };
        influence.gradient = ratio * (influence.gradient - influence.weight * slope);
        influence.weight *= ratio;
        sum += influence.weight;
        sum_gradient += influence.gradient;
    }
    for one in of_body {
        let influence = &mut influences[one.influence];
        let fraction = influence.weight / sum;
        influence.gradient = total_gradient * fraction + total * (influence.gradient - fraction * sum_gradient) / sum;
        influence.weight = total * fraction;
    }
}
