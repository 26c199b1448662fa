//! Settings of the weights: their support and falloff (sections III-B and V-A).

use super::error::ProjectError;
use super::path::Path;
use super::validate;
use crate::display_number::DisplayNumber;

/// α of the smallest supports.
const LEAST_FACTOR: u32 = 0;
/// α of the widest supports.
const MOST_FACTOR: u32 = 1;
/// The least n for which φ is C² (section V-A).
pub(super) const LEAST_DEGREE: u32 = 5;
/// Far above the degrees that still change the picture.
pub(super) const MOST_DEGREE: u32 = 32;

/// The parameters of the weights.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Weighting {
    /// α, from 0 (smallest supports) to 1 (widest supports).
    #[cfg_attr(feature = "schema", schemars(default = "default_shape_factor", range(min = LEAST_FACTOR, max = MOST_FACTOR)))]
    pub shape_factor: f64,
    /// Degree n of the Bézier polynomial φ, from 5 to 32. It is C² for degrees from 5.
    #[cfg_attr(feature = "schema", schemars(default = "default_degree", range(min = LEAST_DEGREE, max = MOST_DEGREE)))]
    pub degree: u32,
    /// Position of the inner control points of φ. They do not affect continuity.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub filling: Filling,
    /// Rule for the radius of a support.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub support: Support,
    /// The region in which weights have two continuous derivatives.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "super::json::is_default"))]
    #[cfg_attr(feature = "schema", schemars(default, extend("default" = Continuity::default())))]
    pub continuity: Continuity,
}

/// Position of the inner control points of φ (section V-A).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Filling {
    /// Evenly spaced on the line from b₂ to bₙ₋₂.
    #[default]
    Line,
    /// All at one half.
    Half,
}

/// The rule for the radius of a support.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Support {
    /// Eq. 3 towards real sites. A support never reaches another real site. It may extend beyond a nearby virtual site
    /// if its own cell does.
    #[default]
    Paper,
    /// Supports of virtual sites may overlap one another, and only keep clear of real sites. This makes the picture
    /// smoother.
    Smooth,
}

/// The region in which weights have two continuous derivatives.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Continuity {
    /// Weights of the exact distance. Second derivatives jump where paths begin to bend around a corner of the outline.
    /// Weights have a crease where two ways around a hole are equally long.
    #[default]
    Exact,
    /// Two continuous derivatives everywhere inside the outline. Distances are blended where paths begin to bend, and
    /// supports end before two ways around a hole are equally long. Holes require more virtual sites.
    C2,
}

fn default_shape_factor() -> f64 {
    1.0
}

fn default_degree() -> u32 {
    LEAST_DEGREE
}

impl Default for Weighting {
    fn default() -> Self {
        Self {
            shape_factor: default_shape_factor(),
            degree: default_degree(),
            filling: Filling::default(),
            support: Support::default(),
            continuity: Continuity::default(),
        }
    }
}

impl Weighting {
    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        let Self { shape_factor, degree, .. } = *self;
        if !(f64::from(LEAST_FACTOR)..=f64::from(MOST_FACTOR)).contains(&shape_factor) {
            return at.key("shape_factor").refuse(format_args!(
                "expected a number from {LEAST_FACTOR} to {MOST_FACTOR}, found {}",
                DisplayNumber(shape_factor)
            ));
        }
        validate::whole_number(&at.key("degree"), degree, &(LEAST_DEGREE..=MOST_DEGREE))
    }
}
