//! Rings as cells of a grid, by the even-odd rule.
//!
//! Cost: linear in the cells, and in the rows that edges pass.

use glam::DVec2;

use super::{Ring, edges};
use crate::rank::{ascending, sort_by_rank};

/// Whether the centre of each cell lies inside rings, row after row. `to_grid` maps to coordinates in which the centres
/// are whole numbers from 0.
pub(crate) fn cells_inside(rings: &[Ring], [columns, rows]: [usize; 2], to_grid: impl Fn(DVec2) -> DVec2) -> Vec<bool> {
    let mut crossings = vec![Vec::new(); rows];
    for (a, b) in rings.iter().flat_map(|ring| edges(ring)) {
        let [a, b] = [a, b].map(&to_grid);
        let (top, bottom) = if a.y < b.y { (a, b) } else { (b, a) };
        let [from, to] = [top.y, bottom.y].map(|y| y.ceil().clamp(0.0, rows as f64) as usize);
        for (row, crossings) in crossings.iter_mut().enumerate().take(to).skip(from) {
            crossings.push(top.x + (row as f64 - top.y) / (bottom.y - top.y) * (bottom.x - top.x));
        }
    }
    let mut cells = vec![false; columns * rows];
    for (crossings, row) in crossings.iter_mut().zip(cells.chunks_exact_mut(columns)) {
        sort_by_rank(crossings, |&crossing| [ascending(crossing), 0]);
        for pair in crossings.chunks_exact(2) {
            let [from, to] = [pair[0], pair[1]].map(|x| x.ceil().clamp(0.0, columns as f64) as usize);
            row[from..to].fill(true);
        }
    }
    cells
}
