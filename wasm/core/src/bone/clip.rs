//! The parts of a straight piece that lie in the domain, ends included.
//!
//! Cost of a piece: a look at every edge of the outline, and where that is held, for each pixel of the piece one at the edges that come
//! near to it.

use glam::DVec2;

use crate::{
    distance::Navigation,
    domain::Domain,
    limits::{HELD_CLEARANCE, MAX_SIDE},
    segment::{distance_between, segment_distance},
    triangulation::OUTLINE_TOLERANCE,
};

/// Parts shorter than this, in pixels, are left out on either side: a line along the outline is not cut to dust.
const SHORTEST: f64 = OUTLINE_TOLERANCE;
/// So many of [`SHORTEST`] before an end it is seen whether the way there is inside: past what a corner at the end allows for.
const AT_END: f64 = 8.0;
/// An end this near to that of its piece, in pixels, stays joined with what the piece is joined with, though it lies beside it: a bar
/// whose corner sticks out by less than anyone sees is one body. As two, which keep clear of one another, it would cost hundreds of sites.
const JOINED: f64 = 0.5;
/// Steps along a segment at most: as many as the diagonal of the largest picture takes at a held outline's clearance.
const MOST_STEPS: f64 = std::f64::consts::SQRT_2 * MAX_SIDE as f64 / HELD_CLEARANCE;
/// Halvings until the way to the outline is known to the last digits.
const HALVINGS: usize = 60;

/// A part of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    /// Its ends, as shares of the piece.
    pub(super) shares: [f64; 2],
    /// Whether the part is joined there with what the piece is joined with.
    pub(super) joined: [bool; 2],
}

/// The parts of a segment in the domain, and clear of its outline where that is `held`, ascending.
pub(super) fn kept(domain: &Domain, navigation: &Navigation, [a, b]: [DVec2; 2], held: bool) -> Vec<Part> {
    let mut shares = inside(domain, navigation, a, b);
    if held {
        let clear = |[enter, leave]: [f64; 2]| {
            let clear = clear_of_outline(domain, a.lerp(b, enter), a.lerp(b, leave), HELD_CLEARANCE);
            clear.into_iter().map(move |part| part.map(|share| enter + share * (leave - enter)))
        };
        shares = shares.into_iter().flat_map(clear).collect();
    }
    let near = JOINED / a.distance(b);
    let part = |shares: [f64; 2]| Part { shares, joined: [shares[0] <= near, shares[1] >= 1.0 - near] };
    shares.into_iter().map(part).collect()
}

/// The parts of the segment from `a` to `b` inside the domain, as shares of it.
fn inside(domain: &Domain, navigation: &Navigation, a: DVec2, b: DVec2) -> Vec<[f64; 2]> {
    let along = b - a;
    let mut stops = vec![0.0, 1.0];
    for (c, d) in domain.edges() {
        let wall = d - c;
        let area = along.perp_dot(wall);
        let (share, on_wall) = ((c - a).perp_dot(wall) / area, (c - a).perp_dot(along) / area);
        let slack = OUTLINE_TOLERANCE / wall.length();
        // Parallel walls give no number; their ends are ends of others, also for what runs along just beside them.
        if share > 0.0 && share < 1.0 && (-slack..=1.0 + slack).contains(&on_wall) {
            stops.push(share);
        }
    }
    stops.sort_by(f64::total_cmp);
    let mut parts: Vec<[f64; 2]> = Vec::new();
    let shortest = SHORTEST / along.length();
    let is_inside = |share: f64| navigation.triangle_at(a.lerp(b, share)).is_some();
    for pair in stops.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let middle = f64::midpoint(from, to);
        if to - from <= shortest || !is_inside(middle) {
            continue;
        }
        // What rounding allows for in the middle it may not nearer to an end, which can be inside by another edge again.
        let [from, to] = [from, to].map(|end| {
            let before = end + (middle - end) * (AT_END * shortest / (middle - end).abs()).min(1.0);
            if is_inside(before) { end } else { last(is_inside, middle, before) }
        });
        match parts.last_mut() {
            Some(last) if from - last[1] <= shortest => last[1] = to,
            _ => parts.push([from, to]),
        }
    }
    // Within rounding of the ends.
    for part in &mut parts {
        if part[0] <= shortest {
            part[0] = 0.0;
        }
        if part[1] >= 1.0 - shortest {
            part[1] = 1.0;
        }
    }
    // What allows for rounding in the middle does not at an end that sticks out by twice as much.
    parts.retain(|&[from, to]| is_inside(f64::midpoint(from, to)));
    for part in &mut parts {
        let middle = f64::midpoint(part[0], part[1]);
        *part = part.map(|end| if is_inside(end) { end } else { last(is_inside, middle, end) });
    }
    parts
}

/// The share nearest to `failing` at which something still holds, as at `holding`.
fn last(holds: impl Fn(f64) -> bool, mut holding: f64, mut failing: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(holding, failing);
        if holds(middle) { holding = middle } else { failing = middle }
    }
    holding
}

/// The parts of a segment in the domain that are no nearer to the outline than `clearance`.
fn clear_of_outline(domain: &Domain, a: DVec2, b: DVec2, clearance: f64) -> Vec<[f64; 2]> {
    // With room for rounding.
    let is_near = |&(c, d): &(DVec2, DVec2)| distance_between([a, b], [c, d]) < clearance + OUTLINE_TOLERANCE;
    let near: Vec<(DVec2, DVec2)> = domain.edges().filter(is_near).collect();
    let is_clear = |share: f64| {
        let p = a.lerp(b, share);
        near.iter().all(|&(c, d)| segment_distance(p, c, d) >= clearance)
    };
    // Steps no longer than the clearance, in any picture: what is nearer between two of them alone does not come much nearer.
    let steps = (a.distance(b) / clearance).ceil().clamp(2.0, MOST_STEPS) as u32;
    let at = |step: u32| f64::from(step) / f64::from(steps);
    let mut runs: Vec<[u32; 2]> = Vec::new();
    for step in (0..=steps).filter(|&step| is_clear(at(step))) {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == step => *last = step,
            _ => runs.push([step, step]),
        }
    }
    let part = |[first, end]: [u32; 2]| {
        let enter = if first == 0 { 0.0 } else { last(is_clear, at(first), at(first - 1)) };
        let leave = if end == steps { 1.0 } else { last(is_clear, at(end), at(end + 1)) };
        [enter, leave]
    };
    runs.into_iter().filter(|[first, last]| first < last).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_held_outline_that_comes_near_for_a_pixel_cuts_the_longest_bar() {
        let (width, tip) = (16_000.0, 9_001.3);
        let ring =
            [(0.0, 0.0), (width, 0.0), (width, 40.0), (tip + 0.6, 40.0), (tip, 20.4), (tip - 0.6, 40.0), (0.0, 40.0)];
        let domain = Domain::from_polygon(&[ring.map(DVec2::from).to_vec()], 16_000, 40).expect("a notched strip");
        let [a, b] = [DVec2::new(10.0, 20.0), DVec2::new(width - 10.0, 20.0)];
        let parts = clear_of_outline(&domain, a, b, HELD_CLEARANCE);
        let [[_, before], [after, _]] = parts[..] else { panic!("two parts: {parts:?}") };
        let near = [before, after].map(|share| a.lerp(b, share).x);
        assert!(near[0] < tip && tip < near[1] && near[1] - near[0] < 3.0, "{near:?}");
    }

    #[test]
    fn what_is_clear_is_clear_of_every_edge() {
        let jagged = |i: u32| 50.0 + 45.0 * (f64::from(i) * 0.618_033_988_75).fract();
        let mut ring: Vec<DVec2> = (0..40).map(|i| DVec2::new(f64::from(5 * i), 100.0 - jagged(i))).collect();
        ring.extend((0..40).rev().map(|i| DVec2::new(f64::from(5 * i), 100.0 + jagged(i + 7))));
        let domain = Domain::from_polygon(&[ring], 200, 200).expect("a jagged strip");
        let [a, b] = [DVec2::new(5.3, 30.0), DVec2::new(190.0, 28.0)];
        let parts = clear_of_outline(&domain, a, b, HELD_CLEARANCE);
        let mut counts = [0, 0];
        // Every tenth is one that is looked at; the ends of parts are between two of those.
        let steps = 10 * (a.distance(b) / HELD_CLEARANCE).ceil() as u32;
        for share in (0..=steps).step_by(10).map(|step| f64::from(step) / f64::from(steps)) {
            let is_in_part = parts.iter().any(|&[enter, leave]| enter <= share && share <= leave);
            let is_clear = domain.distance_to_outline(a.lerp(b, share)) >= HELD_CLEARANCE;
            // One alone is no part.
            assert!(is_clear || !is_in_part, "at {share}");
            counts[usize::from(is_in_part)] += 1;
        }
        for share in parts.iter().flatten().filter(|&&share| share > 0.0 && share < 1.0) {
            let from_outline = domain.distance_to_outline(a.lerp(b, *share));
            assert!((from_outline - HELD_CLEARANCE).abs() < 1e-9, "{from_outline} at {share}");
        }
        assert!(parts.len() > 3 && counts.iter().all(|&count| count > 20), "{parts:?}, {counts:?}");
    }
}
