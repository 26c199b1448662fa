//! Rigid image deformation by moving least squares (Schaefer, McPhail and Warren 2006, section 2.3).
//!
//! Weights are 1/d². A bar has the weight of points at one sample spacing, as an integral along the bar. The variable
//! of integration is the viewing angle, in which 1/d² has no peak.

use std::f64::consts::TAU;

use glam::DVec2;

use crate::constraints::{Constraints, Segment};

/// Integration steps per half turn of the viewing angle.
const STEPS: f64 = 48.0;
/// Distance within which a point is on a handle, in pixels.
const TOLERANCE: f64 = 1e-9;

/// Returns the posed position of `p`. `spacing` is the distance between the points that replace a bar.
#[must_use]
pub fn posed_point(constraints: &Constraints, spacing: f64, p: DVec2) -> DVec2 {
    let mut samples: Vec<(DVec2, DVec2, f64)> = Vec::new();
    for &(rest, posed) in &constraints.points {
        let far = rest.distance(p);
        if far <= TOLERANCE {
            return posed;
        }
        samples.push((rest, posed, 1.0 / (far * far)));
    }
    for segment in &constraints.segments {
        let (t, far) = segment.nearest(p);
        if far <= TOLERANCE {
            return segment.at(t).1;
        }
        samples.extend(bar_samples(segment, p).map(|(rest, posed, weight)| (rest, posed, weight / spacing)));
    }
    let total: f64 = samples.iter().map(|&(.., weight)| weight).sum();
    if total == 0.0 {
        return p;
    }
    let centre = |position: fn(&(DVec2, DVec2, f64)) -> DVec2| {
        samples.iter().map(|sample| sample.2 * position(sample)).sum::<DVec2>() / total
    };
    let (rest_centre, posed_centre) = (centre(|s| s.0), centre(|s| s.1));
    let turn = samples.iter().fold(DVec2::ZERO, |turn, &(rest, posed, weight)| {
        let (before, after) = (rest - rest_centre, posed - posed_centre);
        turn + weight * DVec2::new(before.dot(after), before.perp_dot(after))
    });
    posed_centre + turn.try_normalize().unwrap_or(DVec2::X).rotate(p - rest_centre)
}

/// Returns points of a bar with their weights for `p`: ∫ ds / d².
fn bar_samples(segment: &Segment, p: DVec2) -> impl Iterator<Item = (DVec2, DVec2, f64)> {
    let [a, b] = segment.rest;
    let along = (b - a).normalize();
    // With the foot of the perpendicular and its distance `far`: s = foot + far · tan θ and ds / d² = dθ / far.
    let (foot, far) = ((p - a).dot(along), (p - a).perp_dot(along).abs().max(TOLERANCE));
    let (from, to) = ((-foot / far).atan(), ((a.distance(b) - foot) / far).atan());
    let steps = ((to - from) / (TAU / 2.0) * STEPS).ceil().max(12.0);
    let step = (to - from) / steps;
    let length = a.distance(b);
    let segment = *segment;
    (0..steps as usize).map(move |i| {
        let angle = from + (i as f64 + 0.5) * step;
        let (rest, posed) = segment.at(((foot + far * angle.tan()) / length).clamp(0.0, 1.0));
        (rest, posed, step / far)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rigid_motions_are_reproduced() {
        let turn = |p: DVec2| DVec2::from_angle(0.4).rotate(p) + DVec2::new(3.0, -8.0);
        let segment = [(50.0, 60.0), (90.0, 70.0)].map(DVec2::from);
        let constraints = Constraints {
            points: [(10.0, 10.0), (80.0, 20.0)].map(DVec2::from).map(|p| (p, turn(p))).to_vec(),
            segments: vec![Segment { rest: segment, posed: segment.map(turn) }],
            outline_held: false,
        };
        for p in [(10.0, 10.0), (50.0, 60.0), (70.0, 65.0), (70.001, 65.0), (5.0, 90.0), (44.0, 31.0)].map(DVec2::from)
        {
            assert!(posed_point(&constraints, 10.0, p).distance(turn(p)) < 1e-9, "{p}");
        }
    }

    #[test]
    fn bar_integral_matches_many_points() {
        let segment = Segment {
            rest: [(50.0, 60.0), (90.0, 70.0)].map(DVec2::from),
            posed: [(40.0, 60.0), (95.0, 80.0)].map(DVec2::from),
        };
        let points = vec![((10.0, 10.0).into(), (12.0, 4.0).into())];
        let bar = Constraints { points: points.clone(), segments: vec![segment], outline_held: false };
        let length = segment.rest[0].distance(segment.rest[1]);
        let dense = (0..4000).map(|i| segment.at((f64::from(i) + 0.5) / 4000.0));
        // The points have less weight than 1. Repeating the other handle has the same effect.
        let others = std::iter::repeat_n(points[0], 400);
        let many = Constraints { points: others.chain(dense).collect(), segments: vec![], outline_held: false };
        for p in [(70.0, 75.0), (5.0, 90.0), (44.0, 31.0)].map(DVec2::from) {
            let (integral, sum) = (posed_point(&bar, length / 10.0, p), posed_point(&many, 1.0, p));
            assert!(integral.distance(sum) < 0.02, "{p}: {integral} and {sum}");
        }
    }
}
