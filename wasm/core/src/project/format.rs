//! The version of the project format.

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::error::ProjectError;

/// The version of the format.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[non_exhaustive]
pub enum Format {
    /// The first version, and so far the only one.
    #[default]
    #[serde(rename = "c2warp/1")]
    V1,
}

impl Format {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        match value.string()? {
            "c2warp/1" => Ok(Self::V1),
            other => value.refuse(format_args!("expected \"c2warp/1\", found {other:?}")),
        }
    }
}
