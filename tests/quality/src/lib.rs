//! Measures the quality of poses: `npm run quality`.
//!
//! Standard poses are solved in every mode of the solver and by reference methods, and compared on one mesh. The
//! reference methods exist only in this crate:
//!
//! - [`dense_arap`]: as-rigid-as-possible over the whole mesh. It has the quality that the modes aim at, but is slow.
//! - [`least_squares`]: moving least squares. It ignores the domain.
//! - [`optimum`]: the least energy that a mesh can have. The editor's method is measured against it.
//!
//! [`distances`] compares intrinsic distances with exact geodesics. [`maxima`] counts secondary maxima of weights.
//! [`continuity`] measures jumps of their derivatives. [`suggestions`] draws suggested handles. [`drags`] measures
//! drags of the editor's samples, frame by frame.

pub mod comparison_mesh;
pub mod constraints;
pub mod continuity;
pub mod dense_arap;
pub mod distances;
pub mod drag_tables;
pub mod drags;
pub mod exact;
pub mod fills;
pub mod fitted;
pub mod least_squares;
pub mod maxima;
pub mod measure;
pub mod methods;
pub mod optimum;
pub mod poses;
pub mod random_poses;
pub mod requirements;
pub mod sheet;
pub mod suggestions;
pub mod tables;
