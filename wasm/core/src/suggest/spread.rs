//! Handles in even rows, for a picture without an outline to follow.

use glam::DVec2;

/// Rows of handles, and handles in a row, if their number is left open.
const ROWS: f64 = 3.0;
/// The least distance of handles then, in pixels.
const ROOM: f64 = 8.0;
/// Distance of the outer handles from the sides, as a share of the side.
const INSET: f64 = 0.12;

/// Points in a rectangle: in rows of almost equal length, from top to bottom.
pub(super) fn spread(low: DVec2, high: DVec2, count: Option<usize>) -> Vec<DVec2> {
    let size = high - low;
    let (count, rows) = match count {
        Some(count) => (count, ((count as f64 * size.y / size.x).sqrt().round() as usize).clamp(1, count)),
        None => {
            let [columns, rows] = [size.x, size.y].map(|side| (side / ROOM).floor().clamp(1.0, ROWS) as usize);
            (columns * rows, rows)
        }
    };
    // Rows above and below the middle are alike as far as the number allows.
    let ends = |row: usize| (count * row + rows / 2) / rows;
    let row = |(row, y): (usize, f64)| places(ends(row + 1) - ends(row)).map(move |x| DVec2::new(x, y));
    places(rows).enumerate().flat_map(row).map(|at| low + at * size).collect()
}

/// Even places between 0 and 1.
fn places(count: usize) -> impl Iterator<Item = f64> {
    let place = move |at: usize| INSET + (1.0 - 2.0 * INSET) * at as f64 / (count - 1) as f64;
    (0..count).map(move |at| if count == 1 { 0.5 } else { place(at) })
}
