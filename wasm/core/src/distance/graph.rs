//! The paper's approximation of intrinsic distance: Dijkstra's algorithm on a graph over the samples (section V-B).
//!
//! Kept as the named reference: it overestimates by up to 10 % however dense the samples are, because its paths may only
//! turn where the graph has edges. Point clouds, which have no outline, have nothing better.

use std::{cmp::Reverse, collections::BinaryHeap};

use glam::DVec2;

use crate::triangulation::{NONE, Triangulation};

/// An undirected graph over points, as compressed rows of neighbours.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    /// Nodes + 1: start of each node's neighbours.
    pub start: Vec<u32>,
    /// Neighbours of all nodes, one node after another.
    pub neighbours: Vec<u32>,
}

impl Graph {
    /// The graph of a list of edges, each given once in either direction or both.
    #[must_use]
    pub fn from_edges(nodes: usize, edges: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut start = vec![0_u32; nodes + 1];
        for (a, b) in edges.clone() {
            start[a as usize + 1] += 1;
            start[b as usize + 1] += 1;
        }
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        let mut fill = start.clone();
        let mut neighbours = vec![0; start[nodes] as usize];
        for (a, b) in edges {
            for (from, to) in [(a, b), (b, a)] {
                neighbours[fill[from as usize] as usize] = to;
                fill[from as usize] += 1;
            }
        }
        Self { start, neighbours }
    }

    /// The edges of a mesh.
    #[must_use]
    pub fn of_mesh(mesh: &Triangulation) -> Self {
        let edges = mesh.triangles.iter().zip(&mesh.neighbours).enumerate().flat_map(|(t, (corners, neighbours))| {
            // Each inner edge once: from the triangle of lower number.
            let once = move |&k: &usize| neighbours[k] == NONE || t < neighbours[k] as usize;
            (0..3).filter(once).map(move |k| (corners[k], corners[(k + 1) % 3]))
        });
        Self::from_edges(mesh.vertices.len(), edges)
    }

    /// Neighbours of a node.
    #[must_use]
    pub fn of(&self, node: usize) -> &[u32] {
        &self.neighbours[self.start[node] as usize..self.start[node + 1] as usize]
    }

    /// Lengths of the shortest paths along edges from `source` to every node, infinite where none leads.
    #[must_use]
    pub fn distances(&self, points: &[DVec2], source: usize) -> Vec<f64> {
        let mut distance = vec![f64::INFINITY; points.len()];
        distance[source] = 0.0;
        // Non-negative floats order like their bits.
        let mut queue = BinaryHeap::from([Reverse((0_u64, source as u32))]);
        while let Some(Reverse((bits, node))) = queue.pop() {
            let node = node as usize;
            if f64::from_bits(bits) > distance[node] {
                continue;
            }
            for &next in self.of(node) {
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
