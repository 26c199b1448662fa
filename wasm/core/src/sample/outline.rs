//! Samples along the outline: all its corners, and points between them at most one spacing apart.

use glam::DVec2;

use crate::domain::{Domain, edges};

/// Samples along the outline of a domain.
pub(super) struct OutlineSamples {
    pub(super) vertices: Vec<DVec2>,
    /// The segments between consecutive samples.
    pub(super) segments: Vec<[usize; 2]>,
    /// The samples along each ring.
    pub(super) rings: Vec<Vec<u32>>,
    /// Maximum distance between consecutive samples, in pixels.
    pub(super) spacing: f64,
}

impl OutlineSamples {
    /// Samples a domain's outline.
    pub(super) fn new(domain: &Domain, spacing: f64) -> Self {
        let mut outline = Self { vertices: Vec::new(), segments: Vec::new(), rings: Vec::new(), spacing };
        for ring in domain.rings() {
            let start = outline.vertices.len();
            for (a, b) in edges(ring) {
                let pieces = (a.distance(b) / spacing).ceil().max(1.0);
                outline.vertices.extend((0..pieces as u32).map(|i| a + (b - a) * (f64::from(i) / pieces)));
            }
            let end = outline.vertices.len();
            outline.segments.extend((start..end).map(|i| [i, if i + 1 == end { start } else { i + 1 }]));
            outline.rings.push((start as u32..end as u32).collect());
        }
        outline
    }
}
