//! r_i: the support radius of a site (section III-B, eq. 3).
//!
//! Cost: O(1) for each site.

use super::precedence::precedence_radii;
use crate::{
    project::{Support, Weighting},
    site::Site,
};

/// A support ends this far before the site that it must not reach, relative to its radius, so that rounding cannot make
/// them touch.
const ROUNDING_MARGIN: f64 = 1e-12;
/// With a shape factor of 0, a support still extends beyond its cell, by this share of the room up to its limit.
/// Otherwise the farthest point of the cell would have no weight.
const MIN_SUPPORT_SHARE: f64 = 0.25;
/// Radius of a smooth support relative to the cell radius, if no real site is nearer. Between 1.5 and 2, the bending
/// energy of the sample poses hardly changes; larger supports cost more.
const OVERLAP: f64 = 1.75;

/// The support radius of every site, in pixels.
///
/// - The paper's rule: r_i = (1 − α) r_d + α r_h. Here, r_d includes some additional room, and r_h is at least that
///   large.
/// - The smooth rule: a multiple of r_d replaces r_h, unless a real site is nearer.
///
/// A support extends at least as far as the precedence of its site.
///
/// If an island has no site outside a site's body, the radius is infinite. No support reaches another real site.
pub(crate) fn support_radii(weighting: &Weighting, sites: &[Site]) -> Vec<f64> {
    let radius = |site: &Site| {
        if site.separation.is_infinite() {
            return site.unique_reach;
        }
        let limit = site.clearance.min(site.unique_reach);
        let least = (site.cell_radius + MIN_SUPPORT_SHARE * (site.reach_limit() - site.cell_radius)).min(limit);
        let greatest = match weighting.support {
            Support::Paper => site.separation.min(site.unique_reach),
            Support::Smooth => limit.min(OVERLAP * site.cell_radius),
        };
        let alpha = weighting.shape_factor;
        ((1.0 - alpha) * least + alpha * greatest.max(least)) * (1.0 - ROUNDING_MARGIN)
    };
    let radii = sites.iter().zip(precedence_radii(weighting, sites));
    radii.map(|(site, precedence)| radius(site).max(precedence)).collect()
}
