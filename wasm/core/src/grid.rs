//! A hash grid: items in square cells, for searches around a point.

use std::collections::HashMap;

use glam::{DVec2, I64Vec2};

/// Items at points.
///
/// Cost of a search: every cell that the bounding box of its circle touches, and the items there.
#[derive(Debug)]
pub(crate) struct Grid<T> {
    /// Side of a cell, in pixels.
    side: f64,
    cells: HashMap<I64Vec2, Vec<T>>,
    /// Least and greatest cell with an item.
    low: I64Vec2,
    high: I64Vec2,
}

impl<T: Copy> Grid<T> {
    pub(crate) fn new(side: f64, items: impl IntoIterator<Item = (DVec2, T)>) -> Self {
        let mut grid = Self { side, cells: HashMap::new(), low: I64Vec2::MAX, high: I64Vec2::MIN };
        items.into_iter().for_each(|(p, item)| grid.insert(p, item));
        grid
    }

    /// Side of a cell, in pixels.
    pub(crate) fn side(&self) -> f64 {
        self.side
    }

    pub(crate) fn insert(&mut self, p: DVec2, item: T) {
        let cell = self.cell(p);
        (self.low, self.high) = (self.low.min(cell), self.high.max(cell));
        self.cells.entry(cell).or_default().push(item);
    }

    /// All items within `radius` of a point, and possibly others, cell by cell.
    pub(crate) fn around(&self, p: DVec2, radius: f64) -> impl Iterator<Item = T> + '_ {
        let (low, high) = (self.cell(p - radius).max(self.low), self.cell(p + radius).min(self.high));
        let cells = (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| I64Vec2::new(x, y)));
        cells.filter_map(|cell| self.cells.get(&cell)).flatten().copied()
    }

    fn cell(&self, p: DVec2) -> I64Vec2 {
        (p / self.side).floor().as_i64vec2()
    }
}

impl Grid<DVec2> {
    /// A grid of points without other data.
    pub(crate) fn of_points(side: f64, points: &[DVec2]) -> Self {
        Self::new(side, points.iter().map(|&p| (p, p)))
    }
}
