//! Algorithm 1, virtual handle insertion (section IV-A).
//!
//! While a cell is larger than the greatest support of its site, insert a site at the farthest point of the worst cell.
//!
//! The limit of a cell, [`Site::reach_limit`], is less strict than the paper's r_d ≤ r_h for virtual sites and in
//! [acute joints](Site::in_acute_joint). Three conditions are stricter:
//!
//! - Farthest points are those of the cell itself, not of its samples.
//! - Tied points, of one cell or of several, are inserted in one round. So a symmetric scene remains symmetric.
//! - The condition holds with a [`MARGIN`]. At r_d = r_h, the farthest point of a cell would have no weight at all.
//!
//! A virtual site is inserted at distance r_d from its nearest site, and r_d > (1 − MARGIN) · reach_limit of the cell
//! that it splits. So spacing cannot shrink endlessly. Either r_d is above 1.6 times the separation of that cell's
//! site, or it is above 0.95 times its clearance. On a picture of 1,000 px, two handles 10 px apart cause about 90
//! virtual sites. At 0.01 px they cause about 300.
//!
//! Cost: for each round, the insertion of its sites (see `inserter` and `farthest`), and a visit of all cells. Above
//! [`MANY_SITES`], few rounds remain.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::{
    Round, RoundPoint, Site, SiteInserter, TIE, Tessellation,
    contacts::Contacts,
    farthest::{FarPoint, SAME_POINT},
    voronoi::Voronoi,
};
use crate::{
    error::Error,
    min_entry::MinEntry,
    rank::{descending, from_top, sort_by_rank},
};

/// Cells must be smaller than their limit by this share. At the limit, the farthest point of a cell has no weight, and
/// near the limit, weights are steep.
const MARGIN: f64 = 0.05;
/// Tied points crowd each other if they are closer than this, relative to their distance to the nearest site.
const CROWDED: f64 = 0.5;

/// Weight of a contact relative to a cell in the choice of the next site: compares `CONTACT · √distance` with
/// [`size_rank`]. With 1.5 instead of 2, narrow gaps between bars have no sites; with 3, sites are missing elsewhere.
const CONTACT: f64 = 2.0;

/// Cells with a smaller radius than this fraction of the mean spacing of `density` sites are divided last. Without it,
/// sites crowd around handles that are closer than samples: with 400 sites, twice as many triangles fold. With 0.7, 150
/// sites distort by 3 % more.
const CLOSEST: f64 = 0.55;

/// Above this number of sites, a round divides all cells that are too large. The number of rounds then grows with the
/// logarithm of the number of sites, as in parallel Delaunay refinement (Spielman, Teng and Üngör, 2007).
const MANY_SITES: usize = 500;

/// Inserts virtual sites until every cell is smaller than the greatest support of its site, by [`MARGIN`].
///
/// Then inserts more sites where the picture bends most, until there are `density` virtual ones: between handles, at
/// the [widest contacts](Contacts), and at the farthest points of cells that are [large](size_rank) for their distance
/// from handles.
///
/// Returns the rounds: their scores are the curve of figure 3 (right). The last round inserts nothing.
///
/// # Errors
/// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`].
pub(crate) fn insert_virtual_sites(
    inserter: &mut SiteInserter,
    tessellation: &mut Tessellation,
    density: usize,
) -> Result<Vec<Round>, Error> {
    let mut rounds = Vec::new();
    let limit = allowed_score();
    let size_rank = size_rank(CLOSEST * (inserter.area() / density as f64).sqrt());
    let mut inserted = 0;
    let mut contacts = Contacts::default();
    loop {
        // Bones first, as no virtual site may lie on them.
        tessellation.refine(inserter)?;
        let worst = greatest_rank(inserter, &score_rank);
        let points = if worst > limit && inserter.sites().len() >= MANY_SITES {
            far_points_apart(inserter, limit)
        } else if worst > limit {
            tied_farthest_points(inserter, &score_rank, worst)
        } else if inserted < density && !inserter.sites().is_empty() {
            let (largest, widest) = (greatest_rank(inserter, &size_rank), contacts.widest(inserter));
            let is_wider = widest.first().is_some_and(|point| CONTACT * point.distance.sqrt() > largest);
            if is_wider { spread_out(inserter, widest) } else { tied_farthest_points(inserter, &size_rank, largest) }
        } else {
            Vec::new()
        };
        inserter.check_bounds()?;
        let divided = points.iter().filter_map(|point| round_point(&inserter.voronoi, point)).collect();
        rounds.push(Round { score: worst, sites: inserter.sites().len(), points: divided });
        if points.is_empty() {
            return Ok(rounds);
        }
        inserted += tessellation.insert_virtual(inserter, &points)?;
    }
}

/// A point with the site whose cell it divides; `None` on an island without sites. If several cells meet there, the
/// worst.
fn round_point(voronoi: &Voronoi, &FarPoint { at, triangle, distance }: &FarPoint) -> Option<RoundPoint> {
    let most = distance * (1.0 + SAME_POINT);
    let meets =
        |&site: &usize| voronoi.sites[site].rest.distance(at) <= most && voronoi.distance(site, triangle, at) <= most;
    let limit = |site: usize| voronoi.sites[site].reach_limit();
    let owner = (0..voronoi.sites.len()).filter(meets).min_by(|&a, &b| limit(a).total_cmp(&limit(b)))?;
    let path = voronoi.fields[owner].distances.path(voronoi.navigation, triangle, at)?;
    Some(RoundPoint { at, owner, distance, limit: limit(owner), path })
}

/// The score at or below which Algorithm 1 ends.
pub(crate) fn allowed_score() -> f64 {
    // δ / r_d = 1 − r_h / r_d, and r_d = (1 − MARGIN) r_h on the limit.
    1.0 - 1.0 / (1.0 - MARGIN)
}

/// Algorithm 1's score, δ / r_d.
pub(crate) fn score(radius: f64, limit: f64) -> f64 {
    if radius > 0.0 { 1.0 - limit / radius } else { f64::NEG_INFINITY }
}

/// Ranks a cell by its radius and its site, and ascends with the radius. The cell with the greatest rank is divided
/// next.
type Rank<'a> = &'a dyn Fn(f64, &Site) -> f64;

/// Ranks cells by Algorithm 1's score.
fn score_rank(radius: f64, site: &Site) -> f64 {
    score(radius, site.reach_limit())
}

/// Ranks cells for sites beyond those that Algorithm 1 needs: r_d over the square root of the distance to the next
/// handle.
///
/// Around a displaced handle, the picture bends roughly in inverse proportion to that distance. Radii in proportion to
/// the distance itself would crowd sites around handles. Cells with a radius below `closest` come last.
fn size_rank(closest: f64) -> impl Fn(f64, &Site) -> f64 {
    move |radius, site| {
        let from_handle = if site.kind.is_real() { radius } else { site.clearance };
        let rank = if from_handle > 0.0 && from_handle.is_finite() { radius / from_handle.sqrt() } else { radius };
        if radius < closest { -1.0 / rank } else { rank }
    }
}

/// The greatest rank of all cells. Computes farthest points only for cells that may have that rank.
fn greatest_rank(inserter: &mut SiteInserter, rank: Rank<'_>) -> f64 {
    let is_known = |inserter: &SiteInserter, site: usize| inserter.farthest.known(site).is_some();
    // The rank of a known cell, and an upper bound for another.
    let bound =
        |inserter: &SiteInserter, site: usize| rank(inserter.farthest.radius_bound(site), &inserter.sites()[site]);
    let entry = |inserter: &SiteInserter, site: usize| MinEntry { key: -bound(inserter, site), item: site };
    let (known, unknown): (Vec<usize>, Vec<usize>) =
        (0..inserter.sites().len()).partition(|&site| is_known(inserter, site));
    let mut greatest = known.into_iter().map(|site| bound(inserter, site)).fold(f64::NEG_INFINITY, f64::max);
    let mut cells: BinaryHeap<_> = unknown.into_iter().map(|site| entry(inserter, site)).collect();
    while let Some(MinEntry { item: site, .. }) = cells.pop().filter(|cell| -cell.key > greatest) {
        inserter.farthest.refine(&inserter.voronoi, site);
        if is_known(inserter, site) {
            greatest = greatest.max(bound(inserter, site));
        } else {
            cells.push(entry(inserter, site));
        }
    }
    greatest
}

/// The farthest points of all cells whose rank is tied with the greatest. Their order does not depend on that of the
/// sites.
fn tied_farthest_points(inserter: &mut SiteInserter, rank: Rank<'_>, greatest: f64) -> Vec<FarPoint> {
    let points = far_points(inserter, &|radius, site| rank(radius, site) >= greatest - TIE * greatest.abs());
    spread_out(inserter, points)
}

/// The farthest points of all cells whose score is above `limit`, without crowding: a point is left out if another
/// point is at least as far from the sites, and nearer than they are.
///
/// So each point has the same distance from its nearest site as if the points were inserted one by one. Their order
/// does not depend on that of the sites.
fn far_points_apart(inserter: &mut SiteInserter, limit: f64) -> Vec<FarPoint> {
    let mut points = far_points(inserter, &|radius, site| score_rank(radius, site) > limit);
    sort_by_rank(&mut points, |point| from_top(point.at));
    sort_by_rank(&mut points, |point| [descending(point.distance), 0]);
    let mut chosen: Vec<FarPoint> = Vec::new();
    for tied in points.chunk_by(|one, next| next.distance >= one.distance * (1.0 - TIE)) {
        let is_free =
            |point: &&FarPoint| chosen.iter().all(|other| other.at.distance(point.at) >= (1.0 - TIE) * point.distance);
        let free = tied.iter().filter(is_free).copied().collect();
        chosen.extend(spread_out(inserter, free));
    }
    chosen
}

/// The farthest points of the cells to divide, chosen by radius and site. Other cells are not searched.
fn far_points(inserter: &mut SiteInserter, is_divided: &dyn Fn(f64, &Site) -> bool) -> Vec<FarPoint> {
    let mut points: Vec<FarPoint> = Vec::new();
    for at in 0..inserter.sites().len() {
        while !inserter.farthest.is_full()
            && inserter.farthest.known(at).is_none()
            && is_divided(inserter.farthest.radius_bound(at), &inserter.sites()[at])
        {
            inserter.farthest.refine(&inserter.voronoi, at);
        }
        let site = &inserter.sites()[at];
        let farthest = inserter.farthest.known(at).unwrap_or(&[]);
        for &point in farthest.iter().filter(|point| is_divided(point.distance, site)) {
            // A common corner of several cells is a farthest point of each.
            if points.iter().all(|known| known.at.distance(point.at) > SAME_POINT * point.distance) {
                points.push(point);
            }
        }
    }
    points
}

/// Replaces tied points that crowd each other by one point between them or, if that is impossible, by some of them.
fn spread_out(inserter: &mut SiteInserter, mut points: Vec<FarPoint>) -> Vec<FarPoint> {
    sort_by_rank(&mut points, |point| from_top(point.at));
    let mut groups: Vec<Vec<FarPoint>> = Vec::new();
    for point in points {
        let crowds = |group: &Vec<FarPoint>| {
            group.iter().any(|other| other.at.distance(point.at) < CROWDED * point.distance.min(other.distance))
        };
        let (joined, mut apart): (Vec<_>, Vec<_>) = groups.into_iter().partition(crowds);
        apart.push(joined.into_iter().flatten().chain([point]).collect());
        groups = apart;
    }
    groups.iter().flat_map(|group| representatives(inserter, group)).collect()
}

/// The points to insert for a group of points that crowd each other.
fn representatives(inserter: &mut SiteInserter, group: &[FarPoint]) -> Vec<FarPoint> {
    if let [alone] = group {
        return vec![*alone];
    }
    let least = group.iter().map(|point| point.distance).fold(f64::INFINITY, f64::min);
    let mean = group.iter().map(|point| point.at).sum::<DVec2>() / group.len() as f64;
    let at_mean = far_point_at(&inserter.voronoi, mean);
    if let Some(point) = at_mean.filter(|point| point.distance > (1.0 - CROWDED / 2.0) * least) {
        return vec![point];
    }
    // An obstacle lies between the points. If two of them are mirror images, the obstacle lies on the axis of symmetry,
    // and so does the midpoint of the path around it.
    match innermost(group, mean)[..] {
        [alone] => vec![alone],
        [one, other] => midpoint_of_path(inserter, one, other).map_or_else(|| vec![one, other], |point| vec![point]),
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

/// A point with its distance to the nearest site; `None` outside the domain and on an island without sites.
fn far_point_at(voronoi: &Voronoi, at: DVec2) -> Option<FarPoint> {
    let triangle = voronoi.navigation.triangle_at(at)?;
    voronoi.nearest(triangle, at).map(|(distance, _)| FarPoint { at, triangle, distance })
}

/// The points of a group that are nearest to its mean.
fn innermost(group: &[FarPoint], mean: DVec2) -> Vec<FarPoint> {
    let from_mean = |point: &FarPoint| point.at.distance(mean);
    let least = group.iter().map(from_mean).fold(f64::INFINITY, f64::min);
    group.iter().filter(|point| from_mean(point) <= least + SAME_POINT * point.distance).copied().collect()
}

/// The midpoint of the shortest path between two points that crowd each other; `None` if the path is too long.
fn midpoint_of_path(inserter: &mut SiteInserter, one: FarPoint, other: FarPoint) -> Option<FarPoint> {
    let field = inserter.field(one.at, one.triangle, CROWDED * one.distance.min(other.distance));
    let voronoi = &inserter.voronoi;
    far_point_at(voronoi, field.halfway(voronoi.navigation, other.triangle, other.at)?)
}
