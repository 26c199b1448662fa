//! Sub-pixel contours of a field over pixels by marching squares.
//!
//! Pixel centres are the nodes. Nodes beyond the field lie outside. Contours are closed, simple and disjoint. Their
//! inside is on the right in the y-down image, so outer contours have positive area and holes negative area. At
//! saddles, the mean of the four nodes determines the connection, so a diagonal stroke one pixel wide stays connected.
//!
//! Cost: linear in the pixels, with one byte of memory for each, besides the current contour.

use glam::DVec2;

use super::ring::Ring;

/// Minimum distance of a crossing from the nodes of its edge, as a fraction of the edge.
///
/// It keeps the crossings of a contour distinct, even if a pixel's alpha equals the threshold.
const NODE_CLEARANCE: f64 = 1.0 / 64.0;
/// Crossings are rounded to multiples of this many pixels, far below the effect of one step of alpha.
///
/// The crossings of a picture and of its mirror image are then exact mirror images.
const CROSSING_STEP: f64 = 1.0 / 65_536.0;

/// A field of numbers at pixels.
pub(super) trait Field {
    /// Width and height in pixels.
    fn size(&self) -> (u32, u32);
    /// The number at a pixel of the field.
    fn at(&self, x: u32, y: u32) -> f64;
    /// The number at every pixel outside the field. It must be below the level of every contour.
    const BEYOND: f64;
}

/// The contours of `field ≥ level`, clamped to the field's rectangle.
pub(super) fn contours<'a, F: Field>(field: &'a F, level: f64) -> impl Iterator<Item = Ring> + 'a {
    let (width, height) = field.size();
    let (width, height) = (i64::from(width), i64::from(height));
    let field = Nodes { field, width, height, level };
    let mut seen = vec![false; (width * height) as usize];
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y))).filter_map(move |(x, y)| {
        // Every contour passes a node with its left neighbour outside.
        let is_new = field.inside(x, y) && !field.inside(x - 1, y) && !seen[(y * width + x) as usize];
        is_new.then(|| field.trace(x, y, |x, y| seen[(y * width + x) as usize] = true))
    })
}

/// A cell of four nodes, identified by its top left one.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Cell {
    x: i64,
    y: i64,
}

/// The side of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Top,
    Right,
    Bottom,
    Left,
}

struct Nodes<'a, F> {
    field: &'a F,
    width: i64,
    height: i64,
    level: f64,
}

impl<F: Field> Nodes<'_, F> {
    fn at(&self, x: i64, y: i64) -> f64 {
        if (0..self.width).contains(&x) && (0..self.height).contains(&y) {
            self.field.at(x as u32, y as u32)
        } else {
            F::BEYOND
        }
    }

    fn inside(&self, x: i64, y: i64) -> bool {
        self.at(x, y) >= self.level
    }

    /// Follows the contour upwards through the edge between (x − 1, y), outside, and (x, y), inside.
    ///
    /// Calls `visit` for each node whose left neighbour is outside.
    fn trace(&self, x: i64, y: i64, mut visit: impl FnMut(i64, i64)) -> Ring {
        let start = Cell { x: x - 1, y: y - 1 };
        let (mut cell, mut entry) = (start, Side::Bottom);
        let mut ring = Vec::new();
        loop {
            if entry == Side::Bottom {
                visit(cell.x + 1, cell.y + 1);
            }
            ring.push(self.crossing(cell, entry));
            (cell, entry) = self.next(cell, entry);
            if cell == start && entry == Side::Bottom {
                return ring;
            }
        }
    }

    /// The next cell along the contour, and the side on which the contour enters it.
    fn next(&self, cell: Cell, entry: Side) -> (Cell, Side) {
        let Cell { x, y } = cell;
        // The inside is on the right: on entry from below, the bottom right node is inside.
        let [top_left, top_right, bottom_right, bottom_left] =
            [self.inside(x, y), self.inside(x + 1, y), self.inside(x + 1, y + 1), self.inside(x, y + 1)];
        let (ahead_left, ahead_right) = match entry {
            Side::Bottom => (top_left, top_right),
            Side::Left => (top_right, bottom_right),
            Side::Top => (bottom_right, bottom_left),
            Side::Right => (bottom_left, top_left),
        };
        let turn_right = match (ahead_left, ahead_right) {
            (false, false) => true,
            (false, true) => return straight(cell, entry),
            (true, true) => false,
            // At a saddle the contour turns left if the inside is connected.
            (true, false) => !self.saddle_inside(cell),
        };
        if turn_right { right(cell, entry) } else { left(cell, entry) }
    }

    fn saddle_inside(&self, Cell { x, y }: Cell) -> bool {
        // Sum by diagonals: a mirror image gives the same bits.
        let sum = (self.at(x, y) + self.at(x + 1, y + 1)) + (self.at(x + 1, y) + self.at(x, y + 1));
        sum / 4.0 >= self.level
    }

    /// The point where the contour crosses a side, clamped to the field's rectangle.
    fn crossing(&self, Cell { x, y }: Cell, side: Side) -> DVec2 {
        let ((ax, ay), (bx, by)) = match side {
            Side::Top => ((x, y), (x + 1, y)),
            Side::Right => ((x + 1, y), (x + 1, y + 1)),
            Side::Bottom => ((x, y + 1), (x + 1, y + 1)),
            Side::Left => ((x, y), (x, y + 1)),
        };
        let (a, b) = (self.at(ax, ay), self.at(bx, by));
        let t = ((self.level - a) / (b - a)).clamp(NODE_CLEARANCE, 1.0 - NODE_CLEARANCE);
        let t = (t / CROSSING_STEP).round() * CROSSING_STEP;
        let (from, to) = (DVec2::new(ax as f64, ay as f64), DVec2::new(bx as f64, by as f64));
        let size = DVec2::new(self.width as f64, self.height as f64);
        (from + (to - from) * t + 0.5).clamp(DVec2::ZERO, size)
    }
}

fn straight(Cell { x, y }: Cell, entry: Side) -> (Cell, Side) {
    match entry {
        Side::Bottom => (Cell { x, y: y - 1 }, Side::Bottom),
        Side::Left => (Cell { x: x + 1, y }, Side::Left),
        Side::Top => (Cell { x, y: y + 1 }, Side::Top),
        Side::Right => (Cell { x: x - 1, y }, Side::Right),
    }
}

fn right(cell: Cell, entry: Side) -> (Cell, Side) {
    let turned = match entry {
        Side::Bottom => Side::Left,
        Side::Left => Side::Top,
        Side::Top => Side::Right,
        Side::Right => Side::Bottom,
    };
    straight(cell, turned)
}

fn left(cell: Cell, entry: Side) -> (Cell, Side) {
    let turned = match entry {
        Side::Bottom => Side::Right,
        Side::Left => Side::Bottom,
        Side::Top => Side::Left,
        Side::Right => Side::Top,
    };
    straight(cell, turned)
}
