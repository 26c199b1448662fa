//! From the posed handles to the posed place of every point (sections III and IV-B, eq. 1 and 4).
//!
//! Once for a solution:
//!
//! - `harmonic`: ϖ, the shares of handles in the motions of virtual sites (eq. 4, section V-C): some n √n for n sites.
//! - `rigid/quadrature`: the nodes at which the rigid mode measures distortion.
//!
//! Once a frame, in `poser`, for handles that match those `solved`:
//!
//! - `motion`, `strain`: T_i as logarithms, blended as sums (eq. 4): handles × virtual sites, microseconds.
//! - `automatic`: the rotations that no person set (section VI).
//! - `rigid`: the rigid mode in place of eq. 4: half a millisecond to one for 100 virtual sites.
//! - `unwrap`: whole turns.
//!
//! Then for every point:
//!
//! - `blend`: p′ = Σ w_i(p) T_i(p) (eq. 1), or the rigid blend of `dual`: the supports over each point.
//!
//! `numeric` has the factorisations and the descent that `harmonic` and `rigid` are computed with.

mod automatic;
mod blend;
mod dual;
mod harmonic;
mod motion;
mod numeric;
mod poser;
mod rigid;
mod solved;
mod strain;
mod unwrap;

pub use blend::{Mapped, Pose};
pub(crate) use harmonic::HarmonicFields;
pub use motion::Motion;
pub use poser::Poser;
pub(crate) use rigid::Quadrature;
pub(crate) use solved::Solved;
pub use strain::Strain;
