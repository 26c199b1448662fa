//! Triangles that should tile a region: finds overlaps, and whether they cover a point.
//!
//! The tests are exact (Shewchuk 1997): triangles that only touch do not overlap.
//!
//! Cost: linear in the triangles and in the cells of a grid that their bounding boxes touch, with a few tests for each.

use std::ops::RangeInclusive;

use glam::DVec2;
use robust::{Coord, orient2d};

use crate::rows::Rows;

/// Side of a cell of the grid, in pixels.
const CELL_PX: f64 = 8.0;

/// The corners of a triangle, with a positive area.
type Corners = [DVec2; 3];

/// Triangles in a grid of square cells over a picture.
pub(super) struct Tiles {
    triangles: Vec<Corners>,
    columns: usize,
    rows: usize,
    cells: Rows<u32>,
}

impl Tiles {
    /// Triangles in a picture of `size`. Triangles without a positive area are ignored.
    pub(super) fn new(triangles: Vec<Corners>, size: DVec2) -> Self {
        let [columns, rows] = (size / CELL_PX).to_array().map(|cells| cells as usize + 1);
        let cells = Rows::from_pairs(columns * rows, || {
            let touched =
                |(t, triangle): (usize, &Corners)| cells_of(triangle, columns, rows).map(move |cell| (cell, t as u32));
            triangles.iter().enumerate().filter(|(_, triangle)| area_sign(triangle) > 0.0).flat_map(touched)
        });
        Self { triangles, columns, rows, cells }
    }

    /// Whether a triangle has a negative area, overlaps another one, or is closer to it than a gap in pixels.
    pub(super) fn is_unsound(&self, t: usize, gap: impl Fn(usize) -> f64) -> bool {
        let own = &self.triangles[t];
        let sign = area_sign(own);
        let overlaps = |&other: &u32| {
            let other = other as usize;
            other != t && overlap(own, &self.triangles[other], gap(other))
        };
        sign < 0.0
            || sign > 0.0
                && cells_of(own, self.columns, self.rows).any(|cell| self.cells.row(cell).iter().any(overlaps))
    }

    /// Whether a point lies in one of the accepted triangles.
    pub(super) fn cover(&self, p: DVec2, counts: impl Fn(usize) -> bool) -> bool {
        let cells = cells_of(&[p; 3], self.columns, self.rows);
        let covers = |&t: &u32| {
            let [a, b, c] = self.triangles[t as usize];
            counts(t as usize) && [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| side(a, b, p) >= 0.0)
        };
        cells.flat_map(|cell| self.cells.row(cell)).any(covers)
    }
}

fn side(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let [a, b, p] = [a, b, p].map(|DVec2 { x, y }| Coord { x, y });
    orient2d(a, b, p)
}

fn area_sign(&[a, b, c]: &Corners) -> f64 {
    side(a, b, c)
}

/// Whether two triangles of positive area have a common area, or no edge of either separates them by a gap.
fn overlap(first: &Corners, second: &Corners, gap: f64) -> bool {
    let ([low, high], [other_low, other_high]) = (bounds(first), bounds(second));
    let separates = |triangle: &Corners, other: &Corners| {
        (0..3).any(|k| {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            other.iter().all(|&p| side(a, b, p) <= -gap * a.distance(b))
        })
    };
    (low.cmplt(other_high + gap) & other_low.cmplt(high + gap)).all()
        && !separates(first, second)
        && !separates(second, first)
}

fn bounds(&[a, b, c]: &Corners) -> [DVec2; 2] {
    [a.min(b).min(c), a.max(b).max(c)]
}

/// The cells that the bounding box of a triangle touches.
fn cells_of(triangle: &Corners, columns: usize, rows: usize) -> impl Iterator<Item = usize> + use<> {
    let [low, high] = bounds(triangle);
    let range = |axis: usize, count: usize| -> RangeInclusive<usize> {
        let cell = |x: f64| ((x / CELL_PX).max(0.0) as usize).min(count - 1);
        cell(low[axis])..=cell(high[axis])
    };
    let across = range(0, columns);
    range(1, rows).flat_map(move |row| across.clone().map(move |column| row * columns + column))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_overlap_if_they_share_an_area_and_not_if_they_touch() {
        let triangle = |corners: [[f64; 2]; 3]| corners.map(DVec2::from);
        let all = vec![
            triangle([[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]]),
            // Shares an edge, and a corner.
            triangle([[10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]),
            triangle([[10.0, 10.0], [20.0, 10.0], [10.0, 20.0]]),
            // Overlaps the last one by a hair.
            triangle([[15.0, 15.0], [20.0, 20.0], [14.999_999_999, 15.0]]),
            triangle([[40.0, 40.0], [40.0, 50.0], [50.0, 40.0]]),
            triangle([[60.0, 60.0], [61.0, 61.0], [62.0, 62.0]]),
        ];
        let tiles = Tiles::new(all, DVec2::splat(64.0));
        let unsound: Vec<bool> = (0..6).map(|t| tiles.is_unsound(t, |_| 0.0)).collect();
        assert_eq!(unsound, [false, false, true, true, true, false]);
        assert!(tiles.is_unsound(0, |_| 0.1) && !tiles.is_unsound(0, |other| if other == 1 { 0.0 } else { 0.1 }));
        assert!(tiles.cover(DVec2::splat(2.0), |_| true) && !tiles.cover(DVec2::splat(2.0), |t| t != 0));
        assert!(!tiles.cover(DVec2::new(30.0, 5.0), |_| true));
    }
}
