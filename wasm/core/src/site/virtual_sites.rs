//! Algorithm 1, virtual handle insertion (paper, section IV-A).
//!
//! While some cell is larger than its site's support may reach, insert a site at the farthest point of the worst cell. How far
//! that is, [`Site::reach_limit`](super::Site::reach_limit), is less strict than the paper's r_d ≤ r_h for virtual sites.
//! It is less strict too between two bones that meet at a shallow angle, [`Site::in_nook`](super::Site::in_nook).
//! Three things are stricter:
//! - farthest points are those of the cell itself, not of its samples;
//! - tied points, of one cell or of several, enter in one round, so that a symmetric scene stays symmetric;
//! - the condition holds with a [`MARGIN`]: with r_d = r_h the farthest point of a cell has no weight at all.
//!
//! A new site is farther from all others than the site that asked for it is from its nearest, by a factor, or than that is
//! from a real site; so sites cannot crowd without end. Between two handles 10 px and 0.01 px apart on a picture of 1,000 px
//! the number of virtual sites grows from some 90 to some 300.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::{
    Site,
    contacts::Contacts,
    regions::{FarPoint, Regions},
};
use crate::{error::Error, least::Least};

/// Scores and radii this near to one another, relatively, are tied: far above rounding, far below what anyone places.
pub(super) const TIE: f64 = 1e-9;
/// Points no farther apart than this share of their distance are one that was found twice.
pub(super) const SAME: f64 = 1e-8;
/// Cells must be smaller than the limit by this share: the farthest point of a cell on the limit has no weight, and weights
/// get steep where it is close.
const MARGIN: f64 = 0.05;
/// Tied points closer than this share of their distance to all sites would crowd each other.
const CROWDED: f64 = 0.5;

/// How much a contact as wide counts for beside a cell of that radius around a handle. With 1.5 in place of 2, narrow gaps between bars
/// stay without sites; with 3, sites are missing elsewhere.
const CONTACT: f64 = 2.0;

/// The score δ(h_i) / r_d(h_i) of the worst cell in each round (the paper's figure 3, right).
pub(crate) type Scores = Vec<f64>;

/// Inserts virtual sites until every cell is smaller than its site's support may reach, by [`MARGIN`].
///
/// Further sites enter where they bend the picture most, until there are `density` virtual ones: between handles, where the gap is
/// [widest](Contacts), and at the farthest points of cells that are [large](grown) for how far handles are.
///
/// # Errors
/// [`Error::TooManySites`].
pub(crate) fn insert_virtual_sites(regions: &mut Regions, density: usize) -> Result<Scores, Error> {
    let mut scores = Scores::new();
    let limit = allowed_score();
    let mut inserted = 0;
    let mut contacts = Contacts::default();
    loop {
        // Bones first: on them nothing virtual may stand.
        regions.tessellate()?;
        let worst = greatest(regions, score_of);
        scores.push(worst);
        let points = if worst > limit {
            tied_farthest(regions, score_of, worst)
        } else if inserted < density && !regions.sites.is_empty() {
            let (largest, widest) = (greatest(regions, grown), contacts.widest(regions));
            let is_wider = widest.first().is_some_and(|point| CONTACT * point.distance.sqrt() > largest);
            if is_wider { spread_out(regions, widest) } else { tied_farthest(regions, grown, largest) }
        } else {
            return Ok(scores);
        };
        inserted += regions.insert_virtual(&points)?;
    }
}

/// The greatest score that a cell may have in the end.
pub(crate) fn allowed_score() -> f64 {
    // δ / r_d = 1 − r_h / r_d, and r_d = (1 − MARGIN) r_h on the limit.
    1.0 - 1.0 / (1.0 - MARGIN)
}

/// By what cells compete to be divided, from their radius and their site.
type Rank = fn(f64, &Site) -> f64;

/// Algorithm 1's score, δ / r_d.
pub(crate) fn score(radius: f64, limit: f64) -> f64 {
    if radius > 0.0 { 1.0 - limit / radius } else { f64::NEG_INFINITY }
}

fn score_of(radius: f64, site: &Site) -> f64 {
    score(radius, site.reach_limit())
}

/// For sites beyond those that Algorithm 1 needs: cells grow with the root of the distance to the next handle. What is pulled
/// out of place is bent in inverse proportion to that distance, about; cells that grow with the distance itself would crowd around handles.
fn grown(radius: f64, site: &Site) -> f64 {
    let from_handle = if site.origin.is_real() { radius } else { site.clearance };
    if from_handle > 0.0 && from_handle.is_finite() { radius / from_handle.sqrt() } else { radius }
}

/// The greatest rank of all cells. Farthest points are sought only in cells that may have it.
fn greatest(regions: &mut Regions, rank: Rank) -> f64 {
    // The highest rank first, and whether it is more than a bound.
    let ranked = |regions: &Regions, site: usize| {
        let known = regions.known_farthest(site).map(|points| points[0].distance);
        let radius = known.unwrap_or_else(|| regions.greatest_radius(site));
        Least { key: -rank(radius, &regions.sites[site]), item: (site, known.is_some()) }
    };
    let mut cells: BinaryHeap<_> = (0..regions.sites.len()).map(|site| ranked(regions, site)).collect();
    while let Some(Least { key, item: (site, is_known) }) = cells.pop() {
        if is_known {
            return -key;
        }
        regions.look_closer(site);
        cells.push(ranked(regions, site));
    }
    f64::NEG_INFINITY
}

/// The farthest points of all cells whose rank is tied with the greatest, in an order that does not depend on the sites'.
fn tied_farthest(regions: &mut Regions, rank: Rank, greatest: f64) -> Vec<FarPoint> {
    let tied = |regions: &Regions, site: usize, radius: f64| {
        rank(radius, &regions.sites[site]) >= greatest - TIE * greatest.abs()
    };
    let mut points: Vec<FarPoint> = Vec::new();
    for site in 0..regions.sites.len() {
        while regions.known_farthest(site).is_none() && tied(regions, site, regions.greatest_radius(site)) {
            regions.look_closer(site);
        }
        let far = regions.known_farthest(site).unwrap_or(&[]);
        for &point in far.iter().filter(|point| tied(regions, site, point.distance)) {
            // A corner of several cells is a farthest point of each.
            if points.iter().all(|known| known.at.distance(point.at) > SAME * point.distance) {
                points.push(point);
            }
        }
    }
    spread_out(regions, points)
}

/// Replaces tied points that crowd each other by one between them, or, where there is none, by some of them.
fn spread_out(regions: &mut Regions, mut points: Vec<FarPoint>) -> Vec<FarPoint> {
    points.sort_by(|a, b| a.at.y.total_cmp(&b.at.y).then(a.at.x.total_cmp(&b.at.x)));
    let mut groups: Vec<Vec<FarPoint>> = Vec::new();
    for point in points {
        let crowds = |group: &Vec<FarPoint>| {
            group.iter().any(|other| other.at.distance(point.at) < CROWDED * point.distance.min(other.distance))
        };
        let (joined, mut apart): (Vec<_>, Vec<_>) = groups.into_iter().partition(crowds);
        apart.push(joined.into_iter().flatten().chain([point]).collect());
        groups = apart;
    }
    groups.iter().flat_map(|group| representatives(regions, group)).collect()
}

fn representatives(regions: &mut Regions, group: &[FarPoint]) -> Vec<FarPoint> {
    if let [alone] = group {
        return vec![*alone];
    }
    let least = group.iter().map(|point| point.distance).fold(f64::INFINITY, f64::min);
    let middle = group.iter().map(|point| point.at).sum::<DVec2>() / group.len() as f64;
    if let Some(point) = point_at(regions, middle).filter(|point| point.distance > (1.0 - CROWDED / 2.0) * least) {
        return vec![point];
    }
    // Something is between them. Of two on both sides of an axis of symmetry, it is on the axis, and so is the middle of the way around it.
    match innermost(group, middle)[..] {
        [alone] => vec![alone],
        [one, other] => halfway(regions, one, other).map_or_else(|| vec![one, other], |point| vec![point]),
        _ => {
            let mut chosen: Vec<FarPoint> = Vec::new();
            for point in group {
                if chosen.iter().all(|other| other.at.distance(point.at) >= CROWDED * point.distance) {
                    chosen.push(*point);
                }
            }
            chosen
        }
    }
}

/// A point, if it lies in the domain, and how far the nearest site is.
fn point_at(regions: &Regions, at: DVec2) -> Option<FarPoint> {
    let place = regions.navigation.place(at)?;
    regions.nearest(place, at).map(|(distance, _)| FarPoint { at, place, distance })
}

/// Those of a group that are nearest to its middle.
fn innermost(group: &[FarPoint], middle: DVec2) -> Vec<FarPoint> {
    let from_middle = |point: &FarPoint| point.at.distance(middle);
    let least = group.iter().map(from_middle).fold(f64::INFINITY, f64::min);
    group.iter().filter(|point| from_middle(point) <= least + SAME * point.distance).copied().collect()
}

/// The point halfway along the shortest path between two that crowd each other; none where that is too long.
fn halfway(regions: &mut Regions, one: FarPoint, other: FarPoint) -> Option<FarPoint> {
    let field = regions.field(one.at, one.place, CROWDED * one.distance.min(other.distance));
    point_at(regions, field.halfway(regions.navigation, other.place, other.at)?)
}
