//! The triangular lattice over a domain (section V-B). Known limit: the number of samples is approximate.

use std::ops::Range;

use glam::DVec2;

use crate::domain::Domain;

/// Minimum distance of lattice points from the outline and from bones, as a multiple of the spacing.
///
/// Closer points make slivers. It is not one half, because rounding would then matter on outlines parallel to the
/// lattice.
pub(super) const LATTICE_CLEARANCE: f64 = 0.47;
/// Height of a lattice row as a multiple of the spacing: √3 / 2.
pub(super) const ROW_HEIGHT: f64 = 0.866_025_403_784_438_6;

/// Differences below this fraction of their terms have lost three digits to cancellation.
const CANCELLATION: f64 = 1e-3;

/// The spacing for about `count` points on lattice and outline together.
pub(super) fn spacing(domain: &Domain, count: usize) -> f64 {
    let (area, perimeter) = (domain.area(), domain.perimeter());
    let corners: usize = domain.rings().iter().map(Vec::len).sum();
    let wanted = (count as f64 - corners as f64).max(count as f64 / 4.0);
    // With u = 1 / spacing, the outline has perimeter · u points.
    // The lattice has (area − LATTICE_CLEARANCE · perimeter / u) · u² / ROW_HEIGHT points.
    positive_root(area / ROW_HEIGHT, perimeter * (1.0 - LATTICE_CLEARANCE / ROW_HEIGHT), wanted)
}

/// The positive x with `quadratic / x² + linear / x = wanted`. All three must be positive.
fn positive_root(quadratic: f64, linear: f64, wanted: f64) -> f64 {
    let root = (linear * linear + 4.0 * quadratic * wanted).sqrt();
    let difference = root - linear;
    // Two forms of the same root. In a domain that is nearly all outline, the difference would have no correct digits.
    if difference > CANCELLATION * root { 2.0 * quadratic / difference } else { (root + linear) / (2.0 * wanted) }
}

/// The lattice over a domain's bounding box. One node is at the centre of the box.
#[derive(Debug)]
pub(super) struct Lattice {
    centre: DVec2,
    pub(super) spacing: f64,
    rows: usize,
    columns: usize,
}

impl Lattice {
    pub(super) fn new(domain: &Domain, spacing: f64) -> Self {
        let (low, high) = domain.bounds();
        let half = (high - low) / 2.0;
        let rows = 2 * (half.y / (spacing * ROW_HEIGHT)) as usize + 1;
        let columns = 2 * ((half.x / spacing) as usize + 1);
        Self { centre: (low + high) / 2.0, spacing, rows, columns: columns + 1 }
    }

    /// The position of a node. Every other row is shifted by half a step.
    pub(super) fn node(&self, row: usize, column: usize) -> DVec2 {
        let (j, i) = (self.row_step(row), column as f64 - (self.columns / 2) as f64);
        let shift = if self.is_shifted(row) { 0.5 } else { 0.0 };
        self.centre + DVec2::new((i + shift) * self.spacing, j * self.spacing * ROW_HEIGHT)
    }

    fn row_step(&self, row: usize) -> f64 {
        row as f64 - (self.rows / 2) as f64
    }

    pub(super) fn is_shifted(&self, row: usize) -> bool {
        row.abs_diff(self.rows / 2) % 2 == 1
    }

    /// One more than the maximum number of steps from the top left corner to a triangle: half a spacing to the right,
    /// or a row down.
    pub(super) fn steps(&self) -> usize {
        self.rows + 2 * self.columns + 1
    }

    /// Rows that may have a y between two numbers.
    pub(super) fn rows_within(&self, low: f64, high: f64) -> Range<usize> {
        let step = |y: f64| (y - self.centre.y) / (self.spacing * ROW_HEIGHT) + (self.rows / 2) as f64;
        range(step(low), step(high), self.rows)
    }

    /// Columns of a row that may have an x between two numbers.
    pub(super) fn columns_within(&self, row: usize, low: f64, high: f64) -> Range<usize> {
        let shift = if self.is_shifted(row) { 0.5 } else { 0.0 };
        let step = |x: f64| (x - self.centre.x) / self.spacing - shift + (self.columns / 2) as f64;
        range(step(low), step(high), self.columns)
    }
}

/// The integers from just below `low` to just above `high`, within `0..count`.
fn range(low: f64, high: f64, count: usize) -> Range<usize> {
    let end = ((high.ceil() + 1.0).max(0.0) as usize).min(count);
    (low.floor().max(0.0) as usize).min(end)..end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spacing_is_exact_for_thin_domains() {
        for area in [1e6, 1.0, 1e-6, 1e-12, 1e-18] {
            let x = positive_root(area, 2000.0, 10_000.0);
            let found = area / (x * x) + 2000.0 / x;
            assert!((found - 10_000.0).abs() < 1e-6, "{found} points for an area of {area}");
        }
    }
}
