//! Cells and Algorithm 1 on the points of a cloud (sections IV-A and V-B).
//!
//! While some cell is larger than its site's support may reach, the farthest point of the worst cell becomes a site. A point
//! becomes a site at most once, so this ends; where the points are too sparse for close handles, it ends with all points
//! around them being sites (the paper's "failure").
//!
//! Cost: for each insertion one run of Dijkstra's algorithm and a pass over all points.

use super::PointCloud;
use crate::{
    distance::{DistanceField, NavTriangle},
    error::Error,
    limits::MAX_SITES,
    site::{Site, SiteGraph, SiteKind, allowed_score, score},
    triangulation::NONE,
};

pub(super) struct Regions<'a> {
    cloud: &'a PointCloud,
    pub(super) sites: Vec<Site>,
    /// The point of each site.
    pub(super) points: Vec<u32>,
    /// The nearest site of each point, [`NONE`] in a part without sites; then its distance.
    pub(super) nearest: Vec<u32>,
    distance: Vec<f64>,
}

impl<'a> Regions<'a> {
    pub(super) fn new(cloud: &'a PointCloud) -> Self {
        let n = cloud.points.len();
        let (nearest, distance) = (vec![NONE; n], vec![f64::INFINITY; n]);
        Self { cloud, sites: Vec::new(), points: Vec::new(), nearest, distance }
    }

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
        let rest = self.cloud.points[at];
        self.points.push(point);
        self.sites.push(Site {
            rest,
            kind,
            separation,
            clearance,
            cell_radius: 0.0,
            in_nook: false,
            support_radius: 0.0,
            island: self.cloud.part[at] as usize,
            // A cloud has no triangles: its distances are those of the graph.
            triangle: NavTriangle(NONE),
            field: DistanceField { source: rest, bound: 0.0, triangles: Vec::new(), windows: Vec::new() },
        });
    }

    /// Algorithm 1. Returns the worst score before each insertion, and sets the cells' radii.
    pub(super) fn insert_virtual_sites(&mut self, density: usize) -> Result<Vec<f64>, Error> {
        let (real, mut scores) = (self.sites.len(), Vec::new());
        loop {
            let farthest = self.farthest();
            for (site, &(radius, _)) in self.sites.iter_mut().zip(&farthest) {
                site.cell_radius = radius;
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
            self.insert(farthest[next].1, SiteKind::Virtual);
        }
    }

    /// For each site the farthest point of its cell, after its distance.
    fn farthest(&self) -> Vec<(f64, u32)> {
        let mut farthest: Vec<(f64, u32)> = self.points.iter().map(|&point| (0.0, point)).collect();
        for (point, (&site, &d)) in
            self.nearest.iter().zip(&self.distance).enumerate().filter(|(_, (s, _))| **s != NONE)
        {
            let known = &mut farthest[site as usize];
            if d > known.0 {
                *known = (d, point as u32);
            }
        }
        farthest
    }

    /// The dual graph of the cells with uniform weights (section V-C): two sites are linked where a link of the cloud joins
    /// their cells.
    pub(super) fn dual(&self) -> SiteGraph {
        let cell = |point: usize| self.nearest[point];
        let across = |a: usize| self.cloud.graph.neighbours(a).iter().map(move |&b| [cell(a), cell(b as usize)]);
        // Each link is seen from both ends.
        let mut links: Vec<[u32; 2]> =
            (0..self.nearest.len()).flat_map(across).filter(|&[i, j]| i < j && j != NONE).collect();
        links.sort_unstable();
        links.dedup();
        SiteGraph { weights: vec![1.0; links.len()], links }
    }
}

/// The greatest number and its index, the first one of ties.
fn greatest(ranks: impl Iterator<Item = f64>) -> (f64, usize) {
    ranks.enumerate().fold((f64::NEG_INFINITY, 0), |best, (at, rank)| if rank > best.0 { (rank, at) } else { best })
}
