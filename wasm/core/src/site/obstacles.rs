//! What supports must keep clear of: other sites, bones, and a held outline.
//!
//! Cost of a site: a pass over all sites, and a look at the bones that are nearer than its nearest site.

use glam::DVec2;

use super::{Regions, Site, SiteKind};
use crate::{
    bone::{Skeleton, Track},
    distance::{DistanceField, NavTriangle},
    domain::Domain,
    segment::nearest_on_segment,
};

/// The body of a held outline; bones have lower numbers.
const BOUNDARY: u32 = u32::MAX;

/// A place lies between two bones where the cosine of the angle between the directions to them is below this: bones that meet
/// at less than 20°. At larger angles the sites of both are close enough to bound a cell between them.
const OPPOSITE_COSINE: f64 = -0.94;
/// The distance of the farther of them over that of the nearer is no more than this.
const NOOK_RATIO: f64 = 1.5;

/// Obstacles that supports must keep clear of, besides sites.
#[derive(Debug)]
pub(crate) struct Obstacles<'a> {
    pub(crate) skeleton: &'a Skeleton,
    /// The bones on the navigation mesh.
    pub(crate) tracks: Vec<Track>,
    /// The domain, where its outline is held.
    pub(crate) held: Option<&'a Domain>,
}

/// The room that a site has.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room {
    /// See [`Site::separation`].
    pub(super) separation: f64,
    /// See [`Site::clearance`].
    pub(super) clearance: f64,
    /// See [`Site::in_nook`].
    pub(super) in_nook: bool,
}

impl Regions<'_> {
    /// The room of a site about to be inserted, with its field; that of all others is updated.
    pub(super) fn make_room(
        &mut self,
        rest: DVec2,
        triangle: NavTriangle,
        kind: SiteKind,
        field: &DistanceField,
    ) -> Room {
        let (island, body) = (self.navigation.island_of(triangle), self.body(kind));
        let (separation, mut clearance) = self.update_separations(rest, triangle, kind);
        clearance = self.distance_to_bones(field, island, body, clearance);
        if let Some(held) = self.obstacles.held.filter(|_| body != Some(BOUNDARY)) {
            clearance = clearance.min(held.distance_to_outline(rest));
        }
        let in_nook = body.is_none() && self.is_in_nook(rest, triangle, NOOK_RATIO * clearance);
        Room { separation: separation.min(clearance), clearance, in_nook }
    }

    /// Updates the separation and clearance of all sites for a site about to be inserted. Returns its distance to the nearest
    /// site outside its body, and to the nearest real one.
    fn update_separations(&mut self, rest: DVec2, triangle: NavTriangle, kind: SiteKind) -> (f64, f64) {
        let (island, body) = (self.navigation.island_of(triangle), self.body(kind));
        let (mut separation, mut clearance) = (f64::INFINITY, f64::INFINITY);
        for at in 0..self.sites.len() {
            if !self.is_obstacle(at, island, body) {
                continue;
            }
            let site = &mut self.sites[at];
            let straight = site.rest.distance(rest);
            if straight < site.separation.max(separation).max(site.clearance).max(clearance) {
                let d = site.field.distance(triangle, rest);
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
        (separation, clearance)
    }

    /// Whether a site limits the supports of the sites of an island and a body.
    pub(super) fn is_obstacle(&self, site: usize, island: usize, body: Option<u32>) -> bool {
        let site = &self.sites[site];
        site.island == island && (body.is_none() || self.body(site.kind) != body)
    }

    /// Distance from a field's source to the nearest bone of the island outside a body, or `known` where none is nearer.
    fn distance_to_bones(&self, field: &DistanceField, island: usize, body: Option<u32>, known: f64) -> f64 {
        let bones = self.obstacles.skeleton.bones.iter().zip(&self.obstacles.tracks);
        let others = bones.filter(|(bone, track)| track.island == island && Some(bone.body) != body);
        others.fold(
            known,
            |least, (bone, track)| {
                if bone.distance(field.source) < least { least.min(track.distance(field)) } else { least }
            },
        )
    }

    /// Whether a place lies between two bones that meet, both no farther than `within`.
    pub(super) fn is_in_nook(&mut self, p: DVec2, triangle: NavTriangle, within: f64) -> bool {
        let bones = &self.obstacles.skeleton.bones;
        let near: Vec<(usize, DVec2)> = bones
            .iter()
            .enumerate()
            .map(|(at, bone)| (at, nearest_on_segment(p, bone.rest[0], bone.rest[1]) - p))
            .filter(|(_, to)| to.length() <= within)
            .collect();
        let are_opposite = |&(a, to_a): &(usize, DVec2), &(b, to_b): &(usize, DVec2)| {
            bones[a].meets(&bones[b]) && to_a.dot(to_b) < OPPOSITE_COSINE * to_a.length() * to_b.length()
        };
        let is_opposite = |one: &&(usize, DVec2)| near.iter().any(|other| are_opposite(one, other));
        let opposite: Vec<usize> = near.iter().filter(is_opposite).map(|&(at, _)| at).collect();
        // Excludes bones behind a hole.
        !opposite.is_empty() && {
            let field = self.field(p, triangle, within);
            opposite.iter().all(|&at| self.obstacles.tracks[at].distance(&field) <= within)
        }
    }

    /// Extends a site's field to the radius of its support, where that is farther than the field reaches: obstacles may be
    /// nearer than known.
    ///
    /// Sites of one body do not limit one another, so the nearest other site may be many cells away.
    pub(crate) fn extend_field(&mut self, site: usize, reach: f64) {
        let Site { rest, triangle, island, kind, separation, clearance, .. } = self.sites[site];
        if reach <= self.sites[site].field.bound() {
            return;
        }
        let field = self.field(rest, triangle, reach);
        let body = self.body(kind);
        let (mut separation, mut clearance) = (separation, self.distance_to_bones(&field, island, body, clearance));
        for (at, other) in self.sites.iter().enumerate() {
            if at != site && self.is_obstacle(at, island, body) && other.rest.distance(rest) < separation.max(clearance)
            {
                let d = field.distance(other.triangle, other.rest);
                separation = separation.min(d);
                if other.kind.is_real() {
                    clearance = clearance.min(d);
                }
            }
        }
        let site = &mut self.sites[site];
        (site.separation, site.clearance, site.field) = (separation.min(clearance), clearance, field);
    }

    /// The body of a site.
    pub(super) fn body(&self, kind: SiteKind) -> Option<u32> {
        match kind {
            SiteKind::Bone { bone, .. } => Some(self.obstacles.skeleton.bones[bone as usize].body),
            SiteKind::Boundary => Some(BOUNDARY),
            SiteKind::Point { .. } | SiteKind::Virtual => None,
        }
    }
}
