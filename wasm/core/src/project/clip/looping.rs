//! What follows the end of a clip.

/// What follows the end of a clip.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", schemars(rename = "Loop"))]
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
}
