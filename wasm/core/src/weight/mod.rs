//! The weights w_i of linear blending (section III-B, eq. 2), in closed form at any point: φ (`basis`, eq. 5), r_i
//! (`support`, eq. 3), w_i and its gradient at one point (`evaluate`), w_i of all samples (`sweep`, stored in `sparse`), and
//! the division among connected bones (`sharing`).
//!
//! Cost: at one point, the windows of the supports that reach its triangle; for all samples, some 10 ns for each sample and
//! such support. Limits: weights are C² except at joints of bones and where distances are not, behind corners: where two paths to a
//! site are equally short weights have a crease, and along the line at which paths begin to bend around a corner they are C¹. Their
//! second derivative jumps there, the more the nearer the corner. Eq. 2 does not rule out second maxima: a weight may grow again in a dead
//! end, or where several supports end together.

mod basis;
mod evaluate;
mod sharing;
mod sparse;
mod support;
mod sweep;

pub(crate) use basis::Basis;
pub use evaluate::Influence;
pub(crate) use evaluate::WeightFunctions;
pub use sparse::SparseWeights;
pub(crate) use support::support_radii;
pub(crate) use sweep::Swept;
