//! Scouts: a few samples of their own on which cells and their farthest points are found (paper, section IV-A).
//!
//! Where sites go must not depend on how finely the picture is drawn, and does not: farthest points are found exactly, however few
//! scouts there are. So scouts are as many as make that quick, however many more samples are asked for.

use std::sync::Arc;

use glam::DVec2;

use super::{Ground, Samples};
use crate::{
    distance::{Navigation, Place, graph::Graph},
    domain::Domain,
    locate::Locator,
    rows::Rows,
    triangulation::Triangulation,
};

/// Scouts of a domain at most, where sites are not closer than they resolve. With 1,000 more triangles have to be looked into than that saves
/// distances of scouts; with 10,000 a solve of the benchmark's figure takes half as long again.
const MOST: usize = 2_500;
/// Scouts for each virtual site that is asked for: some across each cell.
const PER_SITE: usize = 16;

/// How many scouts a scene has that asks for so many samples and virtual sites: no more than samples.
pub(crate) fn scouts_wanted(samples: usize, density: usize) -> usize {
    samples.min(MOST.max(PER_SITE * density))
}

/// Samples, and what lies around each.
#[derive(Debug)]
pub(crate) struct Scouts {
    pub(crate) mesh: Triangulation,
    /// Where each scout lies on the navigation mesh.
    pub(crate) places: Vec<Place>,
    /// Edges of the mesh.
    pub(crate) graph: Graph,
    /// Triangles around each scout.
    fans: Rows<u32>,
    /// Length of the longest edge at each scout, in pixels.
    pub(crate) reach: Vec<f64>,
    /// Length of the longest edge of all.
    pub(crate) longest_edge: f64,
    /// Of the ground.
    locator: Arc<Locator>,
}

impl Scouts {
    /// The scouts of a scene with such sites.
    pub(crate) fn new(ground: &Ground, domain: &Domain, navigation: &Navigation, sites: &[DVec2]) -> Self {
        let Samples { mesh, places, .. } = ground.with_sites(domain, navigation, sites);
        let graph = Graph::of_mesh(&mesh);
        let longest = |v: usize| {
            let lengths = graph.of(v).iter().map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            lengths.fold(0.0, f64::max).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, f64::max);
        let fans = fans(&mesh);
        let locator = Arc::clone(&ground.locator);
        Self { mesh, places, graph, fans, reach, longest_edge, locator }
    }

    /// The triangles around a scout.
    pub(crate) fn fan(&self, scout: usize) -> &[u32] {
        self.fans.row(scout)
    }

    /// The triangle that holds a point of the domain.
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
    Rows::sorted(mesh.vertices.len(), || (0..).zip(&mesh.triangles).flat_map(corners))
}
