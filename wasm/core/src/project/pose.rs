//! How virtual sites derive their motions from handles, and how motions are blended.

use super::error::ProjectError;
use super::path::Path;
use super::validate;

/// Greatest density. It is below [`MAX_SITES`](crate::limits::MAX_SITES), which leaves room for the sites that handles
/// need.
pub(super) const MAX_DENSITY: u32 = 4096;

/// Settings of the pose.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Pose", deny_unknown_fields))]
#[non_exhaustive]
pub struct PoseSpec {
    /// How virtual sites derive their motions.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub mode: PoseMode,
    /// How the motions at a point are blended.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub blend: Blend,
    /// Least number of virtual sites, up to 4,096. With 0, Algorithm 1 determines the number.
    #[cfg_attr(feature = "schema", schemars(default, range(max = MAX_DENSITY)))]
    pub density: u32,
}

/// How virtual sites derive their motions from handles.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum PoseMode {
    /// By harmonic fields on the cell graph, as in the paper (eq. 4).
    #[default]
    Harmonic,
    /// As rigid as possible on the cell graph. Then the symmetric Dirichlet energy of the blended picture is
    /// minimized. Handles need no rotations.
    Rigid,
}

/// How the motions at a point are blended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Blend {
    /// Linearly, as in the paper (eq. 1).
    #[default]
    Linear,
    /// As rotations and translations.
    Rigid,
}

impl PoseSpec {
    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        validate::whole_number(&at.key("density"), self.density, &(0..=MAX_DENSITY))
    }
}
