//! Places all over the picture at which a pose is judged, with their weights: what travels to where poses are computed.
//!
//! A cell is divided by which two other sites weigh most, and every part has a place at its centroid: three in what would be a
//! triangle of neighbouring sites, each nearer to another of its corners, like Gauss's of degree 2. A part that is long beside the
//! supports that reach it has two places, which have its second moment along it. Where many sites meet in a narrow space, places are
//! dense. A site whose cell has no other place is one. A symmetric scene has symmetric places.
//!
//! All of a held outline counts as one site: whatever its sites weigh, they stay.
//!
//! Numbers are kept as f32, some 70 kB for 200 sites; what rounding takes from sums that must be 1 and 0 is given back.

use std::ops::AddAssign;

use glam::{DMat2, DVec2};
use serde::{Deserialize, Serialize};

use super::motion::turn;
use crate::{
    distance::{Navigation, Place},
    sample::Samples,
    site::{Site, SiteKind},
    weight::{Influence, SparseWeights, WeightFunctions},
};

/// Sites whose weights differ by no more weigh the same: a sample on an axis of symmetry counts for both sides. One that weighs no more
/// weighs nothing: it is rounding that decides where a support ends.
const TIE: f64 = 1e-9;
/// The site that weighs most and how many others tell a part of the picture from the rest. With one other, folds between the places go
/// unseen; with three, or two in the order of their weights, poses are hardly better.
const TOLD_BY: usize = 3;

/// A part that is longer than wide by more than this share of the least support that reaches it has two places, as standard deviations
/// go. With one for all, what a small support between two bars does goes unseen, and folds; with 0.15 a twisted cross distorts by 2 %
/// more, with 0.1 poses take 10 % longer.
const LONG: f64 = 0.12;
/// Weights that change by more than this within the width of a part say nothing of it: its place is next to a joint of bones, where
/// gradients have no bound.
const STEEP: f64 = 10.0;
/// Least weight of a site at a place: what is less costs a sixth of the time of a pose, and changes its energy by some thousandths.
const TAIL: f64 = 0.004;

/// Where a place is between triangles of the outline, of which each sees the paths on its own side, gradients are differences over this
/// share of the width of its part.
const STEP: f64 = 1e-5;

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
        functions: &WeightFunctions,
    ) -> Self {
        let vertices = &samples.mesh.vertices;
        let outline = sites.iter().position(|site| site.kind == SiteKind::Boundary);
        let counted = |influence: Influence| {
            let stays = sites[influence.site].kind == SiteKind::Boundary;
            Influence { site: outline.filter(|_| stays).unwrap_or(influence.site), ..influence }
        };
        // Samples that follow one another are often of the same part.
        let mut parts: Vec<(Part, Moments)> = Vec::new();
        let mut around = vec![0.0; sites.len()];
        let mut row: Vec<Influence> = Vec::new();
        for (sample, &area) in areas(samples).iter().enumerate() {
            row.clear();
            for (site, weight) in weights.row(sample) {
                around[site] += weight * area;
                add(&mut row, counted(Influence { site, weight, gradient: DVec2::ZERO }));
            }
            divide(&row, [NO_SITE; TOLD_BY], 0, area, &mut |part, area| {
                let about = sites.get(part[0] as usize).map_or(vertices[0], |site| site.rest);
                let moments = Moments::of(vertices[sample], area, about);
                match parts.last_mut().filter(|last| last.0 == part) {
                    Some(last) => last.1 += moments,
                    None => parts.push((part, moments)),
                }
            });
        }
        parts.sort_by_key(|&(part, _)| part);
        parts.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        let node = |at: DVec2, place: Place, area: f64| {
            let mut terms: Vec<Influence> = Vec::new();
            let here = match navigation.is_on_edge(place, at) {
                true => functions.across(navigation, sites, (place, at), STEP * area.sqrt()),
                false => functions.at(sites, place, at),
            };
            here.into_iter().for_each(|influence| add(&mut terms, counted(influence)));
            let steepest = terms.iter().map(|one| one.gradient.length()).fold(0.0, f64::max);
            terms.retain(|one| one.weight >= TAIL);
            let term = |one: &Influence| (one.site as u32, one.weight as f32, one.gradient.as_vec2().to_array());
            let is_seen = area > 0.0 && !terms.is_empty() && steepest * area.sqrt() < STEEP;
            is_seen.then(|| Node { at, area, terms: terms.iter().map(term).collect() })
        };
        let inside = |at: DVec2, area: f64| navigation.place(at).and_then(|place| node(at, place, area));
        let mut nodes = Vec::new();
        let mut has_place = vec![false; sites.len()];
        for ([first, ..], moments) in parts {
            // A centroid may lie in a gap of the domain: then the parts around it tell what there is to tell.
            let Some(one) = inside(moments.centroid(), moments.area) else { continue };
            let reaching = one.terms.iter().map(|&(site, ..)| &sites[site as usize]);
            let supports = reaching.filter(|site| site.kind != SiteKind::Boundary).map(|site| site.support_radius);
            let two = moments.halves(LONG * supports.fold(f64::INFINITY, f64::min));
            match two.map(|halves| halves.map(|at| inside(at, moments.area / 2.0))) {
                Some([Some(one), Some(other)]) => nodes.extend([one, other]),
                _ => nodes.push(one),
            }
            if first != NO_SITE {
                has_place[first as usize] = true;
            }
        }
        let is_alone = |&site: &usize| !has_place[site] && sites[site].kind != SiteKind::Boundary;
        let alone = (0..sites.len()).filter(is_alone);
        nodes.extend(alone.filter_map(|site| node(sites[site].rest, sites[site].place, around[site])));
        Self { nodes }
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

/// Area of a part, and its first and second moments about a place near it: about the picture's corner they would lose the digits that a
/// part far away is told by.
#[derive(Debug, Clone, Copy)]
struct Moments {
    about: DVec2,
    area: f64,
    first: DVec2,
    second: DMat2,
}

impl Moments {
    /// Of an area at one place.
    fn of(at: DVec2, area: f64, about: DVec2) -> Self {
        let from = at - about;
        let first = area * from;
        Self { about, area, first, second: DMat2::from_cols(from.x * first, from.y * first) }
    }

    fn centroid(&self) -> DVec2 {
        self.about + self.first / self.area
    }

    /// Two places that, with half the area each, have the second moment along the longer axis; `None` where that is longer than the shorter
    /// by less than `least`, measured as deviations: where they are as long there is no such axis.
    fn halves(&self, least: f64) -> Option<[DVec2; 2]> {
        let at = self.centroid();
        let mean = self.first / self.area;
        let [xx, xy, _, yy] = (1.0 / self.area * self.second).to_cols_array();
        let (xx, xy, yy) = (xx - mean.x * mean.x, xy - mean.x * mean.y, yy - mean.y * mean.y);
        let half = (xx - yy) / 2.0;
        let excess = libm::hypot(half, xy);
        (2.0 * excess > least * least).then(|| {
            let along = (f64::midpoint(xx, yy) + excess).sqrt() * turn(libm::atan2(xy, half) / 2.0);
            [at - along, at + along]
        })
    }
}

/// Of the same part.
impl AddAssign for Moments {
    fn add_assign(&mut self, more: Self) {
        self.area += more.area;
        self.first += more.first;
        self.second += more.second;
    }
}

/// Adds to what a site has to say already, if it has.
fn add(influences: &mut Vec<Influence>, more: Influence) {
    match influences.iter_mut().find(|known| known.site == more.site) {
        Some(known) => {
            known.weight += more.weight;
            known.gradient += more.gradient;
        }
        None => influences.push(more),
    }
}

/// Divides the area of a sample among the parts that its weights tell of: one, or several where weights are tied. `part` holds the
/// `known` sites that weigh most.
fn divide(row: &[Influence], part: Part, known: usize, area: f64, take: &mut impl FnMut(Part, f64)) {
    let others = || row.iter().filter(|one| !part[..known].contains(&(one.site as u32)));
    let most = others().map(|one| one.weight).fold(0.0, f64::max);
    let tied = || others().filter(|one| one.weight >= most - TIE && one.weight > TIE);
    let count = tied().count();
    if known == TOLD_BY || count == 0 {
        let [first, second, third] = part;
        take([first, second.min(third), second.max(third)], area);
        return;
    }
    for one in tied() {
        let mut next = part;
        next[known] = one.site as u32;
        divide(row, next, known + 1, area / count as f64, take);
    }
}

/// The area that each sample stands for: of every triangle a third. What has more corners on one circle is shared out as a whole.
fn areas(samples: &Samples) -> Vec<f64> {
    let vertices = &samples.mesh.vertices;
    let mut areas = vec![0.0; vertices.len()];
    let share_out = |edges: &[[u32; 2]]| {
        let middle = edges.iter().map(|[a, _]| vertices[*a as usize]).sum::<DVec2>() / edges.len() as f64;
        for edge in edges {
            let [a, b] = edge.map(|v| vertices[v as usize] - middle);
            edge.iter().for_each(|&v| areas[v as usize] += a.perp_dot(b) / 4.0);
        }
    };
    samples.mesh.polygons(|_| true, share_out);
    areas
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equal areas on a grid of so many places by so many, as far apart as told, turned, about a place.
    fn rectangle(long: i32, wide: i32, apart: f64, turned: f64, middle: DVec2) -> Moments {
        let about = middle + DVec2::new(apart, -2.0 * apart);
        let mut sum = Moments::of(middle, 0.0, about);
        for (x, y) in (0..long).flat_map(|x| (0..wide).map(move |y| (x, y))) {
            let (x, y) = (f64::from(2 * x + 1 - long) / 2.0, f64::from(2 * y + 1 - wide) / 2.0);
            let at = middle + turn(turned).rotate(apart * DVec2::new(x, y));
            sum += Moments::of(at, apart * apart / 4.0, about);
        }
        sum
    }

    /// In a picture, and as small as in a mesh that lies far away.
    #[test]
    fn what_is_long_is_halved_along_it() {
        for (apart, middle) in [(1.0, DVec2::new(900.0, -70.0)), (0.01, DVec2::new(1e6, -1e6))] {
            for turned in [0.0, 0.4, 1.6, 3.0] {
                let moments = rectangle(40, 10, apart, turned, middle);
                // The deviation of n numbers one apart: √((n² − 1) / 12).
                let along = apart * (1599.0_f64 / 12.0).sqrt() * turn(turned);
                let halves = moments.halves(2.0 * apart).expect("long");
                for half in [middle - along, middle + along] {
                    assert!(halves.iter().any(|at| at.distance(half) < 1e-9), "{half} is not of {halves:?}");
                }
            }
        }
    }

    #[test]
    fn what_is_short_or_as_wide_as_long_is_one() {
        for (apart, middle) in [(1.0, DVec2::new(900.0, -70.0)), (0.01, DVec2::new(1e6, -1e6))] {
            assert_eq!(rectangle(40, 10, apart, 0.4, middle).halves(12.0 * apart), None);
            assert_eq!(rectangle(40, 40, apart, 0.4, middle).halves(1e-3 * apart), None);
        }
    }
}
