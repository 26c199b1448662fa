//! The samples of a domain before its point handles are among them.
//!
//! Nearly all that sampling costs is the triangulation of the lattice. It does not depend on point handles, so a solver keeps it;
//! handles are inserted into a copy, one by one, in a solve from nothing just as in one that follows another: so what was
//! solved before changes no bit.

use std::sync::Arc;

use glam::DVec2;

use super::{Rim, Samples, bones, lattice, outline::Outline, refine};
use crate::{
    distance::Navigation,
    domain::Domain,
    locate::Locator,
    triangulation::{Inserted, Triangulation},
};

/// Samples of outline, bones and lattice.
#[derive(Debug)]
pub(crate) struct Ground {
    samples: Samples,
    pub(super) locator: Arc<Locator>,
    count: usize,
    bones: Vec<[DVec2; 2]>,
    fading: Option<DVec2>,
}

impl Ground {
    /// About `count` samples: see [`Samples::new`]. With a rim where the picture, of size `fading`, fades out beyond the outline.
    ///
    /// Cost: O(n log n); nearly all of it is the triangulation.
    pub(crate) fn new(
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
        fading: Option<DVec2>,
    ) -> Self {
        let spacing = lattice::spacing(domain, count);
        let Outline { mut vertices, segments, rings } = Outline::new(domain, spacing);
        let on_outline = bones::add_bones(&mut vertices, bones, spacing, domain);
        let mut inner = lattice::inner_points(domain, bones, spacing, &vertices, &segments);
        // What asks about samples in turn then asks for the same place again and again.
        inner.sort_by_cached_key(|&p| navigation.place(p).map(|place| place.0));
        vertices.extend(inner);
        let mesh = Triangulation::constrained_delaunay(vertices, segments);
        let locator = Arc::new(Locator::new(&mesh));
        let mut samples = Samples::from_mesh(mesh, navigation, rings, spacing);
        for p in on_outline {
            insert(&mut samples, navigation, &locator, p);
        }
        samples.rim = fading.map_or_else(Rim::default, |size| Rim::new(&samples.mesh, &samples.outline, size));
        Self { samples, locator, count, bones: bones.to_vec(), fading }
    }

    /// Whether it is what [`new`](Self::new) would make, in the same domain.
    pub(crate) fn is_for(&self, bones: &[[DVec2; 2]], count: usize) -> bool {
        self.count == count && self.bones == bones
    }

    /// The samples with every site among them, and finer lattices where sites are close to one another. `sites` must lie in the
    /// domain, be distinct, and come in an order that does not depend on what came before.
    ///
    /// Cost: a copy, and a walk from a triangle nearby for each vertex that is added. Each patch looks at all vertices, and each of its
    /// nodes at those near: half a second for 250 sites, all closer to others than 10,000 samples resolve.
    pub(crate) fn with_sites(&self, domain: &Domain, navigation: &Navigation, sites: &[DVec2]) -> Samples {
        let Samples { mesh, places, outline, rim, spacing, .. } = &self.samples;
        let mut samples = Samples {
            mesh: mesh.with_room(sites.len() + rim.vertices.len()),
            places: places.clone(),
            outline: outline.clone(),
            rim: Rim::default(),
            at_sites: Vec::new(),
            spacing: *spacing,
        };
        samples.at_sites = sites.iter().map(|&site| insert(&mut samples, navigation, &self.locator, site)).collect();
        for patch in refine::patches(sites, samples.spacing) {
            for node in patch.clear_nodes(&samples.mesh.vertices, navigation, domain) {
                insert(&mut samples, navigation, &self.locator, node);
            }
        }
        samples.rim = match self.fading {
            // The outline has more samples than it had.
            Some(size) if samples.outline != self.samples.outline => Rim::new(&samples.mesh, &samples.outline, size),
            _ => rim.renumbered(self.samples.len(), samples.len()),
        };
        samples
    }
}

/// Adds a point of the domain to samples; on the outline, to that too.
fn insert(samples: &mut Samples, navigation: &Navigation, locator: &Locator, p: DVec2) -> u32 {
    let inserted = samples.mesh.insert(locator.near(p), p);
    if let Inserted::OnBoundary { vertex, between } = inserted {
        let of_edge = |pair: [u32; 2]| pair == between || [pair[1], pair[0]] == between;
        let on_ring = |ring: &Vec<u32>| (0..ring.len()).find(|&i| of_edge([ring[i], ring[(i + 1) % ring.len()]]));
        let at = samples.outline.iter().enumerate().find_map(|(at, ring)| Some((at, on_ring(ring)?)));
        let (ring, edge) = at.expect("what bounds the mesh is the outline");
        samples.outline[ring].insert(edge + 1, vertex);
    }
    if samples.places.len() < samples.mesh.vertices.len() {
        samples.places.push(navigation.place(p).expect("samples lie in the domain"));
    }
    inserted.vertex()
}
