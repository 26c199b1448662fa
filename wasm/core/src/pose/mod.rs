//! From where the handles were taken to where every point goes (paper, sections III (eq. 1) and IV-B (eq. 4)).

mod blend;
mod cholesky;
mod descent;
mod distortion;
mod dual;
mod elimination;
mod form;
mod harmonic;
mod laplacian;
mod motion;
mod poser;
mod quadrature;
mod relaxation;
mod rigid;
mod strain;
mod unwrap;

pub use blend::{Mapped, Pose};
pub use form::Form;
pub(crate) use form::Solved;
pub use harmonic::HarmonicFields;
pub use motion::Motion;
pub use poser::Poser;
pub(crate) use quadrature::Quadrature;
pub use strain::Strain;
