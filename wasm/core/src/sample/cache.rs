//! Base samples that a solver keeps for the next solve.

use glam::DVec2;

use super::base::BaseSamples;
use crate::prepared_domain::PreparedDomain;

/// The last base samples of one domain.
#[derive(Debug, Default)]
pub(crate) struct SamplingCache {
    fine: Option<BaseSamples>,
    /// `None` while the fine ones serve as coarse ones, too.
    coarse: Option<BaseSamples>,
}

impl SamplingCache {
    /// Base samples of the drawn mesh, about `count`. See [`BaseSamples::new`].
    pub(crate) fn fine(&mut self, prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> &BaseSamples {
        let new = || BaseSamples::new(prepared, bones, count).with_skirt(prepared);
        cached_or_new(&mut self.fine, bones, count, new)
    }

    /// Base samples of the [coarse samples](super::CoarseSamples), about `count`.
    pub(crate) fn coarse(&mut self, prepared: &PreparedDomain, bones: &[[DVec2; 2]], count: usize) -> &BaseSamples {
        match &self.fine {
            // Small counts are equal, and so are the base samples.
            Some(fine) if fine.is_for(bones, count) => fine,
            _ => cached_or_new(&mut self.coarse, bones, count, || BaseSamples::new(prepared, bones, count)),
        }
    }
}

/// The cached samples if they fit, or else new ones in their place.
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
