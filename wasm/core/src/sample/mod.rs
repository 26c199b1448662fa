//! 𝒫: points all over the domain, with a constrained Delaunay mesh over them (section V-B).
//!
//! Samples are the vertices of the drawn mesh; a separate, coarser set, the scouts, locates cells. Distances and weights do
//! not depend on either: they are evaluated.

mod bones;
mod ground;
mod grounds;
mod lattice;
mod outline;
mod refine;
mod rim;
mod scouts;

use glam::DVec2;

use crate::{
    distance::{Navigation, OutlineTriangle},
    domain::Domain,
    triangulation::Triangulation,
};

pub(crate) use ground::Ground;
pub(crate) use grounds::Grounds;
pub use rim::Rim;
pub(crate) use scouts::{Scouts, scouts_wanted};

/// Samples of a domain.
#[derive(Debug, Clone)]
pub struct Samples {
    /// The mesh over the samples.
    pub mesh: Triangulation,
    /// The triangle of the navigation mesh that each sample lies in.
    pub outline_triangles: Vec<OutlineTriangle>,
    /// Chains of samples along the outline, as closed rings in the order of the domain's rings.
    pub outline: Vec<Vec<u32>>,
    /// The sample at each point handle; empty where the caller's mesh provides the samples.
    pub at_sites: Vec<u32>,
    /// The skirt around the mesh, for soft edges.
    pub rim: Rim,
    /// Distance between samples away from the outline and from close sites, in pixels.
    pub spacing: f64,
}

impl Samples {
    /// About `count` samples: a triangular lattice centred on the domain's bounding box, so that a symmetric domain is
    /// sampled symmetrically; points along the outline with all its corners; every site; and finer lattices where sites
    /// are closer to one another than the lattice resolves (the paper's up-sampling).
    ///
    /// `sites` must lie in the domain and be distinct; `bones` are straight lines in it, along which the mesh has edges
    /// wherever nothing else is close.
    ///
    /// Cost: O(n log n), nearly all of it for the triangulation.
    #[must_use]
    pub fn new(domain: &Domain, navigation: &Navigation, sites: &[DVec2], bones: &[[DVec2; 2]], count: usize) -> Self {
        Ground::new(domain, navigation, bones, count, None).with_sites(domain, navigation, sites)
    }

    /// The vertices of a mesh as samples. `outline` lists them in rings.
    pub(crate) fn from_mesh(
        mesh: Triangulation,
        navigation: &Navigation,
        outline: Vec<Vec<u32>>,
        spacing: f64,
    ) -> Self {
        let triangle = |&p: &DVec2| navigation.triangle_at(p).expect("samples lie in the domain");
        let outline_triangles = mesh.vertices.iter().map(triangle).collect();
        Self { mesh, outline_triangles, outline, at_sites: Vec::new(), rim: Rim::default(), spacing }
    }

    /// Number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.mesh.vertices.len()
    }

    /// Whether there are no samples. Every domain has some.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mesh.vertices.is_empty()
    }
}
