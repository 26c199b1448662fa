//! The grounds that a solver keeps from one solve to the next.

use glam::DVec2;

use super::Ground;
use crate::{distance::Navigation, domain::Domain};

/// The grounds of samples and of scouts, as last asked for in one domain.
#[derive(Debug, Default)]
pub(crate) struct Grounds {
    of_samples: Option<Ground>,
    /// Only where they are not the same.
    of_scouts: Option<Ground>,
}

impl Grounds {
    /// The ground of about `count` samples: see [`Ground::new`].
    pub(crate) fn of_samples(
        &mut self,
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
        fading: Option<DVec2>,
    ) -> &Ground {
        known_or_new(&mut self.of_samples, domain, navigation, bones, count, fading)
    }

    /// The ground of about `count` scouts.
    pub(crate) fn of_scouts(
        &mut self,
        domain: &Domain,
        navigation: &Navigation,
        bones: &[[DVec2; 2]],
        count: usize,
    ) -> &Ground {
        match &self.of_samples {
            // Usually the count is that of the samples, and so is the ground.
            Some(known) if known.is_for(bones, count) => known,
            _ => known_or_new(&mut self.of_scouts, domain, navigation, bones, count, None),
        }
    }
}

/// A known ground, replaced if it is not the one asked for.
fn known_or_new<'a>(
    known: &'a mut Option<Ground>,
    domain: &Domain,
    navigation: &Navigation,
    bones: &[[DVec2; 2]],
    count: usize,
    fading: Option<DVec2>,
) -> &'a Ground {
    if known.as_ref().is_some_and(|ground| !ground.is_for(bones, count)) {
        *known = None;
    }
    known.get_or_insert_with(|| Ground::new(domain, navigation, bones, count, fading))
}
