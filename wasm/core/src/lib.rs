#![doc = include_str!("../README.md")]
//!
//! # Start here
//!
//! - [`Project`](project::Project) states the problem: read from a file ([`from_json`](project::Project::from_json)) or made in
//!   code. Its fields document their units and ranges; [`check`](project::Project::check) enforces them.
//! - [`solve`] solves it for a [`Picture`], [`solve_mesh`] for a mesh that the caller supplies, [`solve_cloud`] for a point
//!   cloud. A [`Solver`] solves one project of a picture after another, stage by stage, and keeps what they have in common.
//! - [`Solution`] holds for any point of the domain, not for samples only: where it [goes](Solution::map), the
//!   [weights](Solution::weights_at) there, and intrinsic [distances](Solution::distances). It draws the
//!   [warped picture](Solution::warped) and finds what is drawn [at a place of it](Solution::rest_at).
//! - [`Poser`](pose::Poser) makes a [`Pose`](pose::Pose) from posed handles. A drag needs nothing else.
//! - [`Error`] covers everything that is refused: a sentence for people, and a [code](Error::code) for programs.
//!
//! Units: image pixels, pixel centres at +0.5, y down, origin at the top left; radians, but degrees in a project. Places are
//! [`glam::DVec2`]; pairs of numbers convert into them. The same input gives the same bits on every platform.
//!
//! # The method
//!
//! Chuhua Xian, Shuo Jin and Charlie C. L. Wang, "Efficient C²-Weighting for Image Warping": closed-form weights on intrinsic
//! distances, virtual handles, harmonic motions. Weights are evaluated, never interpolated. Sections and equations cited in this
//! crate are the paper's. The pipeline, in the order of the modules:
//!
//! ```text
//! picture ─► domain ─► sample ─► distance ─► site ─► weight ─► pose ─► raster
//!               Ω      𝒫, mesh    d(p, h)    cells,    eq. 2    eq. 4,   picture
//!                                          Algorithm 1          eq. 1
//! ```

// What is given.
mod error;
mod limits;
mod picture;
pub mod project;

// Geometry and containers that know nothing of warping.
mod grid;
mod min_entry;
mod rows;
mod segment;
pub mod triangulation;

// The pipeline.
mod bone;
pub mod cloud;
pub mod distance;
pub mod domain;
mod given_mesh;
mod outline;
pub mod pose;
pub mod sample;
pub mod site;
pub mod weight;

// What is drawn.
mod drawing_order;
mod inverse;
pub mod raster;
mod render_mesh;

// The façade.
mod report;
mod request;
mod solution;
mod solver;
mod stage;

pub use bone::Outside;
pub use error::Error;
pub use given_mesh::GivenMesh;
/// The vectors that this crate's places are.
pub use glam;
pub use limits::{MAX_PIXELS, MAX_SIDE, MIN_SIDE};
pub use picture::{Picture, check_size};
pub use raster::{Canvas, Warped};
pub use render_mesh::RenderMesh;
pub use report::{Inspection, Report};
pub use solution::Solution;
pub use solver::{Solver, distances, solve, solve_cloud, solve_mesh};
pub use stage::{Stage, StageTimes};
