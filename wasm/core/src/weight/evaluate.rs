//! Weights at any point: eq. 2 itself, no interpolation.

use glam::DVec2;

use super::{Basis, SparseWeights, sharing::Sharing};
use crate::{
    bone::Skeleton,
    distance::{Navigation, Place},
    sample::Samples,
    site::Site,
};

/// What one site has to say at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Influence {
    /// The site's index.
    pub site: usize,
    /// w_i at the point.
    pub weight: f64,
    /// ∇w_i, per pixel.
    pub gradient: DVec2,
}

/// The weight functions of all sites.
#[derive(Debug, Clone)]
pub struct Weights {
    basis: Basis,
    sharing: Sharing,
    /// Sites whose support reaches into each triangle of the navigation mesh, as compressed rows.
    reaching_start: Vec<u32>,
    reaching: Vec<u32>,
}

impl Weights {
    /// Prepares the weights of sites whose support radii are set and whose fields reach as far.
    pub(crate) fn new(navigation: &Navigation, sites: &[Site], skeleton: &Skeleton, basis: Basis) -> Self {
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); navigation.mesh.triangles.len()];
        for (i, site) in sites.iter().enumerate() {
            for triangle in site.field.triangles_within(site.support_radius) {
                lists[triangle as usize].push(i as u32);
            }
        }
        let mut reaching_start = vec![0];
        reaching_start.extend(lists.iter().scan(0, |sum, list| {
            *sum += list.len() as u32;
            Some(*sum)
        }));
        let sharing = Sharing::new(sites, skeleton);
        Self { basis, sharing, reaching_start, reaching: lists.concat() }
    }

    /// The weights at a point and their gradients, ascending by site. Empty where no site reaches.
    ///
    /// They sum to 1 within rounding, and none is negative.
    #[must_use]
    pub fn at(&self, sites: &[Site], place: Place, p: DVec2) -> Vec<Influence> {
        let triangle = place.0 as usize;
        let range = self.reaching_start[triangle] as usize..self.reaching_start[triangle + 1] as usize;
        let mut influences: Vec<Influence> = Vec::new();
        let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
        for &site in &self.reaching[range] {
            let Site { rest, support_radius: radius, ref field, .. } = sites[site as usize];
            if rest.distance_squared(p) >= radius * radius {
                continue;
            }
            let Some(foot) = field.foot(place, p).filter(|foot| foot.distance < radius) else { continue };
            let t = foot.distance / radius;
            let (phi, slope) = (self.basis.value(t), self.basis.derivative(t) / radius);
            let gradient = slope * (p - foot.pseudo_source).normalize_or_zero();
            sum += phi;
            sum_gradient += gradient;
            influences.push(Influence { site: site as usize, weight: phi, gradient });
        }
        self.sharing.share_out(p, &mut influences);
        for influence in &mut influences {
            influence.weight /= sum;
            influence.gradient = (influence.gradient - influence.weight * sum_gradient) / sum;
        }
        influences
    }

    /// The weights of all samples, and Σφ at each.
    ///
    /// Cost: the samples within each support, and a margin of one around it.
    pub(crate) fn of_samples(&self, sites: &[Site], samples: &Samples) -> (SparseWeights, Vec<f64>) {
        let mut seen = vec![u32::MAX; samples.len()];
        let mut stack: Vec<u32> = Vec::new();
        let mut by_site = Vec::with_capacity(sites.len());
        for (i, site) in sites.iter().enumerate() {
            let mut covered: Vec<(u32, f64)> = Vec::new();
            stack.extend(samples.around(site.rest).expect("sites lie in the domain"));
            while let Some(sample) = stack.pop() {
                let at = sample as usize;
                if seen[at] == i as u32 {
                    continue;
                }
                seen[at] = i as u32;
                let d = site.field.distance(samples.places[at], samples.mesh.vertices[at]);
                // The path to a covered sample crosses triangles whose corners are at most an edge farther than it.
                if d < site.support_radius + samples.reach[at] {
                    stack.extend(samples.graph.of(at));
                }
                if d < site.support_radius {
                    covered.push((sample, self.basis.value(d / site.support_radius)));
                }
            }
            by_site.push(covered);
        }
        let (mut weights, sums) = SparseWeights::normalised(samples.len(), &by_site);
        self.sharing.share_out_rows(&samples.mesh.vertices, &mut weights);
        (weights, sums)
    }
}
