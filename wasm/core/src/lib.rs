#![doc = include_str!("../README.md")]
//!
//! # Start here
//!
//! - [`Project`](project::Project) is what is asked for: read from a file ([`from_json`](project::Project::from_json)) or made in code. Its
//!   fields say their units and ranges; [`check`](project::Project::check) holds them to these.
//! - [`solve`] solves it for a [`Picture`], [`solve_mesh`] for a mesh that the caller brings, [`solve_cloud`] for a point cloud. A [`Solver`] solves one project of a
//!   picture after another, stage by stage, and keeps what they have in common.
//! - [`Solution`] answers for any point of the domain, not for samples only: where it [goes](Solution::map), what [moves](Solution::weights_at)
//!   it, how [far](Solution::distances) it is from others. It draws the [warped picture](Solution::warped), and tells what is drawn
//!   [where](Solution::rest_at).
//! - [`Poser`](pose::Poser) makes a [`Pose`](pose::Pose) from where the handles are taken. It is all that a drag needs.
//! - [`Error`] is whatever is refused: a sentence for people, and a [code](Error::code) for programs.
//!
//! Units: image pixels, pixel centres at +0.5, y down, origin at the top left; radians, but degrees in a project. Places are [`glam::DVec2`]; pairs
//! of numbers turn into them. The same input gives the same bits on every platform.
//!
//! # The method
//!
//! It is that of Chuhua Xian, Shuo Jin and Charlie C. L. Wang, "Efficient C²-Weighting for Image Warping", IEEE Computer Graphics and
//! Applications 38(1), 2018, [doi:10.1109/MCG.2017.2801409](https://doi.org/10.1109/MCG.2017.2801409): closed-form weights on intrinsic
//! distances, virtual handles, harmonic motions. Weights are evaluated, never interpolated. "Section" and "eq." in these pages mean
//! that paper's. The pipeline, in the order of the modules:
//!
//! ```text
//! picture ─► domain ─► sample ─► distance ─► site ─► weight ─► pose ─► raster
//!               Ω      𝒫, mesh    d(p, h)    cells,    eq. 2    eq. 4,   picture
//!                                          Algorithm 1          eq. 1
//! ```

mod bone;
pub mod cloud;
pub mod distance;
pub mod domain;
mod drawing_order;
mod error;
mod given_mesh;
mod grid;
mod inverse;
mod locate;
mod min_entry;
mod picture;
pub mod pose;
pub mod project;
pub mod raster;
mod render_mesh;
mod report;
mod request;
mod rows;
pub mod sample;
mod segment;
pub mod site;
mod solution;
mod solver;
pub mod triangulation;
pub mod weight;

pub use error::Error;
pub use given_mesh::GivenMesh;
/// The vectors that this crate's places are.
pub use glam;
pub use picture::{MAX_PIXELS, MAX_SIDE, MIN_SIDE, Picture, check_size};
pub use raster::Warped;
pub use render_mesh::RenderMesh;
pub use report::{Inspection, Outside, Report, StageTimes};
pub use solution::Solution;
pub use solver::{Solver, Stage, distances, solve, solve_cloud, solve_mesh};
