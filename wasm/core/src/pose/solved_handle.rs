//! The name and the shape kind of a handle. A pose must match both.

use crate::project::ShapeKind;

/// A solved handle without its positions.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct SolvedHandle {
    pub(crate) id: String,
    pub(crate) shape: ShapeKind,
}
