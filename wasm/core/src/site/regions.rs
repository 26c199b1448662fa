//! Sites with their distance fields and cells: the state of Algorithm 1.
//!
//! Cost of an insertion: a distance field up to its bound, the scouts of the cells around it, and a pass over all sites.

use glam::DVec2;

use super::{Site, SiteKind, cells::Cells, piece::Pieces, tessellation::Chain, visit_stamps::VisitStamps};
use crate::{
    bone::{Skeleton, Track},
    distance::{DistanceField, Navigation, Place, Propagation},
    domain::Domain,
    sample::Scouts,
    segment::nearest_on_segment,
};

/// Reach of the fields of real sites, and of all fields where there are bones, over the largest cell: as far as nearly all
/// supports reach, so that their obstacles are known.
const FIELD_REACH: f64 = 1.75;

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

/// A point of the domain, its place, and the distance to the nearest site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FarPoint {
    pub(crate) at: DVec2,
    pub(crate) place: Place,
    pub(crate) distance: f64,
}

/// State of the search for a cell's farthest points.
pub(super) enum Far {
    /// No farther than this.
    Within(f64),
    /// No farther than `scout`, the farthest scout when this was found, or in one of `triangles`, each with an upper bound,
    /// descending.
    InTriangles { scout: f64, triangles: Vec<(u32, f64)> },
    /// These, all at the same distance from the site: at least one.
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
    /// Farthest points of each cell, as far as known.
    pub(super) far: Vec<Far>,
    pub(super) pieces: Pieces,
    /// The triangle of the scouts' mesh that contains each site.
    pub(super) home: Vec<u32>,
    /// The triangles that the current search has visited.
    pub(super) searched: VisitStamps,
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
            searched: VisitStamps::new(scouts.mesh.triangles.len()),
            propagation,
        }
    }

    /// Inserts a site at a point of the domain.
    pub(crate) fn insert(&mut self, rest: DVec2, place: Place, kind: SiteKind) {
        let island = self.navigation.island_of(place);
        // No scout of the island is farther than this from its nearest site, so the new cell reaches no farther either.
        let island_sites = (0..self.sites.len()).filter(|&i| self.sites[i].island == island);
        let radius = island_sites.map(|i| self.sampled_radius(i)).reduce(f64::max);
        let reaches_beyond_cell = kind.is_real() || !self.obstacles.tracks.is_empty();
        let factor = if reaches_beyond_cell { FIELD_REACH } else { 1.0 };
        let bound = radius.map_or(f64::INFINITY, |radius| factor * (radius + 2.0 * self.scouts.longest_edge));
        let field = self.field(rest, place, bound);
        let body = self.body(kind);
        let (mut separation, mut clearance) = self.update_separations(rest, place, kind);
        clearance = self.distance_to_bones(&field, island, body, clearance);
        if let Some(held) = self.obstacles.held.filter(|_| body != Some(BOUNDARY)) {
            clearance = clearance.min(held.distance_to_outline(rest));
        }
        separation = separation.min(clearance);
        let in_nook = body.is_none() && self.is_in_nook(rest, place, NOOK_RATIO * clearance);
        let scouts = self.scouts;
        let home = scouts.triangle_at(rest);
        let mut lookup = field.cached_lookup();
        let path_end = |at: usize| lookup.path_end(scouts.places[at], scouts.mesh.vertices[at]);
        self.cells.insert(scouts, scouts.mesh.triangles[home], path_end);
        self.sites.push(Site {
            rest,
            kind,
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

    /// Updates the separation and clearance of all sites for a site about to be inserted. Returns its distance to the nearest
    /// site outside its body, and to the nearest real one.
    fn update_separations(&mut self, rest: DVec2, place: Place, kind: SiteKind) -> (f64, f64) {
        let (island, body) = (self.navigation.island_of(place), self.body(kind));
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

    /// Drops the farthest points that the last site has taken over.
    ///
    /// Cells only shrink: a farthest point that stays in its cell stays the farthest, and any later one is no farther.
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
                if bone.distance(field.source()) < least { least.min(track.distance(field)) } else { least }
            },
        )
    }

    /// Whether a place lies between two bones that meet, both no farther than `within`.
    pub(super) fn is_in_nook(&mut self, p: DVec2, place: Place, within: f64) -> bool {
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
            let field = self.field(p, place, within);
            opposite.iter().all(|&at| self.obstacles.tracks[at].distance(&field) <= within)
        }
    }

    /// Extends a site's field to the radius of its support, where that is farther than the field reaches: obstacles may be
    /// nearer than known.
    ///
    /// Sites of one body do not limit one another, so the nearest other site may be many cells away.
    pub(crate) fn extend_field(&mut self, site: usize, reach: f64) {
        let Site { rest, place, island, kind, separation, clearance, .. } = self.sites[site];
        if reach <= self.sites[site].field.bound() {
            return;
        }
        let field = self.field(rest, place, reach);
        let body = self.body(kind);
        let (mut separation, mut clearance) = (separation, self.distance_to_bones(&field, island, body, clearance));
        for (at, other) in self.sites.iter().enumerate() {
            if at != site && self.is_obstacle(at, island, body) && other.rest.distance(rest) < separation.max(clearance)
            {
                let d = field.distance(other.place, other.rest);
                separation = separation.min(d);
                if other.kind.is_real() {
                    clearance = clearance.min(d);
                }
            }
        }
        let site = &mut self.sites[site];
        (site.separation, site.clearance, site.field) = (separation.min(clearance), clearance, field);
    }

    /// The distance field of a point, up to a bound.
    pub(super) fn field(&mut self, from: DVec2, place: Place, bound: f64) -> DistanceField {
        self.propagation.field(self.navigation, place, from, bound)
    }

    /// The body of a site.
    pub(super) fn body(&self, kind: SiteKind) -> Option<u32> {
        match kind {
            SiteKind::Bone { bone, .. } => Some(self.obstacles.skeleton.bones[bone as usize].body),
            SiteKind::Boundary => Some(BOUNDARY),
            SiteKind::Point { .. } | SiteKind::Virtual => None,
        }
    }

    /// Sets the cell radii of all sites.
    pub(crate) fn measure_cells(&mut self) {
        for site in 0..self.sites.len() {
            while self.known_farthest(site).is_none() {
                self.refine_farthest(site);
            }
            self.sites[site].cell_radius = self.known_farthest(site).map_or(0.0, |points| points[0].distance);
        }
    }

    /// The cell radius over the scouts: a lower bound of the true one.
    pub(crate) fn sampled_radius(&self, site: usize) -> f64 {
        self.cells.farthest_sample(site).map_or(0.0, |sample| self.cells.distance[sample])
    }

    /// Upper bound of the cell radius.
    pub(crate) fn greatest_radius(&self, site: usize) -> f64 {
        match &self.far[site] {
            Far::Within(radius) => *radius,
            Far::InTriangles { scout, triangles } => {
                triangles.first().map_or(*scout, |&(_, upper_bound)| upper_bound.max(*scout))
            }
            Far::Known(points) => points[0].distance,
        }
    }

    /// The nearest site of a point, and its distance; `None` on an island without sites.
    pub(crate) fn nearest(&self, place: Place, p: DVec2) -> Option<(f64, &Site)> {
        self.sites.iter().fold(None, |nearest, site| {
            let known = nearest.map_or(f64::INFINITY, |(known, _)| known);
            let distance = if site.rest.distance(p) < known { site.field.distance(place, p) } else { f64::INFINITY };
            if distance < known { Some((distance, site)) } else { nearest }
        })
    }

    /// The farthest points of a site's cell, including ties, if known already.
    pub(crate) fn known_farthest(&self, site: usize) -> Option<&[FarPoint]> {
        match &self.far[site] {
            Far::Known(points) => Some(points),
            Far::Within(_) | Far::InTriangles { .. } => None,
        }
    }
}
