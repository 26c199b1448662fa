//! The samples of a domain before point handles are inserted.
//!
//! The triangulation of the lattice is nearly all of the cost of sampling. It does not depend on point handles, so a
//! solver keeps it. Handles are inserted into a copy one by one, in a first solve just as in a later one. Earlier
//! solves therefore change no bit of the result.

use std::sync::Arc;

use glam::DVec2;

use super::{
    bones, feather::Feather, fringe, lattice, outline::OutlineSamples, refine, samples::Samples, shown::shows_all,
    skirt::Skirt,
};
use crate::{
    distance::Navigation,
    grid::Grid,
    prepared_domain::PreparedDomain,
    triangulation::{Inserted, Locator, Triangulation},
};

/// Samples of outline, bones and lattice.
#[derive(Debug)]
pub(crate) struct BaseSamples {
    samples: Samples,
    pub(super) locator: Arc<Locator>,
    count: usize,
    bones: Vec<[DVec2; 2]>,
}

impl BaseSamples {
    /// About `count` samples: points along the outline with all its corners, and a triangular lattice inside.
    ///
    /// The lattice is centred on the domain's bounding box, so samples of a symmetric domain are symmetric. `bones`
    /// are straight lines in the domain. The mesh has edges along them wherever nothing else is close.
    ///
    /// Cost: O(n log n), nearly all of it for the triangulation.
    pub(crate) fn new(prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> Self {
        let PreparedDomain { domain, navigation, .. } = prepared;
        let spacing = lattice::spacing(domain, count);
        let OutlineSamples { mut vertices, segments, rings } = OutlineSamples::new(domain, spacing);
        let on_outline = bones::add_bones(&mut vertices, bones, spacing, domain);
        let mut inner = lattice::inner_points(domain, bones, spacing, &vertices, &segments);
        // Consecutive samples then often lie in the same triangle of the navigation mesh.
        inner.sort_by_cached_key(|&p| navigation.triangle_at(p).map(|triangle| triangle.0));
        vertices.extend(inner);
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let locator = Arc::new(Locator::new(&mesh));
        let mut samples = Samples::from_mesh(mesh, navigation, rings, spacing);
        for p in on_outline {
            insert(&mut samples, navigation, &locator, p);
        }
        Self { samples, locator, count, bones: bones.to_vec() }
    }

    /// The same samples with a skirt and a feather, if the domain needs them.
    pub(super) fn with_skirt(mut self, prepared: &PreparedDomain) -> Self {
        self.samples.skirt = skirt(&self.samples, prepared);
        self.samples.feather = Feather::new(&self.samples.mesh, &self.samples.outline, prepared);
        self
    }

    /// Whether these samples were made for the same bones and count.
    pub(super) fn is_for(&self, bones: &[[DVec2; 2]], count: usize) -> bool {
        self.count == count && self.bones == bones
    }

    /// A copy with a sample at every site, and finer lattices around close sites (the paper's up-sampling).
    ///
    /// `sites` must lie in the domain and be distinct. Their order must not depend on earlier solves.
    ///
    /// Cost: the copy, a walk from a nearby triangle for each inserted vertex, and the finer lattices (see [`refine`]).
    pub(crate) fn with_sites(&self, prepared: &PreparedDomain, sites: &[DVec2]) -> Samples {
        let PreparedDomain { domain, navigation, .. } = prepared;
        let Samples { mesh, nav_triangles, outline, skirt, feather, spacing } = &self.samples;
        let mut samples = Samples {
            mesh: mesh.with_capacity_for(sites.len() + skirt.vertices.len()),
            nav_triangles: nav_triangles.clone(),
            outline: outline.clone(),
            skirt: Skirt::default(),
            feather: Feather::default(),
            spacing: *spacing,
        };
        for &site in sites {
            insert(&mut samples, navigation, &self.locator, site);
        }
        let patches = refine::patches(sites, samples.spacing);
        if !patches.is_empty() {
            let mut known = Grid::of_points(samples.spacing, &samples.mesh.vertices);
            for patch in patches {
                for node in patch.clear_nodes(&known, navigation, domain) {
                    let vertex = insert(&mut samples, navigation, &self.locator, node);
                    let p = samples.mesh.vertices[vertex as usize];
                    known.insert(p, p);
                }
            }
        }
        if samples.outline == self.samples.outline {
            samples.skirt = skirt.renumbered(self.samples.len(), samples.len());
            samples.feather = feather.clone();
        } else {
            // Samples were inserted on the outline.
            samples.skirt = self::skirt(&samples, prepared);
            samples.feather = Feather::new(&samples.mesh, &samples.outline, prepared);
        }
        samples
    }
}

/// The skirt of samples, with a fringe if it does not draw all of the picture. Empty if nothing is around them.
fn skirt(Samples { mesh, outline, .. }: &Samples, prepared: &PreparedDomain) -> Skirt {
    let Some(opacity) = &prepared.around else { return Skirt::default() };
    let skirt = Skirt::new(mesh, outline, opacity.size());
    if shows_all(mesh, outline, &skirt, opacity) {
        return skirt;
    }
    let size = opacity.size();
    skirt.with_fringe(mesh, outline, opacity, fringe::spacing(size.x * size.y))
}

/// Inserts a point of the domain into the samples, and into their outline if it lies there. Returns its vertex.
fn insert(samples: &mut Samples, navigation: &Navigation, locator: &Locator, p: DVec2) -> u32 {
    let inserted = samples.mesh.insert(locator.nearby_triangle(p), p);
    if let Inserted::OnBoundary { vertex, between } = inserted {
        let of_edge = |pair: [u32; 2]| pair == between || [pair[1], pair[0]] == between;
        let on_ring = |ring: &Vec<u32>| (0..ring.len()).find(|&i| of_edge([ring[i], ring[(i + 1) % ring.len()]]));
        let at = samples.outline.iter().enumerate().find_map(|(at, ring)| Some((at, on_ring(ring)?)));
        let (ring, edge) = at.expect("the outline bounds the mesh");
        samples.outline[ring].insert(edge + 1, vertex);
    }
    if samples.nav_triangles.len() < samples.mesh.vertices.len() {
        samples.nav_triangles.push(navigation.triangle_at(p).expect("samples lie in the domain"));
    }
    inserted.vertex()
}
