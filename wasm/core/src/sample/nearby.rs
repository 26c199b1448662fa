//! Triangles of base samples near a point.
//!
//! Cost of a lookup: a binary search of the rows of the lattice, and a cell of a grid over the other triangles.

use glam::DVec2;

use super::{lattice_triangles::LatticeTriangles, nodes::Nodes};
use crate::triangulation::{Locator, NONE};

/// An index over the triangles of base samples. The triangles of the lattice come first.
#[derive(Debug)]
pub(crate) struct Nearby {
    nodes: Nodes,
    lattice: LatticeTriangles,
    /// The other triangles, numbered from 0.
    band: Locator,
    /// The number of triangles of the lattice.
    first: u32,
}

impl Nearby {
    pub(super) fn new(nodes: Nodes, lattice: LatticeTriangles, band: Locator, first: u32) -> Self {
        Self { nodes, lattice, band, first }
    }

    /// A triangle near a point of the domain.
    pub(crate) fn triangle(&self, p: DVec2) -> usize {
        let Self { nodes, lattice: LatticeTriangles { below, above, .. }, .. } = self;
        let on_lattice = nodes.in_box(p, p).flat_map(|(number, ..)| [below[number], above[number]]);
        on_lattice
            .into_iter()
            .find(|&triangle| triangle != NONE)
            .map_or_else(|| self.first as usize + self.band.nearby_triangle(p), |triangle| triangle as usize)
    }
}
