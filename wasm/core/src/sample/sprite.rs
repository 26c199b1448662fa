//! Few points over a domain: the corners of its outline, and the densest lattice that a given number of points allows.
//!
//! Cost: about forty lattices of that many points.

use glam::DVec2;

use super::{lattice, nodes::Nodes, outline::OutlineSamples};
use crate::domain::Domain;

/// From one spacing to the next, the number of points falls by about 5 %.
const SPACING_STEP: f64 = 1.025;

/// Points along an outline and inside it.
pub(crate) struct SpriteSamples {
    /// The points of the outline come first, ring by ring.
    pub(crate) vertices: Vec<DVec2>,
    /// The segments between consecutive points of the outline.
    pub(crate) segments: Vec<[usize; 2]>,
}

impl SpriteSamples {
    /// As many points as possible up to `most`, for meshes that may duplicate `again` points of the outline. `None` if
    /// there are too many corners.
    pub(crate) fn new(domain: &Domain, most: usize, again: bool) -> Option<Self> {
        let count = |on_outline: usize, inside: usize| on_outline * (1 + usize::from(again)) + inside;
        let corners: usize = domain.rings().iter().map(Vec::len).sum();
        if count(corners, 0) > most {
            return None;
        }
        let (low, high) = domain.bounds();
        let coarsest = low.distance(high);
        let mut spacing = lattice::spacing(domain, most) / 1.5;
        loop {
            let OutlineSamples { mut vertices, segments, .. } = OutlineSamples::new(domain, spacing);
            let nodes = Nodes::new(domain, &[], spacing, &vertices, &segments);
            let inside: Vec<DVec2> = nodes.positions().map(|(_, p)| p).collect();
            // Beyond the coarsest spacing, no edge is divided, and no lattice point has room.
            if count(vertices.len(), inside.len()) <= most || spacing > coarsest {
                vertices.extend(inside);
                return Some(Self { vertices, segments });
            }
            spacing *= SPACING_STEP;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearly_all_points_are_used_and_never_more() {
        let domain = Domain::rectangle(300, 200);
        assert_eq!(SpriteSamples::new(&domain, 4, false).unwrap().vertices.len(), 4);
        assert!(SpriteSamples::new(&domain, 3, false).is_none());
        assert!(SpriteSamples::new(&domain, 7, true).is_none());
        for most in [10, 50, 300, 5000] {
            let found = SpriteSamples::new(&domain, most, false).unwrap().vertices.len();
            assert!(found <= most && found * 10 > most * 7, "{found} of {most}");
        }
    }
}
