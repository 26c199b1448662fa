//! From the posed handles to the posed place of every point (sections III and IV-B, eq. 1 and 4).
//!
//! Once for a solution:
//!
//! - `harmonic`: ϖ, the shares of handles in the motions of virtual sites (eq. 4, section V-C), on a `laplacian` that
//!   `elimination` factorises: some n √n for n sites.
//! - `quadrature`: the nodes at which the rigid mode measures distortion.
//!
//! Once a frame, in `poser`:
//!
//! - `motion`, `strain`: T_i as logarithms, blended as sums (eq. 4): handles × virtual sites, microseconds.
//! - `rigid`: the rigid mode in place of eq. 4, by `descent` on the cell graph and then by `relaxation` of the `distortion`
//!   (with `cholesky`), and `unwrap` for whole turns: half a millisecond to one for 100 virtual sites.
//! - `blend`: p′ = Σ w_i(p) T_i(p) (eq. 1), or the rigid blend of `dual`: the supports over each point.
//!
//! `solved` is what a pose must match: the ids of handles, their kinds and their numbers of corners.

mod blend;
mod cholesky;
mod descent;
mod distortion;
mod dual;
mod elimination;
mod harmonic;
mod laplacian;
mod motion;
mod poser;
mod quadrature;
mod relaxation;
mod rigid;
mod solved;
mod strain;
mod unwrap;

pub use crate::project::Form;
pub use blend::{Mapped, Pose};
pub use harmonic::HarmonicFields;
pub use motion::Motion;
pub use poser::Poser;
pub(crate) use quadrature::Quadrature;
pub(crate) use solved::Solved;
pub use strain::Strain;
