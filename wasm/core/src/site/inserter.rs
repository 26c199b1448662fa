//! The state of Algorithm 1: inserts sites one at a time and updates fields, cells, room and farthest points.
//!
//! Cost of an insertion: a distance field up to its bound, the coarse samples of the cells around it, and a pass over
//! all sites.

use glam::DVec2;

use super::{
    Round, Site, SiteField, SiteKind, UNIQUE,
    farthest::{FarPoint, FarthestPoints},
    obstacles::Obstacles,
    room::{Room, extend_field, make_room},
    voronoi::Voronoi,
};
use crate::{
    distance::{DistanceField, NavTriangle, Navigation, Propagation},
    error::Error,
    limits::{MAX_FIELD_BYTES, MAX_STEPS},
    project::Continuity,
    sample::CoarseSamples,
};

/// Bound of the fields of real sites, relative to the maximum distance in their cells. If there are bones, the bound of
/// all fields. Nearly all supports end within it, so the fields find their obstacles.
const FIELD_REACH: f64 = 1.75;

/// The domain, partitioned into the cells of its sites.
#[derive(Debug)]
pub(crate) struct Partition {
    pub(crate) sites: Vec<Site>,
    /// For each site, its distance field.
    pub(crate) fields: Vec<SiteField>,
    /// The rounds of Algorithm 1.
    pub(crate) rounds: Vec<Round>,
}

/// Inserts sites into a Voronoi diagram.
pub(crate) struct SiteInserter<'a> {
    pub(super) voronoi: Voronoi<'a>,
    pub(super) farthest: FarthestPoints,
    pub(super) obstacles: &'a Obstacles<'a>,
    propagation: &'a mut Propagation,
    /// Whether shortest paths in a support must be unique.
    is_unique: bool,
    /// Steps of all fields before the first one here.
    steps_before: u64,
    /// Memory of the fields of all sites, in bytes.
    field_bytes: usize,
    /// For each coarse sample, an upper bound of its distance to the nearest site, after the announced sites are
    /// inserted.
    expected: Vec<f64>,
}

impl<'a> SiteInserter<'a> {
    pub(crate) fn new(
        navigation: &'a Navigation,
        coarse: &'a CoarseSamples,
        obstacles: &'a Obstacles<'a>,
        propagation: &'a mut Propagation,
        continuity: Continuity,
    ) -> Self {
        let farthest = FarthestPoints::new(coarse.mesh.triangles.len());
        Self {
            voronoi: Voronoi::new(navigation, coarse),
            farthest,
            obstacles,
            steps_before: propagation.steps(),
            propagation,
            is_unique: continuity == Continuity::C2,
            field_bytes: 0,
            expected: vec![f64::INFINITY; coarse.len()],
        }
    }

    /// The sites inserted so far.
    pub(crate) fn sites(&self) -> &[Site] {
        &self.voronoi.sites
    }

    /// The area of the domain, in square pixels.
    pub(super) fn area(&self) -> f64 {
        let mesh = &self.voronoi.coarse.mesh;
        let twice = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| mesh.vertices[v as usize]);
            (b - a).perp_dot(c - a).abs()
        };
        mesh.triangles.iter().map(twice).sum::<f64>() / 2.0
    }

    /// Announces the positions of sites that will be inserted. Their fields are then limited to the cells that they
    /// will have.
    pub(super) fn expect(&mut self, sites: impl Iterator<Item = DVec2>) {
        if self.obstacles.has_lines() {
            return;
        }
        let CoarseSamples { mesh, graph, .. } = self.voronoi.coarse;
        let corners = |rest: DVec2| {
            let corners = mesh.triangles[self.voronoi.coarse.triangle_at(rest)];
            corners.map(|at| (at, rest.distance(mesh.vertices[at as usize])))
        };
        self.expected = graph.distances_from_any(&mesh.vertices, sites.flat_map(corners));
    }

    /// # Errors
    /// - [`Error::TooMuchMemory`] if the fields of all sites exceed [`MAX_FIELD_BYTES`], or the search for farthest
    ///   points its limit.
    /// - [`Error::TooMuchWork`] if they have taken more than [`MAX_STEPS`] in total.
    pub(super) fn check_bounds(&self) -> Result<(), Error> {
        if self.propagation.steps() - self.steps_before + self.farthest.steps() > MAX_STEPS {
            return Err(Error::TooMuchWork);
        }
        if self.field_bytes > MAX_FIELD_BYTES || self.farthest.is_full() {
            return Err(Error::TooMuchMemory);
        }
        Ok(())
    }

    /// Inserts a site at a point of the domain.
    ///
    /// # Errors
    /// The errors of [`check_bounds`](Self::check_bounds).
    pub(super) fn insert(&mut self, rest: DVec2, triangle: NavTriangle, kind: SiteKind) -> Result<(), Error> {
        let (navigation, coarse) = (self.voronoi.navigation, self.voronoi.coarse);
        let island = navigation.island_of(triangle);
        let coarse_triangle = coarse.triangle_at(rest);
        let reach = self.reach_of_new(rest, island, coarse_triangle);
        let reaches_beyond_cell = kind.is_real() || !self.obstacles.skeleton().bones.is_empty();
        let factor = if reaches_beyond_cell { FIELD_REACH } else { 1.0 };
        let field = SiteField { island, triangle, distances: self.field(rest, triangle, factor * reach) };
        self.field_bytes += field.distances.bytes();
        self.check_bounds()?;
        let Room { separation, clearance, in_acute_joint } =
            make_room(&mut self.voronoi, self.obstacles, self.propagation, (rest, kind, &field));
        let (cell_radius, support_radius, precedence_radius) = (0.0, 0.0, 0.0);
        let farthest = rest;
        let unique_reach = self.unique_reach(&field.distances);
        let site = Site {
            rest,
            kind,
            separation,
            clearance,
            unique_reach,
            cell_radius,
            farthest,
            support_radius,
            precedence_radius,
            in_acute_joint,
        };
        self.voronoi.insert(site, field, coarse_triangle);
        self.farthest.insert(&self.voronoi, coarse_triangle, reach);
        Ok(())
    }

    /// An upper bound for the distances in the cell of a new site, and in the triangles that it enters.
    fn reach_of_new(&mut self, rest: DVec2, island: usize, coarse_triangle: usize) -> f64 {
        let coarse = self.voronoi.coarse;
        if self.obstacles.has_lines() {
            // Gaps on a line depend on sites beyond the cells at their ends. One bound for all keeps symmetry.
            let radius = self.voronoi.sampled_radius_of_island(island);
            return radius.map_or(f64::INFINITY, |radius| radius + 2.0 * coarse.longest_edge);
        }
        let start = (rest, coarse.mesh.triangles[coarse_triangle]);
        self.voronoi.cells.reach_of(coarse, start, &self.expected)
    }

    /// See [`Site::unique_reach`].
    fn unique_reach(&self, field: &DistanceField) -> f64 {
        if self.is_unique { UNIQUE * field.unique_radius(self.voronoi.navigation) } else { f64::INFINITY }
    }

    /// The distance field of a point, up to a bound in pixels.
    pub(super) fn field(&mut self, from: DVec2, triangle: NavTriangle, bound: f64) -> DistanceField {
        self.propagation.field(self.voronoi.navigation, triangle, from, bound)
    }

    /// Whether a point lies in an acute joint: see [`Obstacles::has_acute_joint`].
    pub(super) fn is_in_acute_joint(&mut self, p: DVec2, triangle: NavTriangle, within: f64) -> bool {
        self.obstacles.has_acute_joint(self.voronoi.navigation, self.propagation, (triangle, p), within)
    }

    /// Sets the cell radii r_d and the farthest points of all sites.
    pub(crate) fn measure_cells(&mut self) {
        for site in 0..self.voronoi.sites.len() {
            let FarPoint { at, distance, .. } = self.farthest.first(&self.voronoi, site);
            (self.voronoi.sites[site].cell_radius, self.voronoi.sites[site].farthest) = (distance, at);
        }
    }

    /// Extends each site's field to at least its radius in `radii`, and reduces the site's room by the obstacles found.
    ///
    /// Sites of one body do not limit each other, so the nearest other site may be many cells away.
    ///
    /// # Errors
    /// The errors of [`check_bounds`](Self::check_bounds).
    pub(crate) fn extend_fields(&mut self, radii: &[f64]) -> Result<(), Error> {
        for (site, &radius) in radii.iter().enumerate() {
            if radius > self.voronoi.fields[site].distances.bound() {
                let distances = self.field(self.voronoi.sites[site].rest, self.voronoi.fields[site].triangle, radius);
                self.field_bytes += distances.bytes() - self.voronoi.fields[site].distances.bytes();
                self.check_bounds()?;
                self.voronoi.sites[site].unique_reach = self.unique_reach(&distances);
                extend_field(&mut self.voronoi, self.obstacles, site, distances);
            }
        }
        Ok(())
    }

    /// The sites with their fields, and the rounds that inserted them.
    pub(crate) fn into_partition(self, rounds: Vec<Round>) -> Partition {
        let Voronoi { sites, fields, .. } = self.voronoi;
        Partition { sites, fields, rounds }
    }
}
