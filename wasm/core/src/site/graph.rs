//! The cell graph: which sites are neighbours, and how strongly (the Delaunay graph of section IV-B).
//!
//! Cells that touch have d(h_i, h_j) ≤ r_d(h_i) + r_d(h_j). Sites are linked up to [`LINK_REACH`] times that distance, with a
//! weight that falls smoothly to zero there (the paper's links all weigh the same). Cells that touch are always linked, so
//! the graph is connected wherever the domain is; and unlike the dual of a sampled Voronoi diagram, whose links appear and
//! vanish where four cells meet, the graph depends on exact lengths only: it changes smoothly when a handle is placed
//! elsewhere and keeps the symmetry of a scene.
//!
//! Cost: O(n²) for n sites, and a look at every bone for each link.

use super::Site;
use crate::bone::Skeleton;

/// Greatest distance of linked sites, over the distance at which their cells can touch. In a regular packing of sites
/// neighbours are at 0.87 of the latter and second neighbours at 1.5, in a corridor at 1 and 2: second neighbours stay
/// unlinked.
const LINK_REACH: f64 = 1.3;

/// Weighted links between sites.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SiteGraph {
    /// Pairs of linked sites, the lower index first, in ascending order.
    pub(crate) links: Vec<[u32; 2]>,
    /// Weight of each link, in (0, 1].
    pub(crate) weights: Vec<f64>,
}

impl SiteGraph {
    /// The bound that a site's distance field needs for its links to sites with cells no larger than its own.
    pub(crate) fn field_bound(cell_radius: f64) -> f64 {
        2.0 * LINK_REACH * cell_radius
    }

    /// Links sites whose fields reach their [`field_bound`](Self::field_bound).
    ///
    /// Sites that a bone [separates](Skeleton::separates) are not linked.
    pub(crate) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let mut graph = Self::default();
        for (i, a) in sites.iter().enumerate() {
            for (j, b) in sites.iter().enumerate().skip(i + 1) {
                let limit = LINK_REACH * (a.cell_radius + b.cell_radius);
                if a.island != b.island || a.rest.distance(b.rest) >= limit {
                    continue;
                }
                let (larger, smaller) = if a.cell_radius >= b.cell_radius { (a, b) } else { (b, a) };
                let x = larger.field.distance(smaller.triangle, smaller.rest) / limit;
                if x < 1.0 && !skeleton.separates(a.rest, b.rest) {
                    let falling = 1.0 - x * x;
                    graph.links.push([i as u32, j as u32]);
                    graph.weights.push(falling * falling);
                }
            }
        }
        graph
    }

    /// The links with their weights.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.links.iter().zip(&self.weights).map(|(&[i, j], &weight)| (i as usize, j as usize, weight))
    }
}
