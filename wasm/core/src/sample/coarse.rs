//! Coarse samples: a separate set on which cells and their farthest points are located (section IV-A).
//!
//! The positions of virtual sites must not depend on how finely the picture is drawn. This holds because farthest
//! points are exact for any number of coarse samples. So the number is chosen to make the search fast.
//!
//! Known limit: a project with fewer samples also has fewer coarse samples. Contacts, the sites that a density requests
//! between handles, then lie elsewhere along the borders of cells.

use std::sync::{Arc, OnceLock};

use glam::DVec2;

use super::{base::BaseSamples, nearby::Nearby, samples::Samples};
use crate::{
    distance::{NavTriangle, graph::Graph},
    min_max::fast_max,
    prepared_domain::PreparedDomain,
    rows::Rows,
    triangulation::{Locator, Triangulation},
};

/// Upper limit of coarse samples, unless close sites need finer ones.
///
/// With 2,500, the regions of a benchmark solve take a tenth longer. With 1,500, they take the same time: distances
/// take less, but the search opens larger triangles.
const MAX_COARSE_SAMPLES: usize = 1_800;
/// Number of coarse samples for each requested virtual site: a few across each cell.
const COARSE_SAMPLES_PER_SITE: usize = 16;

/// The number of coarse samples for a number of samples and a requested number of virtual sites. It is at most
/// `samples`.
pub(crate) fn coarse_sample_count(samples: usize, density: usize) -> usize {
    samples.min(MAX_COARSE_SAMPLES.max(COARSE_SAMPLES_PER_SITE * density))
}

/// Coarse samples with their mesh.
#[derive(Debug)]
pub(crate) struct CoarseSamples {
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that contains each sample.
    pub(crate) nav_triangles: Vec<NavTriangle>,
    /// The edges of the mesh.
    pub(crate) graph: Graph,
    /// Triangles around each sample.
    fans: Rows<u32>,
    /// Length of the longest edge at each sample, in pixels.
    pub(crate) reach: Vec<f64>,
    /// Length of the longest edge of all, in pixels.
    pub(crate) longest_edge: f64,
    /// The index of the base samples.
    nearby: Arc<Nearby>,
    /// An index over the triangles of the mesh, once a walk has got stuck.
    locator: OnceLock<Box<Locator>>,
}

impl CoarseSamples {
    /// The coarse samples of a scene with point handles at `sites`.
    pub(crate) fn new(base: &BaseSamples, prepared: &PreparedDomain, sites: &[DVec2]) -> Self {
        let Samples { mesh, nav_triangles, .. } = base.with_sites(prepared, sites);
        let graph = Graph::of_mesh(&mesh);
        let longest = |v: usize| {
            let edges = graph.neighbours(v).iter();
            let squares = edges.map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            squares.fold(0.0, fast_max).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, fast_max);
        let fans = fans(&mesh);
        let nearby = Arc::clone(&base.nearby);
        Self { mesh, nav_triangles, graph, fans, reach, longest_edge, nearby, locator: OnceLock::new() }
    }

    /// The triangles around a sample.
    pub(crate) fn fan(&self, sample: usize) -> &[u32] {
        self.fans.row(sample)
    }

    /// The triangle that contains a point of the domain.
    pub(crate) fn triangle_at(&self, p: DVec2) -> usize {
        let near = self.nearby.triangle(p);
        let locator = || self.locator.get_or_init(|| Box::new(Locator::new(&self.mesh)));
        self.mesh.walk(near, p).or_else(|| locator().locate(&self.mesh, p)).unwrap_or(near)
    }

    /// Number of coarse samples.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}

fn fans(mesh: &Triangulation) -> Rows<u32> {
    let corners = |(triangle, corners): (u32, &[u32; 3])| corners.map(|corner| (corner as usize, triangle));
    Rows::from_pairs(mesh.vertices.len(), || (0..).zip(&mesh.triangles).flat_map(corners))
}
