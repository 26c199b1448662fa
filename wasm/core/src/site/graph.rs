//! The cell graph: which sites are neighbours, and how strongly (paper, section IV-B's Delaunay graph).
//!
//! Cells that touch have d(h_i, h_j) ≤ r_d(h_i) + r_d(h_j). Sites are linked when that holds with some room, by a weight that
//! falls smoothly to zero at the end of the room. Every two cells that touch are linked, so the graph hangs together wherever
//! the domain does; and unlike the dual of a sampled Voronoi diagram, whose links come and go where four cells meet, the graph
//! depends on exact lengths only: it changes smoothly when a handle is placed elsewhere and keeps the symmetry of a scene.

use super::Site;
use crate::bone::Skeleton;

/// Cells are linked up to this multiple of the distance at which they can touch. In a regular packing of sites
/// neighbours are 0.87 of that distance apart and second neighbours 1.5, in a corridor 1 and 2: they stay unlinked.
const ROOM: f64 = 1.3;

/// Weighted links between sites.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SiteGraph {
    /// Pairs of linked sites, the lower first, in ascending order.
    pub links: Vec<[u32; 2]>,
    /// Weight of each link, in (0, 1].
    pub weights: Vec<f64>,
}

impl SiteGraph {
    /// How far a site's distance field must reach to know its links to sites with cells no larger than its own.
    pub(crate) fn field_bound(cell_radius: f64) -> f64 {
        2.0 * ROOM * cell_radius
    }

    /// Links the sites, whose fields must reach their [`field_bound`](Self::field_bound).
    ///
    /// What lies on two sides of a bone is not linked: the bone is between.
    pub(crate) fn new(sites: &[Site], skeleton: &Skeleton) -> Self {
        let mut graph = Self::default();
        for (i, a) in sites.iter().enumerate() {
            for (j, b) in sites.iter().enumerate().skip(i + 1) {
                let limit = ROOM * (a.cell_radius + b.cell_radius);
                if a.island != b.island || a.rest.distance(b.rest) >= limit {
                    continue;
                }
                let (larger, smaller) = if a.cell_radius >= b.cell_radius { (a, b) } else { (b, a) };
                let x = larger.field.distance(smaller.place, smaller.rest) / limit;
                if x < 1.0 && !skeleton.is_between(a.rest, b.rest) {
                    let falling = 1.0 - x * x;
                    graph.links.push([i as u32, j as u32]);
                    graph.weights.push(falling * falling);
                }
            }
        }
        graph
    }

    /// Links with their weights.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.links.iter().zip(&self.weights).map(|(&[i, j], &weight)| (i as usize, j as usize, weight))
    }
}
