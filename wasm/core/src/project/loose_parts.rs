//! How parts of the picture without a handle move.

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::error::ProjectError;

/// How connected parts of the domain without a handle move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum LooseParts {
    /// They stay in place.
    #[default]
    Stay,
    /// Each moves with the nearest point of a part that has a handle.
    Follow,
}

impl LooseParts {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("stay", Self::Stay), ("follow", Self::Follow)])
    }
}
