//! The samples of a domain, and the mesh over them.

use glam::DVec2;

use super::{feather::Feather, skirt::Skirt};
use crate::{
    distance::{NavTriangle, Navigation},
    triangulation::Triangulation,
};

/// Samples of a domain.
#[derive(Debug, Clone)]
pub(crate) struct Samples {
    /// The mesh over the samples.
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that contains each sample.
    pub(crate) nav_triangles: Vec<NavTriangle>,
    /// Chains of samples along the outline: closed rings in the order of the domain's rings.
    pub(crate) outline: Vec<Vec<u32>>,
    /// The skirt around the mesh, for soft edges.
    pub(crate) skirt: Skirt,
    /// The soft rim around the mesh.
    pub(crate) feather: Feather,
    /// Distance between samples away from the outline and from close sites, in pixels.
    pub(crate) spacing: f64,
}

impl Samples {
    /// The vertices of a mesh as samples. `outline` lists the samples of each ring.
    ///
    /// # Panics
    /// If a vertex is outside the domain.
    pub(crate) fn from_mesh(
        mesh: Triangulation,
        navigation: &Navigation,
        outline: Vec<Vec<u32>>,
        spacing: f64,
    ) -> Self {
        let triangle = |&p: &DVec2| navigation.triangle_at(p).expect("samples lie in the domain");
        let nav_triangles = mesh.vertices.iter().map(triangle).collect();
        Self::new(mesh, nav_triangles, outline, spacing)
    }

    /// Samples without skirt and feather.
    pub(super) fn new(
        mesh: Triangulation,
        nav_triangles: Vec<NavTriangle>,
        outline: Vec<Vec<u32>>,
        spacing: f64,
    ) -> Self {
        Self { mesh, nav_triangles, outline, skirt: Skirt::default(), feather: Feather::default(), spacing }
    }

    /// Number of samples.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}
