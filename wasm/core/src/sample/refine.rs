//! Finer lattices around sites that are too close for the lattice: the paper's up-sampling.
//!
//! Cells near such sites grow with the distance from them, so the spacing may also grow. It halves towards the sites
//! until it resolves the gap between them. A gap of 0.01 px in a picture of 1,000 px costs about 5,500 samples.
//!
//! Cost of a patch: its nodes, and the nearest rivals of each. If some nodes are its own, also the vertices around it
//! and the outline. Cost of such a node: the vertices within about a spacing, and the outline edges of the patch.

use std::rc::Rc;

use glam::DVec2;

use super::lattice::{LATTICE_CLEARANCE, ROW_HEIGHT};
use crate::{
    distance::Navigation,
    domain::Domain,
    grid::Grid,
    rank::{ascending, sort_by_rank},
    segment::segment_distance,
};

/// Number of samples across the gap between two sites, and across the distance to them.
const RESOLUTION: f64 = 6.0;

/// Nodes lie within this fraction of a patch's radius. This excludes nodes on the circle itself, regardless of
/// rounding.
const INSIDE_CIRCLE: f64 = 1.0 - 1e-9;

/// A patch whose radius exceeds this number of grid cells is coarse: each cell then has few vertices.
const WIDE: f64 = 2.0;

/// A round patch of triangular lattice around a site.
pub(super) struct Patch {
    centre: DVec2,
    spacing: f64,
    radius: f64,
    /// Other sites with patches, the nearest first. Nodes nearer to one of them belong to its patch.
    rivals: Rc<[DVec2]>,
    /// The number of rivals whose patches reach this one.
    reaching: usize,
}

/// The patches for pairs of sites that are too close for `spacing`, coarse ones first.
pub(super) fn patches(sites: &[DVec2], spacing: f64) -> Vec<Patch> {
    let gap = |at: usize| {
        let others = sites.iter().enumerate().filter(|&(other, _)| other != at);
        others.map(|(_, p)| p.distance(sites[at])).fold(f64::INFINITY, f64::min)
    };
    let close: Vec<(DVec2, f64)> =
        (0..sites.len()).map(|at| (sites[at], gap(at))).filter(|&(_, gap)| gap < RESOLUTION * spacing).collect();
    let mut patches = Vec::new();
    for (at, &(centre, gap)) in close.iter().enumerate() {
        let mut rivals: Vec<DVec2> =
            (0..close.len()).filter(|&other| other != at).map(|other| close[other].0).collect();
        sort_by_rank(&mut rivals, |rival| [ascending(rival.distance(centre)), 0]);
        let rivals: Rc<[DVec2]> = rivals.into();
        let mut finer = spacing / 2.0;
        while finer > gap / (2.0 * RESOLUTION) {
            // Beyond this distance the next coarser spacing resolves the distance.
            let radius = 2.0 * finer * RESOLUTION;
            let reaching = rivals.partition_point(|rival| rival.distance(centre) < 2.0 * radius + finer);
            patches.push(Patch { centre, spacing: finer, radius, rivals: Rc::clone(&rivals), reaching });
            finer /= 2.0;
        }
    }
    patches.sort_by(|a, b| b.spacing.total_cmp(&a.spacing));
    patches
}

/// The least and the greatest coordinates of vertices that patches examine.
pub(super) fn bounds(patches: &[Patch]) -> [DVec2; 2] {
    let low = patches.iter().fold(DVec2::INFINITY, |low, patch| low.min(patch.centre - patch.reach()));
    let high = patches.iter().fold(DVec2::NEG_INFINITY, |high, patch| high.max(patch.centre + patch.reach()));
    [low, high]
}

impl Patch {
    /// Vertices beyond this distance from the centre do not matter.
    fn reach(&self) -> f64 {
        self.radius + self.spacing
    }

    /// The nodes inside the domain that keep their clearance from the vertices in `known`.
    pub(super) fn clear_nodes(&self, known: &Grid<DVec2>, navigation: &Navigation, domain: &Domain) -> Vec<DVec2> {
        let (reach, clearance) = (self.reach(), LATTICE_CLEARANCE * self.spacing);
        let mut nodes: Vec<DVec2> = self.own_nodes().collect();
        // Patches of crowded sites have few nodes of their own, and mostly none that is clear.
        if nodes.is_empty() {
            return nodes;
        }
        let finer;
        let near = if self.radius > WIDE * known.side() {
            known
        } else {
            let close = known.around(self.centre, reach).filter(|p| p.distance(self.centre) < reach);
            finer = Grid::new(self.spacing, close.map(|p| (p, p)));
            &finer
        };
        nodes.retain(|&p| near.around(p, clearance).all(|q| p.distance(q) >= clearance));
        nodes.retain(|&p| navigation.triangle_at(p).is_some());
        if nodes.is_empty() {
            return nodes;
        }
        let outline = domain.edges();
        let walls: Vec<(DVec2, DVec2)> =
            outline.filter(|&(a, b)| segment_distance(self.centre, a, b) < reach).collect();
        nodes.retain(|&p| walls.iter().all(|&(a, b)| segment_distance(p, a, b) >= clearance));
        nodes
    }

    /// The nodes that are no nearer to a rival.
    ///
    /// Nodes of two patches with the same spacing keep more than the clearance between them, so both can keep their
    /// nodes. Their order does not matter, and a symmetric scene has symmetric nodes.
    fn own_nodes(&self) -> impl Iterator<Item = DVec2> + '_ {
        let is_own = |rival: &DVec2, p: DVec2| {
            let to_border =
                (p.distance_squared(*rival) - p.distance_squared(self.centre)) / (2.0 * rival.distance(self.centre));
            to_border >= self.spacing / 4.0
        };
        let rivals = &self.rivals[..self.reaching];
        self.nodes().filter(move |&p| rivals.iter().all(|rival| is_own(rival, p)))
    }

    /// The nodes within the radius, except the centre, which is a site.
    fn nodes(&self) -> impl Iterator<Item = DVec2> + '_ {
        let steps = (self.radius / (self.spacing * ROW_HEIGHT)) as i32;
        (-steps..=steps).flat_map(move |j| (-steps - 1..=steps + 1).map(move |i| (i, j))).filter_map(move |(i, j)| {
            let shift = if j % 2 == 0 { 0.0 } else { 0.5 };
            let step = DVec2::new((f64::from(i) + shift) * self.spacing, f64::from(j) * self.spacing * ROW_HEIGHT);
            ((i, j) != (0, 0) && step.length() < INSIDE_CIRCLE * self.radius).then_some(self.centre + step)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_complete_and_clear_of_every_vertex() {
        let domain = Domain::rectangle(100, 80);
        let navigation = Navigation::new(&domain);
        let scattered = |count: u32, size: DVec2| {
            let at = |i: u32| DVec2::new(f64::from(i) * 0.618_033_988_75, f64::from(i) * 0.754_877_666_25);
            (0..count).map(|i| at(i).fract() * size).collect::<Vec<_>>()
        };
        let mut sites = scattered(20, DVec2::new(100.0, 80.0));
        sites.extend([(50.0, 40.0), (50.1, 40.02), (53.0, 41.0)].map(DVec2::from));
        let mut vertices = scattered(900, DVec2::new(100.0, 80.0));
        let (mut clear, mut covered) = (0, 0);
        for patch in patches(&sites, 3.0) {
            let nodes = patch.clear_nodes(&Grid::of_points(3.0, &vertices), &navigation, &domain);
            let mut all = patch.clear_nodes(&Grid::of_points(3.0, &[]), &navigation, &domain);
            covered += all.len();
            all.retain(|p| vertices.iter().all(|q| p.distance(*q) >= LATTICE_CLEARANCE * patch.spacing));
            assert_eq!(nodes, all);
            clear += nodes.len();
            vertices.extend(nodes);
        }
        assert!(1000 < clear && clear + 1000 < covered, "{clear} of {covered}");
    }
}
