//! Finds the lines across which weights may lose derivatives, and measures the jumps across them.
//!
//! The shortest path to a point changes its corners across two kinds of lines. Across a shadow line it begins to bend
//! at one more corner. Across a cut line it takes another way around a hole.

use c2warp::{
    Solution,
    distance::{Distances, Navigation},
};
use glam::DVec2;

/// Points of a line this near to its corner are left out, in pixels. Derivatives have no bound at the corner itself.
const FROM_CORNER_PX: f64 = 3.0;
/// The steps of a walk through a support.
const WALK_STEPS: u32 = 60;

/// The kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Line {
    /// Paths begin to bend.
    Shadow,
    /// Two ways around a hole are equally long.
    Cut,
}

/// A point of a line in the support of a site.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// The kind of line.
    pub line: Line,
    /// The site.
    pub site: usize,
    /// The point.
    pub at: DVec2,
    /// Unit normal of the line.
    pub across: DVec2,
}

/// Jumps of the weight of a site across a line.
#[derive(Debug, Clone, Copy, Default)]
pub struct Jump {
    /// Difference of the gradients on both sides, per pixel.
    pub first: f64,
    /// Difference of the second derivatives on both sides, per square pixel.
    pub second: f64,
}

/// Finds crossings in the supports of all sites, on `walks` straight walks through each.
#[must_use]
pub fn crossings(solution: &Solution, walks: usize) -> Vec<Crossing> {
    let of_site = |(site, at): (usize, &c2warp::site::Site)| {
        let distances = solution.navigation().distances_within(at.rest, at.support_radius).expect("sites are inside");
        let reach = if at.support_radius.is_finite() { at.support_radius } else { 1e3 };
        // Ends in independent directions: the shadow lines of the first corners are radial.
        let turn = |walk: usize| DVec2::from_angle(2.399_963 * walk as f64);
        let ends = |walk: usize| [in_disc(walk + 7 * site), turn(walk).rotate(in_disc(walk + 7 * site + 500))];
        let ends = |walk: usize| ends(walk).map(|end| at.rest + reach * end);
        (0..walks).flat_map(|walk| on_walk(&distances, solution.navigation(), ends(walk), site)).collect::<Vec<_>>()
    };
    solution.sites().iter().enumerate().flat_map(of_site).collect()
}

/// A point of a low-discrepancy sequence in the unit disc.
fn in_disc(k: usize) -> DVec2 {
    let k = k as f64 + 0.5;
    let (u, v) = ((0.754_877_666_246_692_7 * k).fract(), (0.569_840_290_998_053_2 * k).fract());
    u.sqrt() * DVec2::from_angle(std::f64::consts::TAU * v)
}

fn on_walk(distances: &Distances<'_>, navigation: &Navigation, [from, to]: [DVec2; 2], site: usize) -> Vec<Crossing> {
    let path = |p: DVec2| -> Option<Vec<DVec2>> {
        let mut path = navigation.located(p).and_then(|_| distances.path_to(p))?;
        path.pop();
        Some(path)
    };
    let at = |step: u32| from.lerp(to, f64::from(step) / f64::from(WALK_STEPS));
    let mut found = Vec::new();
    let mut before = path(at(0));
    for step in 1..=WALK_STEPS {
        let after = path(at(step));
        if let (Some(one), Some(other)) = (&before, &after)
            && one != other
        {
            found.extend(crossing_between(&path, [at(step - 1), at(step)], site));
        }
        before = after;
    }
    found
}

/// The first change of paths between two points, to a billionth of a pixel.
fn crossing_between(
    path: &impl Fn(DVec2) -> Option<Vec<DVec2>>,
    [mut low, mut high]: [DVec2; 2],
    site: usize,
) -> Option<Crossing> {
    let one = path(low)?;
    let mut other = path(high)?;
    while low.distance(high) > 1e-9 {
        let middle = low.midpoint(high);
        let there = path(middle)?;
        if there == one {
            low = middle;
        } else {
            (high, other) = (middle, there);
        }
    }
    let at = low.midpoint(high);
    let (shorter, longer) = if one.len() <= other.len() { (&one, &other) } else { (&other, &one) };
    let (line, across) = if longer.starts_with(shorter) {
        (Line::Shadow, (at - longer[shorter.len()]).try_normalize()?.perp())
    } else {
        let [a, b] = [&one, &other].map(|path| (at - path[path.len() - 1]).normalize_or_zero());
        (Line::Cut, (a - b).try_normalize()?)
    };
    let corners = [&one, &other].map(|path| path[path.len() - 1]);
    let is_clear = corners.iter().all(|corner| corner.distance(at) > FROM_CORNER_PX);
    is_clear.then_some(Crossing { line, site, at, across })
}

impl Crossing {
    /// The jumps over a distance of `step` on both sides; `None` if a side is outside the domain.
    #[must_use]
    pub fn jump(&self, solution: &Solution, step: f64) -> Option<Jump> {
        let gradient = |steps: f64| {
            let influences = solution.influences_at(self.at + steps * step * self.across)?;
            let of_site = influences.iter().find(|influence| influence.site == self.site);
            Some(of_site.map_or(DVec2::ZERO, |influence| influence.gradient))
        };
        let (before, after) = ([gradient(-2.0)?, gradient(-1.0)?], [gradient(1.0)?, gradient(2.0)?]);
        let second = ((after[1] - after[0]) - (before[1] - before[0])) / step;
        Some(Jump { first: before[1].distance(after[0]), second: second.length() })
    }
}

/// The greatest first and second derivatives of any weight, at `points`.
#[must_use]
pub fn greatest_derivatives(solution: &Solution, points: &[DVec2], step: f64) -> Jump {
    let mut greatest = Jump::default();
    for &p in points {
        let Some(here) = solution.influences_at(p) else { continue };
        for axis in [DVec2::X, DVec2::Y] {
            let Some(there) = solution.influences_at(p + step * axis) else { continue };
            for one in &here {
                greatest.first = greatest.first.max(one.gradient.length());
                if let Some(other) = there.iter().find(|other| other.site == one.site) {
                    greatest.second = greatest.second.max(one.gradient.distance(other.gradient) / step);
                }
            }
        }
    }
    greatest
}

/// The greatest jump of second derivatives found on the way from one point to another, without knowledge of any lines.
///
/// It starts with steps of half a pixel and looks closer where second derivatives differ most, down to steps of `least`
/// pixels. All weights count together. Points within 3 px of a corner of the outline are left out.
#[must_use]
pub fn roughest(solution: &Solution, [from, to]: [DVec2; 2], least: f64) -> f64 {
    let steps = (2.0 * from.distance(to)).ceil() as usize;
    roughest_within(solution, [from, to], steps.max(4), least)
}

/// The number of places of a way at which [`roughest`] looks closer.
const CLOSER: usize = 3;
/// The number of steps there.
const CLOSER_STEPS: usize = 24;

fn roughest_within(solution: &Solution, [from, to]: [DVec2; 2], steps: usize, least: f64) -> f64 {
    let step = from.distance(to) / steps as f64;
    let at = |i: usize| from.lerp(to, i as f64 / steps as f64);
    let is_clear =
        |p: DVec2| solution.domain().rings().iter().flatten().all(|corner| corner.distance(p) > FROM_CORNER_PX);
    let gradients: Vec<Option<Vec<(usize, DVec2)>>> = (0..=steps)
        .map(|i| {
            let influences = Some(at(i)).filter(|&p| is_clear(p)).and_then(|p| solution.influences_at(p))?;
            Some(influences.iter().map(|influence| (influence.site, influence.gradient)).collect())
        })
        .collect();
    let jump = |i: usize| -> Option<f64> {
        let [before, here, after] = [i - 1, i, i + 1].map(|i| gradients[i].as_ref());
        let (before, here, after) = (before?, here?, after?);
        let of = |list: &[(usize, DVec2)], site: usize| {
            list.iter().find(|one| one.0 == site).map_or(DVec2::ZERO, |one| one.1)
        };
        let mut sites: Vec<usize> = before.iter().chain(here).chain(after).map(|one| one.0).collect();
        sites.sort_unstable();
        sites.dedup();
        let second = |site: usize| (of(after, site) - 2.0 * of(here, site) + of(before, site)).length() / step;
        Some(sites.into_iter().map(second).fold(0.0, f64::max))
    };
    let mut jumps: Vec<(f64, usize)> = (1..steps).filter_map(|i| Some((jump(i)?, i))).collect();
    jumps.sort_by(|a, b| b.0.total_cmp(&a.0));
    if step <= least {
        return jumps.first().map_or(0.0, |worst| worst.0);
    }
    let closer = jumps.iter().take(CLOSER);
    closer.map(|&(_, i)| roughest_within(solution, [at(i - 1), at(i + 1)], CLOSER_STEPS, least)).fold(0.0, f64::max)
}
