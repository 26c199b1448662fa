//! The Laplacian of the cell graph over its virtual sites, with the real ones as boundary.
//!
//! Weights of links are positive, so the matrix is a symmetric M-matrix; solved by conjugate gradients, preconditioned by the
//! diagonal. Cost: some dozens of products with the sparse matrix.

use serde::{Deserialize, Serialize};

#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Laplacian {
    /// Site of each unknown.
    pub(super) free: Vec<u32>,
    start: Vec<u32>,
    /// For each unknown its neighbours: an unknown, and the weight.
    inner: Vec<(u32, f64)>,
    /// Links from real sites: real site, unknown, weight.
    pub(super) boundary: Vec<(u32, u32, f64)>,
    diagonal: Vec<f64>,
}

impl Laplacian {
    /// The Laplacian of weighted links between sites of which some are real.
    pub(super) fn new(is_real: &[bool], links: impl Iterator<Item = (usize, usize, f64)>) -> Self {
        let mut unknown = vec![u32::MAX; is_real.len()];
        let mut free = Vec::new();
        for (site, _) in is_real.iter().enumerate().filter(|&(_, real)| !real) {
            unknown[site] = free.len() as u32;
            free.push(site as u32);
        }
        let mut lists: Vec<Vec<(u32, f64)>> = vec![Vec::new(); free.len()];
        let (mut boundary, mut diagonal) = (Vec::new(), vec![0.0; free.len()]);
        for (i, j, weight) in links {
            for (a, b) in [(i, j), (j, i)] {
                let row = unknown[a];
                if row == u32::MAX {
                    continue;
                }
                diagonal[row as usize] += weight;
                match unknown[b] {
                    u32::MAX => boundary.push((b as u32, row, weight)),
                    column => lists[row as usize].push((column, weight)),
                }
            }
        }
        let mut start = vec![0];
        start.extend(lists.iter().scan(0, |sum, list| {
            *sum += list.len() as u32;
            Some(*sum)
        }));
        Self { free, start, inner: lists.concat(), boundary, diagonal }
    }

    /// Whether every index is one of so many sites or of the unknowns.
    pub(super) fn is_whole(&self, sites: usize) -> bool {
        let n = self.free.len();
        let (site, unknown) = (|site: u32| (site as usize) < sites, |row: u32| (row as usize) < n);
        self.diagonal.len() == n
            && self.start.len() == n + 1
            && self.start.is_sorted()
            && self.start[n] as usize == self.inner.len()
            && self.free.iter().all(|&at| site(at))
            && self.inner.iter().all(|&(row, _)| unknown(row))
            && self.boundary.iter().all(|&(real, row, _)| site(real) && unknown(row))
    }

    /// Solves for the unknowns, from a first guess that becomes the solution, until the residual is at most `precision` of the
    /// largest entry of the right hand side.
    pub(super) fn solve(&self, right: &[f64], x: &mut [f64], precision: f64) {
        let n = x.len();
        let mut product = vec![0.0; n];
        self.multiply(x, &mut product);
        let mut residual: Vec<f64> = right.iter().zip(&product).map(|(b, ax)| b - ax).collect();
        let limit = precision * right.iter().map(|r| r.abs()).fold(0.0, f64::max);
        let mut direction: Vec<f64> = residual.iter().zip(&self.diagonal).map(|(r, d)| r / d).collect();
        let mut energy = dot(&residual, &direction);
        // In exact arithmetic n steps suffice; rounding may ask for a few more.
        for _ in 0..4 * n + 16 {
            if energy == 0.0 || residual.iter().all(|r| r.abs() <= limit) {
                break;
            }
            self.multiply(&direction, &mut product);
            let step = energy / dot(&direction, &product);
            let mut next = 0.0;
            for i in 0..n {
                x[i] += step * direction[i];
                residual[i] -= step * product[i];
                next += residual[i] * residual[i] / self.diagonal[i];
            }
            for i in 0..n {
                direction[i] = residual[i] / self.diagonal[i] + next / energy * direction[i];
            }
            energy = next;
        }
    }

    fn multiply(&self, x: &[f64], product: &mut [f64]) {
        for (i, product) in product.iter_mut().enumerate() {
            let inner = &self.inner[self.start[i] as usize..self.start[i + 1] as usize];
            *product = inner.iter().fold(self.diagonal[i] * x[i], |sum, &(j, weight)| sum - weight * x[j as usize]);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
