#![doc = include_str!("../README.md")]
//!
//! # Start here
//!
//! 1. Describe the problem in a [`Project`](project::Project), built in code or [read](project::Project::from_json).
//! 2. Solve it: [`solve()`] on a [`Picture`], [`solve_domain`] on a [`Domain`](domain::Domain), [`solve_mesh`] on an
//!    [`InputMesh`], or [`solve_cloud`] on a [`PointCloud`](cloud::PointCloud). A [`Solver`] works in stages.
//! 3. Pose it: the solution's [`Poser`](pose::Poser) computes a [`Pose`](deform::Pose) for each frame of a drag.
//! 4. Use the [`Solution`] at any point: [`map`](Solution::map) it, read its [weights](Solution::influences_at), or
//!    draw the [warped picture](Solution::warped).
//!
//! [`Navigation`](distance::Navigation) measures intrinsic distances without a solve. [`Error`] has a sentence for
//! people and a [code](Error::code) for programs.
//!
//! Positions are in image pixels, with pixel centres at +0.5, y down, and the origin at the top left. Angles are in
//! radians, and in degrees in projects. The same input gives the same bits on every platform.
//!
//! # The method
//!
//! Xian, Jin and Wang, "Efficient C²-Weighting for Image Warping" (2016). The docs cite its sections and equations.
//!
//! ```text
//! picture ─► domain ─► sample ─► distance ─► site ─► weight ─► pose ─► deform ─► raster
//!               Ω      𝒫, mesh    d(p, h)    cells,    eq. 2    eq. 4     eq. 1    picture
//!                                          Algorithm 1
//! ```
// Some parts of the core serve only one feature. With all features, nothing is unused.
#![cfg_attr(
    not(all(feature = "serde", feature = "raster", feature = "cloud", feature = "rig", feature = "poser-bytes")),
    allow(dead_code, unused_imports)
)]
#![cfg_attr(docsrs, feature(doc_cfg))]

// Input: projects, pictures, limits and errors.
mod display_name;
mod display_number;
mod error;
pub mod limits;
mod opacity;
mod picture;
pub mod project;

// Geometry and containers without knowledge of warping.
mod disjoint_sets;
mod grid;
mod join;
mod min_entry;
mod min_max;
mod point_tree;
mod rank;
mod rows;
mod segment;
mod triangulation;

// The domain, and its other forms: a mesh or a point cloud of the caller.
#[cfg(feature = "cloud")]
pub mod cloud;
pub mod domain;
mod input_mesh;
mod prepared_domain;

// The method, in the order of the pipeline.
mod bone; // section V-D
pub mod clip;
pub mod deform;
pub mod distance;
mod loose;
pub mod pose;
mod sample;
pub mod site;
pub mod weight;

// Drawing.
mod cell_borders;
#[cfg(feature = "raster")]
pub mod fill;
mod fill_key;
#[cfg(feature = "raster")]
pub mod raster;
mod render_mesh;
mod static_background;

// Solving: read `pipeline` first.
#[cfg(feature = "raster")]
mod kept_fill;
mod pipeline;
mod report;
mod solution;
mod solve;
mod solve_input;
mod solve_key;
mod solved_sites;
mod solver;
#[cfg(feature = "raster")]
mod solver_fill;
mod stage;

// The same rig on another picture.
pub mod fit;

// Leaving: solutions for other programs.
mod continued;
#[cfg(feature = "rig")]
pub mod rig;
mod sprite_mesh;

// Where handles may go.
pub mod suggest;

// Explaining a solution.
mod lens;
mod study;

pub use bone::OutsidePart;
pub use cell_borders::BorderPiece;
#[cfg(feature = "cloud")]
pub use cloud::solve_cloud;
pub use continued::ContinuedMap;
pub use display_name::DisplayName;
pub use error::Error;
pub use glam;
pub use input_mesh::InputMesh;
pub use lens::{Lens, LensSite, Share};
pub use picture::Picture;
#[cfg(feature = "raster")]
pub use raster::options::{Canvas, Filter, ResampleOptions};
#[cfg(feature = "raster")]
pub use raster::{Drawing, extent::Extent, sources::Source, warped::Warped};
pub use report::{Inspection, Report};
pub use sample::Feather;
pub use solution::Solution;
pub use solve::{distances, solve, solve_domain, solve_mesh};
pub use solve_key::SolveKey;
pub use solver::Solver;
pub use sprite_mesh::{SpriteMesh, TooFewVertices};
pub use stage::{Stage, StageTimes};
pub use static_background::StaticBackground;
pub use study::{SiteStudy, Study};
