//! Point location: a uniform grid over the triangles of a mesh.
//!
//! Cost of a lookup: a few triangles. Construction visits each cell of the bounding box of each triangle, and stores
//! four bytes for each cell that the triangle may touch. The box of a long triangle across the grid may have as many
//! cells as the mesh has triangles.

use std::iter;

use glam::DVec2;

use super::mesh::Triangulation;
use crate::{min_max::fast_min, rows::Rows, segment::segment_distance};

/// Points up to this far outside every triangle, in pixels, count as inside.
///
/// This exceeds the rounding errors of points on the outline, and is far too small to be visible.
pub(crate) const OUTLINE_TOLERANCE: f64 = 1e-6;

/// An index over the triangles of one mesh.
#[derive(Debug, Clone)]
pub(crate) struct Locator {
    low: DVec2,
    /// Side of a cell, in pixels.
    cell: f64,
    columns: usize,
    rows: usize,
    /// The triangles that each cell may touch.
    cells: Rows<u32>,
}

impl Locator {
    pub(crate) fn new(mesh: &Triangulation) -> Self {
        let low = mesh.vertices.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let high = mesh.vertices.iter().fold(DVec2::NEG_INFINITY, |high, &p| high.max(p));
        let size = high - low;
        let wanted = mesh.triangles.len().clamp(1, 1 << 18) as f64;
        let cell = (size.x * size.y / wanted).sqrt().max(size.max_element() / 4096.0);
        let (columns, rows) = ((size.x / cell) as usize + 1, (size.y / cell) as usize + 1);
        let mut grid = Self { low, cell, columns, rows, cells: Rows::from_pairs(0, iter::empty) };
        let mut entries = Vec::with_capacity(mesh.triangles.len() * 3);
        for t in 0..mesh.triangles.len() {
            grid.visit_cells(mesh.corners(t), |cell| entries.push((cell, t as u32)));
        }
        grid.cells = Rows::from_pairs(columns * rows, || entries.iter().copied());
        grid
    }

    /// The triangle that contains a point, within [`OUTLINE_TOLERANCE`]; `None` outside.
    pub(crate) fn locate(&self, mesh: &Triangulation, p: DVec2) -> Option<usize> {
        let (x, y) = self.cell_of(p)?;
        let mut best = (-OUTLINE_TOLERANCE, None);
        for &t in self.cells.row(y * self.columns + x) {
            let depth = signed_depth(mesh.corners(t as usize), p);
            if depth >= 0.0 {
                return Some(t as usize);
            }
            if depth > best.0 && signed_distance(mesh.corners(t as usize), p) >= -OUTLINE_TOLERANCE {
                best = (depth, Some(t as usize));
            }
        }
        best.1
    }

    /// A triangle near a point. The mesh must not be empty.
    pub(crate) fn nearby_triangle(&self, p: DVec2) -> usize {
        let cell = ((p - self.low) / self.cell).max(DVec2::ZERO);
        let (x, y) = ((cell.x as usize).min(self.columns - 1), (cell.y as usize).min(self.rows - 1));
        // Cells outside the mesh are empty: take a triangle of a later cell.
        let (triangles, at) = (self.cells.items(), self.cells.range(y * self.columns + x).start);
        triangles[at.min(triangles.len() - 1)] as usize
    }

    fn cell_of(&self, p: DVec2) -> Option<(usize, usize)> {
        let cell = (p - self.low) / self.cell;
        let slack = OUTLINE_TOLERANCE / self.cell;
        let inside =
            |c: f64, n: usize| (c >= -slack && c <= n as f64 + slack).then(|| (c.max(0.0) as usize).min(n - 1));
        Some((inside(cell.x, self.columns)?, inside(cell.y, self.rows)?))
    }

    /// Calls `visit` with every cell that a triangle may touch, if widened by [`OUTLINE_TOLERANCE`].
    fn visit_cells(&self, corners: [DVec2; 3], mut visit: impl FnMut(usize)) {
        let [a, b, c] = corners;
        let index = |p: DVec2| ((p - self.low) / self.cell).max(DVec2::ZERO);
        let (first, last) = (index(a.min(b).min(c) - OUTLINE_TOLERANCE), index(a.max(b).max(c) + OUTLINE_TOLERANCE));
        let reach = self.cell * std::f64::consts::FRAC_1_SQRT_2 + OUTLINE_TOLERANCE;
        for y in first.y as usize..=(last.y as usize).min(self.rows - 1) {
            for x in first.x as usize..=(last.x as usize).min(self.columns - 1) {
                let centre = self.low + (DVec2::new(x as f64, y as f64) + 0.5) * self.cell;
                if signed_depth(corners, centre) >= -reach {
                    visit(y * self.columns + x);
                }
            }
        }
    }
}

/// Distance of a point to the nearest line through an edge of a triangle: negative outside the triangle.
///
/// Beyond a sharp corner, the lines are much nearer than the triangle (see [`signed_distance`]).
pub(crate) fn signed_depth([a, b, c]: [DVec2; 3], p: DVec2) -> f64 {
    let side = |from: DVec2, to: DVec2| (to - from).perp_dot(p - from) / (to - from).length();
    fast_min(fast_min(side(a, b), side(b, c)), side(c, a))
}

/// Distance of a point to the border of a triangle: negative outside the triangle.
pub(crate) fn signed_distance([a, b, c]: [DVec2; 3], p: DVec2) -> f64 {
    let depth = signed_depth([a, b, c], p);
    if depth >= 0.0 {
        return depth;
    }
    -fast_min(fast_min(segment_distance(p, a, b), segment_distance(p, b, c)), segment_distance(p, c, a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_of_a_needle_ends_the_mesh() {
        let needle = [(0.0, 0.0), (100.0, 0.0), (100.0, 1e-9)].map(DVec2::from);
        let mesh = Triangulation::constrained_delaunay(needle.to_vec(), vec![[0, 1], [1, 2], [2, 0]]);
        let locator = Locator::new(&mesh);
        let found = |x: f64, y: f64| locator.locate(&mesh, DVec2::new(x, y)) == Some(0);
        for x in [0.0, 1.0, 50.0, 100.0] {
            assert!([-9e-7, 0.0, 9e-7].iter().all(|&y| found(x, y)), "beside {x}");
            assert!([-2e-6, 2e-6].iter().all(|&y| !found(x, y)), "outside {x}");
        }
        assert!(found(-9e-7, 0.0) && !found(-2e-6, 0.0) && !found(-0.01, 0.0));
    }
}
