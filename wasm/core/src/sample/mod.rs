//! 𝒫: points all over the domain, with a constrained Delaunay mesh over them (section V-B).
//!
//! Samples are the vertices of the drawn mesh; a separate, coarser set, the coarse samples, locates cells. Distances and weights do
//! not depend on either: they are evaluated.

mod base;
mod bones;
mod cache;
mod coarse;
mod lattice;
mod outline;
mod refine;
mod skirt;

use glam::DVec2;

use crate::{
    distance::{NavTriangle, Navigation},
    triangulation::Triangulation,
};

pub(crate) use base::BaseSamples;
pub(crate) use cache::SamplingCache;
pub(crate) use coarse::{CoarseSamples, coarse_sample_count};
pub(crate) use skirt::Skirt;

/// Samples of a domain.
#[derive(Debug, Clone)]
pub(crate) struct Samples {
    /// The mesh over the samples.
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that each sample lies in.
    pub(crate) nav_triangles: Vec<NavTriangle>,
    /// Chains of samples along the outline, as closed rings in the order of the domain's rings.
    pub(crate) outline: Vec<Vec<u32>>,
    /// The skirt around the mesh, for soft edges.
    pub(crate) skirt: Skirt,
    /// Distance between samples away from the outline and from close sites, in pixels.
    pub(crate) spacing: f64,
}

impl Samples {
    /// The vertices of a mesh as samples. `outline` lists them in rings.
    pub(crate) fn from_mesh(
        mesh: Triangulation,
        navigation: &Navigation,
        outline: Vec<Vec<u32>>,
        spacing: f64,
    ) -> Self {
        let triangle = |&p: &DVec2| navigation.triangle_at(p).expect("samples lie in the domain");
        let nav_triangles = mesh.vertices.iter().map(triangle).collect();
        Self { mesh, nav_triangles, outline, skirt: Skirt::default(), spacing }
    }

    /// Number of samples.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}
