//! How values go from one key to the next.

use schemars::JsonSchema;
use serde::Serialize;

use super::super::cursor::Cursor;
use super::super::error::ProjectError;

/// How values go from a key to the next one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Ease {
    /// By a monotone cubic: C¹ through keys, and never beyond the values of both.
    #[default]
    Smooth,
    /// At a steady rate.
    Linear,
    /// By a jump at the next key.
    Hold,
}

impl Ease {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("smooth", Self::Smooth), ("linear", Self::Linear), ("hold", Self::Hold)])
    }
}
