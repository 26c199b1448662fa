//! Clips a straight span of a bar or polygon to the domain (section V-D).
//!
//! Cost: each span is tested against every edge of the outline. If the outline is held, each pixel of the span is also
//! tested against the edges near it.
//!
//! Limits: parts shorter than [`SHORTEST`] are dropped. Between two steps, an obstacle may come slightly closer than
//! the clearance of a held outline.

use glam::DVec2;

use crate::{
    distance::Navigation,
    domain::Domain,
    limits::{HELD_CLEARANCE, MAX_SIDE},
    rank::{ascending, sort_by_rank},
    segment::{distance_between, segment_distance},
    triangulation::OUTLINE_TOLERANCE,
};

/// Parts and gaps shorter than this, in pixels, are ignored. So a line along the outline is not cut into many tiny
/// parts.
const SHORTEST: f64 = OUTLINE_TOLERANCE;
/// Distance from an end at which to test that the line is inside, over [`SHORTEST`]: beyond the tolerance at a corner.
const AT_END: f64 = 8.0;
/// A part that ends this near to the end of its span, in pixels, stays connected to the joint there. So a bar remains
/// one body if its corner sticks out invisibly. Two separate bodies would cost hundreds of sites.
const CONNECTED: f64 = 0.5;
/// Maximum number of steps along a segment: enough for the diagonal of the largest picture at a held outline's
/// clearance.
const MAX_STEPS: f64 = std::f64::consts::SQRT_2 * MAX_SIDE as f64 / HELD_CLEARANCE;
/// Number of bisections that find the crossing of the outline to the last digits.
const BISECTIONS: usize = 60;

/// A part of a span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    /// Its ends, as fractions of the span.
    pub(super) ends: [f64; 2],
    /// Whether each end is connected to the joint at that end of the span.
    pub(super) connected: [bool; 2],
}

/// The parts of a segment in the domain, in order. If the outline is `held`, the parts keep [`HELD_CLEARANCE`] from it.
pub(super) fn clip(domain: &Domain, navigation: &Navigation, [a, b]: [DVec2; 2], held: bool) -> Vec<Part> {
    let mut parts = clip_to_domain(domain, navigation, a, b);
    if held {
        let clear = |[enter, leave]: [f64; 2]| {
            let clear = clip_to_clearance(domain, a.lerp(b, enter), a.lerp(b, leave), HELD_CLEARANCE);
            clear.into_iter().map(move |part| part.map(|end| enter + end * (leave - enter)))
        };
        parts = parts.into_iter().flat_map(clear).collect();
    }
    let near = CONNECTED / a.distance(b);
    let part = |ends: [f64; 2]| Part { ends, connected: [ends[0] <= near, ends[1] >= 1.0 - near] };
    parts.into_iter().map(part).collect()
}

/// The parts of the segment from `a` to `b` inside the domain, as fractions of it.
fn clip_to_domain(domain: &Domain, navigation: &Navigation, a: DVec2, b: DVec2) -> Vec<[f64; 2]> {
    let along = b - a;
    let mut stops = vec![0.0, 1.0];
    for (c, d) in domain.edges() {
        let wall = d - c;
        let area = along.perp_dot(wall);
        let (crossing, on_wall) = ((c - a).perp_dot(wall) / area, (c - a).perp_dot(along) / area);
        let slack = OUTLINE_TOLERANCE / wall.length();
        // A parallel wall gives NaN or infinity. Its neighbours provide the stops at its ends.
        if crossing > 0.0 && crossing < 1.0 && (-slack..=1.0 + slack).contains(&on_wall) {
            stops.push(crossing);
        }
    }
    sort_by_rank(&mut stops, |&stop| [ascending(stop), 0]);
    let mut parts: Vec<[f64; 2]> = Vec::new();
    let shortest = SHORTEST / along.length();
    let is_inside = |at: f64| navigation.triangle_at(a.lerp(b, at)).is_some();
    for pair in stops.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let middle = f64::midpoint(from, to);
        if to - from <= shortest || !is_inside(middle) {
            continue;
        }
        // The tolerance that accepts the middle may not accept a point nearer to an end. The end may be inside again,
        // by another edge.
        let [from, to] = [from, to].map(|end| {
            let before = end + (middle - end) * (AT_END * shortest / (middle - end).abs()).min(1.0);
            if is_inside(before) { end } else { bisect(is_inside, middle, before) }
        });
        match parts.last_mut() {
            Some(last) if from - last[1] <= shortest => last[1] = to,
            _ => parts.push([from, to]),
        }
    }
    // Snap to ends within rounding.
    for part in &mut parts {
        if part[0] <= shortest {
            part[0] = 0.0;
        }
        if part[1] >= 1.0 - shortest {
            part[1] = 1.0;
        }
    }
    // An end may stick out by twice the tolerance that accepts the middle.
    parts.retain(|&[from, to]| is_inside(f64::midpoint(from, to)));
    for part in &mut parts {
        let middle = f64::midpoint(part[0], part[1]);
        *part = part.map(|end| if is_inside(end) { end } else { bisect(is_inside, middle, end) });
    }
    parts
}

/// The fraction nearest to `failing` at which a condition holds. The condition holds at `holding`.
fn bisect(holds: impl Fn(f64) -> bool, mut holding: f64, mut failing: f64) -> f64 {
    for _ in 0..BISECTIONS {
        let middle = f64::midpoint(holding, failing);
        if holds(middle) { holding = middle } else { failing = middle }
    }
    holding
}

/// The parts of a segment in the domain that are at least `clearance` away from the outline, as fractions of the
/// segment.
fn clip_to_clearance(domain: &Domain, a: DVec2, b: DVec2, clearance: f64) -> Vec<[f64; 2]> {
    // The tolerance leaves room for rounding.
    let is_near = |&(c, d): &(DVec2, DVec2)| distance_between([a, b], [c, d]) < clearance + OUTLINE_TOLERANCE;
    let near: Vec<(DVec2, DVec2)> = domain.edges().filter(is_near).collect();
    let is_clear = |at: f64| {
        let p = a.lerp(b, at);
        near.iter().all(|&(c, d)| segment_distance(p, c, d) >= clearance)
    };
    // Steps are no longer than the clearance, in any picture. An edge that is nearer only between two steps is not much
    // nearer.
    let steps = (a.distance(b) / clearance).ceil().clamp(2.0, MAX_STEPS) as u32;
    let at = |step: u32| f64::from(step) / f64::from(steps);
    let mut runs: Vec<[u32; 2]> = Vec::new();
    for step in (0..=steps).filter(|&step| is_clear(at(step))) {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == step => *last = step,
            _ => runs.push([step, step]),
        }
    }
    let part = |[first, end]: [u32; 2]| {
        let enter = if first == 0 { 0.0 } else { bisect(is_clear, at(first), at(first - 1)) };
        let leave = if end == steps { 1.0 } else { bisect(is_clear, at(end), at(end + 1)) };
        [enter, leave]
    };
    runs.into_iter().filter(|[first, last]| first < last).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn held_outline_near_for_one_pixel_cuts_the_longest_bar() {
        let (width, tip) = (16_000.0, 9_001.3);
        let ring =
            [(0.0, 0.0), (width, 0.0), (width, 40.0), (tip + 0.6, 40.0), (tip, 20.4), (tip - 0.6, 40.0), (0.0, 40.0)];
        let domain = Domain::from_polygon(&[ring.map(DVec2::from).to_vec()], 16_000, 40).expect("a notched strip");
        let [a, b] = [DVec2::new(10.0, 20.0), DVec2::new(width - 10.0, 20.0)];
        let parts = clip_to_clearance(&domain, a, b, HELD_CLEARANCE);
        let [[_, before], [after, _]] = parts[..] else { panic!("two parts: {parts:?}") };
        let near = [before, after].map(|at| a.lerp(b, at).x);
        assert!(near[0] < tip && tip < near[1] && near[1] - near[0] < 3.0, "{near:?}");
    }

    #[test]
    fn clear_parts_keep_clear_of_every_edge() {
        let jagged = |i: u32| 50.0 + 45.0 * (f64::from(i) * 0.618_033_988_75).fract();
        let mut ring: Vec<DVec2> = (0..40).map(|i| DVec2::new(f64::from(5 * i), 100.0 - jagged(i))).collect();
        ring.extend((0..40).rev().map(|i| DVec2::new(f64::from(5 * i), 100.0 + jagged(i + 7))));
        let domain = Domain::from_polygon(&[ring], 200, 200).expect("a jagged strip");
        let [a, b] = [DVec2::new(5.3, 30.0), DVec2::new(190.0, 28.0)];
        let parts = clip_to_clearance(&domain, a, b, HELD_CLEARANCE);
        let mut counts = [0, 0];
        // Every tenth step is one of the clipping; parts end between two of those.
        let steps = 10 * (a.distance(b) / HELD_CLEARANCE).ceil() as u32;
        for at in (0..=steps).step_by(10).map(|step| f64::from(step) / f64::from(steps)) {
            let is_in_part = parts.iter().any(|&[enter, leave]| enter <= at && at <= leave);
            let is_clear = domain.distance_to_outline(a.lerp(b, at)) >= HELD_CLEARANCE;
            // A clear step alone is no part, so the converse need not hold.
            assert!(is_clear || !is_in_part, "at {at}");
            counts[usize::from(is_in_part)] += 1;
        }
        for at in parts.iter().flatten().filter(|&&at| at > 0.0 && at < 1.0) {
            let from_outline = domain.distance_to_outline(a.lerp(b, *at));
            assert!((from_outline - HELD_CLEARANCE).abs() < 1e-9, "{from_outline} at {at}");
        }
        assert!(parts.len() > 3 && counts.iter().all(|&count| count > 20), "{parts:?}, {counts:?}");
    }
}
