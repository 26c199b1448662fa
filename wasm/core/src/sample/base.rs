//! The samples of a domain before point handles are inserted.
//!
//! The triangulation of the lattice is nearly all of the cost of sampling. It does not depend on point handles, so a solver
//! keeps it; handles are inserted into a copy one by one, in a first solve just as in a later one, so earlier solves change
//! no bit.

use std::sync::Arc;

use glam::DVec2;

use super::{Samples, Skirt, bones, lattice, outline::OutlineSamples, refine};
use crate::{
    distance::Navigation,
    domain::Domain,
    grid::Grid,
    triangulation::{Inserted, Locator, Triangulation},
};

/// Samples of outline, bones and lattice.
#[derive(Debug)]
pub(crate) struct BaseSamples {
    samples: Samples,
    pub(super) locator: Arc<Locator>,
    count: usize,
    bones: Vec<[DVec2; 2]>,
    fading: Option<DVec2>,
}

impl BaseSamples {
    /// About `count` samples: a triangular lattice centred on the domain's bounding box, so that a symmetric domain is sampled
    /// symmetrically, and points along the outline with all its corners. `bones` are straight lines in the domain, along which the
    /// mesh has edges wherever nothing else is close. With a skirt where the picture, of size `fading`, fades out beyond the outline.
    ///
    /// Cost: O(n log n), nearly all of it for the triangulation.
    pub(crate) fn new(
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
        fading: Option<DVec2>,
    ) -> Self {
        let spacing = lattice::spacing(domain, count);
        let OutlineSamples { mut vertices, segments, rings } = OutlineSamples::new(domain, spacing);
        let on_outline = bones::add_bones(&mut vertices, bones, spacing, domain);
        let mut inner = lattice::inner_points(domain, bones, spacing, &vertices, &segments);
        // Consecutive samples then often lie in the same triangle of the outline.
        inner.sort_by_cached_key(|&p| navigation.triangle_at(p).map(|triangle| triangle.0));
        vertices.extend(inner);
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let locator = Arc::new(Locator::new(&mesh));
        let mut samples = Samples::from_mesh(mesh, navigation, rings, spacing);
        for p in on_outline {
            insert(&mut samples, navigation, &locator, p);
        }
        samples.skirt = fading.map_or_else(Skirt::default, |size| Skirt::new(&samples.mesh, &samples.outline, size));
        Self { samples, locator, count, bones: bones.to_vec(), fading }
    }

    /// Whether [`new`](Self::new) would return the same in the same domain.
    pub(crate) fn is_for(&self, bones: &[[DVec2; 2]], count: usize) -> bool {
        self.count == count && self.bones == bones
    }

    /// The samples including every site, with finer lattices where sites are closer to one another than the lattice resolves (the
    /// paper's up-sampling). `sites` must lie in the domain, be distinct,
    /// and come in an order that does not depend on earlier solves.
    ///
    /// Cost: a copy, and a walk from a nearby triangle for each inserted vertex; for finer lattices that of [`refine`].
    pub(crate) fn with_sites(&self, domain: &Domain, navigation: &Navigation, sites: &[DVec2]) -> Samples {
        let Samples { mesh, nav_triangles, outline, skirt, spacing, .. } = &self.samples;
        let mut samples = Samples {
            mesh: mesh.with_capacity_for(sites.len() + skirt.vertices.len()),
            nav_triangles: nav_triangles.clone(),
            outline: outline.clone(),
            skirt: Skirt::default(),
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
        samples.skirt = match self.fading {
            // Samples were inserted on the outline.
            Some(size) if samples.outline != self.samples.outline => Skirt::new(&samples.mesh, &samples.outline, size),
            _ => skirt.renumbered(self.samples.len(), samples.len()),
        };
        samples
    }
}

/// Inserts a point of the domain into the samples and, if it lies on the outline, into that.
fn insert(samples: &mut Samples, navigation: &Navigation, locator: &Locator, p: DVec2) -> u32 {
    let inserted = samples.mesh.insert(locator.near(p), p);
    if let Inserted::OnBoundary { vertex, between } = inserted {
        let of_edge = |pair: [u32; 2]| pair == between || [pair[1], pair[0]] == between;
        let on_ring = |ring: &Vec<u32>| (0..ring.len()).find(|&i| of_edge([ring[i], ring[(i + 1) % ring.len()]]));
        let at = samples.outline.iter().enumerate().find_map(|(at, ring)| Some((at, on_ring(ring)?)));
        let (ring, edge) = at.expect("what bounds the mesh is the outline");
        samples.outline[ring].insert(edge + 1, vertex);
    }
    if samples.nav_triangles.len() < samples.mesh.vertices.len() {
        samples.nav_triangles.push(navigation.triangle_at(p).expect("samples lie in the domain"));
    }
    inserted.vertex()
}
