//! Divides the total weight of a body among its bones, so that on each bone only its own map acts.
//!
//! Supports of connected bones overlap. So that a point of a bone moves by that bone's map alone, φ_j is replaced by Φ (φ_j /
//! q_j) / Σ_k (φ_k / q_k), where Φ = Σ_k φ_k, the sums run over the body's sites, and q_j is the [offset](Bone::offset) of
//! the point from the bone of site j, about its squared distance. On a bone its own sites have all of Φ, at a joint those of
//! all bones that meet there. The total of the body does not change, so neither do the partition of unity and the weights of
//! other sites. As q is C² and zero on its bone alone, weights are C² except at joints, where the maps agree and the body
//! bends.
//!
//! Cost: O(n log n) for the n influences of bones at a point, however many bones there are. Limits: at a joint gradients have
//! no bound.

use glam::DVec2;

use super::{Influence, SparseWeights};
use crate::{
    bone::{Bone, Skeleton},
    site::{Site, SiteKind},
};

#[derive(Debug, Clone, Default)]
pub(super) struct Sharing {
    bones: Vec<Bone>,
    /// The bone of each site whose body has several bones.
    bone: Vec<Option<u32>>,
}

/// The influence of a bone whose body has several.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sharer {
    body: u32,
    /// Index of the influence.
    influence: usize,
    bone: u32,
    /// [`Bone::offset`] of the point, and its gradient.
    offset: f64,
    gradient: DVec2,
}

impl Sharing {
    pub(super) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let jointed = skeleton.jointed();
        if !jointed.contains(&true) {
            return Self::default();
        }
        let bone = |site: &Site| match site.kind {
            SiteKind::Bone { bone, .. } if jointed[bone as usize] => Some(bone),
            _ => None,
        };
        Self { bones: skeleton.bones.clone(), bone: sites.iter().map(bone).collect() }
    }

    /// Divides `influences` at a point, whose weights and gradients are those of φ up to a common factor. `sharers` is
    /// scratch memory.
    pub(super) fn share_out(&self, p: DVec2, influences: &mut [Influence], sharers: &mut Vec<Sharer>) {
        if self.bone.is_empty() {
            return;
        }
        sharers.clear();
        for (at, influence) in influences.iter().enumerate() {
            let Some(bone) = self.bone[influence.site] else { continue };
            let sharer = match sharers.last() {
                // Consecutive sites are often of one bone.
                Some(last) if last.bone == bone => Sharer { influence: at, ..*last },
                _ => {
                    let Bone { body, .. } = self.bones[bone as usize];
                    let (offset, gradient) = self.bones[bone as usize].offset(p);
                    Sharer { body, influence: at, bone, offset, gradient }
                }
            };
            sharers.push(sharer);
        }
        // Rounding depends on the order within a body, which must stay that of the influences: the sort is stable.
        sharers.sort_by_key(|sharer| sharer.body);
        for of_body in sharers.chunk_by(|one, other| one.body == other.body) {
            if of_body.iter().any(|sharer| sharer.bone != of_body[0].bone) {
                share_among(influences, of_body);
            }
        }
    }

    /// As [`share_out`](Self::share_out), for the rows of many points.
    pub(super) fn share_out_rows(&self, points: &[DVec2], weights: &mut SparseWeights) {
        if self.bone.is_empty() {
            return;
        }
        let (mut row, mut sharers): (Vec<Influence>, Vec<Sharer>) = Default::default();
        for (point, &p) in points.iter().enumerate() {
            row.clear();
            let plain = |(site, weight)| Influence { site, weight, gradient: DVec2::ZERO };
            row.extend(weights.row(point).map(plain));
            self.share_out(p, &mut row, &mut sharers);
            for (weight, shared) in weights.row_mut(point).iter_mut().zip(&row) {
                *weight = shared.weight;
            }
        }
    }
}

/// Divides the weights of one body among its bones.
fn share_among(influences: &mut [Influence], sharers: &[Sharer]) {
    // Normalises all q by a common factor, which cancels.
    let least = sharers.iter().map(|sharer| sharer.offset).fold(f64::INFINITY, f64::min);
    let (mut total, mut total_gradient) = (0.0, DVec2::ZERO);
    let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
    for &Sharer { influence, offset, gradient, .. } in sharers {
        let influence = &mut influences[influence];
        total += influence.weight;
        total_gradient += influence.gradient;
        // On a bone its own sites keep their shares; φ / q has no gradient but that of φ there, as q is level.
        let (ratio, slope) = match (offset == least, offset > 0.0) {
            (true, true) => (1.0, gradient / offset),
            (true, false) => (1.0, DVec2::ZERO),
            (false, _) => (least / offset, gradient / offset),
        };
        influence.gradient = ratio * (influence.gradient - influence.weight * slope);
        influence.weight *= ratio;
        sum += influence.weight;
        sum_gradient += influence.gradient;
    }
    for sharer in sharers {
        let influence = &mut influences[sharer.influence];
        let share = influence.weight / sum;
        influence.gradient = total_gradient * share + total * (influence.gradient - share * sum_gradient) / sum;
        influence.weight = total * share;
    }
}
