//! Weights at any point by eq. 2 itself, without interpolation.
//!
//! Cost: for each support that reaches the point's triangle, the windows of its field there; with shared bones, O(n log n) in
//! these supports. Limits: where two paths to a site are equally short, weights have a crease and the gradient is a mean.

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
    rows::Rows,
    sample::Samples,
    site::Site,
};

/// A site's weight at a point, and the gradient.
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
pub struct WeightFunctions {
    basis: Basis,
    sharing: Sharing,
    /// The supports that reach into each triangle of the navigation mesh, ascending by site.
    reaching: Rows<Reaching>,
}

/// A support that reaches into a triangle.
#[derive(Debug, Clone, Default)]
struct Reaching {
    site: u32,
    /// The windows of the site's field in the triangle.
    windows: Range<u32>,
}

impl WeightFunctions {
    /// Prepares the weight functions of sites whose support radii are set and whose fields reach as far.
    pub(crate) fn new(navigation: &Navigation, sites: &[Site], skeleton: &Skeleton, basis: Basis) -> Self {
        let supports = || {
            (0..).zip(sites).flat_map(|(number, site)| {
                let triangles = site.field.windows_within(site.support_radius);
                triangles.map(move |(triangle, windows)| (triangle as usize, Reaching { site: number, windows }))
            })
        };
        let reaching = Rows::from_pairs(navigation.mesh.triangles.len(), supports);
        Self { basis, sharing: Sharing::new(sites, skeleton), reaching }
    }

    /// The weights at a point and their gradients, ascending by site. Empty where no support reaches.
    ///
    /// Weights sum to 1 within rounding, and none is negative. Where two paths to a site are equally short, behind a hole for
    /// example, weights have a crease and several gradients: their mean is returned.
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
            let Some(path) = field.path_end_in(windows, p).filter(|path| path.distance < radius) else { continue };
            let t = path.distance / radius;
            let (phi, slope) = (self.basis.value(t), self.basis.derivative(t) / radius);
            let gradient = slope * path.gradient_in(windows, p);
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

    /// As [`at`](Self::at), with gradients from central differences over `step`: where weights have a crease, the mean of
    /// both sides.
    pub(crate) fn across(
        &self,
        navigation: &Navigation,
        sites: &[Site],
        (place, p): (Place, DVec2),
        step: f64,
    ) -> Vec<Influence> {
        let mut here = self.at(sites, place, p);
        // Beside a sharp corner a point may be moved by more than a step when it is located.
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
        self.reaching.row(place.0 as usize)
    }
}
