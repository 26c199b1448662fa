//! The separation r_h and the clearance of each site, which limit its support (section III-B).
//!
//! Cost of an insertion: a pass over all sites, and a query for each bone that is nearer than the nearest site.

use glam::DVec2;

use super::{
    Site, SiteField, SiteKind,
    obstacles::{BOUNDARY, Obstacles},
    voronoi::Voronoi,
};
use crate::distance::{DistanceField, Propagation};

/// Greatest ratio of the distances of the farther and the nearer bone of an acute joint.
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

impl Room {
    fn of(&Site { separation, clearance, in_acute_joint, .. }: &Site) -> Self {
        Self { separation, clearance, in_acute_joint }
    }

    /// The distance within which a site of a given kind reduces the room. Only real sites count for the clearance.
    fn reduced_within(&self, kind: SiteKind) -> f64 {
        if kind.is_real() { self.separation.max(self.clearance) } else { self.separation }
    }

    /// Reduces the room by a site of a given kind at a distance.
    fn reduce(&mut self, kind: SiteKind, distance: f64) {
        self.separation = self.separation.min(distance);
        if kind.is_real() {
            self.clearance = self.clearance.min(distance);
        }
    }
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
    let mut room = Room { separation: f64::INFINITY, clearance: f64::INFINITY, in_acute_joint: false };
    for at in 0..voronoi.sites.len() {
        if !limits(voronoi, obstacles, at, island, body) {
            continue;
        }
        let (site, other) = (&mut voronoi.sites[at], &voronoi.fields[at]);
        let mut others = Room::of(site);
        // No path is shorter than the straight line.
        if site.rest.distance(rest) < room.reduced_within(site.kind).max(others.reduced_within(kind)) {
            let there = other.distance(triangle, rest);
            // The field of the other may end before this site, and the field of this one reach the other.
            let d = if there.is_finite() { there } else { distances.distance(other.triangle, site.rest) };
            others.reduce(kind, d);
            (site.separation, site.clearance) = (others.separation, others.clearance);
            room.reduce(site.kind, d);
        }
    }
    room.clearance = obstacles.distance_to_bones(distances, island, body, room.clearance);
    if let Some(held) = obstacles.held().filter(|_| body != Some(BOUNDARY)) {
        room.clearance = room.clearance.min(held.distance_to_outline(rest));
    }
    room.separation = room.separation.min(room.clearance);
    let within = ACUTE_JOINT_RATIO * room.clearance;
    room.in_acute_joint =
        body.is_none() && obstacles.has_acute_joint(voronoi.navigation, propagation, (triangle, rest), within);
    room
}

/// Replaces a site's field by a larger one, and reduces the site's room by the obstacles that it now reaches.
pub(super) fn extend_field(voronoi: &mut Voronoi, obstacles: &Obstacles, site: usize, distances: DistanceField) {
    let Site { rest, kind, .. } = voronoi.sites[site];
    let (island, body) = (voronoi.fields[site].island, obstacles.body(kind));
    let mut room = Room::of(&voronoi.sites[site]);
    room.clearance = obstacles.distance_to_bones(&distances, island, body, room.clearance);
    for (at, other) in voronoi.sites.iter().enumerate() {
        let is_other = at != site && limits(voronoi, obstacles, at, island, body);
        if is_other && other.rest.distance(rest) < room.reduced_within(other.kind) {
            room.reduce(other.kind, distances.distance(voronoi.fields[at].triangle, other.rest));
        }
    }
    let extended = &mut voronoi.sites[site];
    (extended.separation, extended.clearance) = (room.separation.min(room.clearance), room.clearance);
    voronoi.fields[site].distances = distances;
}

/// Whether a site limits the supports of the other sites of an island and a body.
pub(super) fn limits(voronoi: &Voronoi, obstacles: &Obstacles, site: usize, island: usize, body: Option<u32>) -> bool {
    let is_of_body = || body.is_some() && obstacles.body(voronoi.sites[site].kind) == body;
    voronoi.fields[site].island == island && !is_of_body()
}
