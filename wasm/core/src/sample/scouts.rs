//! Scouts: a separate, coarse set of samples on which cells and their farthest points are located (section IV-A).
//!
//! The places of virtual sites must not depend on how finely the picture is drawn, and do not: farthest points are exact,
//! however few scouts there are. So the number of scouts is the one that makes the search fast, however many samples are
//! requested. With fewer samples than that there are as few scouts: then contacts, the sites that a density asks for between
//! handles, are elsewhere along their borders.

use std::sync::Arc;

use glam::DVec2;

use super::{Ground, Samples};
use crate::{
    distance::{Navigation, OutlineTriangle, graph::Graph},
    domain::Domain,
    extremes::greater,
    rows::Rows,
    triangulation::{Locator, Triangulation},
};

/// Upper limit of scouts, unless close sites need finer ones. With 2,500, the regions of a benchmark solve take a tenth longer;
/// with 1,500 as long, as what is saved in distances goes into the triangles that must be searched.
const MAX_SCOUTS: usize = 1_800;
/// Scouts for each requested virtual site: a few across each cell.
const SCOUTS_PER_SITE: usize = 16;

/// The number of scouts for a number of samples and a requested number of virtual sites: no more than samples.
pub(crate) fn scouts_wanted(samples: usize, density: usize) -> usize {
    samples.min(MAX_SCOUTS.max(SCOUTS_PER_SITE * density))
}

/// The scouts, and the surroundings of each.
#[derive(Debug)]
pub(crate) struct Scouts {
    pub(crate) mesh: Triangulation,
    /// The triangle of the navigation mesh that each scout lies in.
    pub(crate) outline_triangles: Vec<OutlineTriangle>,
    /// Edges of the mesh.
    pub(crate) graph: Graph,
    /// Triangles around each scout.
    fans: Rows<u32>,
    /// Length of the longest edge at each scout, in pixels.
    pub(crate) reach: Vec<f64>,
    /// Length of the longest edge of all.
    pub(crate) longest_edge: f64,
    /// The locator of the ground.
    locator: Arc<Locator>,
}

impl Scouts {
    /// The scouts of a scene with these point handles.
    pub(crate) fn new(ground: &Ground, domain: &Domain, navigation: &Navigation, sites: &[DVec2]) -> Self {
        let Samples { mesh, outline_triangles, .. } = ground.with_sites(domain, navigation, sites);
        let graph = Graph::of_mesh(&mesh);
        let longest = |v: usize| {
            let lengths = graph.of(v).iter().map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            lengths.fold(0.0, greater).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, greater);
        let fans = fans(&mesh);
        let locator = Arc::clone(&ground.locator);
        Self { mesh, outline_triangles, graph, fans, reach, longest_edge, locator }
    }

    /// The triangles around a scout.
    pub(crate) fn fan(&self, scout: usize) -> &[u32] {
        self.fans.row(scout)
    }

    /// The triangle that contains a point of the domain.
    pub(crate) fn triangle_at(&self, p: DVec2) -> usize {
        self.mesh.triangle_at(self.locator.near(p), p)
    }

    /// Number of scouts.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}

fn fans(mesh: &Triangulation) -> Rows<u32> {
    let corners = |(triangle, corners): (u32, &[u32; 3])| corners.map(|corner| (corner as usize, triangle));
    Rows::from_pairs(mesh.vertices.len(), || (0..).zip(&mesh.triangles).flat_map(corners))
}
