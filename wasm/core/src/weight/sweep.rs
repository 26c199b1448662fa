//! The weights of all samples (eq. 2), in one sweep.
//!
//! Samples in one triangle of the navigation mesh are consecutive and share its windows. So each window is evaluated
//! for a [`BATCH`] of samples at once, in branchless loops over flat arrays, unless it cannot reach their bounding box.
//!
//! Cost: for each sample and each support that reaches into its triangle, about 4 ns per window. φ and the row take the
//! same time again.

use std::ops::Range;

use glam::DVec2;

use super::{Basis, SparseWeights, precedence::kept};
use crate::{
    distance::{NavTriangle, Penumbrae, WINDOW_SLACK, Window},
    error::Error,
    limits::MAX_WEIGHTS,
    sample::Samples,
    triangulation::NONE,
};

/// Number of samples evaluated together. With twice as many, their bounding boxes are larger and more windows reach
/// them.
const BATCH: usize = 32;

/// The weights of all samples, and the sums that normalise them.
#[derive(Debug)]
pub(crate) struct SampleWeights {
    /// Samples × sites.
    pub(crate) weights: SparseWeights,
    /// Samples: Σφ at each sample.
    pub(crate) phi_sums: Vec<f64>,
    /// For each sample, the nearest of the sites whose supports reach the sample or its batch; [`NONE`] if there is
    /// none.
    pub(crate) nearest: Vec<u32>,
}

/// A site whose support reaches into a triangle.
pub(super) struct ReachingSite<'a> {
    pub(super) site: u32,
    pub(super) support_radius: f64,
    /// See [`Site::precedence_radius`](crate::site::Site).
    pub(super) precedence_radius: f64,
    /// The windows of the site's field in the triangle.
    pub(super) windows: &'a [Window],
    /// The penumbrae of the site's field in the triangle, if there are any.
    pub(super) penumbrae: Option<(&'a Penumbrae, Range<u32>)>,
}

/// Samples of one triangle.
struct Batch {
    /// Their bounding box.
    low: DVec2,
    high: DVec2,
    x: [f64; BATCH],
    y: [f64; BATCH],
    count: usize,
}

/// A site with its distance, and first φ, then the weight, at each sample of a batch.
struct Column {
    site: u32,
    precedence_radius: f64,
    distance: [f64; BATCH],
    phi: [f64; BATCH],
}

/// The weights of all samples. `reaching` returns the sites whose supports reach into a triangle, ascending.
///
/// # Errors
/// [`Error::TooMuchMemory`] for more than [`MAX_WEIGHTS`] weights.
pub(super) fn sweep<'a, R: Iterator<Item = ReachingSite<'a>>>(
    samples: &Samples,
    basis: &Basis,
    reaching: impl Fn(NavTriangle) -> R,
) -> Result<SampleWeights, Error> {
    let count = samples.len();
    let mut swept = SampleWeights {
        weights: SparseWeights::with_capacity(count),
        phi_sums: Vec::with_capacity(count),
        nearest: Vec::with_capacity(count),
    };
    let mut columns: Vec<Column> = Vec::new();
    let mut batch = Batch { low: DVec2::ZERO, high: DVec2::ZERO, x: [0.0; BATCH], y: [0.0; BATCH], count: 0 };
    let mut remaining = &samples.mesh.vertices[..];
    for same in samples.nav_triangles.chunk_by(|a, b| a == b) {
        let (mut of_triangle, after) = remaining.split_at(same.len());
        remaining = after;
        while !of_triangle.is_empty() {
            let (now, later) = of_triangle.split_at(of_triangle.len().min(BATCH));
            of_triangle = later;
            batch.fill(now);
            let mut used = 0;
            for reaching in reaching(same[0]) {
                if used == columns.len() {
                    columns.push(Column::default());
                }
                used += usize::from(columns[used].fill(&reaching, &batch, basis));
            }
            give_precedence(&mut columns[..used], batch.count, basis);
            swept.push_rows(&mut columns[..used], batch.count);
            if swept.weights.weights().len() > MAX_WEIGHTS {
                return Err(Error::TooMuchMemory);
            }
        }
    }
    Ok(swept)
}

impl Batch {
    /// Takes 1 to [`BATCH`] points.
    fn fill(&mut self, points: &[DVec2]) {
        self.count = points.len();
        (self.low, self.high) = points.iter().fold((points[0], points[0]), |(low, high), &p| (low.min(p), high.max(p)));
        for (k, p) in points.iter().enumerate() {
            (self.x[k], self.y[k]) = (p.x, p.y);
        }
    }
}

impl Default for Column {
    fn default() -> Self {
        Self { site: NONE, precedence_radius: 0.0, distance: [0.0; BATCH], phi: [0.0; BATCH] }
    }
}

impl Column {
    /// Evaluates the distances of a site and φ at a batch. Returns false if its support does not overlap it.
    fn fill(&mut self, reaching: &ReachingSite, batch: &Batch, basis: &Basis) -> bool {
        let Self { distance, phi, .. } = self;
        let &ReachingSite { site, support_radius: radius, precedence_radius, windows, ref penumbrae } = reaching;
        (self.site, self.precedence_radius) = (site, precedence_radius);
        let n = batch.count;
        let (distance, phi, x, y) = (&mut distance[..n], &mut phi[..n], &batch.x[..n], &batch.y[..n]);
        distance.fill(f64::INFINITY);
        for window in windows {
            if window.nearest >= radius {
                break;
            }
            if !window.may_reach(batch.low, batch.high, radius) {
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
        if least >= radius {
            return false;
        }
        if let Some((penumbrae, range)) = penumbrae {
            penumbrae.lengthen(range.clone(), (x, y), distance);
        }
        for k in 0..n {
            let t = distance[k] / radius;
            // Without a path to an infinite support, t is NaN.
            phi[k] = if t < 1.0 { t } else { 1.0 };
        }
        basis.values(phi);
        true
    }
}

/// Reduces φ of all other columns around each site with precedence.
fn give_precedence(columns: &mut [Column], count: usize, basis: &Basis) {
    for preceding in 0..columns.len() {
        let Column { precedence_radius: radius, distance, .. } = columns[preceding];
        if radius <= 0.0 {
            continue;
        }
        let kept = distance.map(|d| kept(basis, d, radius));
        for (_, other) in columns.iter_mut().enumerate().filter(|(at, _)| *at != preceding) {
            other.phi[..count].iter_mut().zip(&kept).for_each(|(phi, kept)| *phi *= kept);
        }
    }
}

impl SampleWeights {
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
            // Without a reaching support the quotient is NaN, and `SparseWeights` skips it as it skips zero.
            column.phi[..count].iter_mut().zip(&*sums).for_each(|(phi, sum)| *phi /= sum);
        }
        self.weights.push_rows(count, &columns.iter().map(|column| (column.site, &column.phi)));
        self.phi_sums.extend_from_slice(sums);
        self.nearest.extend_from_slice(nearest);
    }
}
