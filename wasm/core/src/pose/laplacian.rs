//! The Laplacian of the cell graph over the virtual sites, with the real ones as boundary (section V-C); factorised once. Its
//! weights are those of the links, not the paper's uniform ones: see `site/graph.rs`.

use super::elimination::GroundedLaplacian;

#[derive(Debug, Clone)]
pub(super) struct Laplacian {
    /// Site of each unknown.
    pub(super) free: Vec<u32>,
    /// Links from real sites: real site, unknown, weight.
    pub(super) boundary: Vec<(u32, u32, f64)>,
    /// The factorisation.
    pub(super) inverse: GroundedLaplacian,
}

impl Laplacian {
    /// The Laplacian of weighted links between sites; `is_real` marks the boundary.
    pub(super) fn new(is_real: &[bool], links: impl Iterator<Item = (usize, usize, f64)>) -> Self {
        let mut unknown = vec![None; is_real.len()];
        let mut free = Vec::new();
        for (site, _) in is_real.iter().enumerate().filter(|&(_, real)| !real) {
            unknown[site] = Some(free.len());
            free.push(site as u32);
        }
        let (mut inner, mut boundary, mut ground) = (Vec::new(), Vec::new(), vec![0.0; free.len()]);
        for (i, j, weight) in links {
            match (unknown[i], unknown[j]) {
                (Some(row), Some(column)) => inner.push((row, column, weight)),
                (Some(row), None) => boundary.push((j as u32, row as u32, weight)),
                (None, Some(row)) => boundary.push((i as u32, row as u32, weight)),
                (None, None) => {}
            }
        }
        for &(_, row, weight) in &boundary {
            ground[row as usize] += weight;
        }
        Self { free, boundary, inverse: GroundedLaplacian::new(ground, inner.into_iter()) }
    }
}
