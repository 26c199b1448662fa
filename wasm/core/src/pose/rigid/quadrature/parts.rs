//! The parts of the picture that have one or two nodes each: the samples with the same dominant sites.

use glam::DVec2;

use super::{HeldOutline, Moments};
use crate::{
    rank::sort_by_rank,
    sample::Samples,
    site::Site,
    weight::{Influence, SparseWeights},
};

/// Weights that differ by at most this are equal: a sample on an axis of symmetry counts for both sides. Weights up to
/// this count as 0, because rounding determines where a support ends.
const TIE: f64 = 1e-9;
/// Number of dominant sites that identify a part. With two, folds between the nodes are missed. With four, or with the
/// order of the weights, poses are hardly better.
const DOMINANT_COUNT: usize = 3;
/// Maximum number of tied sites that divide a sample. In the hub of a star, hundreds are tied, with millions of
/// triples. Symmetric scenes seldom tie more than eight.
const MAX_TIED: usize = 12;

/// The sites with the largest weights: the first one, then the next two in ascending order; [`NO_SITE`] if fewer
/// reach, [`MANY_SITES`] if more than [`MAX_TIED`] are tied.
type DominantSites = [u32; DOMINANT_COUNT];
const NO_SITE: u32 = u32::MAX;
const MANY_SITES: u32 = u32::MAX - 1;

/// A part of the picture.
#[derive(Debug)]
pub(super) struct Part {
    dominant: DominantSites,
    pub(super) moments: Moments,
}

impl Part {
    /// The site with the largest weight, if a support reaches the part and few sites are tied.
    pub(super) fn site(&self) -> Option<usize> {
        (self.dominant[0] < MANY_SITES).then_some(self.dominant[0] as usize)
    }
}

/// The parts of a picture, whose samples represent `areas`.
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
        divide(&row, [NO_SITE; DOMINANT_COUNT], 0, area, &mut |dominant, area| {
            let about = sites.get(dominant[0] as usize).map_or(vertices[0], |site| site.rest);
            let moments = Moments::of(vertices[sample], area, about);
            match parts.last_mut().filter(|last| last.dominant == dominant) {
                Some(last) => last.moments += moments,
                None => parts.push(Part { dominant, moments }),
            }
        });
    }
    // By the first two sites, and then by the third.
    sort_by_rank(&mut parts, |part| [part.dominant[2].into(), 0]);
    sort_by_rank(&mut parts, |part| [part.dominant[0].into(), part.dominant[1].into()]);
    parts.dedup_by(|next, kept| {
        let same = next.dominant == kept.dominant;
        if same {
            kept.moments += next.moments;
        }
        same
    });
    parts
}

/// Divides the area of a sample among its parts: one, or several if weights are tied. `dominant` holds the `known`
/// sites with the largest weights.
fn divide(
    row: &[Influence],
    dominant: DominantSites,
    known: usize,
    area: f64,
    take: &mut impl FnMut(DominantSites, f64),
) {
    let others = || row.iter().filter(|one| !dominant[..known].contains(&(one.site as u32)));
    let most = others().map(|one| one.weight).fold(0.0, f64::max);
    let tied = || others().filter(|one| one.weight >= most - TIE && one.weight > TIE);
    let count = tied().count();
    if known == DOMINANT_COUNT || count == 0 {
        let [first, second, third] = dominant;
        take([first, second.min(third), second.max(third)], area);
        return;
    }
    if count > MAX_TIED {
        let mut next = dominant;
        next[known..].fill(MANY_SITES);
        if known == 0 {
            // One of them distinguishes two hubs.
            next[1] = tied().next().map_or(NO_SITE, |one| one.site as u32);
        }
        take(next, area);
        return;
    }
    for one in tied() {
        let mut next = dominant;
        next[known] = one.site as u32;
        divide(row, next, known + 1, area / count as f64, take);
    }
}

/// The area that each sample represents: a third of every triangle. Polygons with all corners on one circle are
/// divided as a whole.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The parts of a sample that all of these sites move alike.
    fn parts_of_tied(sites: usize) -> Vec<DominantSites> {
        let weight = 1.0 / sites as f64;
        let row: Vec<Influence> = (0..sites).map(|site| Influence { site, weight, gradient: DVec2::ZERO }).collect();
        let (mut parts, mut areas) = (Vec::new(), 0.0);
        divide(&row, [NO_SITE; DOMINANT_COUNT], 0, 1.0, &mut |dominant, area| {
            parts.push(dominant);
            areas += area;
        });
        assert!((areas - 1.0).abs() < 1e-12);
        parts
    }

    #[test]
    fn a_sample_counts_for_each_triple_of_few_tied_sites() {
        assert_eq!(parts_of_tied(4).len(), 4 * 3 * 2);
    }

    /// Hundreds of tied sites have millions of triples.
    #[test]
    fn a_sample_of_many_tied_sites_is_one_part() {
        for sites in [MAX_TIED + 1, 300] {
            assert_eq!(parts_of_tied(sites), [[MANY_SITES, 0, MANY_SITES]]);
        }
    }
}
