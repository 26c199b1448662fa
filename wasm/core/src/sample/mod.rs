//! 𝒫: points all over the domain, with a constrained Delaunay mesh over them (paper, section V-B).
//!
//! Samples carry the cells and the drawn mesh. Distances and weights do not depend on them: those are evaluated.

mod bones;
mod lattice;
mod outline;
mod refine;
mod rim;

use glam::DVec2;

use crate::{
    distance::{Navigation, Place, graph::Graph},
    domain::Domain,
    locate::Locator,
    triangulation::{NONE, Triangulation},
};

pub use rim::Rim;

/// Samples of a domain.
#[derive(Debug, Clone)]
pub struct Samples {
    /// The mesh over the samples.
    pub mesh: Triangulation,
    /// Edges of the mesh.
    pub graph: Graph,
    /// Where each sample lies on the navigation mesh.
    pub places: Vec<Place>,
    /// Length of the longest edge at each sample, in pixels.
    pub reach: Vec<f64>,
    /// Length of the longest edge of all.
    pub longest_edge: f64,
    /// Chains of samples along the outline, as closed rings in the order of the domain's rings.
    pub outline: Vec<Vec<u32>>,
    /// The sample at each real site; empty where the samples were there before the sites.
    pub at_sites: Vec<u32>,
    /// Distance between samples away from the outline and from close sites, in pixels.
    pub spacing: f64,
    locator: Locator,
}

impl Samples {
    /// About `count` samples: a triangular lattice centred on the domain's bounding box, so that a symmetric domain is
    /// sampled symmetrically; points along the outline with all its corners; every site; and finer lattices where sites
    /// are closer to one another than the lattice resolves (the paper's up-sampling).
    ///
    /// `sites` must lie in the domain and be distinct; `bones` are straight lines in it, along which there are edges of the
    /// mesh wherever nothing else is close.
    ///
    /// Cost: O(n log n); nearly all of it is the triangulation.
    #[must_use]
    pub fn new(domain: &Domain, navigation: &Navigation, sites: &[DVec2], bones: &[[DVec2; 2]], count: usize) -> Self {
        let spacing = lattice::spacing(domain, count);
        let mut points = outline::Outline::new(domain, sites, spacing);
        let mut at_sites = Vec::with_capacity(sites.len());
        for &site in sites {
            at_sites.push(points.place_site(site));
        }
        let mut vertices = points.vertices;
        bones::add_bones(&mut vertices, bones, spacing);
        let patches = refine::patches(sites, spacing);
        let taken = vertices.len();
        vertices.extend(lattice::inner_points(domain, sites, bones, spacing, &vertices[..taken], &points.segments));
        refine::add_patches(&mut vertices, &patches, navigation, domain);
        // What asks about samples in turn then asks for the same place again and again.
        vertices[taken..].sort_by_cached_key(|&p| navigation.place(p).map(|place| place.0));
        let mesh = Triangulation::constrained_delaunay(vertices, points.segments);
        Self::from_mesh(mesh, navigation, points.rings, at_sites, spacing)
    }

    /// The samples that the vertices of a mesh are. Its `outline` is given as rings of vertices; sites need not be among them.
    pub(crate) fn from_mesh(
        mesh: Triangulation,
        navigation: &Navigation,
        outline: Vec<Vec<u32>>,
        at_sites: Vec<u32>,
        spacing: f64,
    ) -> Self {
        let edges = mesh.triangles.iter().zip(&mesh.neighbours).enumerate().flat_map(|(t, (corners, neighbours))| {
            // Each inner edge once: from the triangle of lower number.
            let once = move |&k: &usize| neighbours[k] == NONE || t < neighbours[k] as usize;
            (0..3).filter(once).map(move |k| (corners[k], corners[(k + 1) % 3]))
        });
        let graph = Graph::from_edges(mesh.vertices.len(), edges);
        let longest = |v: usize| {
            let lengths = graph.of(v).iter().map(|&n| mesh.vertices[v].distance_squared(mesh.vertices[n as usize]));
            lengths.fold(0.0, f64::max).sqrt()
        };
        let reach: Vec<f64> = (0..mesh.vertices.len()).map(longest).collect();
        let longest_edge = reach.iter().copied().fold(0.0, f64::max);
        let place = |&p: &DVec2| navigation.place(p).expect("samples lie in the domain");
        let places = mesh.vertices.iter().map(place).collect();
        let locator = Locator::new(&mesh);
        Self { mesh, graph, places, reach, longest_edge, outline, at_sites, spacing, locator }
    }

    /// The corners of the mesh triangle that holds a point of the domain.
    #[must_use]
    pub fn around(&self, p: DVec2) -> Option<[u32; 3]> {
        self.locator.locate(&self.mesh, p).map(|t| self.mesh.triangles[t])
    }

    /// Number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.mesh.vertices.len()
    }

    /// Whether there is no sample, which no domain has.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mesh.vertices.is_empty()
    }
}
