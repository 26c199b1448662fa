//! How the bones of one body share out what it weighs.
//!
//! Sites of connected bones reach over one another. So that a point of a bone moves by that bone's map alone, φ_j is replaced by
//! Φ (φ_j / q_j) / Σ_k (φ_k / q_k), where Φ = Σ_k φ_k, sums run over the body's sites, and q_j is
//! [how far](Bone::offset) the point is off the bone of site j. On a bone its sites have all of Φ, in a joint those of all
//! that meet there. The body as a whole weighs what it did: partition of unity, and what others weigh, do not change. As q is twice
//! continuously differentiable and zero on its bone alone, so are weights, but at joints, where maps agree and the body bends.

use glam::DVec2;

use super::{Influence, SparseWeights};
use crate::{
    bone::{Bone, Skeleton},
    site::{Origin, Site},
};

#[derive(Debug, Clone, Default)]
pub(super) struct Sharing {
    bones: Vec<Bone>,
    /// The bone of each site that has to share with others.
    bone: Vec<Option<u32>>,
}

/// An influence of a bone that has to share.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sharer {
    body: u32,
    /// Of the influences, the one it is.
    influence: usize,
    bone: u32,
    /// How far off the bone the point is, and the gradient.
    offset: f64,
    gradient: DVec2,
}

impl Sharing {
    pub(super) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let jointed = skeleton.jointed();
        if !jointed.contains(&true) {
            return Self::default();
        }
        let bone = |site: &Site| match site.origin {
            Origin::Bone { bone, .. } if jointed[bone as usize] => Some(bone),
            _ => None,
        };
        Self { bones: skeleton.bones.clone(), bone: sites.iter().map(bone).collect() }
    }

    /// Shares out `influences` at a point, whose weights and gradients are those of φ up to a factor. `sharers` is room to work in.
    ///
    /// Cost: O(n log n) for n influences, however many bones there are.
    pub(super) fn share_out(&self, p: DVec2, influences: &mut [Influence], sharers: &mut Vec<Sharer>) {
        if self.bone.is_empty() {
            return;
        }
        sharers.clear();
        for (at, influence) in influences.iter().enumerate() {
            let Some(bone) = self.bone[influence.site] else { continue };
            let sharer = match sharers.last() {
                // Sites that follow one another are often of one bone.
                Some(last) if last.bone == bone => Sharer { influence: at, ..*last },
                _ => {
                    let Bone { body, .. } = self.bones[bone as usize];
                    let (offset, gradient) = self.bones[bone as usize].offset(p);
                    Sharer { body, influence: at, bone, offset, gradient }
                }
            };
            sharers.push(sharer);
        }
        // Rounding depends on the order within a body, which must be that of the influences.
        sharers.sort_by_key(|sharer| sharer.body);
        for of_body in sharers.chunk_by(|one, other| one.body == other.body) {
            if of_body.iter().any(|sharer| sharer.bone != of_body[0].bone) {
                share_among(influences, of_body);
            }
        }
    }

    /// The same for the rows of many points.
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

/// Shares out the weights of the sites of one body.
fn share_among(influences: &mut [Influence], sharers: &[Sharer]) {
    // A common factor of all q, which cancels.
    let least = sharers.iter().map(|sharer| sharer.offset).fold(f64::INFINITY, f64::min);
    let (mut total, mut total_gradient) = (0.0, DVec2::ZERO);
    let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
    for &Sharer { influence, offset, gradient, .. } in sharers {
        let influence = &mut influences[influence];
        total += influence.weight;
        total_gradient += influence.gradient;
        // On a bone its own sites share what there is, as they did; φ / q has no gradient but φ's, q being level there.
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
