//! Points in square cells, for finding points in a triangle.

use glam::DVec2;

use crate::domain::ring::edges;

/// Side of a cell, in pixels.
const CELL_PX: f64 = 4.0;
/// Tolerance of the triangle test: in pixels around the triangle's box, and in square pixels for twice the area over
/// each edge. It is far above rounding, and far below the tolerance of the outline.
const TRIANGLE_TOLERANCE: f64 = 1e-6;
/// The end of a linked list.
const END: u32 = u32::MAX;

/// Points in square cells. Each cell is a linked list.
pub(super) struct PointGrid {
    low: DVec2,
    columns: usize,
    /// The first point of each cell.
    head: Vec<u32>,
    /// The next point after each point in its cell.
    next: Vec<u32>,
}

impl PointGrid {
    pub(super) fn new(points: &[DVec2]) -> Self {
        let low = points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
        let high = points.iter().fold(DVec2::NEG_INFINITY, |high, &p| high.max(p));
        let cells = ((high - low) / CELL_PX).floor() + 1.0;
        let columns = cells.x as usize;
        let mut grid =
            Self { low, columns, head: vec![END; columns * cells.y as usize], next: vec![END; points.len()] };
        for (i, &p) in points.iter().enumerate() {
            let (x, y) = grid.cell(p);
            let cell = y * grid.columns + x;
            grid.next[i] = grid.head[cell];
            grid.head[cell] = i as u32;
        }
        grid
    }

    fn cell(&self, p: DVec2) -> (usize, usize) {
        let cell = (p - self.low) / CELL_PX;
        (cell.x as usize, cell.y as usize)
    }

    /// Whether a point accepted by `filter` lies in a closed triangle.
    ///
    /// The search proceeds row by row, because such triangles are long and thin.
    pub(super) fn any_in_triangle(
        &self,
        triangle: [DVec2; 3],
        filter: impl Fn(usize) -> bool,
        points: &[DVec2],
    ) -> bool {
        let [a, b, c] = triangle;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let ((_, first), (_, last)) = (self.cell(low), self.cell(high));
        (first..=last).any(|row| {
            let top = self.low.y + row as f64 * CELL_PX;
            let Some((left, right)) = extent(triangle, top, top + CELL_PX) else { return false };
            let column = |x: f64| self.cell(DVec2::new(x, top)).0.min(self.columns - 1);
            (column(left)..=column(right)).any(|column| {
                let mut i = self.head[row * self.columns + column];
                while i != END {
                    if filter(i as usize) && in_triangle(points[i as usize], triangle) {
                        return true;
                    }
                    i = self.next[i as usize];
                }
                false
            })
        })
    }
}

/// Least and greatest x of a triangle between two values of y, or `None` if it lies above or below.
fn extent(triangle: [DVec2; 3], top: f64, bottom: f64) -> Option<(f64, f64)> {
    let mut extent: Option<(f64, f64)> = None;
    for (a, b) in edges(&triangle) {
        let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
        if b.y < top || a.y > bottom {
            continue;
        }
        // The part of the edge between them. A level edge lies there completely.
        let at = |y: f64| a.lerp(b, ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0)).x;
        let (p, q) = if a.y == b.y { (a.x, b.x) } else { (at(top), at(bottom)) };
        let (left, right) = extent.unwrap_or((p, p));
        extent = Some((left.min(p).min(q), right.max(p).max(q)));
    }
    extent.map(|(left, right)| (left - TRIANGLE_TOLERANCE, right + TRIANGLE_TOLERANCE))
}

/// Whether a point lies in a triangle, or touches it.
fn in_triangle(p: DVec2, triangle: [DVec2; 3]) -> bool {
    let [a, b, c] = triangle;
    let beside =
        p.cmplt(a.min(b).min(c) - TRIANGLE_TOLERANCE).any() || p.cmpgt(a.max(b).max(c) + TRIANGLE_TOLERANCE).any();
    let sides = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    !beside && (sides.iter().all(|&s| s >= -TRIANGLE_TOLERANCE) || sides.iter().all(|&s| s <= TRIANGLE_TOLERANCE))
}
