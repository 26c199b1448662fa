//! The paper's approximation of intrinsic distance: Dijkstra's algorithm on a graph over the samples (section V-B).
//!
//! Its paths follow edges, so it overestimates by about 10 % on average, however dense the samples are. It is kept as
//! the reference, and for point clouds, which have no outline for an exact method. Coarse samples use the graph only
//! for adjacency.
//!
//! Cost: O(n log n) for the distances from one source to n nodes.

use std::{cmp::Reverse, collections::BinaryHeap};

use glam::DVec2;

use crate::{
    rank::sort_by_rank,
    rows::Rows,
    triangulation::{NONE, Triangulation},
};

/// An undirected graph over points.
#[derive(Debug, Clone)]
pub struct Graph {
    neighbours: Rows<u32>,
}

impl Graph {
    /// The graph with `nodes` nodes and the given undirected edges. Each edge must occur once.
    pub(crate) fn of_edges<I: Iterator<Item = (u32, u32)>>(nodes: usize, edges: impl Fn() -> I) -> Self {
        let both_ways = |(a, b): (u32, u32)| [(a as usize, b), (b as usize, a)];
        Self { neighbours: Rows::from_pairs(nodes, || edges().flat_map(both_ways)) }
    }

    /// The edges of a mesh of `nodes` vertices. `triangles` are triples of vertex indices.
    ///
    /// # Panics
    /// If a vertex index is out of bounds.
    #[must_use]
    pub fn of_triangles(nodes: usize, triangles: &[[u32; 3]]) -> Self {
        let sides = |&[a, b, c]: &[u32; 3]| [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b)));
        let mut edges: Vec<(u32, u32)> = triangles.iter().flat_map(sides).collect();
        sort_by_rank(&mut edges, |&(a, b)| [a.into(), b.into()]);
        edges.dedup();
        Self::of_edges(nodes, || edges.iter().copied())
    }

    /// The edges of a mesh with known neighbours. No sort is needed: every insertion of a handle builds this graph.
    pub(crate) fn of_mesh(mesh: &Triangulation) -> Self {
        Self::of_edges(mesh.vertices.len(), || {
            mesh.triangles.iter().zip(&mesh.neighbours).enumerate().flat_map(|(t, (corners, neighbours))| {
                // Each inner edge once: from the triangle with the lower index.
                let once = move |&k: &usize| neighbours[k] == NONE || t < neighbours[k] as usize;
                (0..3).filter(once).map(move |k| (corners[k], corners[(k + 1) % 3]))
            })
        })
    }

    /// Neighbours of a node.
    pub(crate) fn neighbours(&self, node: usize) -> &[u32] {
        self.neighbours.row(node)
    }

    /// Lengths of the shortest paths along edges from the node `source` to every node, in pixels.
    ///
    /// `points` are the positions of the nodes. A length is infinite if no path to the node exists.
    ///
    /// # Panics
    /// If there are fewer points than nodes, or if `source` is out of bounds.
    #[must_use]
    pub fn distances(&self, points: &[DVec2], source: usize) -> Vec<f64> {
        self.distances_from_any(points, [(source as u32, 0.0)])
    }

    /// Lengths of the shortest paths along edges to every node from any of `starts`: nodes with initial lengths.
    pub(crate) fn distances_from_any(
        &self,
        points: &[DVec2],
        starts: impl IntoIterator<Item = (u32, f64)>,
    ) -> Vec<f64> {
        let mut distance = vec![f64::INFINITY; points.len()];
        // Non-negative floats order like their bits.
        let mut queue = BinaryHeap::new();
        for (node, length) in starts {
            if length < distance[node as usize] {
                distance[node as usize] = length;
                queue.push(Reverse((length.to_bits(), node)));
            }
        }
        while let Some(Reverse((bits, node))) = queue.pop() {
            let node = node as usize;
            if f64::from_bits(bits) > distance[node] {
                continue;
            }
            for &next in self.neighbours(node) {
                let through = distance[node] + points[node].distance(points[next as usize]);
                if through < distance[next as usize] {
                    distance[next as usize] = through;
                    queue.push(Reverse((through.to_bits(), next)));
                }
            }
        }
        distance
    }
}
