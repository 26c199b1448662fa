//! Image deformation by moving least squares, rigid: Schaefer, McPhail and Warren 2006, section 2.3.
//!
//! Weights are 1/d². Bars count as points one sample spacing apart, in the limit of ever more points of ever less weight: the
//! integral along the bar, taken in the angle under which the point sees it, in which 1/d² has no peak.

use std::f64::consts::TAU;

use glam::DVec2;

use crate::targets::{Piece, Targets};

/// Steps of the angle under which a bar is seen, for half a turn.
const STEPS: f64 = 48.0;
/// What counts as on a handle, in pixels.
const ON: f64 = 1e-9;

/// Where a point goes. `spacing` is the distance between the points that bars count as.
#[must_use]
pub fn moved(targets: &Targets, spacing: f64, p: DVec2) -> DVec2 {
    let mut sights: Vec<(DVec2, DVec2, f64)> = Vec::new();
    for &(rest, posed) in &targets.points {
        let far = rest.distance(p);
        if far <= ON {
            return posed;
        }
        sights.push((rest, posed, 1.0 / (far * far)));
    }
    for piece in &targets.pieces {
        let (t, far) = piece.nearest(p);
        if far <= ON {
            return piece.at(t).1;
        }
        sights.extend(seen(piece, p).map(|(rest, posed, weight)| (rest, posed, weight / spacing)));
    }
    let total: f64 = sights.iter().map(|&(.., weight)| weight).sum();
    if total == 0.0 {
        return p;
    }
    let centre = |place: fn(&(DVec2, DVec2, f64)) -> DVec2| {
        sights.iter().map(|sight| sight.2 * place(sight)).sum::<DVec2>() / total
    };
    let (rest_centre, posed_centre) = (centre(|s| s.0), centre(|s| s.1));
    let turn = sights.iter().fold(DVec2::ZERO, |turn, &(rest, posed, weight)| {
        let (before, after) = (rest - rest_centre, posed - posed_centre);
        turn + weight * DVec2::new(before.dot(after), before.perp_dot(after))
    });
    posed_centre + turn.try_normalize().unwrap_or(DVec2::X).rotate(p - rest_centre)
}

/// Places of a bar with the weights that they get from a point: ∫ ds / d².
fn seen(piece: &Piece, p: DVec2) -> impl Iterator<Item = (DVec2, DVec2, f64)> {
    let [a, b] = piece.rest;
    let along = (b - a).normalize();
    // The foot of the perpendicular on the bar's line, and how far it is: s = foot + far · tan θ, ds / d² = dθ / far.
    let (foot, far) = ((p - a).dot(along), (p - a).perp_dot(along).abs().max(ON));
    let (from, to) = ((-foot / far).atan(), ((a.distance(b) - foot) / far).atan());
    let steps = ((to - from) / (TAU / 2.0) * STEPS).ceil().max(12.0);
    let step = (to - from) / steps;
    let length = a.distance(b);
    let piece = *piece;
    (0..steps as usize).map(move |i| {
        let angle = from + (i as f64 + 0.5) * step;
        let (rest, posed) = piece.at(((foot + far * angle.tan()) / length).clamp(0.0, 1.0));
        (rest, posed, step / far)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handles_are_kept_and_a_rigid_motion_is_one() {
        let turn = |p: DVec2| DVec2::from_angle(0.4).rotate(p) + DVec2::new(3.0, -8.0);
        let piece = [(50.0, 60.0), (90.0, 70.0)].map(DVec2::from);
        let targets = Targets {
            points: [(10.0, 10.0), (80.0, 20.0)].map(DVec2::from).map(|p| (p, turn(p))).to_vec(),
            pieces: vec![Piece { rest: piece, posed: piece.map(turn) }],
            outline_held: false,
        };
        for p in [(10.0, 10.0), (50.0, 60.0), (70.0, 65.0), (70.001, 65.0), (5.0, 90.0), (44.0, 31.0)].map(DVec2::from)
        {
            assert!(moved(&targets, 10.0, p).distance(turn(p)) < 1e-9, "{p}");
        }
    }

    #[test]
    fn a_bar_is_as_many_points() {
        let piece = Piece {
            rest: [(50.0, 60.0), (90.0, 70.0)].map(DVec2::from),
            posed: [(40.0, 60.0), (95.0, 80.0)].map(DVec2::from),
        };
        let points = vec![((10.0, 10.0).into(), (12.0, 4.0).into())];
        let bar = Targets { points: points.clone(), pieces: vec![piece], outline_held: false };
        let length = piece.rest[0].distance(piece.rest[1]);
        let dense = (0..4000).map(|i| piece.at((f64::from(i) + 0.5) / 4000.0));
        // Points of less weight than one: the same by giving the others as much more.
        let others = std::iter::repeat_n(points[0], 400);
        let many = Targets { points: others.chain(dense).collect(), pieces: vec![], outline_held: false };
        for p in [(70.0, 75.0), (5.0, 90.0), (44.0, 31.0)].map(DVec2::from) {
            let (integral, sum) = (moved(&bar, length / 10.0, p), moved(&many, 1.0, p));
            assert!(integral.distance(sum) < 0.02, "{p}: {integral} and {sum}");
        }
    }
}
