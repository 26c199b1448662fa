//! The cell graph: links between neighbouring sites, with weights (the Delaunay graph of section IV-B).
//!
//! Cells that touch have d(h_i, h_j) ≤ r_d(h_i) + r_d(h_j). Sites are linked up to [`LINK_REACH`] times that distance.
//! The weight of a link falls smoothly to zero there, while the paper gives all links the same weight.
//!
//! Cells that touch are always linked, so the graph is connected in every connected part of the domain. The dual of a
//! sampled Voronoi diagram gains and loses links where four cells meet. This graph depends only on exact lengths: it
//! changes smoothly with the position of a handle, and preserves the symmetry of a scene.
//!
//! Cost: O(n²) for n sites, plus a visit of every bone for each link.

use super::{Site, SiteField};
use crate::bone::Skeleton;

/// Maximum distance of linked sites, over the distance at which their cells can touch. In a regular packing, neighbours
/// are at 0.87 of that distance and second neighbours at 1.5; in a corridor, at 1 and 2. Second neighbours are not
/// linked.
const LINK_REACH: f64 = 1.3;

/// Weighted links between sites.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SiteGraph {
    /// Links × 2: the linked sites, the lower index first, in ascending order.
    pub(crate) links: Vec<[u32; 2]>,
    /// Links: the weight of each, in (0, 1].
    pub(crate) weights: Vec<f64>,
}

impl SiteGraph {
    /// The bound that the field of a site needs, in pixels. The field then reaches every site that may be linked and
    /// whose cell is not larger.
    pub(crate) fn field_bound(cell_radius: f64) -> f64 {
        2.0 * LINK_REACH * cell_radius
    }

    /// Links sites whose fields reach their [`field_bound`](Self::field_bound), unless a bone
    /// [separates](Skeleton::separates) them.
    pub(crate) fn new(sites: &[Site], fields: &[SiteField], skeleton: &Skeleton) -> Self {
        let mut graph = Self::default();
        for (i, a) in sites.iter().enumerate() {
            for (j, b) in sites.iter().enumerate().skip(i + 1) {
                let limit = LINK_REACH * (a.cell_radius + b.cell_radius);
                if fields[i].island != fields[j].island || a.rest.distance(b.rest) >= limit {
                    continue;
                }
                let (larger, smaller) = if a.cell_radius >= b.cell_radius { (i, j) } else { (j, i) };
                let x = fields[larger].distance(fields[smaller].triangle, sites[smaller].rest) / limit;
                if x < 1.0 && !skeleton.separates(a.rest, b.rest) {
                    let falling = 1.0 - x * x;
                    graph.links.push([i as u32, j as u32]);
                    graph.weights.push(falling * falling);
                }
            }
        }
        graph
    }

    /// The two sites and the weight of each link.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.links.iter().zip(&self.weights).map(|(&[i, j], &weight)| (i as usize, j as usize, weight))
    }
}
