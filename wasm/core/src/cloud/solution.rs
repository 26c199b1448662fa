//! A solved cloud: weights of its points by eq. 2, and of any place by interpolation (section V-B).

use std::collections::BTreeMap;

use glam::DVec2;

use super::{PointCloud, regions::Regions};
use crate::{
    bone::Skeleton,
    deform::Pose,
    error::Error,
    pose::{HarmonicFields, Poser, PoserInput},
    project::Project,
    request::Request,
    site::{PointSite, Site, SiteGraph, SiteKind},
    triangulation::NONE,
    weight::{Basis, SparseWeights, support_radii},
};

/// The result of [`solve_cloud`](crate::solve_cloud). It does not depend on where the handles are posed: its
/// [`poser`](Self::poser) makes the poses that it takes, and no other does.
#[derive(Debug, Clone)]
pub struct CloudSolution {
    weights: SparseWeights,
    sites: Vec<Site>,
    graph: SiteGraph,
    harmonic: HarmonicFields,
    /// The nearest site of each point, [`NONE`] in a part of the cloud without sites.
    nearest: Vec<u32>,
    scores: Vec<f64>,
    points: usize,
    given: PointCloud,
    /// The cloud with the handles as points; their short links would make `contains` narrower around them.
    cloud: PointCloud,
    poser: Poser,
}

impl CloudSolution {
    /// Solves for point handles in the cloud, distinct and sorted.
    pub(crate) fn new(cloud: &PointCloud, handles: &[PointSite<()>], request: Request) -> Result<Self, Error> {
        let Request { weighting, density, mode, handles: solved, .. } = request;
        let points = cloud.points.len();
        let places: Vec<DVec2> = handles.iter().map(|handle| handle.rest).collect();
        let given = cloud.clone();
        let (cloud, at) = cloud.with(&places);
        let mut regions = Regions::new(&cloud);
        for (&PointSite { handle, .. }, &point) in handles.iter().zip(&at) {
            regions.insert(point, SiteKind::Point { handle });
        }
        let scores = regions.insert_virtual_sites(density)?;
        let graph = regions.dual();
        let Regions { mut sites, points: at, nearest, .. } = regions;
        let basis = Basis::new(weighting.degree, weighting.filling);
        let mut by_site = Vec::with_capacity(sites.len());
        let radii = support_radii(&weighting, &sites);
        for ((site, radius), &at) in sites.iter_mut().zip(radii).zip(&at) {
            site.support_radius = radius;
            let distances = cloud.graph.distances(&cloud.points, at as usize).into_iter().enumerate();
            let covered = distances.filter(|&(_, d)| d < radius);
            by_site.push(covered.map(|(point, d)| (point as u32, basis.value(d / radius))).collect());
        }
        let (weights, _) = SparseWeights::normalised(cloud.points.len(), &by_site);
        let harmonic = HarmonicFields::new(&sites, &graph);
        let poser = Poser::new(PoserInput {
            sites: &sites,
            graph: &graph,
            harmonic: &harmonic,
            skeleton: Skeleton::default(),
            handles: solved,
            mode,
            quadrature: None,
        });
        Ok(Self { weights, sites, graph, harmonic, nearest, scores, points, given, cloud, poser })
    }

    /// The weights of the cloud's points in the caller's order, then those of handles between them: points × sites.
    #[must_use]
    pub fn weights(&self) -> &SparseWeights {
        &self.weights
    }

    /// Real sites from top to bottom, then virtual ones as they were inserted.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// The links of the cells' dual graph: two sites, the lower index first, and the weight of the link, which is 1. Ascending.
    pub fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.graph.iter()
    }

    /// ϖ: the real sites that a site gets its motion from and their shares (eq. 4), which sum to 1 within rounding; ascending by site. Of a
    /// real site itself alone.
    ///
    /// # Panics
    /// For a site that there is not.
    pub fn harmonic_weights(&self, site: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.harmonic.row(site)
    }

    /// The nearest site of a point of [`weights`](Self::weights), `None` in a part of the cloud without sites.
    ///
    /// # Panics
    /// For a point that there is not.
    #[must_use]
    pub fn nearest_site(&self, point: usize) -> Option<usize> {
        let site = self.nearest[point];
        (site != NONE).then_some(site as usize)
    }

    /// The score δ / r_d of the worst cell before each insertion, as in the paper's figure 3 (right), with δ = r_d minus the
    /// greatest radius that the cell may have, in place of r_d − r_h. Infinite where there is no cell.
    #[must_use]
    pub fn scores(&self) -> &[f64] {
        &self.scores
    }

    /// Makes poses of this solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.poser
    }

    /// The pose of a project's handles, blended as the project says: see [`Poser::pose`].
    ///
    /// # Errors
    /// Those of [`Poser::pose`].
    pub fn pose(&self, project: &Project) -> Result<Pose, Error> {
        self.poser.pose(&project.handles, project.pose.blend)
    }

    /// The sites that move a place and their weights, ascending by site; `None` outside the cloud.
    ///
    /// Interpolated by reciprocal distances (the paper's \[18\]) from the nearest points of one connected part. At a point of
    /// the cloud they are that point's.
    #[must_use]
    pub fn weights_at(&self, p: DVec2) -> Option<Vec<(usize, f64)>> {
        let cloud = &self.cloud;
        if !self.given.contains(p) {
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
        let shares: Vec<(usize, f64)> = near.map(|(square, point)| (point as usize, (least / square).sqrt())).collect();
        let sum: f64 = shares.iter().map(|&(_, share)| share).sum();
        let mut weights: BTreeMap<usize, f64> = BTreeMap::new();
        for (point, share) in shares {
            for (site, weight) in self.weights.row(point) {
                *weights.entry(site).or_default() += share / sum * weight;
            }
        }
        Some(weights.into_iter().collect())
    }

    /// Where a place goes (eq. 1), in pixels; `None` outside the cloud.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn map(&self, pose: &Pose, p: DVec2) -> Option<DVec2> {
        self.expect_own(pose);
        Some(pose.blended(p, self.weights_at(p)?))
    }

    /// Where the cloud's points go, in the caller's order.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn posed_points(&self, pose: &Pose) -> Vec<DVec2> {
        self.expect_own(pose);
        let points = self.cloud.points[..self.points].iter().enumerate();
        points.map(|(point, &p)| pose.blended(p, self.weights.row(point))).collect()
    }

    fn expect_own(&self, pose: &Pose) {
        assert!(self.poser.has_made(pose), "{}", Error::PoseOfAnother);
    }
}
