//! Places all over the picture at which a pose is judged, with their weights: what travels to where poses are computed.
//!
//! A cell is divided by which two other sites weigh most, and every part has a place at its centroid: three in what would be a
//! triangle of neighbouring sites, each nearer to another of its corners, like Gauss's of degree 2. Where many sites meet in a
//! narrow space, places are dense. Each site is a place, too: a narrow cell may have no other. A symmetric scene has symmetric
//! places.
//!
//! Numbers are kept as f32, some 70 kB for 200 sites; what rounding takes from sums that must be 1 and 0 is given back.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::{
    distance::{Navigation, Place},
    sample::Samples,
    site::Site,
    weight::{Influence, SparseWeights, Weights},
};

/// Sites whose weights differ by no more weigh the same: a sample on an axis of symmetry counts for both sides.
const TIE: f64 = 1e-9;
/// The site that weighs most and how many others tell a part of the picture from the rest. With one other, folds between the places go
/// unseen; with three, or two in the order of their weights, poses are hardly better.
const TOLD_BY: usize = 3;

/// Weights that change by more than this within the width of a part say nothing of it: its place is next to a joint of bones, where
/// gradients have no bound.
const STEEP: f64 = 10.0;
/// Least weight of a site at a place: what is less costs a sixth of the time of a pose, and changes its energy by some thousandths.
const TAIL: f64 = 0.004;
/// The part of what a site weighs that it stands for itself.
const OWN: f64 = 0.1;

/// The site that weighs most, and the next two in the order of their numbers; [`NO_SITE`] where fewer reach.
type Part = [u32; TOLD_BY];
const NO_SITE: u32 = u32::MAX;

/// A place of the quadrature.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Node {
    at: DVec2,
    area: f64,
    /// Site, weight and gradient.
    terms: Vec<(u32, f32, [f32; 2])>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Quadrature {
    nodes: Vec<Node>,
}

impl Quadrature {
    /// Places for the samples of a picture with their weights.
    pub(crate) fn new(
        navigation: &Navigation,
        sites: &[Site],
        samples: &Samples,
        weights: &SparseWeights,
        functions: &Weights,
    ) -> Self {
        let vertices = &samples.mesh.vertices;
        // Area, and area times place, of each part; samples that follow one another are often of the same.
        let mut sums: Vec<(Part, f64, DVec2)> = Vec::new();
        let mut around = vec![0.0; sites.len()];
        for (sample, &area) in areas(samples).iter().enumerate() {
            weights.row(sample).for_each(|(site, weight)| around[site] += weight * area);
            divide(&|| weights.row(sample), [NO_SITE; TOLD_BY], 0, area, &mut |part, area| {
                let moment = area * vertices[sample];
                match sums.last_mut().filter(|last| last.0 == part) {
                    Some(last) => *last = (part, last.1 + area, last.2 + moment),
                    None => sums.push((part, area, moment)),
                }
            });
        }
        sums.sort_by_key(|&(part, ..)| part);
        sums.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                *kept = (kept.0, kept.1 + next.1, kept.2 + next.2);
            }
            same
        });
        // A centroid may lie in a gap of the domain: then the parts around it tell what there is to tell.
        let of_parts = sums.into_iter().filter_map(|(_, area, moment)| {
            let at = moment / area;
            Some((at, navigation.place(at)?, area))
        });
        let of_sites = sites.iter().zip(around).map(|(site, around)| (site.rest, site.place, OWN * around));
        let node = |(at, place, area): (DVec2, Place, f64)| {
            let mut influences = functions.at(sites, place, at);
            let term = |one: &Influence| (one.site as u32, one.weight as f32, one.gradient.as_vec2().to_array());
            let steepest = influences.iter().map(|one| one.gradient.length()).fold(0.0, f64::max);
            influences.retain(|one| one.weight >= TAIL);
            let is_seen = area > 0.0 && !influences.is_empty() && steepest * area.sqrt() < STEEP;
            is_seen.then(|| Node { at, area, terms: influences.iter().map(term).collect() })
        };
        Self { nodes: of_parts.chain(of_sites).filter_map(node).collect() }
    }

    /// Whether it is made for so many sites: to be asked of what came from elsewhere.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        self.nodes.iter().all(|node| {
            let known = |&(site, weight, [x, y]): &(u32, f32, [f32; 2])| {
                (site as usize) < sites && weight.is_finite() && x.is_finite() && y.is_finite()
            };
            let sum: f64 = node.terms.iter().map(|&(_, weight, _)| f64::from(weight)).sum();
            node.at.is_finite() && node.area > 0.0 && node.area.is_finite() && sum > 0.5 && node.terms.iter().all(known)
        })
    }

    /// Place and area of each node, and the influences there: their weights sum to 1, their gradients to 0.
    pub(super) fn nodes(&self) -> impl Iterator<Item = (DVec2, f64, Vec<Influence>)> + '_ {
        self.nodes.iter().map(|node| {
            let influence = |&(site, weight, [x, y]): &(u32, f32, [f32; 2])| Influence {
                site: site as usize,
                weight: weight.into(),
                gradient: DVec2::new(x.into(), y.into()),
            };
            let mut influences: Vec<Influence> = node.terms.iter().map(influence).collect();
            let sum: f64 = influences.iter().map(|one| one.weight).sum();
            influences.iter_mut().for_each(|one| one.weight /= sum);
            let excess: DVec2 = influences.iter().map(|one| one.gradient).sum();
            influences.iter_mut().for_each(|one| one.gradient -= one.weight * excess);
            (node.at, node.area, influences)
        })
    }
}

/// Divides the area of a sample among the parts that its weights tell of: one, or several where weights are tied. `part` holds the
/// `known` sites that weigh most.
fn divide<Row: Iterator<Item = (usize, f64)>>(
    row: &impl Fn() -> Row,
    part: Part,
    known: usize,
    area: f64,
    take: &mut impl FnMut(Part, f64),
) {
    let others = || row().filter(|&(site, _)| !part[..known].contains(&(site as u32)));
    let most = others().map(|(_, weight)| weight).fold(0.0, f64::max);
    let tied = || others().filter(|&(_, weight)| weight >= most - TIE && weight > 0.0);
    let count = tied().count();
    if known == TOLD_BY || count == 0 {
        let [first, second, third] = part;
        take([first, second.min(third), second.max(third)], area);
        return;
    }
    for (site, _) in tied() {
        let mut next = part;
        next[known] = site as u32;
        divide(row, next, known + 1, area / count as f64, take);
    }
}

/// The area that each sample stands for: its Voronoi cell's, cut at the outline. Corners on one circle may be triangulated in
/// either way, which leaves these areas alone.
fn areas(samples: &Samples) -> Vec<f64> {
    let vertices = &samples.mesh.vertices;
    let mut areas = vec![0.0; vertices.len()];
    for corners in &samples.mesh.triangles {
        let p = corners.map(|v| vertices[v as usize]);
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let (to, from) = (p[i] - p[k], p[j] - p[k]);
            let cotangent = to.dot(from) / to.perp_dot(from).abs();
            let share = cotangent * p[i].distance_squared(p[j]) / 8.0;
            areas[corners[i] as usize] += share;
            areas[corners[j] as usize] += share;
        }
    }
    areas
}
