//! How the motions of virtual sites are computed from the handles, and how motions are blended.

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::path::Path;
use super::{ProjectError, rules};

/// Greatest density: half of the greatest number of sites, so that the sites that handles require have room.
const MAX_DENSITY: u32 = crate::limits::MAX_SITES as u32 / 2;

/// How a pose is made from the handles.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[schemars(rename = "Pose", deny_unknown_fields)]
#[non_exhaustive]
pub struct PoseSpec {
    /// Where virtual sites get their motions from.
    #[schemars(default)]
    pub mode: PoseMode,
    /// How the motions that reach a point are blended.
    #[schemars(default)]
    pub blend: Blend,
    /// The least number of virtual sites to insert, up to 4,096; 0 leaves it to Algorithm 1.
    #[schemars(default, range(max = MAX_DENSITY))]
    pub density: u32,
}

/// Where virtual sites get their motions from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum PoseMode {
    /// Harmonic fields on the cell graph, as the paper does (eq. 4).
    #[default]
    Harmonic,
    /// As rigid as possible on the cell graph, and then with as little stretch of the blended picture as may be (its symmetric
    /// Dirichlet energy): needs no rotations from the person.
    Rigid,
}

/// How the motions that reach a point are blended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Blend {
    /// Linearly, as the paper does (eq. 1).
    #[default]
    Linear,
    /// As rotations and translations.
    Rigid,
}

impl PoseSpec {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let pose = value.object()?;
        pose.only(&["mode", "blend", "density"])?;
        let default = Self::default();
        Ok(Self {
            mode: pose.or("mode", default.mode, |value| {
                value.one_of(&[("harmonic", PoseMode::Harmonic), ("rigid", PoseMode::Rigid)])
            })?,
            blend: pose.or("blend", default.blend, |value| {
                value.one_of(&[("linear", Blend::Linear), ("rigid", Blend::Rigid)])
            })?,
            density: pose.or("density", default.density, |value| value.whole_number(&(0..=MAX_DENSITY)))?,
        })
    }

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        rules::whole_number(&at.key("density"), self.density, &(0..=MAX_DENSITY))
    }
}
