//! The affine map closest to a warp over some points, for content that cannot bend: gradients, patterns, pictures.

use kurbo::{Affine, Point, Vec2};

use crate::warp::Warp;

/// Points whose spread across is less than this fraction of the spread along count as a line, which does not determine
/// the map.
const THIN: f64 = 1e-4;
/// Number of points at which the growth is measured.
const GROWTH_POINTS: usize = 12;

/// The affine map from rest positions to posed positions with the least sum of squared errors. For points on a line,
/// the map's derivative at their centre.
pub(crate) fn affine_of(places: &[[Point; 2]], warp: &Warp<'_>) -> Affine {
    if places.is_empty() {
        return Affine::IDENTITY;
    }
    let count = places.len() as f64;
    let mean =
        |side: usize| places.iter().map(|place| place[side].to_vec2()).fold(Vec2::ZERO, |sum, p| sum + p) / count;
    let [rest, posed] = [mean(0), mean(1)];
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let [mut by_x, mut by_y] = [Vec2::ZERO; 2];
    for [p, q] in places {
        let (p, q) = (p.to_vec2() - rest, q.to_vec2() - posed);
        (xx, xy, yy) = (xx + p.x * p.x, xy + p.x * p.y, yy + p.y * p.y);
        (by_x, by_y) = (by_x + q * p.x, by_y + q * p.y);
    }
    let det = xx * yy - xy * xy;
    let [x, y] = if det > THIN * (xx + yy) * (xx + yy) {
        [(by_x * yy - by_y * xy) / det, (by_y * xx - by_x * xy) / det]
    } else {
        warp.slopes(rest.to_point())
    };
    let offset = posed - x * rest.x - y * rest.y;
    Affine::new([x.x, x.y, y.x, y.y, offset.x, offset.y])
}

/// The growth of lengths near points: the mean root of the growth of areas.
pub(crate) fn growth(places: &[[Point; 2]], warp: &Warp<'_>) -> f64 {
    let step = places.len().div_ceil(GROWTH_POINTS).max(1);
    let roots: Vec<f64> = places
        .iter()
        .step_by(step)
        .map(|[rest, _]| {
            let [x, y] = warp.slopes(*rest);
            x.cross(y).abs().sqrt()
        })
        .collect();
    if roots.is_empty() { 1.0 } else { roots.iter().sum::<f64>() / roots.len() as f64 }
}
