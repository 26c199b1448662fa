//! What happens after the end of a clip.

/// What happens after the end of a clip.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", schemars(rename = "Loop"))]
#[non_exhaustive]
pub enum Looping {
    /// The clip repeats. Values continue from the last keys to the first ones.
    #[default]
    Repeat,
    /// The clip runs backwards, then forwards again.
    Alternate,
    /// The clip stops at the last pose.
    None,
}

impl Looping {
    /// Whether the clip repeats.
    pub(crate) fn repeats(self) -> bool {
        self == Self::Repeat
    }
}
