//! The weights of all samples (eq. 2), in one sweep.
//!
//! Samples of one triangle of the navigation mesh are consecutive and share its windows. So each window is evaluated for a
//! [`BATCH`] of samples at once, in branchless loops over flat arrays, unless it cannot reach their bounding box.
//!
//! Cost: for each sample and each support that reaches into its triangle, some 4 ns a window and as much for φ and the row.

use glam::DVec2;

use super::{Basis, SparseWeights};
use crate::{
    distance::{NavTriangle, WINDOW_SLACK, Window},
    sample::Samples,
    site::Site,
    triangulation::NONE,
};

/// Samples asked at once. With twice as many the boxes around them are wider, and more windows reach these.
const BATCH: usize = 32;

/// What the sweep finds.
#[derive(Debug)]
pub(crate) struct Swept {
    pub(crate) weights: SparseWeights,
    /// Σφ at each sample.
    pub(crate) sums: Vec<f64>,
    /// The nearest site of each sample of those whose supports reach it or a sample beside it; [`NONE`] where there is none.
    pub(crate) nearest: Vec<u32>,
}

/// Samples of one triangle.
struct Batch {
    /// The box around them.
    low: DVec2,
    high: DVec2,
    x: [f64; BATCH],
    y: [f64; BATCH],
    count: usize,
}

/// A site, and its distance and φ, then weight, at each sample of a batch.
struct Column {
    site: u32,
    distance: [f64; BATCH],
    phi: [f64; BATCH],
}

/// Sweeps over the samples. `reaching` tells the supports that reach into a triangle, ascending by site, each with the windows
/// of its field there.
pub(super) fn sweep<'a, R: Iterator<Item = (u32, &'a [Window])>>(
    sites: &[Site],
    samples: &Samples,
    basis: &Basis,
    reaching: impl Fn(NavTriangle) -> R,
) -> Swept {
    let count = samples.len();
    let mut swept = Swept {
        weights: SparseWeights::with_capacity(count),
        sums: Vec::with_capacity(count),
        nearest: Vec::with_capacity(count),
    };
    let mut columns: Vec<Column> = Vec::new();
    let mut batch = Batch { low: DVec2::ZERO, high: DVec2::ZERO, x: [0.0; BATCH], y: [0.0; BATCH], count: 0 };
    let mut rest = &samples.mesh.vertices[..];
    for same in samples.nav_triangles.chunk_by(|a, b| a == b) {
        let (mut of_triangle, after) = rest.split_at(same.len());
        rest = after;
        while !of_triangle.is_empty() {
            let (now, later) = of_triangle.split_at(of_triangle.len().min(BATCH));
            of_triangle = later;
            batch.count = now.len();
            (batch.low, batch.high) = now.iter().fold((now[0], now[0]), |(low, high), &p| (low.min(p), high.max(p)));
            for (k, p) in now.iter().enumerate() {
                (batch.x[k], batch.y[k]) = (p.x, p.y);
            }
            let mut used = 0;
            for (site, windows) in reaching(same[0]) {
                if used == columns.len() {
                    columns.push(Column { site, distance: [0.0; BATCH], phi: [0.0; BATCH] });
                }
                used += usize::from(columns[used].fill(site, &sites[site as usize], windows, &batch, basis));
            }
            swept.push_rows(&mut columns[..used], batch.count);
        }
    }
    swept
}

impl Column {
    /// Distances of a site and φ at a batch; false where its support covers none of it.
    fn fill(&mut self, number: u32, site: &Site, windows: &[Window], batch: &Batch, basis: &Basis) -> bool {
        let Self { distance, phi, .. } = self;
        self.site = number;
        let n = batch.count;
        let (distance, phi, x, y) = (&mut distance[..n], &mut phi[..n], &batch.x[..n], &batch.y[..n]);
        distance.fill(f64::INFINITY);
        for window in windows {
            if window.nearest >= site.support_radius {
                break;
            }
            if !window.may_reach(batch.low, batch.high, site.support_radius) {
                continue;
            }
            let Window { source, offset, first, last, .. } = *window;
            for k in 0..n {
                let (to_x, to_y) = (x[k] - source.x, y[k] - source.y);
                let d = offset + (to_x * to_x + to_y * to_y).sqrt();
                let seen = (first.x * to_y - first.y * to_x >= -WINDOW_SLACK)
                    & (to_x * last.y - to_y * last.x >= -WINDOW_SLACK);
                distance[k] = if seen & (d < distance[k]) { d } else { distance[k] };
            }
        }
        let least = distance.iter().fold(f64::INFINITY, |least, &d| if d < least { d } else { least });
        if least >= site.support_radius {
            return false;
        }
        for k in 0..n {
            let t = distance[k] / site.support_radius;
            // Where no path leads and the support has no end, t is not a number.
            phi[k] = if t < 1.0 { t } else { 1.0 };
        }
        basis.values(phi);
        true
    }
}

impl Swept {
    /// Appends the rows of a batch, normalised: the quotient of eq. 2.
    fn push_rows(&mut self, columns: &mut [Column], count: usize) {
        let (mut sums, mut least, mut nearest) = ([0.0; BATCH], [f64::INFINITY; BATCH], [NONE; BATCH]);
        let (sums, least, nearest) = (&mut sums[..count], &mut least[..count], &mut nearest[..count]);
        for column in &*columns {
            let (distance, phi, site) = (&column.distance[..count], &column.phi[..count], column.site);
            for k in 0..count {
                sums[k] += phi[k];
                nearest[k] = if distance[k] < least[k] { site } else { nearest[k] };
                least[k] = if distance[k] < least[k] { distance[k] } else { least[k] };
            }
        }
        for column in &mut *columns {
            // Where nothing reaches, what is not a number takes the place of zero.
            column.phi[..count].iter_mut().zip(&*sums).for_each(|(phi, sum)| *phi /= sum);
        }
        self.weights.push_rows(count, &columns.iter().map(|column| (column.site, &column.phi)));
        self.sums.extend_from_slice(sums);
        self.nearest.extend_from_slice(nearest);
    }
}
