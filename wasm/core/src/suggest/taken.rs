//! The cells of existing handles.

use glam::DVec2;

use super::cells::Cells;
use crate::{
    project::{Handle, Shape},
    segment::segment_distance,
};

/// A handle a few cells outside the domain counts as lying on the outline.
const BESIDE: i32 = 3;

/// The cells that handles occupy at rest: around points, along bars, and inside polygons.
pub(super) fn taken_cells(cells: &Cells, handles: &[Handle]) -> Vec<usize> {
    handles.iter().flat_map(|handle| held_cells(cells, &handle.shape)).collect()
}

fn held_cells(cells: &Cells, shape: &Shape) -> Vec<usize> {
    let corners = shape.rest();
    let mut held: Vec<usize> = match shape {
        Shape::Point { .. } => Vec::new(),
        Shape::Bar { .. } => within(cells, corners, |p| corners.windows(2).any(|ends| is_on(cells, ends, p))),
        Shape::Polygon { .. } => within(cells, corners, |p| {
            let closing = [corners[corners.len() - 1], corners[0]];
            is_enclosed(corners, p) || corners.windows(2).chain([&closing[..]]).any(|ends| is_on(cells, ends, p))
        }),
    };
    held.extend(corners.iter().filter_map(|&corner| cells.inside_near(corner, BESIDE)));
    held
}

/// The cells in the box around corners whose centre is occupied.
fn within(cells: &Cells, corners: &[DVec2], is_held: impl Fn(DVec2) -> bool) -> Vec<usize> {
    let first = corners[0];
    let (low, high) = corners.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
    cells.inside_between(low - cells.side, high + cells.side).filter(|&cell| is_held(cells.centre(cell))).collect()
}

fn is_on(cells: &Cells, ends: &[DVec2], p: DVec2) -> bool {
    segment_distance(p, ends[0], ends[1]) <= cells.side
}

/// Whether a ring of corners encloses a point, by the even-odd rule.
fn is_enclosed(corners: &[DVec2], p: DVec2) -> bool {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let crosses = |(a, b): &(&DVec2, &DVec2)| {
        (a.y <= p.y) != (b.y <= p.y) && a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) <= p.x
    };
    ends.filter(crosses).count() % 2 == 1
}
