//! Sites, distances and cells while they grow: what Algorithm 1 works on.

use glam::DVec2;

use super::{Origin, Site, cells::Cells, marks::Marks, piece::Pieces, tessellation::Chain};
use crate::{
    bone::{Skeleton, Track},
    distance::{DistanceField, Navigation, Place, Propagation},
    domain::Domain,
    sample::Scouts,
    segment::nearest_on_segment,
};

/// Fields of real sites, and all fields where there are bones, reach this much farther than the largest cell: as far as
/// nearly all supports do, so that what they must stay clear of is known.
const LOOK_OUT: f64 = 1.75;

/// The body of a held outline: bones have lower numbers.
const BOUNDARY: u32 = u32::MAX;

/// Bones are on both sides of a place where the directions to them differ by more than this (cosine): where they meet at
/// less than 20°. At larger angles the sites of both are close enough to end a cell between them.
const BOTH_SIDES: f64 = -0.94;
/// The farther of them is no farther than this multiple of the nearer.
const BOTH_NEAR: f64 = 1.5;

/// What supports must stay clear of, besides sites.
#[derive(Debug)]
pub(crate) struct Obstacles<'a> {
    pub(crate) skeleton: &'a Skeleton,
    /// The bones on the navigation mesh.
    pub(crate) tracks: Vec<Track>,
    /// The domain, where its outline is held.
    pub(crate) held: Option<&'a Domain>,
}

/// A point of the domain, where it lies and how far the nearest site is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FarPoint {
    pub(crate) at: DVec2,
    pub(crate) place: Place,
    pub(crate) distance: f64,
}

/// What is known of a cell's farthest points.
pub(super) enum Far {
    /// They are no farther than this.
    Within(f64),
    /// They are no farther than the farthest scout was, or in these triangles of the scouts' mesh, in each no farther than told;
    /// the farthest first.
    InTriangles { scout: f64, triangles: Vec<(u32, f64)> },
    /// These, all as far from the site: at least one.
    Known(Vec<FarPoint>),
}

/// All sites with their distance fields and cells.
pub(crate) struct Regions<'a> {
    pub(crate) navigation: &'a Navigation,
    pub(crate) scouts: &'a Scouts,
    pub(super) obstacles: &'a Obstacles<'a>,
    pub(crate) sites: Vec<Site>,
    pub(super) chains: Vec<Chain>,
    pub(crate) cells: Cells,
    /// Farthest points of each cell.
    pub(super) far: Vec<Far>,
    pub(super) pieces: Pieces,
    /// The triangle of the scouts' mesh that holds each site.
    pub(super) home: Vec<u32>,
    /// The triangles that the running search has come to.
    pub(super) searched: Marks,
    propagation: &'a mut Propagation,
}

impl<'a> Regions<'a> {
    pub(crate) fn new(
        navigation: &'a Navigation,
        scouts: &'a Scouts,
        obstacles: &'a Obstacles<'a>,
        propagation: &'a mut Propagation,
    ) -> Self {
        Self {
            navigation,
            scouts,
            obstacles,
            sites: Vec::new(),
            chains: Vec::new(),
            cells: Cells::new(scouts.len()),
            far: Vec::new(),
            pieces: Pieces::new(scouts.mesh.triangles.len()),
            home: Vec::new(),
            searched: Marks::new(scouts.mesh.triangles.len()),
            propagation,
        }
    }

    /// Adds a site at a point of the domain.
    pub(crate) fn insert(&mut self, rest: DVec2, place: Place, origin: Origin) {
        let island = self.navigation.island_of(place);
        // No scout of the island is farther from its nearest site, so the new cell reaches no farther either.
        let island_sites = (0..self.sites.len()).filter(|&i| self.sites[i].island == island);
        let radius = island_sites.map(|i| self.sampled_radius(i)).reduce(f64::max);
        let looks_out = origin.is_real() || !self.obstacles.tracks.is_empty();
        let factor = if looks_out { LOOK_OUT } else { 1.0 };
        let bound = radius.map_or(f64::INFINITY, |radius| factor * (radius + 2.0 * self.scouts.longest_edge));
        let field = self.field(rest, place, bound);
        let body = self.body(origin);
        let (mut separation, mut clearance) = self.separate(rest, place, origin);
        clearance = self.distance_to_bones(&field, island, body, clearance);
        if let Some(held) = self.obstacles.held.filter(|_| body != Some(BOUNDARY)) {
            clearance = clearance.min(held.distance_to_outline(rest));
        }
        separation = separation.min(clearance);
        let in_nook = body.is_none() && self.is_in_nook(rest, place, BOTH_NEAR * clearance);
        let scouts = self.scouts;
        let home = scouts.triangle_at(rest);
        let mut field_in_turn = field.in_turn();
        let foot = |at: usize| field_in_turn.foot(scouts.places[at], scouts.mesh.vertices[at]);
        self.cells.insert(scouts, scouts.mesh.triangles[home], foot);
        self.sites.push(Site {
            rest,
            origin,
            separation,
            clearance,
            cell_radius: 0.0,
            support_radius: 0.0,
            in_nook,
            island,
            place,
            field,
        });
        let mut pieces = std::mem::take(&mut self.pieces);
        pieces.insert(self);
        self.pieces = pieces;
        self.keep_far_points();
        self.far.push(Far::Within(radius.map_or(f64::INFINITY, |radius| radius + self.scouts.longest_edge)));
        self.home.push(home as u32);
    }

    /// Lets all sites know of one that is to come. Returns how far the nearest that is in its way is, and the nearest real one.
    fn separate(&mut self, rest: DVec2, place: Place, origin: Origin) -> (f64, f64) {
        let (island, body) = (self.navigation.island_of(place), self.body(origin));
        let (mut separation, mut clearance) = (f64::INFINITY, f64::INFINITY);
        for at in 0..self.sites.len() {
            if !self.is_obstacle(at, island, body) {
                continue;
            }
            let site = &mut self.sites[at];
            let straight = site.rest.distance(rest);
            if straight < site.separation.max(separation).max(site.clearance).max(clearance) {
                let d = site.field.distance(place, rest);
                site.separation = site.separation.min(d);
                separation = separation.min(d);
                if origin.is_real() {
                    site.clearance = site.clearance.min(d);
                }
                if site.origin.is_real() {
                    clearance = clearance.min(d);
                }
            }
        }
        (separation, clearance)
    }

    /// Forgets the farthest points that the last site has taken over.
    ///
    /// Cells only shrink: a farthest point that stays in its cell stays the farthest, and a later one is no farther.
    fn keep_far_points(&mut self) {
        let Some(Site { rest, field, .. }) = self.sites.last() else { return };
        let kept = |point: &FarPoint| {
            rest.distance(point.at) >= point.distance || field.distance(point.place, point.at) >= point.distance
        };
        for far in &mut self.far {
            if let Far::Known(points) = far {
                let radius = points[0].distance;
                points.retain(kept);
                if points.is_empty() {
                    *far = Far::Within(radius);
                }
            }
        }
    }

    /// Whether a site is in the way of others of an island and a body.
    pub(super) fn is_obstacle(&self, site: usize, island: usize, body: Option<u32>) -> bool {
        let site = &self.sites[site];
        site.island == island && (body.is_none() || self.body(site.origin) != body)
    }

    /// Distance from a field's source to the nearest bone of the island that is not of a body, or `known` where none is nearer.
    fn distance_to_bones(&self, field: &DistanceField, island: usize, body: Option<u32>, known: f64) -> f64 {
        let bones = self.obstacles.skeleton.bones.iter().zip(&self.obstacles.tracks);
        let others = bones.filter(|(bone, track)| track.island == island && Some(bone.body) != body);
        others.fold(
            known,
            |least, (bone, track)| {
                if bone.distance(field.source()) < least { least.min(track.distance(field)) } else { least }
            },
        )
    }

    /// Whether bones that meet are on both sides of a place, and no farther than told.
    pub(super) fn is_in_nook(&mut self, p: DVec2, place: Place, within: f64) -> bool {
        let bones = &self.obstacles.skeleton.bones;
        let near: Vec<(usize, DVec2)> = bones
            .iter()
            .enumerate()
            .map(|(at, bone)| (at, nearest_on_segment(p, bone.rest[0], bone.rest[1]) - p))
            .filter(|(_, to)| to.length() <= within)
            .collect();
        let are_opposite = |&(a, to_a): &(usize, DVec2), &(b, to_b): &(usize, DVec2)| {
            bones[a].meets(&bones[b]) && to_a.dot(to_b) < BOTH_SIDES * to_a.length() * to_b.length()
        };
        let is_opposite = |one: &&(usize, DVec2)| near.iter().any(|other| are_opposite(one, other));
        let opposite: Vec<usize> = near.iter().filter(is_opposite).map(|&(at, _)| at).collect();
        // And not behind a hole.
        !opposite.is_empty() && {
            let field = self.field(p, place, within);
            opposite.iter().all(|&at| self.obstacles.tracks[at].distance(&field) <= within)
        }
    }

    /// Looks around a site as far as its support is to reach, where that is farther than was looked when it was inserted: what it
    /// must stay clear of may be nearer than was known.
    ///
    /// Sites of one body are no obstacle to one another, so what others they have may be many of their cells away.
    pub(crate) fn look_out(&mut self, site: usize, reach: f64) {
        let Site { rest, place, island, origin, separation, clearance, .. } = self.sites[site];
        if reach <= self.sites[site].field.bound() {
            return;
        }
        let field = self.field(rest, place, reach);
        let body = self.body(origin);
        let (mut separation, mut clearance) = (separation, self.distance_to_bones(&field, island, body, clearance));
        for (at, other) in self.sites.iter().enumerate() {
            if at != site && self.is_obstacle(at, island, body) && other.rest.distance(rest) < separation.max(clearance)
            {
                let d = field.distance(other.place, other.rest);
                separation = separation.min(d);
                if other.origin.is_real() {
                    clearance = clearance.min(d);
                }
            }
        }
        let site = &mut self.sites[site];
        (site.separation, site.clearance, site.field) = (separation.min(clearance), clearance, field);
    }

    /// Distances from a point, up to a bound.
    pub(super) fn field(&mut self, from: DVec2, place: Place, bound: f64) -> DistanceField {
        self.propagation.field(self.navigation, place, from, bound)
    }

    /// The body that a site is part of.
    pub(super) fn body(&self, origin: Origin) -> Option<u32> {
        match origin {
            Origin::Bone { bone, .. } => Some(self.obstacles.skeleton.bones[bone as usize].body),
            Origin::Boundary => Some(BOUNDARY),
            Origin::Point { .. } | Origin::Virtual => None,
        }
    }

    /// Sets the cell radii of all sites.
    pub(crate) fn measure_cells(&mut self) {
        for site in 0..self.sites.len() {
            while self.known_farthest(site).is_none() {
                self.look_closer(site);
            }
            self.sites[site].cell_radius = self.known_farthest(site).map_or(0.0, |points| points[0].distance);
        }
    }

    /// The cell radius as the scouts tell it; never more than the true one.
    pub(crate) fn sampled_radius(&self, site: usize) -> f64 {
        self.cells.farthest_sample(site).map_or(0.0, |sample| self.cells.distance[sample])
    }

    /// More than the true cell radius can be.
    pub(crate) fn greatest_radius(&self, site: usize) -> f64 {
        match &self.far[site] {
            Far::Within(radius) => *radius,
            Far::InTriangles { scout, triangles } => triangles.first().map_or(*scout, |&(_, above)| above.max(*scout)),
            Far::Known(points) => points[0].distance,
        }
    }

    /// The nearest site of a point, and its distance; none on an island without sites.
    pub(crate) fn nearest(&self, place: Place, p: DVec2) -> Option<(f64, &Site)> {
        self.sites.iter().fold(None, |nearest, site| {
            let known = nearest.map_or(f64::INFINITY, |(known, _)| known);
            let distance = if site.rest.distance(p) < known { site.field.distance(place, p) } else { f64::INFINITY };
            if distance < known { Some((distance, site)) } else { nearest }
        })
    }

    /// The farthest points of a site's cell: all that are tied for it, if known already.
    pub(crate) fn known_farthest(&self, site: usize) -> Option<&[FarPoint]> {
        match &self.far[site] {
            Far::Known(points) => Some(points),
            Far::Within(_) | Far::InTriangles { .. } => None,
        }
    }
}
