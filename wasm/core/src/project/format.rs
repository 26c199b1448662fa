//! The version of the project format.

/// The version of the format.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Format {
    /// The first and only version so far.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "c2warp/1"))]
    V1,
}
