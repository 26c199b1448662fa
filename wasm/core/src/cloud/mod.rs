//! Solves on a point cloud without outline or mesh, as the paper does for meshless domains (section V-B).
//!
//! A graph over the k nearest neighbours of each point represents the domain. As in the paper, distances are shortest
//! paths on this graph. Cells and Algorithm 1 use the points only, and weights are interpolated between points.
//!
//! Cost: O(n log n) for the graph, and two runs of Dijkstra's algorithm over all points for each site.
//!
//! Limits: all results are approximate. If there is an outline or a mesh, use that.
//!
//! - Distances are a few per cent too long, however dense the points are.
//! - Weights jump a little where the set of the k nearest points changes.
//! - A symmetric cloud may get asymmetric cells.

mod partition;
mod solution;
mod solve;

use glam::DVec2;

use crate::{distance::graph::Graph, error::Error, limits::MAX_COORDINATE, point_tree::Tree, triangulation::NONE};

pub use solution::CloudSolution;
pub use solve::solve_cloud;

/// Points and the graph over their nearest neighbours, for [`solve_cloud`].
///
/// ```
/// use c2warp::{cloud::PointCloud, project::{Handle, Project}, solve_cloud};
///
/// let points = (0..600).map(|i| [f64::from(i % 30) * 10.0, f64::from(i / 30) * 10.0].into()).collect();
/// let cloud = PointCloud::new(points, 8)?;
/// let left = Handle::point("left", [42.0, 97.0]);
/// let right = Handle::point("right", [250.0, 100.0]).posed_at([[250.0, 130.0]]);
/// // Of any size, as the picture is ignored.
/// let project = Project::for_picture(1, 1).with_handles([left, right]);
/// let solution = solve_cloud(&project, &cloud)?;
/// let pose = solution.pose(&project)?;
/// assert_eq!(solution.map(&pose, [250.0, 100.0].into()), Some([250.0, 130.0].into()));
/// assert_eq!(solution.posed_points(&pose).len(), 600);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct PointCloud {
    points: Vec<DVec2>,
    graph: Graph,
    /// Points: the index of the connected part of each.
    part: Vec<u32>,
    /// k: the number of nearest neighbours that each point is linked with.
    neighbours: usize,
    tree: Tree,
}

impl PointCloud {
    /// Links every point with its `neighbours` nearest, in either direction.
    ///
    /// Positions are in pixels, each coordinate from −1,000,000 to 1,000,000. Handles must be at least 0.01 px apart.
    ///
    /// The paper does not specify the number of neighbours; 8 is common. Fewer neighbours lengthen distances. More
    /// neighbours create links across gaps.
    ///
    /// # Errors
    /// [`Error::CloudNeighbours`], [`Error::CloudPoint`], [`Error::CloudDuplicate`].
    pub fn new(points: Vec<DVec2>, neighbours: usize) -> Result<Self, Error> {
        if neighbours == 0 || points.len() <= neighbours {
            return Err(Error::CloudNeighbours { points: points.len(), neighbours });
        }
        if let Some(point) = points.iter().position(|p| !(p.is_finite() && p.abs().max_element() <= MAX_COORDINATE)) {
            return Err(Error::CloudPoint { point });
        }
        let tree = Tree::new(&points);
        let mut edges = Vec::with_capacity(points.len() * neighbours);
        for (point, &p) in points.iter().enumerate() {
            for (square, other) in tree.nearest(&points, p, neighbours + 1) {
                if other as usize == point {
                    continue;
                }
                if square == 0.0 {
                    let (other, point) = (point.min(other as usize), point.max(other as usize));
                    return Err(Error::CloudDuplicate { point, other });
                }
                edges.push((other.min(point as u32), other.max(point as u32)));
            }
        }
        Ok(Self::linked(points, edges, neighbours, tree))
    }

    fn linked(points: Vec<DVec2>, mut edges: Vec<(u32, u32)>, neighbours: usize, tree: Tree) -> Self {
        edges.sort_unstable();
        edges.dedup();
        let graph = Graph::of_edges(points.len(), || edges.iter().copied());
        let part = connected_parts(&graph, points.len());
        Self { points, graph, part, neighbours, tree }
    }

    /// The points, in the caller's order.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The points linked with a point.
    ///
    /// # Panics
    /// If `point` is out of bounds.
    #[must_use]
    pub fn neighbours(&self, point: usize) -> &[u32] {
        self.graph.neighbours(point)
    }

    /// Lengths of the shortest paths along links from a point to every point, in pixels; infinite if no path exists.
    ///
    /// Dijkstra's algorithm, O(n log n).
    ///
    /// # Panics
    /// If `point` is out of bounds.
    #[must_use]
    pub fn distances_from(&self, point: usize) -> Vec<f64> {
        self.graph.distances(&self.points, point)
    }

    /// Whether a position belongs to the domain that the cloud represents. Its distance to the nearest point may be at
    /// most the length of that point's longest link.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        self.tree.nearest(&self.points, p, 1).first().is_some_and(|&(square, point)| {
            let from = self.points[point as usize];
            let links = self.graph.neighbours(point as usize).iter();
            square <= links.map(|&n| from.distance_squared(self.points[n as usize])).fold(0.0, f64::max)
        })
    }

    /// The cloud with further points, and the index of each. A position that coincides with a point of the cloud gets
    /// that point's index.
    ///
    /// Each new point is linked with its nearest neighbours in the cloud, and with new points that are nearer than
    /// these.
    fn with(&self, positions: &[DVec2]) -> (Self, Vec<u32>) {
        let mut points = self.points.clone();
        let links = |from: usize| self.graph.neighbours(from).iter().map(move |&to| (from as u32, to));
        let mut edges: Vec<(u32, u32)> = (0..points.len()).flat_map(links).filter(|(a, b)| a < b).collect();
        let mut at = Vec::with_capacity(positions.len());
        for &p in positions {
            let near = self.tree.nearest(&self.points, p, self.neighbours);
            if let Some(&(_, same)) = near.first().filter(|(square, _)| *square == 0.0) {
                at.push(same);
                continue;
            }
            let new = points.len() as u32;
            let reach = near.last().map_or(0.0, |&(square, _)| square);
            let others = (self.points.len()..points.len()).filter(|&other| points[other].distance_squared(p) < reach);
            edges.extend(others.map(|other| (other as u32, new)));
            edges.extend(near.iter().map(|&(_, point)| (point, new)));
            points.push(p);
            at.push(new);
        }
        let tree = Tree::new(&points);
        (Self::linked(points, edges, self.neighbours, tree), at)
    }
}

/// Nodes: the index of the connected part of each.
fn connected_parts(graph: &Graph, nodes: usize) -> Vec<u32> {
    let (mut part, mut count) = (vec![NONE; nodes], 0);
    for seed in 0..nodes {
        if part[seed] != NONE {
            continue;
        }
        let mut stack = vec![seed as u32];
        while let Some(node) = stack.pop() {
            if part[node as usize] == NONE {
                part[node as usize] = count;
                stack.extend(graph.neighbours(node as usize));
            }
        }
        count += 1;
    }
    part
}
