//! The Voronoi diagram Vor(H): all sites inserted so far, with their distance fields and cells (section III-B).
//!
//! Distances are exact. Cells are stored over the coarse samples, and `farthest` finds their exact extent.
//!
//! Cost of an insertion: that of `cells`, and one query of the new field for each coarse sample visited.

use glam::DVec2;

use super::{Site, SiteField, cells::Cells};
use crate::{
    distance::{NavTriangle, Navigation},
    sample::CoarseSamples,
};

/// Sites with their distance fields and cells.
pub(crate) struct Voronoi<'a> {
    pub(super) navigation: &'a Navigation,
    pub(super) coarse: &'a CoarseSamples,
    pub(super) sites: Vec<Site>,
    /// For each site, its distance field.
    pub(super) fields: Vec<SiteField>,
    pub(super) cells: Cells,
}

impl<'a> Voronoi<'a> {
    /// A diagram without sites.
    pub(super) fn new(navigation: &'a Navigation, coarse: &'a CoarseSamples) -> Self {
        let cells = Cells::new(coarse.len());
        Self { navigation, coarse, sites: Vec::new(), fields: Vec::new(), cells }
    }

    /// Inserts a site in a triangle of the coarse samples' mesh.
    pub(super) fn insert(&mut self, site: Site, field: SiteField, coarse_triangle: usize) {
        let (coarse, mut lookup) = (self.coarse, field.distances.cached_lookup());
        let path_end = |at: usize| lookup.path_end(coarse.nav_triangles[at], coarse.mesh.vertices[at]);
        self.cells.insert(coarse, (site.rest, coarse.mesh.triangles[coarse_triangle]), path_end);
        self.sites.push(site);
        self.fields.push(field);
    }

    /// Intrinsic distance from a site to a point, in pixels; infinite beyond the bound of the site's field.
    pub(super) fn distance(&self, site: usize, triangle: NavTriangle, p: DVec2) -> f64 {
        self.fields[site].distance(triangle, p)
    }

    /// The greatest cell radius of an island, over the coarse samples; `None` if the island has no site.
    pub(super) fn sampled_radius_of_island(&self, island: usize) -> Option<f64> {
        let sites = (0..self.sites.len()).filter(|&site| self.fields[site].island == island);
        sites.map(|site| self.cells.sampled_radius(site)).reduce(f64::max)
    }

    /// The distance to the nearest site, and that site; `None` on an island without sites.
    pub(super) fn nearest(&self, triangle: NavTriangle, p: DVec2) -> Option<(f64, &Site)> {
        self.sites.iter().zip(&self.fields).fold(None, |nearest, (site, field)| {
            let known = nearest.map_or(f64::INFINITY, |(known, _)| known);
            let distance = if site.rest.distance(p) < known { field.distance(triangle, p) } else { f64::INFINITY };
            if distance < known { Some((distance, site)) } else { nearest }
        })
    }
}
