//! Algorithm 1, virtual handle insertion (section IV-A).
//!
//! While some cell is larger than its site's support may reach, insert a site at the farthest point of the worst cell. The
//! limit, [`Site::reach_limit`](super::Site::reach_limit), is less strict than the paper's r_d ≤ r_h for virtual sites, and
//! between two bones that meet at a shallow angle, [`Site::in_nook`](super::Site::in_nook). Three conditions are stricter:
//!
//! - farthest points are those of the cell itself, not of its samples;
//! - tied points, of one cell or of several, enter in one round, so that a symmetric scene stays symmetric;
//! - the condition holds with a [`MARGIN`]: with r_d = r_h the farthest point of a cell has no weight at all.
//!
//! A virtual site enters at distance r_d from its nearest site, and r_d > (1 − MARGIN) · reach_limit of the cell it splits.
//! So spacing cannot shrink without end: r_d is above 1.6 times the separation of that cell's site, or above 0.95 times its
//! clearance. Between two handles on a picture of 1,000 px the number of virtual sites is some 90 for a gap of 10 px, and
//! some 300 for 0.01 px.
//!
//! Cost: for each round the insertion of its sites (see `cells` and `farthest`), and a heap of all cells.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::{
    Regions, Site, TIE,
    contacts::Contacts,
    farthest::{FarPoint, SAME_POINT},
};
use crate::{error::Error, min_entry::MinEntry};

/// Cells must be smaller than the limit by this share: at the limit the farthest point of a cell has no weight, and near it
/// weights are steep.
const MARGIN: f64 = 0.05;
/// Tied points closer than this share of their distance to the nearest site crowd each other.
const CROWDED: f64 = 0.5;

/// Weight of a contact against a cell when the next site is chosen: `CONTACT · √distance` is compared with [`grown`]. With
/// 1.5 in place of 2, narrow gaps between bars stay without sites; with 3, sites are missing elsewhere.
const CONTACT: f64 = 2.0;

/// The score δ / r_d of the worst cell in each round, as in the paper's figure 3 (right), with δ = r_d − `reach_limit` in
/// place of r_d − r_h.
pub(crate) type Scores = Vec<f64>;

/// Inserts virtual sites until every cell is smaller than its site's support may reach, by [`MARGIN`].
///
/// Then further sites enter where the picture bends most, until there are `density` virtual ones: between handles, where the
/// gap is [widest](Contacts), and at the farthest points of cells that are [large](grown) for their distance from handles.
///
/// # Errors
/// [`Error::TooManySites`].
pub(crate) fn insert_virtual_sites(regions: &mut Regions, density: usize) -> Result<Scores, Error> {
    let mut scores = Scores::new();
    let limit = allowed_score();
    let mut inserted = 0;
    let mut contacts = Contacts::default();
    loop {
        // Bones first: no virtual site may lie on them.
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

/// The greatest score that ends Algorithm 1.
pub(crate) fn allowed_score() -> f64 {
    // δ / r_d = 1 − r_h / r_d, and r_d = (1 − MARGIN) r_h on the limit.
    1.0 - 1.0 / (1.0 - MARGIN)
}

/// The rank by which the next cell is chosen, from its radius and its site.
type Rank = fn(f64, &Site) -> f64;

/// Algorithm 1's score, δ / r_d.
pub(crate) fn score(radius: f64, limit: f64) -> f64 {
    if radius > 0.0 { 1.0 - limit / radius } else { f64::NEG_INFINITY }
}

fn score_of(radius: f64, site: &Site) -> f64 {
    score(radius, site.reach_limit())
}

/// The rank for sites beyond those that Algorithm 1 needs: cell radii grow with the square root of the distance to the next
/// handle. Around a displaced handle the picture bends roughly in inverse proportion to that distance; radii in proportion to
/// the distance itself would crowd sites around handles.
fn grown(radius: f64, site: &Site) -> f64 {
    let from_handle = if site.kind.is_real() { radius } else { site.clearance };
    if from_handle > 0.0 && from_handle.is_finite() { radius / from_handle.sqrt() } else { radius }
}

/// The greatest rank of all cells. Farthest points are computed only for cells that may have it.
fn greatest(regions: &mut Regions, rank: Rank) -> f64 {
    // Keyed by the greatest possible rank, with whether it is exact.
    let ranked = |regions: &Regions, site: usize| {
        let known = regions.known_farthest(site).map(|points| points[0].distance);
        let radius = known.unwrap_or_else(|| regions.greatest_radius(site));
        MinEntry { key: -rank(radius, &regions.sites[site]), item: (site, known.is_some()) }
    };
    let mut cells: BinaryHeap<_> = (0..regions.sites.len()).map(|site| ranked(regions, site)).collect();
    while let Some(MinEntry { key, item: (site, is_known) }) = cells.pop() {
        if is_known {
            return -key;
        }
        regions.refine_farthest(site);
        cells.push(ranked(regions, site));
    }
    f64::NEG_INFINITY
}

/// The farthest points of all cells whose rank is tied with the greatest, in an order independent of the sites'.
fn tied_farthest(regions: &mut Regions, rank: Rank, greatest: f64) -> Vec<FarPoint> {
    let tied = |regions: &Regions, site: usize, radius: f64| {
        rank(radius, &regions.sites[site]) >= greatest - TIE * greatest.abs()
    };
    let mut points: Vec<FarPoint> = Vec::new();
    for site in 0..regions.sites.len() {
        while regions.known_farthest(site).is_none() && tied(regions, site, regions.greatest_radius(site)) {
            regions.refine_farthest(site);
        }
        let far = regions.known_farthest(site).unwrap_or(&[]);
        for &point in far.iter().filter(|point| tied(regions, site, point.distance)) {
            // A common corner of several cells is a farthest point of each.
            if points.iter().all(|known| known.at.distance(point.at) > SAME_POINT * point.distance) {
                points.push(point);
            }
        }
    }
    spread_out(regions, points)
}

/// Replaces tied points that crowd each other by one between them, or, where that is impossible, by some of them.
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
    // An obstacle is between them. Of two points on both sides of an axis of symmetry, the obstacle is on the axis, and so is
    // the midpoint of the path around it.
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

/// A point with its distance to the nearest site, if it lies in the domain.
fn point_at(regions: &Regions, at: DVec2) -> Option<FarPoint> {
    let triangle = regions.navigation.triangle_at(at)?;
    regions.nearest(triangle, at).map(|(distance, _)| FarPoint { at, triangle, distance })
}

/// The points of a group that are nearest to its mean.
fn innermost(group: &[FarPoint], middle: DVec2) -> Vec<FarPoint> {
    let from_middle = |point: &FarPoint| point.at.distance(middle);
    let least = group.iter().map(from_middle).fold(f64::INFINITY, f64::min);
    group.iter().filter(|point| from_middle(point) <= least + SAME_POINT * point.distance).copied().collect()
}

/// The midpoint of the shortest path between two points that crowd each other; `None` where the path is too long.
fn halfway(regions: &mut Regions, one: FarPoint, other: FarPoint) -> Option<FarPoint> {
    let field = regions.field(one.at, one.triangle, CROWDED * one.distance.min(other.distance));
    point_at(regions, field.halfway(regions.navigation, other.triangle, other.at)?)
}
