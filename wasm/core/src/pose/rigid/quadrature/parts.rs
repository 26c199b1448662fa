//! The parts of the picture that have a node or two each: where the same site weighs most, and the same two others next to it.

use glam::DVec2;

use super::{HeldOutline, Moments};
use crate::{
    sample::Samples,
    site::Site,
    weight::{Influence, SparseWeights},
};

/// Sites whose weights differ by no more weigh the same: a sample on an axis of symmetry counts for both sides. One that weighs no more
/// weighs nothing: it is rounding that decides where a support ends.
const TIE: f64 = 1e-9;
/// The site that weighs most and how many others tell a part of the picture from the rest. With one other, folds between the places go
/// unseen; with three, or two in the order of their weights, poses are hardly better.
const TOLD_BY: usize = 3;

/// The site that weighs most, and the next two in the order of their numbers; [`NO_SITE`] where fewer reach.
type Told = [u32; TOLD_BY];
const NO_SITE: u32 = u32::MAX;

/// A part of the picture.
#[derive(Debug)]
pub(super) struct Part {
    told: Told,
    pub(super) moments: Moments,
}

impl Part {
    /// The site that weighs most, if any reaches.
    pub(super) fn site(&self) -> Option<usize> {
        (self.told[0] != NO_SITE).then_some(self.told[0] as usize)
    }
}

/// The parts of a picture, whose samples stand for `areas`.
pub(super) fn parts(
    sites: &[Site],
    samples: &Samples,
    areas: &[f64],
    weights: &SparseWeights,
    held: HeldOutline,
) -> Vec<Part> {
    let vertices = &samples.mesh.vertices;
    // Samples that follow one another are often of the same part.
    let mut parts: Vec<Part> = Vec::new();
    let mut row: Vec<Influence> = Vec::new();
    for (sample, &area) in areas.iter().enumerate() {
        row.clear();
        for (site, weight) in weights.row(sample) {
            held.add(&mut row, sites, Influence { site, weight, gradient: DVec2::ZERO });
        }
        divide(&row, [NO_SITE; TOLD_BY], 0, area, &mut |told, area| {
            let about = sites.get(told[0] as usize).map_or(vertices[0], |site| site.rest);
            let moments = Moments::of(vertices[sample], area, about);
            match parts.last_mut().filter(|last| last.told == told) {
                Some(last) => last.moments += moments,
                None => parts.push(Part { told, moments }),
            }
        });
    }
    parts.sort_by_key(|part| part.told);
    parts.dedup_by(|next, kept| {
        let same = next.told == kept.told;
        if same {
            kept.moments += next.moments;
        }
        same
    });
    parts
}

/// Divides the area of a sample among the parts that its weights tell of: one, or several where weights are tied. `told` holds the
/// `known` sites that weigh most.
fn divide(row: &[Influence], told: Told, known: usize, area: f64, take: &mut impl FnMut(Told, f64)) {
    let others = || row.iter().filter(|one| !told[..known].contains(&(one.site as u32)));
    let most = others().map(|one| one.weight).fold(0.0, f64::max);
    let tied = || others().filter(|one| one.weight >= most - TIE && one.weight > TIE);
    let count = tied().count();
    if known == TOLD_BY || count == 0 {
        let [first, second, third] = told;
        take([first, second.min(third), second.max(third)], area);
        return;
    }
    for one in tied() {
        let mut next = told;
        next[known] = one.site as u32;
        divide(row, next, known + 1, area / count as f64, take);
    }
}

/// The area that each sample stands for: of every triangle a third. What has more corners on one circle is shared out as a whole.
pub(super) fn areas(samples: &Samples) -> Vec<f64> {
    let vertices = &samples.mesh.vertices;
    let mut areas = vec![0.0; vertices.len()];
    let share_out = |edges: &[[u32; 2]]| {
        let middle = edges.iter().map(|[a, _]| vertices[*a as usize]).sum::<DVec2>() / edges.len() as f64;
        for edge in edges {
            let [a, b] = edge.map(|v| vertices[v as usize] - middle);
            edge.iter().for_each(|&v| areas[v as usize] += a.perp_dot(b) / 4.0);
        }
    };
    samples.mesh.visit_polygons(|_| true, share_out);
    areas
}
