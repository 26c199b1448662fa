//! The weights w_i of linear blending (section III-B, eq. 2), in closed form at any point.
//!
//! - `basis`: φ (section V-A, eq. 5).
//! - `precedence`: the share that point handles take from other sites if the outline is held.
//! - `support`: r_i (eq. 3).
//! - `evaluate`: w_i and its gradient at one point, as an `influence`.
//! - `sweep`: w_i at all samples, stored in `sparse`.
//! - `bodies`: how the bones of a body divide its weight (section V-D).
//!
//! Cost: at one point, the windows of the supports that reach its triangle. For all samples, about 10 ns for each
//! sample and such support.
//!
//! Limits:
//!
//! - Weights are C² except at joints of bones and where distances are not C², behind reflex corners. Weights have a
//!   crease where two paths to a site are equally short. They are C¹ where paths begin to bend around a corner: their
//!   second derivative jumps, and the jump grows towards the corner.
//! - `"continuity": "c2"` avoids both. Penumbrae blend distances where paths begin to bend, and supports end before two
//!   paths are equally short. Weights are then C² except at joints of bones and at reflex corners themselves.
//! - Eq. 2 does not rule out second maxima: a weight may grow again in a dead end, or where several supports end
//!   together.

mod basis;
mod bodies;
mod evaluate;
mod influence;
mod precedence;
mod sparse;
mod support;
mod sweep;

pub(crate) use basis::Basis;
pub(crate) use evaluate::WeightFunctions;
pub use influence::Influence;
pub(crate) use precedence::precedence_radii;
pub use sparse::SparseWeights;
pub(crate) use support::support_radii;
pub(crate) use sweep::SampleWeights;
