//! ϖ_i: the weight of handle i in the motion of each virtual site (sections IV-B and V-C, eq. 4).
//!
//! On the cell graph ϖ_i is 1 at handle i, 0 at the others and harmonic elsewhere. The paper iterates the Laplacian
//! "tens of times"; here it is factorised once for all fields, with additions and multiplications of positive numbers
//! only. So even small weights are accurate to the last digits. No weight is negative, and weights sum to 1.
//!
//! The graph uses the weights of the links, not the paper's uniform weights: see `site/graph.rs`.
//!
//! Cost: see `numeric/elimination.rs`; one solution for each real site that is linked to virtual sites.

use super::numeric::Laplacian;
use crate::{
    rank::sort_by_rank,
    site::{Site, SiteGraph},
};

/// The harmonic fields at all sites.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct HarmonicFields {
    /// For each site, the real sites and their weights, ascending. A real site has only itself.
    pub(crate) rows: Vec<Vec<(u32, f64)>>,
}

impl HarmonicFields {
    pub(crate) fn new(sites: &[Site], graph: &SiteGraph) -> Self {
        let is_real: Vec<bool> = sites.iter().map(|site| site.kind.is_real()).collect();
        let laplacian = Laplacian::new(&is_real, graph.iter());
        let alone = |(site, real): (u32, &bool)| if *real { vec![(site, 1.0)] } else { Vec::new() };
        let mut rows: Vec<Vec<(u32, f64)>> = (0..).zip(&is_real).map(alone).collect();
        let mut links = laplacian.boundary.clone();
        sort_by_rank(&mut links, |&(real, ..)| [real.into(), 0]);
        for of_real in links.chunk_by(|(one, ..), (other, ..)| one == other) {
            let real = of_real[0].0;
            let mut field = vec![0.0; laplacian.free.len()];
            for &(_, row, weight) in of_real {
                field[row as usize] += weight;
            }
            laplacian.inverse.solve(&mut field);
            for (site, value) in field.into_iter().enumerate().filter(|&(_, value)| value > 0.0) {
                rows[laplacian.free[site] as usize].push((real, value));
            }
        }
        for row in &mut rows {
            let sum: f64 = row.iter().map(|&(_, weight)| weight).sum();
            for (_, weight) in row {
                *weight /= sum;
            }
        }
        Self { rows }
    }

    /// The real sites that determine the motion of a site, and their weights.
    pub(crate) fn row(&self, site: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.rows[site].iter().map(|&(real, weight)| (real as usize, weight))
    }
}
