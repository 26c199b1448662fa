//! How well pictures bend: standard poses, each by every mode of the solver and by two methods to compare with, measured on one
//! mesh.
//!
//! The methods to compare with are here, in test code: as-rigid-as-possible over the whole mesh ([`dense`]), which takes the
//! modes' place where time plays no part, and moving least squares ([`least_squares`]), which knows no domain. Distances inside the
//! picture, which all rests on, are compared with the geodesic ([`distances`]), and second maxima of weights are counted ([`maxima`]).

pub mod bars;
pub mod dense;
pub mod distances;
pub mod fine;
pub mod least_squares;
pub mod maxima;
pub mod measure;
pub mod methods;
pub mod poses;
pub mod sheet;
pub mod tables;
pub mod targets;
