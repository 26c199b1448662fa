//! The base samples that a solver keeps from one solve to the next.

use glam::DVec2;

use super::BaseSamples;
use crate::{distance::Navigation, domain::Domain};

/// The base samples of samples and of coarse samples, as last asked for in one domain.
#[derive(Debug, Default)]
pub(crate) struct SamplingCache {
    of_samples: Option<BaseSamples>,
    /// Only where they are not the same.
    of_coarse: Option<BaseSamples>,
}

impl SamplingCache {
    /// The base samples of about `count` samples: see [`BaseSamples::new`].
    pub(crate) fn of_samples(
        &mut self,
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
        fading: Option<DVec2>,
    ) -> &BaseSamples {
        known_or_new(&mut self.of_samples, domain, navigation, bones, count, fading)
    }

    /// The base samples of about `count` coarse samples.
    pub(crate) fn of_coarse(
        &mut self,
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
    ) -> &BaseSamples {
        match &self.of_samples {
            // Usually the count is that of the samples, and so is the base samples.
            Some(known) if known.is_for(bones, count) => known,
            _ => known_or_new(&mut self.of_coarse, domain, navigation, bones, count, None),
        }
    }
}

/// A known base samples, replaced if it is not the one asked for.
fn known_or_new<'a>(
    known: &'a mut Option<BaseSamples>,
    domain: &Domain,
    navigation: &Navigation,
    bones: &[[DVec2; 2]],
    count: usize,
    fading: Option<DVec2>,
) -> &'a BaseSamples {
    if known.as_ref().is_some_and(|base| !base.is_for(bones, count)) {
        *known = None;
    }
    known.get_or_insert_with(|| BaseSamples::new(domain, navigation, bones, count, fading))
}
