//! The mesh between the triangles of the lattice and the outline.
//!
//! A constrained Delaunay triangulation fills it. Its constraints are the outline and the border of the lattice's
//! triangles, which are Delaunay, too. So the result is the constrained Delaunay mesh of all vertices.
//!
//! Cost: O(b log b) for b vertices along the outline, on bones, and on the lattice's border.

use glam::DVec2;

use super::{lattice_triangles::LatticeTriangles, nearby::Nearby, nodes::Nodes};
use crate::triangulation::{Locator, NONE, Triangulation};

/// Number of triangles of the band for each vertex on the outline or on a bone, usually an overestimate.
const ROOM: usize = 4;

/// An edge of a lattice triangle without a neighbour.
struct BorderEdge {
    ends: [u32; 2],
    triangle: usize,
    side: usize,
}

/// The constrained Delaunay mesh inside closed chains of `segments`, and an index of its triangles.
///
/// `of_nodes` are the vertices of the lattice's nodes. The `others` other vertices come first.
pub(super) fn mesh(
    vertices: Vec<DVec2>,
    segments: Vec<[usize; 2]>,
    others: usize,
    nodes: Nodes,
    of_nodes: &[u32],
) -> (Triangulation, Nearby) {
    let lattice = LatticeTriangles::new(&nodes, &vertices[..others]);
    let (mut triangles, mut neighbours) = lattice.mesh(&nodes, of_nodes, ROOM * others);
    let mut border = border(&triangles, &neighbours);
    // The vertices of the band: those without a lattice triangle, and those on its border.
    let mut is_in_band = vec![false; vertices.len()];
    is_in_band[..others].fill(true);
    border.iter().flat_map(|edge| edge.ends).for_each(|v| is_in_band[v as usize] = true);
    for number in (0..nodes.numbers()).filter(|&number| nodes.is_node(number) && !lattice.has_corner(number)) {
        is_in_band[of_nodes[number] as usize] = true;
    }
    let mut number = vec![0; vertices.len()];
    let mut of_band = Vec::new();
    for v in (0..vertices.len()).filter(|&v| is_in_band[v]) {
        number[v] = of_band.len();
        of_band.push(v as u32);
    }
    let mut constraints = segments;
    constraints.extend(border.iter().map(|edge| edge.ends.map(|v| number[v as usize])));
    let places = of_band.iter().map(|&v| vertices[v as usize]).collect();
    let band = Triangulation::constrained_delaunay(places, constraints);
    let first = triangles.len() as u32;
    let nearby = Nearby::new(nodes, lattice, Locator::new(&band), first);
    triangles.extend(band.triangles.iter().map(|corners| corners.map(|v| of_band[v as usize])));
    let beyond = |neighbour: u32| if neighbour == NONE { NONE } else { first + neighbour };
    neighbours.extend(band.neighbours.iter().map(|beside| beside.map(beyond)));
    sew(&triangles, &mut neighbours, first as usize, &mut border);
    (Triangulation { vertices, triangles, neighbours }, nearby)
}

/// The edges of triangles without a neighbour.
fn border(triangles: &[[u32; 3]], neighbours: &[[u32; 3]]) -> Vec<BorderEdge> {
    let edge = |triangle: usize, side: usize| {
        let corners = triangles[triangle];
        BorderEdge { ends: [corners[side], corners[(side + 1) % 3]], triangle, side }
    };
    let of_triangle = |(triangle, beside): (usize, &[u32; 3])| {
        let open = beside.map(|neighbour| neighbour == NONE);
        (0..3).filter(move |&side| open[side]).map(move |side| (triangle, side))
    };
    neighbours.iter().enumerate().flat_map(of_triangle).map(|(triangle, side)| edge(triangle, side)).collect()
}

/// Connects the triangles from `first` on with those along the border.
fn sew(triangles: &[[u32; 3]], neighbours: &mut [[u32; 3]], first: usize, border: &mut [BorderEdge]) {
    border.sort_unstable_by_key(|edge| edge.ends);
    for triangle in first..triangles.len() {
        let corners = triangles[triangle];
        let beside = neighbours[triangle];
        for side in (0..3).filter(|&side| beside[side] == NONE) {
            let ends = [corners[(side + 1) % 3], corners[side]];
            if let Ok(at) = border.binary_search_by_key(&ends, |edge| edge.ends) {
                let edge = &border[at];
                neighbours[triangle][side] = edge.triangle as u32;
                neighbours[edge.triangle][edge.side] = triangle as u32;
            }
        }
    }
}
