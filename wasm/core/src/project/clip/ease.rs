//! How values change from one key to the next.

/// How values change from a key to the next one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Ease {
    /// A monotone cubic: C¹ through keys, and never beyond the values of both.
    #[default]
    Smooth,
    /// Linear change.
    Linear,
    /// A jump at the next key.
    Hold,
}
