//! The mesh that is drawn: the samples' mesh and the rim around it, in drawing order.

use glam::DVec2;

use crate::{pose::HarmonicFields, sample::Samples};

/// Triangles to draw, later ones over earlier ones as long as no handle has a depth.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderMesh {
    /// Rest places: the samples, then the rim's.
    pub vertices: Vec<DVec2>,
    /// Triangles × 3 vertex numbers.
    pub triangles: Vec<[u32; 3]>,
}

impl RenderMesh {
    /// Orders triangles by the real site that leads their first corner, those of sites further down over others, and each site's
    /// rim first: so where the picture comes to lie over itself one part covers the other whole, whatever the order of the
    /// handles.
    pub(crate) fn new(samples: Samples, leading: &[u32]) -> Self {
        let Samples { mesh, rim, .. } = samples;
        let layers = [&rim.triangles, &mesh.triangles];
        // The first corner of every triangle is a sample. A counting sort, by site and then by layer.
        let key = |layer: usize, t: &[u32; 3]| leading[t[0] as usize] * layers.len() as u32 + layer as u32;
        let mut keys: Vec<u32> = Vec::with_capacity(rim.triangles.len() + mesh.triangles.len());
        for (layer, triangles) in layers.iter().enumerate() {
            keys.extend(triangles.iter().map(|t| key(layer, t)));
        }
        let mut start = vec![0_usize; keys.iter().max().map_or(0, |&last| last as usize + 1) + 1];
        for &key in &keys {
            start[key as usize + 1] += 1;
        }
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        let mut triangles = vec![[0; 3]; keys.len()];
        for (&key, t) in keys.iter().zip(layers.into_iter().flatten()) {
            let at = &mut start[key as usize];
            triangles[*at] = *t;
            *at += 1;
        }
        let mut vertices = mesh.vertices;
        vertices.reserve_exact(rim.vertices.len());
        vertices.extend_from_slice(&rim.vertices);
        Self { vertices, triangles }
    }
}

/// The real site that each sample goes with: of the sample's cell, the one that has the largest share.
pub(crate) fn leading_sites(nearest: &[u32], harmonic: &HarmonicFields) -> Vec<u32> {
    let leader: Vec<u32> = harmonic.rows.iter().map(|row| leading_site(row)).collect();
    nearest.iter().map(|&site| leader.get(site as usize).copied().unwrap_or(0)).collect()
}

/// The real site that has the largest share of a site. Real sites come first, from top to bottom.
fn leading_site(shares: &[(u32, f64)]) -> u32 {
    shares.iter().fold((0, 0.0), |best, &(site, share)| if share > best.1 { (site, share) } else { best }).0
}
