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

/// A bone near a point.
struct Near {
    bone: u32,
    /// How far off it is, and the gradient.
    offset: f64,
    gradient: DVec2,
}

impl Sharing {
    pub(super) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let jointed: Vec<bool> = (0..skeleton.bones.len()).map(|bone| skeleton.is_jointed(bone)).collect();
        if !jointed.contains(&true) {
            return Self::default();
        }
        let bone = |site: &Site| match site.origin {
            Origin::Bone { bone, .. } if jointed[bone as usize] => Some(bone),
            _ => None,
        };
        Self { bones: skeleton.bones.clone(), bone: sites.iter().map(bone).collect() }
    }

    /// Shares out `influences` at a point, whose weights and gradients are those of φ up to a factor.
    pub(super) fn share_out(&self, p: DVec2, influences: &mut [Influence]) {
        let bone_of = |influence: &Influence| self.bone.get(influence.site).copied().flatten();
        let body_of = |bone: u32| self.bones[bone as usize].body;
        let mut done: Vec<u32> = Vec::new();
        for start in 0..influences.len() {
            let Some(first) = bone_of(&influences[start]) else { continue };
            let body = body_of(first);
            if done.contains(&body) {
                continue;
            }
            done.push(body);
            let mut near: Vec<Near> = Vec::new();
            for influence in &influences[start..] {
                if let Some(bone) = bone_of(influence)
                    && body_of(bone) == body
                    && near.iter().all(|known| known.bone != bone)
                {
                    let (offset, gradient) = self.bones[bone as usize].offset(p);
                    near.push(Near { bone, offset, gradient });
                }
            }
            if near.len() > 1 {
                let near_of = |influence: &Influence| {
                    let bone = bone_of(influence)?;
                    near.iter().find(|known| known.bone == bone)
                };
                share_among(influences, near_of);
            }
        }
    }

    /// The same for the rows of many points.
    pub(super) fn share_out_rows(&self, points: &[DVec2], weights: &mut SparseWeights) {
        if self.bone.is_empty() {
            return;
        }
        let mut row: Vec<Influence> = Vec::new();
        for (point, &p) in points.iter().enumerate() {
            row.clear();
            let plain = |(site, weight)| Influence { site, weight, gradient: DVec2::ZERO };
            row.extend(weights.row(point).map(plain));
            self.share_out(p, &mut row);
            for (weight, shared) in weights.row_mut(point).iter_mut().zip(&row) {
                *weight = shared.weight;
            }
        }
    }
}

/// Shares out the weights of the sites of one body, those that `near_of` knows the bone of.
fn share_among<'a>(influences: &mut [Influence], near_of: impl Fn(&Influence) -> Option<&'a Near>) {
    let of_body = |influence: &Influence| near_of(influence).map(|near| (near.offset, near.gradient));
    let offsets = influences.iter().filter_map(|influence| of_body(influence).map(|(offset, _)| offset));
    // A common factor of all q, which cancels.
    let least = offsets.fold(f64::INFINITY, f64::min);
    let (mut total, mut total_gradient) = (0.0, DVec2::ZERO);
    let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
    for influence in influences.iter_mut() {
        let Some((offset, gradient)) = of_body(influence) else { continue };
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
    for influence in influences.iter_mut().filter(|influence| of_body(influence).is_some()) {
        let share = influence.weight / sum;
        influence.gradient = total_gradient * share + total * (influence.gradient - share * sum_gradient) / sum;
        influence.weight = total * share;
    }
}
