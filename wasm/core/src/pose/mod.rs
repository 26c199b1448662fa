//! From the posed handles to the motions of all sites (section IV-B, eq. 4). [`deform`](crate::deform) blends them.
//!
//! Once per solution:
//!
//! - `harmonic`: ϖ, the weights of handles in the motions of virtual sites (eq. 4, section V-C): about n √n for n
//!   sites.
//! - `rigid/quadrature`: the nodes at which the rigid mode measures distortion.
//!
//! Once per frame, in `poser`, for handles that match each `solved_handle`:
//!
//! - `motion`, `strain`: T_i as logarithms, blended as sums (eq. 4): handles × virtual sites, microseconds.
//! - `automatic`: rotations that the user did not set (section VI).
//! - `rigid`: the rigid mode, instead of eq. 4: some four milliseconds for 150 virtual sites.
//! - `sampled`: the start of the rigid mode from the shape in which a drag has left the picture.
//! - `unwrap`: whole turns.
//!
//! `displacement` moves points before the sites do.
//!
//! `numeric` contains the factorisations for `harmonic` and `rigid`.

mod automatic;
mod displacement;
mod harmonic;
mod motion;
mod numeric;
mod poser;
#[cfg(feature = "poser-bytes")]
mod poser_bytes;
#[cfg(feature = "rig")]
mod poser_parts;
mod rigid;
mod sampled;
mod solved_handle;
mod strain;
mod unwrap;

pub(crate) use displacement::{DisplacementField, picture_size};
pub(crate) use harmonic::HarmonicFields;
pub use motion::Motion;
pub(crate) use motion::turn;
pub use poser::Poser;
pub(crate) use poser::PoserInput;
#[cfg(feature = "rig")]
pub(crate) use poser_parts::PoserParts;
pub(crate) use rigid::{Node, Quadrature, RigidParts, StiffnessField, StiffnessMask};
pub(crate) use solved_handle::SolvedHandle;
pub use strain::Strain;
