//! The part of a picture outside a domain of polygons: it does not move, and lies behind the part that bends.
//!
//! Its triangles share the samples of the outline, so that no gap appears along an outline that is held.
//!
//! Cost: O(n log n) in the outline's samples.

use glam::DVec2;

use crate::{sample::Samples, triangulation::Triangulation};

/// A mesh over the part of a picture outside the domain. Empty unless the domain is given as polygons.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StaticBackground {
    vertices: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
}

impl StaticBackground {
    /// The background of sampled rings in a picture of this size.
    pub(crate) fn new(samples: &Samples, size: DVec2) -> Self {
        let mut vertices = vec![DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
        let mut segments = Vec::new();
        for ring in &samples.outline {
            let (first, count) = (vertices.len(), ring.len());
            vertices.extend(ring.iter().map(|&sample| samples.mesh.vertices[sample as usize]));
            segments.extend((0..count).map(|i| [first + i, first + (i + 1) % count]));
        }
        let Triangulation { vertices, triangles, .. } = Triangulation::constrained_delaunay_outside(vertices, segments);
        Self { vertices, triangles }
    }

    /// In image pixels.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// Triangles × 3 vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
}
