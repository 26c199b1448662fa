//! The parts of a straight piece that lie in the domain.

use glam::DVec2;

use super::HELD_CLEARANCE;
use crate::{distance::Navigation, domain::Domain};

/// Parts shorter than this, in pixels, are left out on either side: a line along the outline is not cut to dust.
const SHORTEST: f64 = 1e-6;
/// Halvings until the way to the outline is known to the last digits.
const HALVINGS: usize = 60;

/// The parts of a segment in the domain, and clear of its outline where that is `held`, as shares of it, ascending.
pub(super) fn kept(domain: &Domain, navigation: &Navigation, [a, b]: [DVec2; 2], held: bool) -> Vec<[f64; 2]> {
    let parts = inside(domain, navigation, a, b);
    if !held {
        return parts;
    }
    let clear = |[enter, leave]: [f64; 2]| {
        let clear = clear_of_outline(domain, a.lerp(b, enter), a.lerp(b, leave), HELD_CLEARANCE);
        clear.into_iter().map(move |part| part.map(|share| enter + share * (leave - enter)))
    };
    parts.into_iter().flat_map(clear).collect()
}

/// The parts of the segment from `a` to `b` inside the domain.
fn inside(domain: &Domain, navigation: &Navigation, a: DVec2, b: DVec2) -> Vec<[f64; 2]> {
    let along = b - a;
    let mut stops = vec![0.0, 1.0];
    for (c, d) in domain.edges() {
        let wall = d - c;
        let area = along.perp_dot(wall);
        let (share, on_wall) = ((c - a).perp_dot(wall) / area, (c - a).perp_dot(along) / area);
        // Parallel walls give no number; their ends are ends of others.
        if share > 0.0 && share < 1.0 && (0.0..=1.0).contains(&on_wall) {
            stops.push(share);
        }
    }
    stops.sort_by(f64::total_cmp);
    let mut parts: Vec<[f64; 2]> = Vec::new();
    let shortest = SHORTEST / along.length();
    for pair in stops.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let is_inside = || navigation.place(a.lerp(b, f64::midpoint(from, to))).is_some();
        if to - from <= shortest || !is_inside() {
            continue;
        }
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
    parts
}

/// The parts of a segment in the domain that are no nearer to the outline than `clearance`.
fn clear_of_outline(domain: &Domain, a: DVec2, b: DVec2, clearance: f64) -> Vec<[f64; 2]> {
    let is_clear = |share: f64| domain.distance_to_outline(a.lerp(b, share)) >= clearance;
    // Steps no longer than the clearance: what is nearer between two of them alone does not come much nearer.
    let steps = (a.distance(b) / clearance).ceil().clamp(2.0, 4096.0) as u32;
    let at = |step: u32| f64::from(step) / f64::from(steps);
    let mut runs: Vec<[u32; 2]> = Vec::new();
    for step in (0..=steps).filter(|&step| is_clear(at(step))) {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == step => *last = step,
            _ => runs.push([step, step]),
        }
    }
    let edge = |mut clear: f64, mut near: f64| {
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(clear, near);
            if is_clear(middle) { clear = middle } else { near = middle }
        }
        clear
    };
    let part = |[first, last]: [u32; 2]| {
        let enter = if first == 0 { 0.0 } else { edge(at(first), at(first - 1)) };
        let leave = if last == steps { 1.0 } else { edge(at(last), at(last + 1)) };
        [enter, leave]
    };
    runs.into_iter().filter(|[first, last]| first < last).map(part).collect()
}
