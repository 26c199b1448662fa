//! What follows the end of a clip.

use schemars::JsonSchema;
use serde::Serialize;

use super::super::cursor::Cursor;
use super::super::error::ProjectError;

/// What follows the end of a clip.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "Loop")]
#[non_exhaustive]
pub enum Looping {
    /// The clip begins again. Values go on from the last keys to the first ones.
    #[default]
    Repeat,
    /// The clip runs backwards, then forwards again.
    Alternate,
    /// The last pose stays.
    None,
}

impl Looping {
    /// Whether the clip begins again after its end.
    pub(crate) fn repeats(self) -> bool {
        self == Self::Repeat
    }

    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("repeat", Self::Repeat), ("alternate", Self::Alternate), ("none", Self::None)])
    }
}
