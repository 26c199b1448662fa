//! A mesh of few vertices over the visible part of a picture, for game engines.
//!
//! The outline comes first: it encloses all visible pixels, with as few corners as a tolerance allows. The tolerance
//! grows until corners are at most half of the vertices. A lattice fills the rest. Vertices outside the domain have the
//! weights of its nearest point, like those of the skirt.
//!
//! Cost: linear in the pixels, plus about forty lattices, and a visit of the whole outline for each vertex outside.
//!
//! Known limits: specks are left out, and parts closer than a few pixels are joined.

use glam::DVec2;

use crate::{
    deform::{Adjacency, DepthOrder, Pose, PosedMesh, depths, topological},
    domain::{Domain, VisiblePixels},
    picture::Picture,
    render_mesh::leading_parts,
    sample::SpriteSamples,
    segment::nearest_on_segment,
    solution::Solution,
    triangulation::Triangulation,
    weight::SparseWeights,
};

/// The finest tolerance of the outline, in pixels: hardly visible on an edge.
const FINEST_PX: f64 = 0.5;
/// Factor from one tolerance to the next.
const COARSER: f64 = 1.4;
/// The coarsest tolerance, as a fraction of the picture's diagonal: 33 px in a picture of 1024 × 1280 px.
const COARSEST: f64 = 0.02;
/// Corners of the outline may be this fraction of the vertices, unless the coarsest tolerance is reached.
const OUTLINE_SHARE: f64 = 0.5;
/// The corners of the picture, in a mesh with a background.
const PICTURE_CORNERS: usize = 4;

/// A mesh of few vertices with the weights of a solution.
///
/// ```
/// # use c2warp::{Picture, SpriteMesh, project::{Handle, Project}, solve};
/// # let rgba = vec![255; 40 * 30 * 4];
/// # let mut project = Project::for_picture(40, 30);
/// # project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
/// let picture = Picture::new(40, 30, &rgba)?;
/// let solution = solve(&project, &picture)?;
/// let mesh = SpriteMesh::new(&solution, &picture, 60)?;
/// assert!((40..=60).contains(&mesh.vertices().len()));
/// let posed = mesh.posed_vertices(&solution.pose(&project)?);
/// assert!(posed.iter().zip(mesh.vertices()).all(|(posed, rest)| posed.distance(*rest) < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SpriteMesh {
    vertices: Vec<DVec2>,
    displaced: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    /// The triangles of the static background come first.
    behind: usize,
    weights: SparseWeights,
    hull: Vec<u32>,
    tolerance: f64,
}

/// The outline needs more vertices than requested.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the outline alone needs {least} vertices, but only {asked} are allowed")]
#[non_exhaustive]
pub struct TooFewVertices {
    /// The requested number.
    pub asked: usize,
    /// The minimum number.
    pub least: usize,
}

impl SpriteMesh {
    /// A mesh of at most `most` vertices for a solution of this picture.
    ///
    /// # Errors
    /// [`TooFewVertices`] if the outline needs more, even with a tolerance of 2 % of the picture's diagonal.
    pub fn new(solution: &Solution, picture: &Picture, most: usize) -> Result<Self, TooFewVertices> {
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        let has_background = !solution.static_background().triangles().is_empty();
        let room = most.saturating_sub(if has_background { PICTURE_CORNERS } else { 0 });
        let too_few = |corners: usize| TooFewVertices { asked: most, least: corners + most - room };
        let Outline { domain, tolerance } = Outline::new(solution, picture, room, has_background).map_err(too_few)?;
        let corners = |domain: &Domain| domain.rings().iter().map(Vec::len).sum::<usize>();
        let SpriteSamples { vertices, segments } = SpriteSamples::new(&domain, room, has_background)
            .ok_or_else(|| too_few(corners(&domain) * (1 + usize::from(has_background))))?;
        let on_outline = vertices[..segments.len()].to_vec();
        let first_ring = segments.iter().position(|[a, b]| b <= a).map_or(0, |last| last + 1);
        let Triangulation { vertices, triangles, .. } = Triangulation::constrained_delaunay(vertices, segments.clone());
        let weights = weights_around(solution, &vertices);
        let triangles = by_part(solution, &weights, triangles);
        let displaced = solution.poser().displaced(&vertices).into_owned();
        let hull = (0..first_ring as u32).collect();
        let mut mesh = Self { behind: 0, hull, vertices, displaced, triangles, weights, tolerance };
        if domain.rings().len() > 1 {
            mesh.hull.clear();
        }
        if has_background {
            mesh.add_background(size, &on_outline, &segments);
        }
        Ok(mesh)
    }

    /// Vertices at rest, in image pixels. Those of the outline come first, and those of the static background last.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// The [`vertices`](Self::vertices) before the handles pose them, displaced as in the solution's project. Those of
    /// the static background do not move.
    #[must_use]
    pub fn displaced_vertices(&self) -> &[DVec2] {
        &self.displaced
    }

    /// Triangles × 3 vertices, those of the static background first.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The weights of the vertices, vertices × sites. A vertex that does not move has no weights.
    #[must_use]
    pub fn weights(&self) -> &SparseWeights {
        &self.weights
    }

    /// The vertices around the mesh, or `None` if it has several parts, holes or a background.
    #[must_use]
    pub fn hull(&self) -> &[u32] {
        &self.hull
    }

    /// The maximum distance between the outline and that of the visible pixels or of the domain, in pixels.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The posed vertices.
    ///
    /// # Panics
    /// If the pose belongs to a solution with fewer sites.
    #[must_use]
    pub fn posed_vertices(&self, pose: &Pose) -> Vec<DVec2> {
        pose.blend_places(&self.displaced, &self.weights)
    }

    /// One order of the triangles for several poses, by the depths of the first one. Where parts cross in any pose, one
    /// lies completely in front, unless the poses contradict each other.
    ///
    /// # Panics
    /// Without a pose, or for a pose of a solution with fewer sites.
    #[must_use]
    pub fn drawn_triangles(&self, poses: &[Pose]) -> Vec<[u32; 3]> {
        let (still, moving) = self.triangles.split_at(self.behind);
        let by_depth = |pose: &Pose| DepthOrder::new(moving, &self.weights, &depths(pose.motions()));
        let adjacency = Adjacency::new(moving);
        let mut pairs = Vec::new();
        for pose in poses {
            let posed = self.posed_vertices(pose);
            let mesh = PosedMesh { rest: &self.vertices, posed: &posed, triangles: moving };
            pairs.extend(by_depth(pose).pairs(moving, &adjacency.crossings(mesh)));
        }
        // A pair that several poses agree on counts once; of two that contradict each other, the first pose's wins.
        let mut seen = std::collections::BTreeSet::new();
        pairs.retain(|&[front, back]| !seen.contains(&[back, front]) && seen.insert([front, back]));
        let base = by_depth(poses.first().expect("at least one pose")).order(moving.len());
        let order = topological(&base, &pairs);
        still.iter().copied().chain(order.into_iter().map(|t| moving[t as usize])).collect()
    }

    /// Adds the static picture around the outline.
    fn add_background(&mut self, size: DVec2, on_outline: &[DVec2], segments: &[[usize; 2]]) {
        let mut vertices = on_outline.to_vec();
        vertices.extend([DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)]);
        let Triangulation { vertices, triangles, .. } =
            Triangulation::constrained_delaunay_outside(vertices, segments.to_vec());
        let first = self.vertices.len() as u32;
        for _ in &vertices {
            self.weights.push_row(std::iter::empty());
        }
        self.displaced.extend(&vertices);
        self.vertices.extend(vertices);
        self.behind = triangles.len();
        self.triangles.splice(0..0, triangles.into_iter().map(|t| t.map(|vertex| first + vertex)));
        self.hull.clear();
    }
}

/// The outline of a mesh.
struct Outline {
    domain: Domain,
    tolerance: f64,
}

impl Outline {
    /// The finest outline with few corners, or else the coarsest that fits. An error contains its number of corners.
    fn new(solution: &Solution, picture: &Picture, room: usize, again: bool) -> Result<Self, usize> {
        let visible = solution.draws_around().then(|| VisiblePixels::new(picture));
        let diagonal = libm::hypot(f64::from(picture.width()), f64::from(picture.height()));
        let (mut tolerance, mut fitting, mut least) = (FINEST_PX, None, usize::MAX);
        while tolerance <= FINEST_PX.max(COARSEST * diagonal) {
            let domain = match &visible {
                Some(pixels) => pixels.region(tolerance),
                None => solution.domain().simplified(tolerance),
            };
            if let Some(domain) = domain {
                let corners = domain.rings().iter().map(Vec::len).sum::<usize>() * (1 + usize::from(again));
                least = least.min(corners);
                if corners <= room {
                    fitting = Some(Self { domain, tolerance });
                }
                if corners as f64 <= OUTLINE_SHARE * room as f64 {
                    break;
                }
            }
            tolerance *= COARSER;
        }
        fitting.ok_or(least)
    }
}

/// The weights of points in the domain or around it.
fn weights_around(solution: &Solution, points: &[DVec2]) -> SparseWeights {
    let domain = solution.domain();
    let nearest = |p: DVec2| {
        let on_edges = domain.edges().map(|(a, b)| nearest_on_segment(p, a, b));
        on_edges.min_by(|a, b| a.distance_squared(p).total_cmp(&b.distance_squared(p))).unwrap_or(p)
    };
    let inside: Vec<DVec2> =
        points.iter().map(|&p| if solution.navigation().triangle_at(p).is_some() { p } else { nearest(p) }).collect();
    solution.weights_of(&inside)
}

/// The triangles with lower parts after upper ones, as [`Solution::triangles`] has them.
fn by_part(solution: &Solution, weights: &SparseWeights, mut triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    let strongest = |vertex: usize| {
        let heavier = |best: (usize, f64), one: (usize, f64)| if one.1 > best.1 { one } else { best };
        weights.row(vertex).reduce(heavier).map_or(u32::MAX, |(site, _)| site as u32)
    };
    let strongest: Vec<u32> = (0..weights.len()).map(strongest).collect();
    let parts = leading_parts(&strongest, &solution.solved.sites, &solution.solved.harmonic);
    triangles.sort_by_key(|corners| parts[corners[0] as usize]);
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        project::{DomainSpec, Handle, Project},
        solve,
    };

    /// A disc of radius 40 px with a handle at either side.
    fn disc() -> (Project, Vec<u8>) {
        let is_opaque = |x: i32, y: i32| (x - 50).pow(2) + (y - 50).pow(2) < 1600;
        let rgba = (0..100 * 100).flat_map(|i| [9, 9, 9, if is_opaque(i % 100, i / 100) { 255 } else { 0 }]).collect();
        let mut project = Project::for_picture(100, 100);
        project.handles = vec![Handle::point("left", [20.0, 50.0]), Handle::point("right", [80.0, 50.0])];
        (project, rgba)
    }

    #[test]
    fn vertices_outside_the_domain_move_with_its_edge() {
        let (mut project, rgba) = disc();
        let picture = Picture::new(100, 100, &rgba).unwrap();
        let solution = solve(&project, &picture).unwrap();
        let mesh = SpriteMesh::new(&solution, &picture, 80).unwrap();
        assert!(mesh.vertices().len() <= 80 && mesh.hull().len() > 8);
        let radii = mesh.hull().iter().map(|&v| mesh.vertices()[v as usize].distance(DVec2::splat(50.0)));
        assert!(radii.clone().all(|radius| radius > 40.0 && radius < 44.0), "{:?}", radii.collect::<Vec<_>>());
        project.handles.iter_mut().for_each(|handle| handle.shape.posed_mut()[0].y += 9.0);
        let posed = mesh.posed_vertices(&solution.pose(&project).unwrap());
        let moved = posed.iter().zip(mesh.vertices()).map(|(posed, rest)| *posed - *rest);
        assert!(moved.clone().all(|by| by.distance(DVec2::new(0.0, 9.0)) < 1e-9), "{:?}", moved.collect::<Vec<_>>());
    }

    #[test]
    fn a_background_covers_the_rest_of_the_picture_once() {
        let (mut project, rgba) = disc();
        let ring = [(10.0, 30.0), (90.0, 30.0), (90.0, 70.0), (10.0, 70.0)].map(DVec2::from).to_vec();
        project.domain = Some(DomainSpec::polygon(vec![ring]));
        let picture = Picture::new(100, 100, &rgba).unwrap();
        let solution = solve(&project, &picture).unwrap();
        let mesh = SpriteMesh::new(&solution, &picture, 60).unwrap();
        assert!(mesh.vertices().len() <= 60);
        let area = |[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|&vertex| mesh.vertices()[vertex as usize]);
            (b - a).perp_dot(c - a) / 2.0
        };
        assert!((mesh.triangles().iter().map(area).sum::<f64>() - 10_000.0).abs() < 1e-6);
        assert_eq!(mesh.drawn_triangles(&[solution.pose(&project).unwrap()]).len(), mesh.triangles().len());
    }

    #[test]
    fn too_few_vertices_are_refused_with_the_least_number() {
        let (project, rgba) = disc();
        let picture = Picture::new(100, 100, &rgba).unwrap();
        let solution = solve(&project, &picture).unwrap();
        let TooFewVertices { asked, least, .. } = SpriteMesh::new(&solution, &picture, 2).unwrap_err();
        assert_eq!(asked, 2);
        assert!(SpriteMesh::new(&solution, &picture, least - 1).is_err());
        assert_eq!(SpriteMesh::new(&solution, &picture, least).unwrap().vertices().len(), least);
    }
}
