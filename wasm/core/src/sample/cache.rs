//! Base samples that a solver keeps for the next solve.
//!
//! Fine and coarse samples are independent, so they are computed on two cores.

use glam::DVec2;

use super::{base::BaseSamples, coarse::CoarseSamples, samples::Samples};
use crate::{join::join, prepared_domain::PreparedDomain};

/// The last base samples of one domain.
#[derive(Debug, Default)]
pub(crate) struct SamplingCache {
    fine: Option<BaseSamples>,
    /// `None` while the fine samples also serve as coarse samples.
    coarse: Option<BaseSamples>,
}

/// The handles that samples lie on: bones, and points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places<'a> {
    pub(crate) bones: &'a [[DVec2; 2]],
    pub(crate) points: &'a [DVec2],
}

impl SamplingCache {
    /// About `count` samples of the drawn mesh, and about `coarse_count` coarse samples.
    pub(crate) fn samples(
        &mut self,
        prepared: &PreparedDomain,
        Places { bones, points }: Places<'_>,
        count: usize,
        coarse_count: usize,
    ) -> (Samples, CoarseSamples) {
        let Self { fine, coarse } = self;
        let new_fine = || BaseSamples::with_skirt(prepared, bones, count);
        let new_coarse = || BaseSamples::new(prepared, bones, coarse_count);
        if count == coarse_count {
            // The base samples are equal.
            let base = cached_or_new(fine, bones, count, new_fine);
            return (base.with_sites(prepared, points), CoarseSamples::new(base, prepared, points));
        }
        let (coarse, samples) = join(
            || CoarseSamples::new(cached_or_new(coarse, bones, coarse_count, new_coarse), prepared, points),
            || cached_or_new(fine, bones, count, new_fine).with_sites(prepared, points),
        );
        (samples, coarse)
    }
}

/// About `count` coarse samples, without others.
pub(crate) fn coarse_samples(
    prepared: &PreparedDomain,
    Places { bones, points }: Places<'_>,
    count: usize,
) -> CoarseSamples {
    CoarseSamples::new(&BaseSamples::new(prepared, bones, count), prepared, points)
}

/// The cached samples if they fit, or else new ones that replace them.
fn cached_or_new<'a>(
    cached: &'a mut Option<BaseSamples>,
    bones: &[[DVec2; 2]],
    count: usize,
    new: impl FnOnce() -> BaseSamples,
) -> &'a BaseSamples {
    // Drop samples that do not fit before making new ones: both need memory.
    if cached.as_ref().is_some_and(|base| !base.is_for(bones, count)) {
        *cached = None;
    }
    cached.get_or_insert_with(new)
}
