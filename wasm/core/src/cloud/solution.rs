//! A solved cloud: weights of its points by eq. 2, and of any position by interpolation (section V-B).
//!
//! Cost: to solve, one run of Dijkstra's algorithm for each site; to interpolate, a search for the nearest points.

use std::collections::BTreeMap;

use glam::DVec2;

use super::{PointCloud, partition::CloudPartition};
use crate::{
    bone::Skeleton,
    deform::Pose,
    error::Error,
    pose::{HarmonicFields, Poser, PoserInput, StiffnessField},
    project::Project,
    site::{Site, SiteKind},
    solve_input::SolveInput,
    solved_sites::SolvedSites,
    weight::{Basis, SparseWeights, support_radii},
};

/// The result of [`solve_cloud`](crate::solve_cloud). It does not depend on the pose of the handles. It accepts only
/// poses from its own [`poser`](Self::poser).
#[derive(Debug, Clone)]
pub struct CloudSolution {
    weights: SparseWeights,
    solved: SolvedSites,
    /// Number of the caller's points.
    points: usize,
    /// Rounds: the score of the worst cell before each.
    scores: Vec<f64>,
    /// The caller's cloud. `cloud` has short links around handles, so it covers less.
    original: PointCloud,
    /// The cloud with the handles as additional points.
    cloud: PointCloud,
}

impl CloudSolution {
    /// Solves for point handles in the cloud: their distinct positions, sorted, and their indices.
    pub(crate) fn new(original: &PointCloud, handles: &[(DVec2, u32)], input: &SolveInput) -> Result<Self, Error> {
        let positions: Vec<DVec2> = handles.iter().map(|&(rest, _)| rest).collect();
        let (cloud, at) = original.with(&positions);
        let mut partition = CloudPartition::new(&cloud);
        for (&(_, handle), &point) in handles.iter().zip(&at) {
            partition.insert(point, SiteKind::Point { handle });
        }
        let scores = partition.insert_virtual_sites(input.density)?;
        let graph = partition.dual_graph();
        let CloudPartition { mut sites, points: at, nearest, .. } = partition;
        let basis = Basis::new(input.weighting.degree, input.weighting.filling);
        let mut phi_by_site = Vec::with_capacity(sites.len());
        let radii = support_radii(&input.weighting, &sites);
        for ((site, radius), &at) in sites.iter_mut().zip(radii).zip(&at) {
            site.support_radius = radius;
            let distances = cloud.graph.distances(&cloud.points, at as usize).into_iter().enumerate();
            let covered = distances.filter(|&(_, d)| d < radius);
            phi_by_site.push(covered.map(|(point, d)| (point as u32, basis.value(d / radius))).collect());
        }
        let (weights, _) = SparseWeights::normalised(cloud.points.len(), &phi_by_site);
        let harmonic = HarmonicFields::new(&sites, &graph);
        let poser = Poser::new(PoserInput {
            sites: &sites,
            graph: &graph,
            harmonic: &harmonic,
            skeleton: Skeleton::default(),
            handles: input.handles.clone(),
            mode: input.mode,
            quadrature: None,
            stiffness: StiffnessField::default(),
            picture: input.picture,
            displacement: None,
        });
        let solved = SolvedSites { sites, graph, harmonic, poser, nearest };
        Ok(Self { weights, solved, scores, points: original.points.len(), original: original.clone(), cloud })
    }

    /// The weights of the cloud's points in the caller's order, followed by those of handles between points: points ×
    /// sites.
    #[must_use]
    pub fn weights(&self) -> &SparseWeights {
        &self.weights
    }

    /// The real sites from top to bottom, then the virtual ones as they were inserted.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.solved.sites
    }

    /// The links of the cells' dual graph: two sites, the lower index first, and the weight, 1. Ascending.
    pub fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.solved.graph.iter()
    }

    /// See [`Solution::harmonic_weights`](crate::Solution::harmonic_weights).
    ///
    /// # Panics
    /// If `site` is out of bounds.
    pub fn harmonic_weights(&self, site: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.solved.harmonic.row(site)
    }

    /// The nearest site of a point of [`weights`](Self::weights); `None` in a part of the cloud without sites.
    ///
    /// # Panics
    /// If `point` is out of bounds.
    #[must_use]
    pub fn nearest_site(&self, point: usize) -> Option<usize> {
        self.solved.nearest_site(point)
    }

    /// The score of the worst cell before each round of Algorithm 1: see [`Round`](crate::site::Round). Each round
    /// inserts one site.
    #[must_use]
    pub fn scores(&self) -> &[f64] {
        &self.scores
    }

    /// Computes poses of this solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.solved.poser
    }

    /// The pose of a project's handles, with the project's blend: see [`Poser::pose`].
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub fn pose(&self, project: &Project) -> Result<Pose, Error> {
        self.solved.pose(project)
    }

    /// The sites that move a position, and their weights, ascending by site; `None` outside the cloud.
    ///
    /// Interpolates by reciprocal distances (the paper's \[18\]) from the nearest points of one connected part. At a
    /// point of the cloud, returns the weights of that point.
    #[must_use]
    pub fn weights_at(&self, p: DVec2) -> Option<Vec<(usize, f64)>> {
        let cloud = &self.cloud;
        if !self.original.contains(p) {
            return None;
        }
        let near = cloud.tree.nearest(&cloud.points, p, cloud.neighbours);
        let &(least, first) = near.first()?;
        if least == 0.0 {
            return Some(self.weights.row(first as usize).collect());
        }
        let part = cloud.part[first as usize];
        let near = near.into_iter().filter(|&(_, point)| cloud.part[point as usize] == part);
        // Relative to the nearest, so that no reciprocal overflows.
        let reciprocals: Vec<(usize, f64)> =
            near.map(|(square, point)| (point as usize, (least / square).sqrt())).collect();
        let sum: f64 = reciprocals.iter().map(|&(_, reciprocal)| reciprocal).sum();
        let mut weights: BTreeMap<usize, f64> = BTreeMap::new();
        for (point, reciprocal) in reciprocals {
            for (site, weight) in self.weights.row(point) {
                *weights.entry(site).or_default() += reciprocal / sum * weight;
            }
        }
        Some(weights.into_iter().collect())
    }

    /// The posed position of a position at rest (eq. 1), in pixels; `None` outside the cloud.
    ///
    /// # Panics
    /// If the pose comes from another solution's poser.
    #[must_use]
    pub fn map(&self, pose: &Pose, p: DVec2) -> Option<DVec2> {
        self.solved.expect_own(pose);
        Some(pose.blended(p, self.weights_at(p)?))
    }

    /// The posed positions of the cloud's points, in the caller's order.
    ///
    /// # Panics
    /// If the pose comes from another solution's poser.
    #[must_use]
    pub fn posed_points(&self, pose: &Pose) -> Vec<DVec2> {
        self.solved.expect_own(pose);
        let points = self.cloud.points[..self.points].iter().enumerate();
        points.map(|(point, &p)| pose.blended(p, self.weights.row(point))).collect()
    }
}
