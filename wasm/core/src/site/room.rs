//! The separation r_h and the clearance of each site: how far its support may reach (section III-B).
//!
//! Cost of an insertion: a pass over all sites, and a query for each bone that is nearer than the nearest site.

use glam::DVec2;

use super::{
    Site, SiteField, SiteKind,
    obstacles::{BOUNDARY, Obstacles},
    voronoi::Voronoi,
};
use crate::distance::{DistanceField, Propagation};

/// Greatest distance of the farther bone of an acute joint, over that of the nearer one.
const ACUTE_JOINT_RATIO: f64 = 1.5;

/// The room of one site.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room {
    /// See [`Site::separation`].
    pub(super) separation: f64,
    /// See [`Site::clearance`].
    pub(super) clearance: f64,
    /// See [`Site::in_acute_joint`].
    pub(super) in_acute_joint: bool,
}

/// Returns the room of a site that is about to be inserted, and reduces the room of all others. `rest` is the site's
/// position.
pub(super) fn make_room(
    voronoi: &mut Voronoi,
    obstacles: &Obstacles,
    propagation: &mut Propagation,
    (rest, kind, field): (DVec2, SiteKind, &SiteField),
) -> Room {
    let SiteField { island, triangle, ref distances } = *field;
    let body = obstacles.body(kind);
    let (mut separation, mut clearance) = (f64::INFINITY, f64::INFINITY);
    for at in 0..voronoi.sites.len() {
        if !limits(voronoi, obstacles, at, island, body) {
            continue;
        }
        let (site, other) = (&mut voronoi.sites[at], &voronoi.fields[at]);
        // No path is shorter than the straight line. Only distances from real sites count for a clearance.
        let straight = site.rest.distance(rest);
        if straight < site.separation.max(separation)
            || kind.is_real() && straight < site.clearance
            || site.kind.is_real() && straight < clearance
        {
            let there = other.distance(triangle, rest);
            // The field of the other may end before this site, and the field of this one reach the other.
            let d = if there.is_finite() { there } else { distances.distance(other.triangle, site.rest) };
            site.separation = site.separation.min(d);
            separation = separation.min(d);
            if kind.is_real() {
                site.clearance = site.clearance.min(d);
            }
            if site.kind.is_real() {
                clearance = clearance.min(d);
            }
        }
    }
    clearance = obstacles.distance_to_bones(distances, island, body, clearance);
    if let Some(held) = obstacles.held().filter(|_| body != Some(BOUNDARY)) {
        clearance = clearance.min(held.distance_to_outline(rest));
    }
    let within = ACUTE_JOINT_RATIO * clearance;
    let in_acute_joint =
        body.is_none() && obstacles.has_acute_joint(voronoi.navigation, propagation, (triangle, rest), within);
    Room { separation: separation.min(clearance), clearance, in_acute_joint }
}

/// Replaces a site's field by one that reaches farther, and reduces the site's room by the obstacles that it now
/// reaches.
pub(super) fn extend_field(voronoi: &mut Voronoi, obstacles: &Obstacles, site: usize, distances: DistanceField) {
    let Site { rest, kind, separation, clearance, .. } = voronoi.sites[site];
    let (island, body) = (voronoi.fields[site].island, obstacles.body(kind));
    let mut separation = separation;
    let mut clearance = obstacles.distance_to_bones(&distances, island, body, clearance);
    for (at, other) in voronoi.sites.iter().enumerate() {
        let is_other = at != site && limits(voronoi, obstacles, at, island, body);
        let farthest = if other.kind.is_real() { separation.max(clearance) } else { separation };
        if is_other && other.rest.distance(rest) < farthest {
            let d = distances.distance(voronoi.fields[at].triangle, other.rest);
            separation = separation.min(d);
            if other.kind.is_real() {
                clearance = clearance.min(d);
            }
        }
    }
    let extended = &mut voronoi.sites[site];
    (extended.separation, extended.clearance) = (separation.min(clearance), clearance);
    voronoi.fields[site].distances = distances;
}

/// Whether a site limits the supports of the other sites of an island and a body.
pub(super) fn limits(voronoi: &Voronoi, obstacles: &Obstacles, site: usize, island: usize, body: Option<u32>) -> bool {
    let is_of_body = || body.is_some() && obstacles.body(voronoi.sites[site].kind) == body;
    voronoi.fields[site].island == island && !is_of_body()
}
