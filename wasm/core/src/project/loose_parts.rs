//! How parts of the picture without a handle move.

/// How connected parts of the domain without a handle move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum LooseParts {
    /// They do not move.
    #[default]
    Stay,
    /// Each moves with the nearest point of a part that has a handle.
    Follow,
}
