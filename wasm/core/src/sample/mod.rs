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
    triangulation::Triangulation,
};

pub(crate) use ground::Ground;
pub(crate) use grounds::Grounds;
pub(crate) use rim::Rim;
pub(crate) use scouts::{Scouts, scouts_wanted};

/// Samples of a domain.
#[derive(Debug, Clone)]
pub(crate) struct Samples {
    /// The mesh over the samples.
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that each sample lies in.
    pub(crate) outline_triangles: Vec<OutlineTriangle>,
    /// Chains of samples along the outline, as closed rings in the order of the domain's rings.
    pub(crate) outline: Vec<Vec<u32>>,
    /// The skirt around the mesh, for soft edges.
    pub(crate) rim: Rim,
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
        let outline_triangles = mesh.vertices.iter().map(triangle).collect();
        Self { mesh, outline_triangles, outline, rim: Rim::default(), spacing }
    }

    /// Number of samples.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}
