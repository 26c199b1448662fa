//! Sites with their distance fields and cells: the state of Algorithm 1.
//!
//! Cost of an insertion: a distance field up to its bound, the coarse samples of the cells around it, and a pass over all sites.

use glam::DVec2;

use super::{
    Site, SiteKind,
    cells::Cells,
    chain::Chain,
    farthest::{Far, Pieces},
    obstacles::{Obstacles, Room},
    visit_stamps::VisitStamps,
};
use crate::{
    distance::{DistanceField, NavTriangle, Navigation, Propagation},
    sample::CoarseSamples,
};

/// Reach of the fields of real sites, and of all fields where there are bones, over the largest cell: as far as nearly all
/// supports reach, so that their obstacles are known.
const FIELD_REACH: f64 = 1.75;

/// All sites with their distance fields and cells.
pub(crate) struct Regions<'a> {
    pub(crate) navigation: &'a Navigation,
    pub(crate) coarse: &'a CoarseSamples,
    pub(super) obstacles: &'a Obstacles<'a>,
    pub(crate) sites: Vec<Site>,
    pub(super) chains: Vec<Chain>,
    pub(crate) cells: Cells,
    /// Farthest points of each cell, as far as known.
    pub(super) far: Vec<Far>,
    pub(super) pieces: Pieces,
    /// The triangle of the coarse samples' mesh that contains each site.
    pub(super) home: Vec<u32>,
    /// The triangles that the current search has visited.
    pub(super) searched: VisitStamps,
    propagation: &'a mut Propagation,
}

impl<'a> Regions<'a> {
    pub(crate) fn new(
        navigation: &'a Navigation,
        coarse: &'a CoarseSamples,
        obstacles: &'a Obstacles<'a>,
        propagation: &'a mut Propagation,
    ) -> Self {
        Self {
            navigation,
            coarse,
            obstacles,
            sites: Vec::new(),
            chains: Vec::new(),
            cells: Cells::new(coarse.len()),
            far: Vec::new(),
            pieces: Pieces::new(coarse.mesh.triangles.len()),
            home: Vec::new(),
            searched: VisitStamps::new(coarse.mesh.triangles.len()),
            propagation,
        }
    }

    /// Inserts a site at a point of the domain.
    pub(crate) fn insert(&mut self, rest: DVec2, triangle: NavTriangle, kind: SiteKind) {
        let island = self.navigation.island_of(triangle);
        // No coarse sample of the island is farther than this from its nearest site, so the new cell reaches no farther either.
        let island_sites = (0..self.sites.len()).filter(|&i| self.sites[i].island == island);
        let radius = island_sites.map(|i| self.sampled_radius(i)).reduce(f64::max);
        let reaches_beyond_cell = kind.is_real() || !self.obstacles.tracks.is_empty();
        let factor = if reaches_beyond_cell { FIELD_REACH } else { 1.0 };
        let bound = radius.map_or(f64::INFINITY, |radius| factor * (radius + 2.0 * self.coarse.longest_edge));
        let field = self.field(rest, triangle, bound);
        let Room { separation, clearance, in_nook } = self.make_room(rest, triangle, kind, &field);
        let coarse = self.coarse;
        let home = coarse.triangle_at(rest);
        let mut lookup = field.cached_lookup();
        let path_end = |at: usize| lookup.path_end(coarse.nav_triangles[at], coarse.mesh.vertices[at]);
        self.cells.insert(coarse, (rest, coarse.mesh.triangles[home]), path_end);
        self.sites.push(Site {
            rest,
            kind,
            separation,
            clearance,
            cell_radius: 0.0,
            support_radius: 0.0,
            in_nook,
            island,
            triangle,
            field,
        });
        let mut pieces = std::mem::take(&mut self.pieces);
        pieces.insert(self);
        self.pieces = pieces;
        self.keep_far_points();
        self.far.push(Far::Within(radius.map_or(f64::INFINITY, |radius| radius + self.coarse.longest_edge)));
        self.home.push(home as u32);
    }

    /// The distance field of a point, up to a bound.
    pub(super) fn field(&mut self, from: DVec2, triangle: NavTriangle, bound: f64) -> DistanceField {
        self.propagation.field(self.navigation, triangle, from, bound)
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

    /// The cell radius over the coarse samples: a lower bound of the true one.
    pub(crate) fn sampled_radius(&self, site: usize) -> f64 {
        self.cells.farthest_sample(site).map_or(0.0, |sample| self.cells.distance[sample])
    }

    /// The nearest site of a point, and its distance; `None` on an island without sites.
    pub(crate) fn nearest(&self, triangle: NavTriangle, p: DVec2) -> Option<(f64, &Site)> {
        self.sites.iter().fold(None, |nearest, site| {
            let known = nearest.map_or(f64::INFINITY, |(known, _)| known);
            let distance = if site.rest.distance(p) < known { site.field.distance(triangle, p) } else { f64::INFINITY };
            if distance < known { Some((distance, site)) } else { nearest }
        })
    }
}
