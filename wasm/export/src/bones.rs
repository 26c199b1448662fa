//! Selects the sites that become bones: those whose motion other sites cannot represent.
//!
//! Sites are merged into a neighbour one by one, always the pair with the smallest loss. The loss of a pair is the
//! squared distance between the two motions, over all poses and over the vertices that the removed site moves.
//!
//! A site with an owner joins an earlier site of the same owner only. So the first site of each owner stays a bone.
//!
//! Cost: linear in the poses, for each link of the cell graph, and for each link of a merged site.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DAffine2, DVec2};

use c2warp::weight::SparseWeights;

/// The sites that become bones, and the bone that represents each site.
#[derive(Debug, PartialEq)]
pub(crate) struct ChosenSites {
    /// Ascending.
    pub(crate) kept: Vec<usize>,
    /// For each site, the kept site that receives its weights.
    pub(crate) leader: Vec<usize>,
}

/// The distribution of a site's weights: sums of w², w² p and w² p pᵀ over the vertices.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    mass: f64,
    first: DVec2,
    /// xx, xy, yy.
    second: [f64; 3],
}

impl Moments {
    fn add_vertex(&mut self, p: DVec2, weight: f64) {
        let mass = weight * weight;
        self.mass += mass;
        self.first += mass * p;
        self.second[0] += mass * p.x * p.x;
        self.second[1] += mass * p.x * p.y;
        self.second[2] += mass * p.y * p.y;
    }

    fn add(&mut self, other: &Self) {
        self.mass += other.mass;
        self.first += other.first;
        self.second.iter_mut().zip(other.second).for_each(|(sum, more)| *sum += more);
    }

    /// Σ w² |difference(p)|².
    fn squared(&self, difference: &DAffine2) -> f64 {
        let [x, y] = [difference.matrix2.x_axis, difference.matrix2.y_axis];
        let [xx, xy, yy] = self.second;
        let linear = x.length_squared() * xx + 2.0 * x.dot(y) * xy + y.length_squared() * yy;
        let t = difference.translation;
        linear + 2.0 * t.dot(difference.matrix2 * self.first) + t.length_squared() * self.mass
    }
}

/// Selects at most `most` sites, but at least one for each owner, given their maps in some poses (poses × sites) and
/// the weights of vertices. `owners` has one entry for each site.
pub(crate) fn chosen_sites<Owner: PartialEq>(
    maps: &[Vec<DAffine2>],
    vertices: &[DVec2],
    weights: &SparseWeights,
    links: impl Iterator<Item = (usize, usize)>,
    owners: &[Option<Owner>],
    most: usize,
) -> ChosenSites {
    let sites = maps.first().map_or(0, Vec::len);
    let mut moments = vec![Moments::default(); sites];
    for (vertex, &p) in vertices.iter().enumerate() {
        weights.row(vertex).for_each(|(site, weight)| moments[site].add_vertex(p, weight));
    }
    let mut beside: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); sites];
    for (a, b) in links {
        beside[a].insert(b);
        beside[b].insert(a);
    }
    let mut leader: Vec<usize> = (0..sites).collect();
    let mut alive: BTreeSet<usize> = (0..sites).collect();
    let loss = |moments: &[Moments], from: usize, to: usize| -> f64 {
        let difference = |pose: &Vec<DAffine2>| DAffine2 {
            matrix2: pose[to].matrix2 - pose[from].matrix2,
            translation: pose[to].translation - pose[from].translation,
        };
        maps.iter().map(|pose| moments[from].squared(&difference(pose))).sum()
    };
    // The cheapest merge of each site.
    let cheapest = |site: usize, moments: &[Moments], beside: &[BTreeSet<usize>], alive: &BTreeSet<usize>| {
        let may_join = |to: usize| owners[site].is_none() || (to < site && owners[to] == owners[site]);
        let of = |others: &BTreeSet<usize>| {
            let allowed = others.iter().filter(|&&to| to != site && may_join(to));
            let least = |a: (f64, usize), b: (f64, usize)| if b.0 < a.0 { b } else { a };
            allowed.map(|&to| (loss(moments, site, to), to)).reduce(least)
        };
        // A site without neighbours left may join any other.
        of(&beside[site]).or_else(|| of(alive))
    };
    let mut merges: BTreeMap<usize, (f64, usize)> = BTreeMap::new();
    for site in 0..sites {
        merges.extend(cheapest(site, &moments, &beside, &alive).map(|merge| (site, merge)));
    }
    while alive.len() > most.max(1) {
        let least = merges.iter().min_by(|a, b| a.1.0.total_cmp(&b.1.0)).map(|(&from, &(_, to))| (from, to));
        let Some((from, to)) = least else { break };
        alive.remove(&from);
        merges.remove(&from);
        leader[from] = to;
        let moved = moments[from];
        moments[to].add(&moved);
        let around = std::mem::take(&mut beside[from]);
        for &other in &around {
            beside[other].remove(&from);
            if other != to {
                beside[other].insert(to);
                beside[to].insert(other);
            }
        }
        let stale = merges.iter().filter(|(site, (_, into))| *into == from || around.contains(site) || **site == to);
        let stale: Vec<usize> = stale.map(|(&site, _)| site).collect();
        for site in stale {
            merges.remove(&site);
            merges.extend(cheapest(site, &moments, &beside, &alive).map(|merge| (site, merge)));
        }
    }
    for site in 0..sites {
        let mut last = site;
        while leader[last] != last {
            last = leader[last];
        }
        leader[site] = last;
    }
    ChosenSites { kept: alive.into_iter().collect(), leader }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sites_that_move_alike_become_one_bone() {
        let shift = |x: f64| DAffine2::from_translation(DVec2::new(x, 0.0));
        // Sites 1 and 2 always move alike, site 0 independently.
        let maps = vec![vec![shift(0.0), shift(5.0), shift(5.0)], vec![shift(2.0), shift(-1.0), shift(-1.0)]];
        let vertices = [DVec2::ZERO, DVec2::X, DVec2::Y];
        let weights = SparseWeights::from_parts(vec![0, 1, 2, 3], vec![0, 1, 2], vec![1.0; 3]).unwrap();
        let links = [(0, 1), (1, 2)].into_iter();
        let chosen = chosen_sites(&maps, &vertices, &weights, links, &[None::<u32>; 3], 2);
        assert_eq!(chosen.kept.len(), 2);
        assert_eq!(chosen.leader[1], chosen.leader[2]);
        assert_eq!(chosen.leader[0], 0);
    }

    #[test]
    fn sites_without_links_are_merged_as_well() {
        let maps = vec![vec![DAffine2::IDENTITY; 5]];
        let weights = SparseWeights::from_parts(vec![0], vec![], vec![]).unwrap();
        let chosen = chosen_sites(&maps, &[], &weights, std::iter::empty(), &[None::<u32>; 5], 2);
        assert_eq!(chosen.kept.len(), 2);
        assert!(chosen.leader.iter().all(|leader| chosen.kept.contains(leader)));
    }
    #[test]
    fn the_first_site_of_an_owner_stays_even_if_it_moves_as_its_neighbours_do() {
        // All sites move alike, so any merge loses nothing. Those of owners come in no order.
        let maps = vec![vec![DAffine2::IDENTITY; 7]];
        let weights = SparseWeights::from_parts(vec![0], vec![], vec![]).unwrap();
        let owners = [Some('b'), None, Some('a'), Some('b'), None, Some('a'), Some('c')];
        let links = || (0..6).map(|site| (site, site + 1));
        for most in [0, 1, 3, 4, 5] {
            let chosen = chosen_sites(&maps, &[], &weights, links(), &owners, most);
            assert_eq!(chosen.kept.len(), most.max(3), "{most}");
            assert!([0, 2, 6].iter().all(|first| chosen.kept.contains(first)), "{:?}", chosen.kept);
            let is_own = |site: usize| owners[site].is_none() || owners[chosen.leader[site]] == owners[site];
            assert!((0..7).all(is_own), "{:?}", chosen.leader);
        }
    }
}
