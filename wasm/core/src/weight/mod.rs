//! The weights w_i of linear blending (paper, section III-B, eq. 2), in closed form at any point.

mod basis;
mod evaluate;
mod sharing;
mod sparse;
mod support;
mod sweep;

pub use basis::Basis;
pub use evaluate::{Influence, Weights};
pub use sparse::SparseWeights;
pub(crate) use support::support_radii;
pub(crate) use sweep::Swept;
