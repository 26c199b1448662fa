//! The Laplacian of a weighted graph over its free vertices, with the others as boundary (section V-C: virtual and
//! real sites of the cell graph); factorised once.

use super::elimination::GroundedLaplacian;

/// A factorised Laplacian.
#[derive(Debug, Clone)]
pub(crate) struct Laplacian {
    /// Vertex of each unknown.
    pub(crate) free: Vec<u32>,
    /// Links from the boundary: vertex, unknown, weight.
    pub(crate) boundary: Vec<(u32, u32, f64)>,
    /// The factorisation.
    pub(crate) inverse: GroundedLaplacian,
}

impl Laplacian {
    /// The Laplacian of weighted links between vertices; `is_fixed` marks the boundary.
    pub(crate) fn new(is_fixed: &[bool], links: impl Iterator<Item = (usize, usize, f64)>) -> Self {
        let mut unknown = vec![None; is_fixed.len()];
        let mut free = Vec::new();
        for (vertex, _) in is_fixed.iter().enumerate().filter(|&(_, fixed)| !fixed) {
            unknown[vertex] = Some(free.len());
            free.push(vertex as u32);
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
