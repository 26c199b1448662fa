//! Scouts: a few samples of their own on which cells and their farthest points are found (paper, section IV-A).
//!
//! Where sites go must not depend on how finely the picture is drawn, and need not: a farthest point is found exactly from any
//! sample near enough. So scouts are as many as that takes, however many more samples are asked for, and the time that
//! Algorithm 1 takes does not grow with them either: mostly it goes into the climbs to farthest points.
//!
//! Limits: a cell that is much smaller than the distance between scouts may be taken for smaller than it is. Around close point
//! handles scouts are closer, too.

use std::sync::Arc;

use glam::DVec2;

use super::{Ground, Samples};
use crate::{
    distance::{Navigation, Place, graph::Graph},
    domain::Domain,
    locate::Locator,
    triangulation::Triangulation,
};

/// Scouts of a domain at most, where sites are not closer than they resolve. On the sample picture the farthest point of one cell is missed
/// from 2,500 or 4,000 of them, which makes its support a tenth too small; from 7,000 on none is.
const MOST: usize = 10_000;
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
    /// Chains of scouts along the outline.
    pub(crate) outline: Vec<Vec<u32>>,
    /// Distance between scouts away from the outline and from close sites, in pixels.
    pub(crate) spacing: f64,
    /// Edges of the mesh.
    pub(crate) graph: Graph,
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
        let Samples { mesh, places, outline, spacing, .. } = ground.with_sites(domain, navigation, sites);
        let graph = Graph::of_mesh(&mesh);
        let longest = |v: usize| {
            let lengths = graph.of(v).iter().map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            lengths.fold(0.0, f64::max).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, f64::max);
        Self { mesh, places, outline, spacing, graph, reach, longest_edge, locator: Arc::clone(&ground.locator) }
    }

    /// The corners of the triangle that holds a point of the domain.
    pub(crate) fn around(&self, p: DVec2) -> [u32; 3] {
        self.mesh.triangles[self.mesh.triangle_at(self.locator.near(p), p)]
    }

    /// Number of scouts.
    pub(crate) fn len(&self) -> usize {
        self.mesh.vertices.len()
    }
}
