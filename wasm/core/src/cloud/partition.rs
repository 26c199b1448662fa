//! Cells and Algorithm 1 over the points of a cloud (sections IV-A and V-B).
//!
//! While a cell is larger than the greatest support of its site, the farthest point of the worst cell becomes a site.
//!
//! Cost: for each insertion one run of Dijkstra's algorithm and a pass over all points.
//!
//! Limits: a point becomes a site at most once, so the algorithm terminates. If the points are too sparse for close
//! handles, all points around them become sites: the paper's "failure" of the insertion.

use super::PointCloud;
use crate::{
    error::Error,
    limits::MAX_SITES,
    site::{Site, SiteGraph, SiteKind, allowed_score, score},
    triangulation::NONE,
};

/// A cloud, partitioned into the cells of its sites.
pub(super) struct CloudPartition<'a> {
    cloud: &'a PointCloud,
    pub(super) sites: Vec<Site>,
    /// Sites: the point of each.
    pub(super) points: Vec<u32>,
    /// Points: the nearest site of each; [`NONE`] in a part without sites.
    pub(super) nearest: Vec<u32>,
    /// Points: the distance of each to that site, in pixels.
    distance: Vec<f64>,
}

/// The farthest point of a cell.
struct FarthestPoint {
    distance: f64,
    point: u32,
}

impl<'a> CloudPartition<'a> {
    /// A cloud without sites.
    pub(super) fn new(cloud: &'a PointCloud) -> Self {
        let n = cloud.points.len();
        let (nearest, distance) = (vec![NONE; n], vec![f64::INFINITY; n]);
        Self { cloud, sites: Vec::new(), points: Vec::new(), nearest, distance }
    }

    /// Inserts a site at a point.
    pub(super) fn insert(&mut self, point: u32, kind: SiteKind) {
        let (at, new) = (point as usize, self.sites.len() as u32);
        let from = self.cloud.graph.distances(&self.cloud.points, at);
        let (separation, mut clearance) = (self.distance[at], f64::INFINITY);
        for (site, &point) in self.sites.iter_mut().zip(&self.points) {
            let d = from[point as usize];
            site.separation = site.separation.min(d);
            if kind.is_real() {
                site.clearance = site.clearance.min(d);
            }
            if site.kind.is_real() {
                clearance = clearance.min(d);
            }
        }
        for (p, &d) in from.iter().enumerate() {
            if d < self.distance[p] {
                (self.nearest[p], self.distance[p]) = (new, d);
            }
        }
        self.points.push(point);
        self.sites.push(Site {
            rest: self.cloud.points[at],
            kind,
            separation,
            clearance,
            unique_reach: f64::INFINITY,
            cell_radius: 0.0,
            farthest: self.cloud.points[at],
            support_radius: 0.0,
            precedence_radius: 0.0,
            in_acute_joint: false,
        });
    }

    /// Algorithm 1. Sets the radii of the cells. Returns the score of the worst cell before each insertion.
    ///
    /// # Errors
    /// [`Error::TooManySites`].
    pub(super) fn insert_virtual_sites(&mut self, density: usize) -> Result<Vec<f64>, Error> {
        let (real, mut scores) = (self.sites.len(), Vec::new());
        loop {
            let farthest = self.farthest_points();
            for (site, farthest) in self.sites.iter_mut().zip(&farthest) {
                site.cell_radius = farthest.distance;
                site.farthest = self.cloud.points[farthest.point as usize];
            }
            let rank = |site: &Site| score(site.cell_radius, site.reach_limit());
            let (worst, by_score) = greatest(self.sites.iter().map(rank));
            let (size, by_size) = greatest(self.sites.iter().map(|site| site.cell_radius));
            scores.push(worst);
            let next = if worst > allowed_score() {
                by_score
            } else if self.sites.len() - real < density && size > 0.0 {
                by_size
            } else {
                return Ok(scores);
            };
            if self.sites.len() >= MAX_SITES {
                return Err(Error::TooManySites);
            }
            self.insert(farthest[next].point, SiteKind::Virtual);
        }
    }

    /// Sites: the farthest point of each cell.
    fn farthest_points(&self) -> Vec<FarthestPoint> {
        let site_itself = |&point: &u32| FarthestPoint { distance: 0.0, point };
        let mut farthest: Vec<FarthestPoint> = self.points.iter().map(site_itself).collect();
        for (point, (&site, &distance)) in (0..).zip(self.nearest.iter().zip(&self.distance)) {
            if site != NONE && distance > farthest[site as usize].distance {
                farthest[site as usize] = FarthestPoint { distance, point };
            }
        }
        farthest
    }

    /// The dual graph of the cells with uniform weights (section V-C). Two sites are linked if a link of the cloud
    /// joins their cells.
    pub(super) fn dual_graph(&self) -> SiteGraph {
        let cell = |point: usize| self.nearest[point];
        let across = |a: usize| self.cloud.graph.neighbours(a).iter().map(move |&b| [cell(a), cell(b as usize)]);
        // Each link is found from both ends.
        let mut links: Vec<[u32; 2]> =
            (0..self.nearest.len()).flat_map(across).filter(|&[i, j]| i < j && j != NONE).collect();
        links.sort_unstable();
        links.dedup();
        SiteGraph { weights: vec![1.0; links.len()], links }
    }
}

/// The largest number and its index; of ties, the first.
fn greatest(ranks: impl Iterator<Item = f64>) -> (f64, usize) {
    ranks.enumerate().fold((f64::NEG_INFINITY, 0), |best, (at, rank)| if rank > best.0 { (rank, at) } else { best })
}
