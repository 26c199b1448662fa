//! What tests and measurements share: the scenes of `scenes/` and their pictures, which are drawn by formulas.

pub mod pictures;
mod scene;

pub use scene::Scene;
