//! A triangle mesh from the caller, instead of a picture's outline and samples (section V-B).
//!
//! The mesh's boundary is the outline of the domain, and its vertices are the samples. Distances and weights are
//! evaluated, not propagated along edges, so they are as exact as on the solver's own mesh. Cells are stored over
//! coarse samples of the solver, and do not depend on inner vertices.
//!
//! Cost of the checks: one lookup for each edge, and a sweep over the boundary.
//!
//! Limits: no part of a mesh may touch another.

use std::{collections::HashMap, sync::Arc};

use glam::DVec2;

use crate::{
    domain::{Domain, Ring},
    error::Error,
    limits::MAX_COORDINATE,
    prepared_domain::PreparedDomain,
    sample::Samples,
    triangulation::{NONE, Triangulation},
};

/// Least area of a triangle, in square pixels and relative to the square of its longest edge. Smaller areas are
/// rounding errors.
const MIN_AREA: f64 = 1e-12;
/// The boundary is straight at a vertex if the sine of its turning angle is below this. Paths use the same limit.
const STRAIGHT: f64 = 1e-12;

/// A checked triangle mesh, for [`solve_mesh`](crate::solve_mesh).
///
/// ```
/// use c2warp::{InputMesh, project::{Handle, Project}, solve_mesh};
///
/// // Four columns and three rows of vertices, 10 px apart.
/// let vertices = (0..12).map(|i| [f64::from(i % 4) * 10.0, f64::from(i / 4) * 10.0].into()).collect();
/// let quads = [0, 1, 2, 4, 5, 6];
/// let triangles = quads.iter().flat_map(|&a| [[a, a + 1, a + 5], [a, a + 5, a + 4]]).collect();
/// let mesh = InputMesh::new(vertices, triangles)?;
/// let left = Handle::point("left", [2.0, 9.0]);
/// let right = Handle::point("right", [30.0, 10.0]).posed_at([[30.0, 15.0]]);
/// // Of any size, as the picture is ignored.
/// let project = Project::for_picture(1, 1).with_handles([left, right]);
/// let solution = solve_mesh(&project, &mesh)?;
/// let pose = solution.pose(&project)?;
/// let posed = solution.posed_vertices(&pose);
/// assert_eq!(posed.len(), 12);
/// assert_eq!(posed[7], [30.0, 15.0].into());
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct InputMesh {
    mesh: Triangulation,
    /// Rings of the boundary × the vertices along each.
    rings: Vec<Vec<u32>>,
    pub(crate) prepared: Arc<PreparedDomain>,
}

impl InputMesh {
    /// Checks a mesh of positions in pixels and triangles × 3 vertices.
    ///
    /// Coordinates must be from −1,000,000 to 1,000,000. Triangles may have either orientation. The mesh may have
    /// several parts and holes, and parts inside holes. No part may touch another.
    ///
    /// Tolerances are in pixels, not relative to the mesh. Handles must be at least 0.01 px apart, and rounding is up
    /// to 1e-6 px. Scale a mesh with coordinates from 0 to 1, and its handles, to hundreds of pixels.
    ///
    /// # Errors
    /// One of the `Mesh…` errors, with the triangle or vertex.
    pub fn new(vertices: Vec<DVec2>, mut triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        if triangles.is_empty() {
            return Err(Error::MeshEmpty);
        }
        let is_valid = |p: &DVec2| p.is_finite() && p.abs().max_element() <= MAX_COORDINATE;
        if let Some(vertex) = vertices.iter().position(|p| !is_valid(p)) {
            return Err(Error::MeshVertex { vertex });
        }
        let mut used = vec![false; vertices.len()];
        for (triangle, corners) in triangles.iter_mut().enumerate() {
            let &mut [a, b, c] = corners;
            if [a, b, c].iter().any(|&v| v as usize >= vertices.len()) || a == b || b == c || c == a {
                return Err(Error::MeshTriangle { triangle, vertices: vertices.len() });
            }
            let [p, q, r] = corners.map(|v| vertices[v as usize]);
            let area = (q - p).perp_dot(r - p) / 2.0;
            let longest = p.distance_squared(q).max(q.distance_squared(r)).max(r.distance_squared(p));
            if area.abs() <= MIN_AREA * longest.max(1.0) {
                return Err(Error::MeshTriangleFlat { triangle });
            }
            if area < 0.0 {
                corners.swap(1, 2);
            }
            for &v in &*corners {
                used[v as usize] = true;
            }
        }
        if let Some(vertex) = used.iter().position(|used| !used) {
            return Err(Error::MeshVertexLoose { vertex });
        }
        let neighbours = neighbours(&triangles)?;
        let mesh = Triangulation { vertices, triangles, neighbours };
        let rings = boundary(&mesh)?;
        let corners: Vec<Vec<u32>> = rings.iter().map(|ring| turning_vertices(&mesh.vertices, ring)).collect();
        let position = |&v: &u32| mesh.vertices[v as usize];
        let domain =
            Domain::from_oriented(corners.iter().map(|ring| ring.iter().map(position).collect::<Ring>()).collect());
        let domain = domain.map_err(|error| mesh_error(error, &corners))?;
        Ok(Self { mesh, rings, prepared: Arc::new(PreparedDomain::without_picture(domain)) })
    }

    /// The vertices as samples.
    pub(crate) fn samples(&self) -> Samples {
        // The distance between vertices is unknown.
        Samples::from_mesh(self.mesh.clone(), &self.prepared.navigation, self.rings.clone(), f64::NAN)
    }
}

/// Triangles × 3 edges: the triangle across each edge; [`NONE`] on the boundary.
///
/// Triangles have positive orientation, so two neighbours run along their edge in opposite directions.
fn neighbours(triangles: &[[u32; 3]]) -> Result<Vec<[u32; 3]>, Error> {
    let mut beside: HashMap<[u32; 2], usize> = HashMap::with_capacity(triangles.len() * 3);
    for (triangle, corners) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            if let Some(other) = beside.insert([from, to], triangle) {
                return Err(Error::MeshEdge { triangle, other, from: from as usize, to: to as usize });
            }
        }
    }
    let across = |a: u32, b: u32| beside.get(&[b, a]).map_or(NONE, |&t| t as u32);
    Ok(triangles.iter().map(|&[a, b, c]| [across(a, b), across(b, c), across(c, a)]).collect())
}

/// The rings of vertices along the boundary, with the mesh to their right.
fn boundary(mesh: &Triangulation) -> Result<Vec<Vec<u32>>, Error> {
    let mut next = vec![NONE; mesh.vertices.len()];
    for (corners, neighbours) in mesh.triangles.iter().zip(&mesh.neighbours) {
        for k in (0..3).filter(|&k| neighbours[k] == NONE) {
            let vertex = corners[k] as usize;
            if next[vertex] != NONE {
                return Err(Error::MeshPinched { vertex });
            }
            next[vertex] = corners[(k + 1) % 3];
        }
    }
    let mut rings = Vec::new();
    for start in 0..next.len() {
        let (mut ring, mut v) = (Vec::new(), start);
        while next[v] != NONE {
            ring.push(v as u32);
            v = std::mem::replace(&mut next[v], NONE) as usize;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    Ok(rings)
}

/// The vertices at which a ring turns. Paths never bend at the others.
fn turning_vertices(vertices: &[DVec2], ring: &[u32]) -> Vec<u32> {
    let n = ring.len();
    let position = |i: usize| vertices[ring[i % n] as usize];
    let is_turn = |i: usize| {
        let (before, after) =
            ((position(i) - position(i + n - 1)).normalize(), (position(i + 1) - position(i)).normalize());
        before.perp_dot(after).abs() > STRAIGHT || before.dot(after) < 0.0
    };
    (0..n).filter(|&i| is_turn(i)).map(|i| ring[i]).collect()
}

/// Translates an error of the outline's rings into one of the mesh.
fn mesh_error(error: Error, corners: &[Vec<u32>]) -> Error {
    let vertex = |ring: usize, point: usize| corners[ring][point] as usize;
    match error {
        Error::RingDuplicate { ring, point, other_ring, other_point }
        | Error::RingsCross { ring, point, other_ring, other_point } => {
            Error::MeshCrosses { vertex: vertex(ring, point), other: vertex(other_ring, other_point) }
        }
        Error::RingsTooFine { corners } => Error::MeshTooFine { corners },
        Error::RingFlat { ring } => Error::MeshCovered { vertex: vertex(ring, 0) },
        other => other,
    }
}
