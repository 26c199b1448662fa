//! The nodes all over the picture at which the rigid mode measures distortion, with their weights.
//!
//! A cell is divided by its next two dominant sites. A part has a node at its centroid. In a triangle of neighbouring
//! sites, these are three nodes, each near a different corner, like Gauss's rule of degree 2. A part that is long
//! compared with its supports has two nodes with its second moment along it, and one that is large has four.
//!
//! Nodes are dense where many sites meet in a narrow space. A site whose cell has no node becomes a node. A symmetric
//! scene has symmetric nodes.
//!
//! A held outline counts as one site, because none of its sites move.
//!
//! Numbers are stored as f32, about 200 kB for 200 sites. Sums that must be 1 and 0 are corrected for rounding.

mod moments;
mod parts;

use glam::DVec2;

use self::{
    moments::Moments,
    parts::{Part, areas, parts},
};
use crate::{
    distance::{NavTriangle, Navigation},
    sample::Samples,
    site::{Site, SiteKind},
    weight::{Influence, SparseWeights, WeightFunctions},
};

/// A part has two nodes if its standard deviations differ by more than this fraction of the smallest support that
/// reaches it. With one node for each part, a small support between two bars would be missed, and fold. With 0.15, a
/// twisted cross distorts by 2 % more; with 0.1, poses take 10 % longer.
const LONG: f64 = 0.12;
/// A part has four nodes if the root of its area is above this fraction of the smallest support that
/// reaches it. With 0.2, the same number of folds is missed.
const LARGE: f64 = 0.3;
/// A node is dropped if weights change by more than this within the width of its part: such a node is next to a joint
/// of bones, where gradients are unbounded.
const STEEP: f64 = 10.0;
/// Least weight of a site at a node. Smaller weights would take a sixth of the time of a pose, and change its energy by
/// thousandths.
const TAIL: f64 = 0.004;

/// For a node between triangles of the outline, each of which sees the paths on its own side, gradients are
/// differences over this fraction of the width of its part.
const STEP: f64 = 1e-4;

/// A node of the quadrature.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    pub(crate) at: DVec2,
    pub(crate) area: f64,
    /// Their weights sum to 1, their gradients to 0.
    pub(crate) influences: Vec<Influence>,
}

/// All nodes, as they are stored.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Quadrature {
    nodes: Vec<PackedNode>,
}

#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
struct PackedNode {
    at: DVec2,
    area: f64,
    influences: Vec<PackedInfluence>,
}

#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
struct PackedInfluence {
    site: u32,
    weight: f32,
    gradient: [f32; 2],
}

impl Quadrature {
    /// The nodes for the samples of a picture with their weights.
    pub(crate) fn new(
        navigation: &Navigation,
        sites: &[Site],
        samples: &Samples,
        weights: &SparseWeights,
        functions: &WeightFunctions,
    ) -> Self {
        let held = HeldOutline::of(sites);
        let areas = areas(samples);
        let placing = Placing { navigation, sites, functions, held };
        let mut nodes = Vec::new();
        let mut has_node = vec![false; sites.len()];
        for part in parts(sites, samples, &areas, weights, held) {
            let Some(at_centroid) = placing.centroid_node(&part) else { continue };
            if let Some(site) = part.site() {
                has_node[site] = true;
            }
            let support = placing.smallest_support(&at_centroid);
            let several = placing.quarters(&part, support).or_else(|| placing.halves(&part, support));
            nodes.extend(several.unwrap_or_else(|| vec![at_centroid]));
        }
        let is_alone = |&site: &usize| !has_node[site] && sites[site].kind != SiteKind::Boundary;
        let around = areas_around(sites.len(), &areas, weights);
        let alone = (0..sites.len()).filter(is_alone);
        nodes.extend(
            alone.filter_map(|site| placing.node(sites[site].rest, functions.fields()[site].triangle, around[site])),
        );
        Self { nodes }
    }

    pub(super) fn from_nodes(nodes: &[Node]) -> Self {
        Self { nodes: nodes.iter().map(PackedNode::new).collect() }
    }

    /// All nodes, with the influences there.
    pub(super) fn nodes(&self) -> impl Iterator<Item = Node> + '_ {
        self.nodes.iter().map(PackedNode::unpacked)
    }

    /// Whether data read from bytes is consistent for this number of sites.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        self.nodes.iter().all(|node| node.is_whole(sites))
    }
}

impl PackedNode {
    fn new(node: &Node) -> Self {
        let packed = |one: &Influence| PackedInfluence {
            site: one.site as u32,
            weight: one.weight as f32,
            gradient: one.gradient.as_vec2().to_array(),
        };
        Self { at: node.at, area: node.area, influences: node.influences.iter().map(packed).collect() }
    }

    fn is_whole(&self, sites: usize) -> bool {
        let known = |&PackedInfluence { site, weight, gradient: [x, y] }: &PackedInfluence| {
            (site as usize) < sites && weight.is_finite() && x.is_finite() && y.is_finite()
        };
        let sum: f64 = self.influences.iter().map(|one| f64::from(one.weight)).sum();
        self.at.is_finite()
            && self.area > 0.0
            && self.area.is_finite()
            && sum > 0.5
            && self.influences.iter().all(known)
    }

    fn unpacked(&self) -> Node {
        let influence = |&PackedInfluence { site, weight, gradient: [x, y] }: &PackedInfluence| Influence {
            site: site as usize,
            weight: weight.into(),
            gradient: DVec2::new(x.into(), y.into()),
        };
        let mut influences: Vec<Influence> = self.influences.iter().map(influence).collect();
        let sum: f64 = influences.iter().map(|one| one.weight).sum();
        influences.iter_mut().for_each(|one| one.weight /= sum);
        let excess: DVec2 = influences.iter().map(|one| one.gradient).sum();
        influences.iter_mut().for_each(|one| one.gradient -= one.weight * excess);
        Node { at: self.at, area: self.area, influences }
    }
}

/// Places nodes, and evaluates the weights there.
struct Placing<'a> {
    navigation: &'a Navigation,
    sites: &'a [Site],
    functions: &'a WeightFunctions,
    held: HeldOutline,
}

impl Placing<'_> {
    /// The node at the centroid of a part. `None` if that lies in a gap of the domain: the parts around it suffice.
    fn centroid_node(&self, part: &Part) -> Option<PackedNode> {
        self.node_at(part.moments.centroid(), part.moments.area)
    }

    /// The smallest support that reaches a node.
    fn smallest_support(&self, node: &PackedNode) -> f64 {
        let reaching = node.influences.iter().map(|one| &self.sites[one.site as usize]);
        let supports = reaching.filter(|site| site.kind != SiteKind::Boundary).map(|site| site.support_radius);
        supports.fold(f64::INFINITY, f64::min)
    }

    /// The two nodes of a part that is long.
    fn halves(&self, part: &Part, support: f64) -> Option<Vec<PackedNode>> {
        let halves = part.moments.halves(LONG * support)?;
        halves.map(|at| self.node_at(at, part.moments.area / 2.0)).into_iter().collect()
    }

    /// The four nodes of a part that is large. `None` if it is flat, or if one of them would lie outside the domain.
    fn quarters(&self, part: &Part, support: f64) -> Option<Vec<PackedNode>> {
        let moments = &part.moments;
        let is_large = moments.area.sqrt() > LARGE * support;
        let quarters = is_large.then(|| moments.quarters()).flatten()?;
        quarters.map(|at| self.node_at(at, moments.area / 4.0)).into_iter().collect()
    }

    fn node_at(&self, at: DVec2, area: f64) -> Option<PackedNode> {
        self.node(at, self.navigation.triangle_at(at)?, area)
    }

    /// The node at a position that represents an area; `None` if weights change too much within the area.
    fn node(&self, at: DVec2, triangle: NavTriangle, area: f64) -> Option<PackedNode> {
        let Self { navigation, sites, functions, held } = *self;
        let here = match navigation.is_on_edge(triangle, at) {
            true => functions.across(navigation, (triangle, at), STEP * area.sqrt()),
            false => functions.at(triangle, at),
        };
        let mut influences: Vec<Influence> = Vec::new();
        here.into_iter().for_each(|one| held.add(&mut influences, sites, one));
        let steepest = influences.iter().map(|one| one.gradient.length()).fold(0.0, f64::max);
        influences.retain(|one| one.weight >= TAIL);
        let is_seen = area > 0.0 && !influences.is_empty() && steepest * area.sqrt() < STEEP;
        is_seen.then(|| PackedNode::new(&Node { at, area, influences }))
    }
}

/// The site that counts for all of a held outline: its first.
#[derive(Debug, Clone, Copy)]
struct HeldOutline(Option<usize>);

impl HeldOutline {
    fn of(sites: &[Site]) -> Self {
        Self(sites.iter().position(|site| site.kind == SiteKind::Boundary))
    }

    /// Adds to an existing influence of the same site.
    fn add(self, influences: &mut Vec<Influence>, sites: &[Site], more: Influence) {
        let stays = sites[more.site].kind == SiteKind::Boundary;
        let site = self.0.filter(|_| stays).unwrap_or(more.site);
        match influences.iter_mut().find(|known| known.site == site) {
            Some(known) => {
                known.weight += more.weight;
                known.gradient += more.gradient;
            }
            None => influences.push(Influence { site, ..more }),
        }
    }
}

/// The area that each site moves: the sum of its weights.
fn areas_around(sites: usize, areas: &[f64], weights: &SparseWeights) -> Vec<f64> {
    let mut around = vec![0.0; sites];
    for (sample, area) in areas.iter().enumerate() {
        weights.row(sample).for_each(|(site, weight)| around[site] += weight * area);
    }
    around
}
