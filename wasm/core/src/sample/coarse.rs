//! Coarse samples: a separate, coarse set of samples on which cells and their farthest points are located (section IV-A).
//!
//! The places of virtual sites must not depend on how finely the picture is drawn, and do not: farthest points are exact,
//! however few coarse samples there are. So the number of coarse samples is the one that makes the search fast, however many samples are
//! requested. With fewer samples than that there are as few coarse samples: then contacts, the sites that a density asks for between
//! handles, are elsewhere along their borders.

use std::sync::Arc;

use glam::DVec2;

use super::{BaseSamples, Samples};
use crate::{
    distance::{NavTriangle, Navigation, graph::Graph},
    domain::Domain,
    min_max::fast_max,
    rows::Rows,
    triangulation::{Locator, Triangulation},
};

/// Upper limit of coarse samples, unless close sites need finer ones. With 2,500, the regions of a benchmark solve take a tenth longer;
/// with 1,500 as long, as what is saved in distances goes into the triangles that must be searched.
const MAX_COARSE_SAMPLES: usize = 1_800;
/// Coarse samples for each requested virtual site: a few across each cell.
const COARSE_SAMPLES_PER_SITE: usize = 16;

/// The number of coarse samples for a number of samples and a requested number of virtual sites: no more than samples.
pub(crate) fn coarse_sample_count(samples: usize, density: usize) -> usize {
    samples.min(MAX_COARSE_SAMPLES.max(COARSE_SAMPLES_PER_SITE * density))
}

/// The coarse samples, and the surroundings of each.
#[derive(Debug)]
pub(crate) struct CoarseSamples {
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that each coarse sample lies in.
    pub(crate) nav_triangles: Vec<NavTriangle>,
    /// Edges of the mesh.
    pub(crate) graph: Graph,
    /// Triangles around each coarse sample.
    fans: Rows<u32>,
    /// Length of the longest edge at each coarse sample, in pixels.
    pub(crate) reach: Vec<f64>,
    /// Length of the longest edge of all.
    pub(crate) longest_edge: f64,
    /// The locator of the base samples.
    locator: Arc<Locator>,
}

impl CoarseSamples {
    /// The coarse samples of a scene with these point handles.
    pub(crate) fn new(base: &BaseSamples, domain: &Domain, navigation: &Navigation, sites: &[DVec2]) -> Self {
        let Samples { mesh, nav_triangles, .. } = base.with_sites(domain, navigation, sites);
        let graph = Graph::of_mesh(&mesh);
        let longest = |v: usize| {
            let lengths =
                graph.neighbours(v).iter().map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            lengths.fold(0.0, fast_max).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, fast_max);
        let fans = fans(&mesh);
        let locator = Arc::clone(&base.locator);
        Self { mesh, nav_triangles, graph, fans, reach, longest_edge, locator }
    }

    /// The triangles around a coarse sample.
    pub(crate) fn fan(&self, sample: usize) -> &[u32] {
        self.fans.row(sample)
    }

    /// The triangle that contains a point of the domain.
    pub(crate) fn triangle_at(&self, p: DVec2) -> usize {
        self.mesh.triangle_at(self.locator.near(p), p)
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
