//! r_i: the support radius of a site (section III-B, eq. 3).

use crate::{
    project::{Support, Weighting},
    site::Site,
};

/// A support ends this share before the site that it must keep clear of, so that rounding cannot make the two touch.
const ROUNDING_MARGIN: f64 = 1e-12;
/// With a shape factor of 0 a support still extends beyond its cell, or the farthest point of the cell would have no weight:
/// by this share of the room up to its limit.
const MIN_SUPPORT_SHARE: f64 = 0.25;
/// Smooth supports have this multiple of the cell's radius, where no real site is nearer. Between 1.5 and 2 the bending
/// energy of the sample poses hardly changes; larger supports cost more.
const OVERLAP: f64 = 1.75;

/// The support radius of every site.
///
/// By the paper's rule r_i = (1 − α) r_d + α r_h, with some room added to r_d, and r_h no less than that sum. By the smooth
/// rule a multiple of r_d replaces r_h, as far as no real site is in the way. A site that has no other in its island, apart
/// from those of its own body, reaches everywhere. No support reaches another real site.
pub(crate) fn support_radii(weighting: &Weighting, sites: &[Site]) -> Vec<f64> {
    let radius = |site: &Site| {
        if site.separation.is_infinite() {
            return f64::INFINITY;
        }
        let least =
            (site.cell_radius + MIN_SUPPORT_SHARE * (site.reach_limit() - site.cell_radius)).min(site.clearance);
        let greatest = match weighting.support {
            Support::Paper => site.separation,
            Support::Smooth => site.clearance.min(OVERLAP * site.cell_radius),
        };
        let alpha = weighting.shape_factor;
        ((1.0 - alpha) * least + alpha * greatest.max(least)) * (1.0 - ROUNDING_MARGIN)
    };
    sites.iter().map(radius).collect()
}
