//! What tests and measurements share: the scenes of `scenes/` and their pictures, which are drawn by formulas; outlines that are
//! hard for distances, and the geodesic in them; second maxima of weights.

pub mod maxima;
pub mod outlines;
pub mod pictures;
mod scene;
pub mod visibility;

pub use scene::Scene;
