//! The drawn mesh: the samples' mesh and the skirt around it, in drawing order.

use std::collections::HashMap;

use glam::DVec2;

use crate::{
    pose::HarmonicFields,
    rank::sort_by_rank,
    rows::Rows,
    sample::Samples,
    site::{Site, SiteKind},
};

/// Triangles. Later triangles are drawn over earlier ones while no handle has a depth.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RenderMesh {
    /// Rest places: the samples, then the skirt's vertices.
    pub(crate) vertices: Vec<DVec2>,
    /// Triangles × 3 vertex indices.
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl RenderMesh {
    /// Orders triangles by the [part](leading_parts) of their first corner, lower parts over upper ones, and each
    /// part's skirt before its mesh. So where the picture covers itself, one part covers the other completely, in any
    /// order of the handles. `leading` is the part of each vertex, including the skirt.
    pub(crate) fn new(samples: Samples, leading: &[u32]) -> Self {
        let Samples { mesh, skirt, .. } = samples;
        let layers = [&skirt.triangles, &mesh.triangles];
        // Rows are sorted by part, then by layer.
        let parts = leading.iter().max().map_or(0, |&last| last as usize + 1);
        let row = |layer: usize, t: &[u32; 3]| leading[t[0] as usize] as usize * layers.len() + layer;
        let of_layer = |layer: usize| layers[layer].iter().map(move |t| (row(layer, t), *t));
        let triangles = Rows::from_pairs(parts * layers.len(), || (0..layers.len()).flat_map(of_layer)).into_items();
        let mut vertices = mesh.vertices;
        vertices.reserve_exact(skirt.vertices.len());
        vertices.extend_from_slice(&skirt.vertices);
        Self { vertices, triangles }
    }
}

/// For each sample the part with the largest harmonic weight in its cell. A part is a point, a straight piece of a bar
/// or polygon, or the whole held outline.
pub(crate) fn leading_parts(nearest: &[u32], sites: &[Site], harmonic: &HarmonicFields) -> Vec<u32> {
    let parts = parts(sites);
    let mut sums = vec![0.0; sites.len()];
    let mut leader = |weights: &[(u32, f64)]| {
        let part = |site: u32| parts[site as usize];
        weights.iter().for_each(|&(site, weight)| sums[part(site) as usize] += weight);
        let most = |best: (u32, f64), &(site, _): &(u32, f64)| {
            let sum = std::mem::take(&mut sums[part(site) as usize]);
            if sum > best.1 { (part(site), sum) } else { best }
        };
        weights.iter().fold((0, 0.0), most).0
    };
    let leaders: Vec<u32> = harmonic.rows.iter().map(|row| leader(row)).collect();
    nearest.iter().map(|&site| leaders.get(site as usize).copied().unwrap_or(0)).collect()
}

/// The part of each real site. Parts are numbered by their first sites, from top to bottom; those of one handle are
/// consecutive.
fn parts(sites: &[Site]) -> Vec<u32> {
    let (mut of_handles, mut of_kinds) = (HashMap::new(), HashMap::new());
    let first = |(at, site): (usize, &Site)| {
        let handle = match site.kind {
            SiteKind::Point { handle } | SiteKind::Bone { handle, .. } => Some(handle),
            SiteKind::Boundary | SiteKind::Virtual => None,
        };
        (*of_handles.entry(handle).or_insert(at), *of_kinds.entry(site.kind).or_insert(at))
    };
    let firsts: Vec<(usize, usize)> = sites.iter().enumerate().map(first).collect();
    let mut order = firsts.clone();
    sort_by_rank(&mut order, |&(handle, kind)| [handle as i64, kind as i64]);
    order.dedup();
    firsts.iter().map(|first| order.partition_point(|other| other < first) as u32).collect()
}
