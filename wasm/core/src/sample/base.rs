//! The samples of a domain before point handles are inserted.
//!
//! They do not depend on point handles, so a solver keeps them. Handles are inserted into a copy one by one, in the
//! first solve and in later ones alike. Earlier solves therefore do not change a bit of the result.

use std::sync::Arc;

use glam::DVec2;

use super::{
    band, bones, feather::Feather, fringe, lattice, nav_scan, nearby::Nearby, nodes::Nodes, outline::OutlineSamples,
    refine, samples::Samples, shown::shows_all, skirt::Skirt,
};
use crate::{
    distance::{NavTriangle, Navigation},
    grid::Grid,
    join::join,
    prepared_domain::PreparedDomain,
    triangulation::Inserted,
};

/// Samples of outline, bones and lattice.
#[derive(Debug)]
pub(crate) struct BaseSamples {
    samples: Samples,
    pub(super) nearby: Arc<Nearby>,
    count: usize,
    bones: Vec<[DVec2; 2]>,
}

impl BaseSamples {
    /// About `count` samples: points along the outline with all its corners, and a triangular lattice inside.
    ///
    /// The lattice is centred on the domain's bounding box, so samples of a symmetric domain are symmetric. `bones`
    /// are straight lines in the domain. The mesh has edges along them where no other sample is close.
    ///
    /// Cost: O(n) for n samples, plus the cost of [`band`] for samples near the outline and bones.
    pub(crate) fn new(prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> Self {
        let spacing = lattice::spacing(&prepared.domain, count);
        Self::of_outline(OutlineSamples::new(&prepared.domain, spacing), prepared, bones, count)
    }

    /// The same samples with a skirt and a feather, if the domain needs them.
    ///
    /// Cost: the same, plus that of the skirt, on two cores.
    pub(super) fn with_skirt(prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> Self {
        let spacing = lattice::spacing(&prepared.domain, count);
        let outline = OutlineSamples::new(&prepared.domain, spacing);
        let (rings, vertices) = (outline.rings.clone(), outline.vertices.clone());
        let (skirt, mut base) = join(
            || NarrowSkirt::new(&vertices, &rings, prepared),
            || Self::of_outline(outline, prepared, bones, count),
        );
        let Self { samples, .. } = &mut base;
        samples.skirt = if samples.outline == rings {
            skirt.renumbered(vertices.len(), samples.len()).completed(samples, prepared)
        } else {
            // Bones have samples on the outline.
            NarrowSkirt::new(&samples.mesh.vertices, &samples.outline, prepared).completed(samples, prepared)
        };
        samples.feather = Feather::new(&samples.mesh, &samples.outline, prepared);
        base
    }

    /// The samples of an outline, with those inside.
    fn of_outline(outline: OutlineSamples, prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> Self {
        let PreparedDomain { domain, navigation, .. } = prepared;
        let OutlineSamples { mut vertices, segments, rings, spacing } = outline;
        let on_outline = bones::add_bones(&mut vertices, bones, spacing, domain);
        let others = vertices.len();
        let nodes = Nodes::new(domain, bones, spacing, &vertices, &segments);
        let mut nav_triangles: Vec<NavTriangle> = vertices.iter().map(|&p| located(navigation, p)).collect();
        let of_nodes = add_nodes(&nodes, navigation, &mut vertices, &mut nav_triangles);
        let (mesh, nearby) = band::mesh(vertices, segments, others, nodes, &of_nodes);
        let nearby = Arc::new(nearby);
        let mut samples = Samples::new(mesh, nav_triangles, rings, spacing);
        for p in on_outline {
            insert(&mut samples, navigation, &nearby, p);
        }
        Self { samples, nearby, count, bones: bones.to_vec() }
    }

    /// Whether these samples were made for the same bones and count.
    pub(super) fn is_for(&self, bones: &[[DVec2; 2]], count: usize) -> bool {
        self.count == count && self.bones == bones
    }

    /// A copy with a sample at every site, and finer lattices around close sites (the paper's up-sampling).
    ///
    /// `sites` must lie in the domain and be distinct. The order of sites must not depend on earlier solves.
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
            insert(&mut samples, navigation, &self.nearby, site);
        }
        let patches = refine::patches(sites, samples.spacing);
        if !patches.is_empty() {
            let [low, high] = refine::bounds(&patches);
            let vertices = samples.mesh.vertices.iter().filter(|p| p.clamp(low, high) == **p);
            let mut known = Grid::new(samples.spacing, vertices.map(|&p| (p, p)));
            for patch in patches {
                for node in patch.clear_nodes(&known, navigation, domain) {
                    let vertex = insert(&mut samples, navigation, &self.nearby, node);
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
            let skirt = NarrowSkirt::new(&samples.mesh.vertices, &samples.outline, prepared);
            samples.skirt = skirt.completed(&samples, prepared);
            samples.feather = Feather::new(&samples.mesh, &samples.outline, prepared);
        }
        samples
    }
}

/// Adds the lattice's nodes to the vertices, in the order of their navigation triangles. Consecutive samples then often
/// lie in the same one. Returns the vertex of each node.
fn add_nodes(
    nodes: &Nodes,
    navigation: &Navigation,
    vertices: &mut Vec<DVec2>,
    nav_triangles: &mut Vec<NavTriangle>,
) -> Vec<u32> {
    let found = nav_scan::nav_triangles(nodes, navigation);
    // A counting sort.
    let mut next = vec![0; navigation.triangles().count() + 1];
    nodes.positions().for_each(|(number, _)| next[found[number].0 as usize + 1] += 1);
    let mut sum = vertices.len() as u32;
    for count in &mut next {
        sum += *count;
        *count = sum;
    }
    vertices.resize(sum as usize, DVec2::ZERO);
    nav_triangles.resize(sum as usize, NavTriangle(0));
    let mut of_nodes = vec![0; nodes.numbers()];
    for (number, p) in nodes.positions() {
        let triangle = found[number];
        let vertex = &mut next[triangle.0 as usize];
        (vertices[*vertex as usize], nav_triangles[*vertex as usize], of_nodes[number]) = (p, triangle, *vertex);
        *vertex += 1;
    }
    of_nodes
}

fn located(navigation: &Navigation, p: DVec2) -> NavTriangle {
    navigation.triangle_at(p).expect("samples lie in the domain")
}

/// A skirt without a fringe.
struct NarrowSkirt {
    skirt: Skirt,
    /// Whether it draws the whole picture.
    is_enough: bool,
}

impl NarrowSkirt {
    /// The skirt of samples. It is empty if the picture ends at the outline.
    fn new(samples: &[DVec2], outline: &[Vec<u32>], prepared: &PreparedDomain) -> Self {
        let Some(opacity) = &prepared.around else { return Self { skirt: Skirt::default(), is_enough: true } };
        let skirt = Skirt::new(samples, outline, opacity.size());
        let is_enough = shows_all(samples, outline, &skirt, opacity);
        Self { skirt, is_enough }
    }

    /// See [`Skirt::renumbered`].
    fn renumbered(self, before: usize, now: usize) -> Self {
        Self { skirt: self.skirt.renumbered(before, now), ..self }
    }

    /// The skirt with a fringe if it does not draw the whole picture.
    fn completed(self, Samples { mesh, outline, .. }: &Samples, prepared: &PreparedDomain) -> Skirt {
        let Self { skirt, is_enough } = self;
        let Some(opacity) = prepared.around.as_ref().filter(|_| !is_enough) else { return skirt };
        let size = opacity.size();
        skirt.with_fringe(mesh, outline, opacity, fringe::spacing(size.x * size.y))
    }
}

/// Inserts a point of the domain into the samples, and into their outline if it lies there. Returns its vertex.
fn insert(samples: &mut Samples, navigation: &Navigation, nearby: &Nearby, p: DVec2) -> u32 {
    let inserted = samples.mesh.insert(nearby.triangle(p), p);
    if let Inserted::OnBoundary { vertex, between } = inserted {
        let of_edge = |pair: [u32; 2]| pair == between || [pair[1], pair[0]] == between;
        let on_ring = |ring: &Vec<u32>| (0..ring.len()).find(|&i| of_edge([ring[i], ring[(i + 1) % ring.len()]]));
        let at = samples.outline.iter().enumerate().find_map(|(at, ring)| Some((at, on_ring(ring)?)));
        let (ring, edge) = at.expect("the outline bounds the mesh");
        samples.outline[ring].insert(edge + 1, vertex);
    }
    if samples.nav_triangles.len() < samples.mesh.vertices.len() {
        samples.nav_triangles.push(located(navigation, p));
    }
    inserted.vertex()
}
