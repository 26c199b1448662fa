//! Weights at any point: eq. 2 itself, no interpolation.

use std::ops::Range;

use glam::DVec2;

use super::{
    Basis,
    sharing::Sharing,
    sweep::{Swept, sweep},
};
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
    /// The supports that reach into each triangle of the navigation mesh, ascending by site, as compressed rows.
    reaching_start: Vec<u32>,
    reaching: Vec<Reaching>,
}

/// A support that reaches into a triangle.
#[derive(Debug, Clone, Default)]
struct Reaching {
    site: u32,
    /// What the site's field has for the triangle.
    windows: Range<u32>,
}

impl Weights {
    /// Prepares the weights of sites whose support radii are set and whose fields reach as far.
    pub(crate) fn new(navigation: &Navigation, sites: &[Site], skeleton: &Skeleton, basis: Basis) -> Self {
        let mut reaching_start = vec![0_u32; navigation.mesh.triangles.len() + 1];
        for (triangle, _) in sites.iter().flat_map(|site| site.field.windows_within(site.support_radius)) {
            reaching_start[triangle as usize + 1] += 1;
        }
        for i in 1..reaching_start.len() {
            reaching_start[i] += reaching_start[i - 1];
        }
        let mut fill = reaching_start.clone();
        let mut reaching = vec![Reaching::default(); reaching_start[reaching_start.len() - 1] as usize];
        for (site, at) in sites.iter().zip(0..) {
            for (triangle, windows) in site.field.windows_within(site.support_radius) {
                let next = &mut fill[triangle as usize];
                reaching[*next as usize] = Reaching { site: at, windows };
                *next += 1;
            }
        }
        let sharing = Sharing::new(sites, skeleton);
        Self { basis, sharing, reaching_start, reaching }
    }

    /// The weights at a point and their gradients, ascending by site. Empty where no site reaches.
    ///
    /// They sum to 1 within rounding, and none is negative. Where two ways to a site are as long, around a hole say, weights have an
    /// edge and several gradients: the mean of these is told.
    #[must_use]
    pub fn at(&self, sites: &[Site], place: Place, p: DVec2) -> Vec<Influence> {
        let mut influences: Vec<Influence> = Vec::new();
        let (mut sum, mut sum_gradient) = (0.0, DVec2::ZERO);
        for Reaching { site, windows } in self.reaching_in(place) {
            let &Site { rest, support_radius: radius, ref field, .. } = &sites[*site as usize];
            if rest.distance_squared(p) >= radius * radius {
                continue;
            }
            let windows = field.windows(windows.clone());
            let Some(foot) = field.foot_in(windows, p).filter(|foot| foot.distance < radius) else { continue };
            let t = foot.distance / radius;
            let (phi, slope) = (self.basis.value(t), self.basis.derivative(t) / radius);
            let gradient = slope * foot.gradient_in(windows, p);
            sum += phi;
            sum_gradient += gradient;
            influences.push(Influence { site: *site as usize, weight: phi, gradient });
        }
        self.sharing.share_out(p, &mut influences, &mut Vec::new());
        for influence in &mut influences {
            influence.weight /= sum;
            influence.gradient = (influence.gradient - influence.weight * sum_gradient) / sum;
        }
        influences
    }

    /// The same with the gradients that differences over a small step tell: where weights have an edge, means of both its sides.
    pub(crate) fn across(
        &self,
        navigation: &Navigation,
        sites: &[Site],
        (place, p): (Place, DVec2),
        step: f64,
    ) -> Vec<Influence> {
        let mut here = self.at(sites, place, p);
        // Beside a sharp corner the place of a point allows for more than a step.
        let at = |q: DVec2| navigation.locate(q).map_or((p, here.clone()), |(place, q)| (q, self.at(sites, place, q)));
        let [left, right, above, below] = [-DVec2::X, DVec2::X, -DVec2::Y, DVec2::Y].map(|axis| at(p + step * axis));
        let slope = |(from, before): &(DVec2, Vec<Influence>), (to, after): &(DVec2, Vec<Influence>), site: usize| {
            let weight = |list: &[Influence]| list.iter().find(|one| one.site == site).map_or(0.0, |one| one.weight);
            let apart = from.distance(*to);
            if apart > 0.0 { (weight(after) - weight(before)) / apart } else { 0.0 }
        };
        for one in &mut here {
            one.gradient = DVec2::new(slope(&left, &right, one.site), slope(&above, &below, one.site));
        }
        here
    }

    /// The weights of all samples.
    pub(crate) fn of_samples(&self, sites: &[Site], samples: &Samples) -> Swept {
        let mut swept = sweep(sites, samples, &self.basis, |place| {
            let reaching = self.reaching_in(place).iter();
            reaching.map(|Reaching { site, windows }| (*site, sites[*site as usize].field.windows(windows.clone())))
        });
        self.sharing.share_out_rows(&samples.mesh.vertices, &mut swept.weights);
        swept
    }

    fn reaching_in(&self, place: Place) -> &[Reaching] {
        let triangle = place.0 as usize;
        &self.reaching[self.reaching_start[triangle] as usize..self.reaching_start[triangle + 1] as usize]
    }
}
