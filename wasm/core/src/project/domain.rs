//! The part of the picture to warp: Ω of the paper.

use glam::DVec2;

use super::error::ProjectError;
use super::path::Path;
use super::validate;
use crate::display_number::DisplayNumber;

/// The widest feather, in pixels.
pub(crate) const MOST_FEATHER_PX: f64 = 64.0;

/// The part of the picture to warp.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", schemars(rename = "Domain", deny_unknown_fields))]
#[non_exhaustive]
pub enum DomainSpec {
    /// The whole picture.
    Image,
    /// The part of the picture with enough opacity.
    Alpha {
        /// Minimum opacity of the domain, above 0 and up to 1.
        #[cfg_attr(feature = "schema", schemars(default = "default_threshold", extend("exclusiveMinimum" = 0), range(max = 1)))]
        threshold: f64,
    },
    /// The inside of closed rings by the even-odd rule: a ring inside a ring is a hole. The rest of the picture does
    /// not move.
    Polygon {
        /// One or more rings of at least three points `[x, y]`.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::rings"))]
        #[cfg_attr(
            feature = "schema",
            schemars(with = "Vec<Vec<super::points::Point>>", length(min = 1), inner(length(min = 3)))
        )]
        rings: Vec<Vec<DVec2>>,
        /// Width of the soft rim around the rings, in pixels, from 0 to 64. Moving parts extend this far beyond their
        /// outline and fade out. At rest, nothing changes.
        #[cfg_attr(feature = "schema", schemars(default, range(min = 0, max = MOST_FEATHER_PX)))]
        feather: f64,
    },
}

impl DomainSpec {
    /// The default threshold.
    pub(crate) const THRESHOLD: f64 = 0.5;

    /// The inside of rings, without a feather.
    #[must_use]
    pub fn polygon(rings: Vec<Vec<DVec2>>) -> Self {
        Self::Polygon { rings, feather: 0.0 }
    }

    /// The same rings with a feather of a width in pixels. Other domains have no feather.
    #[must_use]
    pub fn feathered(self, feather: f64) -> Self {
        match self {
            Self::Polygon { rings, .. } => Self::Polygon { rings, feather },
            other => other,
        }
    }
}

impl DomainSpec {
    pub(super) fn check(&self) -> Result<(), ProjectError> {
        match self {
            Self::Image => Ok(()),
            Self::Alpha { threshold } => Self::check_threshold(*threshold),
            Self::Polygon { rings, feather } => {
                Self::check_rings(rings)?;
                Self::check_feather(*feather)
            }
        }
    }

    /// Checks the range of a threshold.
    pub(crate) fn check_threshold(threshold: f64) -> Result<(), ProjectError> {
        // NaN fails both comparisons.
        if threshold > 0.0 && threshold <= 1.0 {
            return Ok(());
        }
        let domain = Path::Top.key("domain");
        domain
            .key("threshold")
            .refuse(format_args!("expected a number above 0 and up to 1, found {}", DisplayNumber(threshold)))
    }

    fn check_feather(feather: f64) -> Result<(), ProjectError> {
        if (0.0..=MOST_FEATHER_PX).contains(&feather) {
            return Ok(());
        }
        let domain = Path::Top.key("domain");
        let found = DisplayNumber(feather);
        domain.key("feather").refuse(format_args!("expected a number from 0 to {MOST_FEATHER_PX}, found {found}"))
    }

    /// Checks the number of rings and points, and that points are finite.
    pub(crate) fn check_rings(rings: &[Vec<DVec2>]) -> Result<(), ProjectError> {
        let domain = Path::Top.key("domain");
        let at = domain.key("rings");
        if rings.is_empty() {
            return at.refuse("expected at least one ring");
        }
        rings.iter().enumerate().try_for_each(|(index, ring)| validate::points(&at.index(index), ring, 3))
    }
}

#[cfg(feature = "schema")]
fn default_threshold() -> f64 {
    DomainSpec::THRESHOLD
}
