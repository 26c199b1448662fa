//! Points in square cells: which are near a place.

use std::collections::HashMap;

use glam::DVec2;

/// Points, to be asked for those around a place.
///
/// Cost: of a question, a look at every cell that its circle touches and at the points there.
#[derive(Debug)]
pub(super) struct PointGrid {
    /// Side of a cell, in pixels.
    side: f64,
    cells: HashMap<[i64; 2], Vec<DVec2>>,
}

impl PointGrid {
    pub(super) fn new(side: f64, points: &[DVec2]) -> Self {
        let mut grid = Self { side, cells: HashMap::new() };
        points.iter().for_each(|&p| grid.insert(p));
        grid
    }

    pub(super) fn insert(&mut self, p: DVec2) {
        let cell = self.cell(p);
        self.cells.entry(cell).or_default().push(p);
    }

    /// All points nearer to a place than `radius`, and some more, cell by cell.
    pub(super) fn around(&self, p: DVec2, radius: f64) -> impl Iterator<Item = DVec2> + '_ {
        let ([left, top], [right, bottom]) = (self.cell(p - radius), self.cell(p + radius));
        let cells = (top..=bottom).flat_map(move |y| (left..=right).map(move |x| [x, y]));
        cells.filter_map(|cell| self.cells.get(&cell)).flatten().copied()
    }

    fn cell(&self, p: DVec2) -> [i64; 2] {
        [p.x, p.y].map(|at| (at / self.side).floor() as i64)
    }
}
