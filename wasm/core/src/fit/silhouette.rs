//! An outline with its box and moments, for comparison with another outline.

use glam::{DAffine2, DMat2, DVec2};

use crate::domain::{Domain, Ring, cells_inside};

/// Rows and columns of the grid on which two outlines are compared.
const GRID: usize = 160;

/// The region inside an outline.
#[derive(Debug, Clone)]
pub(super) struct Silhouette {
    rings: Vec<Ring>,
    /// Least and greatest coordinates, in pixels.
    pub(super) low: DVec2,
    pub(super) high: DVec2,
    pub(super) centroid: DVec2,
    /// The covariance of its points, in square pixels.
    pub(super) spread: DMat2,
}

impl Silhouette {
    pub(super) fn new(domain: &Domain) -> Self {
        let (low, high) = domain.bounds();
        // Near the region, so that the moments lose no digits.
        let origin = (low + high) / 2.0;
        let (mut area, mut first) = (0.0, DVec2::ZERO);
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        // Green's theorem: each edge is a triangle with the origin.
        for (a, b) in domain.edges().map(|(a, b)| (a - origin, b - origin)) {
            let twice = a.perp_dot(b);
            area += twice / 2.0;
            first += (a + b) * twice / 6.0;
            xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
            yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
            xy += twice * (2.0 * (a.x * a.y + b.x * b.y) + a.x * b.y + b.x * a.y) / 24.0;
        }
        let mean = first / area;
        let [xx, xy, yy] = [xx / area - mean.x * mean.x, xy / area - mean.x * mean.y, yy / area - mean.y * mean.y];
        let spread = DMat2::from_cols(DVec2::new(xx, xy), DVec2::new(xy, yy));
        Self { rings: domain.rings().to_vec(), low, high, centroid: origin + mean, spread }
    }

    /// The overlap of a mapped region with this one, from 0 to 1. It is 1 if they are the same.
    pub(super) fn overlap(&self, other: &Self, map: &DAffine2) -> f64 {
        // Half a box around, where the other region may reach.
        let (margin, cell) = ((self.high - self.low) / 2.0, (self.high - self.low) * 2.0 / GRID as f64);
        let grid = DAffine2::from_scale(cell.recip()) * DAffine2::from_translation(margin - self.low);
        let cells =
            |rings: &[Ring], to_grid: DAffine2| cells_inside(rings, [GRID; 2], |p| to_grid.transform_point2(p) - 0.5);
        let (own, mapped) = (cells(&self.rings, grid), cells(&other.rings, grid * *map));
        let count = |both: fn(bool, bool) -> bool| own.iter().zip(&mapped).filter(|&(&a, &b)| both(a, b)).count();
        count(|a, b| a && b) as f64 / count(|a, b| a || b).max(1) as f64
    }
}
