//! Handles in even rows, for a picture without an outline to follow.

use glam::DVec2;

use super::{SuggestedRole, placing::Place};
use crate::{
    domain::Domain,
    project::{Handle, Shape},
    segment::segment_distance,
};

/// Rows of handles, and handles in a row, if no number is given.
const ROWS: f64 = 3.0;
/// The minimum distance of handles in that case, in pixels.
const ROOM: f64 = 8.0;
/// Distance of the outer handles from the sides, as a share of the side.
const INSET: f64 = 0.12;

/// An existing handle occupies a position if it is closer than this share of the distance between rows or columns.
const NEAR: f64 = 0.6;

/// Handles in a rectangle: in rows of almost equal length, from top to bottom.
pub(super) fn spread(domain: &Domain, count: Option<usize>) -> Vec<Place> {
    points(domain, count).into_iter().map(place).collect()
}

/// The same without positions near existing handles.
pub(super) fn spread_beside(domain: &Domain, handles: &[Handle]) -> Vec<Place> {
    let points = points(domain, None);
    let apart = |p: DVec2| points.iter().filter(|&&q| q != p).map(|q| q.distance(p)).fold(f64::INFINITY, f64::min);
    let is_free = |p: DVec2| handles.iter().all(|handle| distance(&handle.shape, p) > NEAR * apart(p));
    points.iter().copied().filter(|&p| is_free(p)).map(place).collect()
}

fn place(at: DVec2) -> Place {
    Place { at, role: SuggestedRole::Spread, name: None }
}

/// The distance from the line or the point of a handle at rest.
fn distance(shape: &Shape, p: DVec2) -> f64 {
    let corners = shape.rest();
    let closing = matches!(shape, Shape::Polygon { .. }).then(|| (corners[corners.len() - 1], corners[0]));
    let pieces = corners.windows(2).map(|ends| (ends[0], ends[1])).chain(closing);
    pieces.map(|(a, b)| segment_distance(p, a, b)).fold(corners[0].distance(p), f64::min)
}

fn points(domain: &Domain, count: Option<usize>) -> Vec<DVec2> {
    let (low, high) = domain.bounds();
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

/// Evenly spaced positions between 0 and 1.
fn places(count: usize) -> impl Iterator<Item = f64> {
    let place = move |at: usize| INSET + (1.0 - 2.0 * INSET) * at as f64 / (count - 1) as f64;
    (0..count).map(move |at| if count == 1 { 0.5 } else { place(at) })
}
