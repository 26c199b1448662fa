//! The Laplacian of the cell graph over its virtual sites, with the real ones as boundary; factorised once.

use super::elimination::Elimination;

#[derive(Debug, Clone)]
pub(super) struct Laplacian {
    /// Site of each unknown.
    pub(super) free: Vec<u32>,
    /// Links from real sites: real site, unknown, weight.
    pub(super) boundary: Vec<(u32, u32, f64)>,
    /// Takes a right hand side to the unknowns.
    pub(super) inverse: Elimination,
}

impl Laplacian {
    /// The Laplacian of weighted links between sites of which some are real.
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
        Self { free, boundary, inverse: Elimination::new(ground, inner.into_iter()) }
    }
}
