//! Code that tests, benchmarks and quality measurements share.
//!
//! - The scenes of `scenes/` and their generated pictures.
//! - Outlines that are difficult for distances, and exact geodesics in them.
//! - Secondary maxima of weights, and jumps of their derivatives.
//! - Pseudo-random numbers.

pub mod outlines;
pub mod pictures;
mod random;
mod scene;
pub mod secondary_maxima;
pub mod smoothness;
pub mod visibility;

pub use random::Random;
pub use scene::Scene;
