//! r_i: how far a site's basis function reaches (paper, section III-B, eq. 3).

use crate::{
    project::{Support, Weighting},
    site::Site,
};

/// A support ends this share before the site it must stay clear of, so that rounding cannot make the two touch.
const CLEAR: f64 = 1e-12;
/// With a shape factor of 0 a support still reaches a little beyond its cell, or the farthest point of the cell would have
/// no weight at all: by this share of the room there is.
const LEAST: f64 = 0.25;
/// Smooth supports of virtual sites reach this multiple of their cell's radius, where no real site is nearer. Between
/// 1.5 and 2 the bending energy of the sample poses hardly changes; larger supports cost more.
const OVERLAP: f64 = 1.75;

/// The support radius of every site.
///
/// By the paper's rule, r_i = (1 − α) r_d + α r_h, where r_d has some room added and r_h is no less than that. By the
/// smooth rule r_h gives way to a multiple of r_d, as far as no real site is in the way. The only site of an island reaches
/// everywhere. No support reaches another real site.
pub(crate) fn support_radii(weighting: &Weighting, sites: &[Site]) -> Vec<f64> {
    let radius = |site: &Site| {
        if site.separation.is_infinite() {
            return f64::INFINITY;
        }
        let least = (site.cell_radius + LEAST * (site.reach_limit() - site.cell_radius)).min(site.clearance);
        let greatest = match weighting.support {
            Support::Paper => site.separation,
            Support::Smooth => site.clearance.min(OVERLAP * site.cell_radius),
        };
        let alpha = weighting.shape_factor;
        ((1.0 - alpha) * least + alpha * greatest.max(least)) * (1.0 - CLEAR)
    };
    sites.iter().map(radius).collect()
}
