//! Vertices and the sites that move them.

use std::sync::Arc;

use glam::DVec2;

use crate::{deform::Pose, pose::Motion, project::Blend, weight::SparseWeights};

/// Vertices before sites move them, with their weights, and the rest positions of the sites.
#[derive(Debug)]
pub(super) struct Skin {
    pub(super) vertices: Vec<DVec2>,
    pub(super) weights: SparseWeights,
    pub(super) rest: Arc<[DVec2]>,
}

impl Skin {
    /// The posed vertices.
    pub(super) fn posed(&self, motions: &[Motion], blend: Blend) -> Vec<DVec2> {
        Pose::new(Arc::clone(&self.rest), motions.to_vec(), blend).blend_all(&self.vertices, &self.weights)
    }
}

/// The maximum distance between two positions of one vertex. It is infinite for non-finite positions.
pub(super) fn greatest_distance(a: &[DVec2], b: &[DVec2]) -> f64 {
    let distance = |(a, b): (&DVec2, &DVec2)| a.distance(*b);
    let greater = |most: f64, d: f64| if d.is_nan() { f64::INFINITY } else { most.max(d) };
    a.iter().zip(b).map(distance).fold(0.0, greater)
}
