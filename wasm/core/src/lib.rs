#![doc = include_str!("../README.md")]
//!
//! # Start here
//!
//! - [`Project`](project::Project) states the problem: read from a file ([`from_json`](project::Project::from_json)) or made in
//!   code. Its fields document their units and ranges; [`check`](project::Project::check) enforces them.
//! - [`solve`] solves it for a [`Picture`], [`solve_domain`] for a [`Domain`](domain::Domain) alone, [`solve_mesh`] for a mesh
//!   that the caller supplies, [`solve_cloud`] for a point cloud. A [`Solver`] solves one project of a picture after another, stage
//!   by stage, and keeps what they have in common.
//! - [`Solution`] holds for any point of the domain, not for samples only: where it [goes](Solution::map), and the
//!   [weights](Solution::influences_at) there with their gradients, for many points as [sparse rows](Solution::weights_of). It draws the
//!   [warped picture](Solution::warped) and finds what is drawn [at places of it](Solution::rest_points).
//! - [`Poser`](pose::Poser) makes a [`Pose`](deform::Pose) from posed handles. A drag needs nothing else.
//! - [`Navigation`](distance::Navigation) measures intrinsic distances in a domain, and needs nothing else.
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
mod display_number;
mod error;
pub mod limits;
mod picture;
pub mod project;

// Geometry and containers that know nothing of warping.
mod grid;
mod min_entry;
mod min_max;
mod rows;
mod segment;
mod triangulation;

// The pipeline.
mod bone;
pub mod cloud;
pub mod distance;
pub mod domain;
mod input_mesh;
pub mod pose;
mod prepared_domain;
mod sample;
pub mod site;
pub mod weight;

// What is drawn.
mod cell_borders;
pub mod deform;
pub mod raster;
mod render_mesh;
mod static_background;

// The façade.
mod pipeline;
mod report;
mod solution;
mod solve;
mod solve_input;
mod solved_sites;
mod solver;
mod stage;

/// The vectors that this crate's places are.
pub use glam;

// The problem.
pub use error::Error;
pub use input_mesh::InputMesh;
pub use picture::Picture;

// Solving it.
pub use solve::{distances, solve, solve_cloud, solve_domain, solve_mesh};
pub use solver::Solver;
pub use stage::{Stage, StageTimes};

// What comes out.
pub use bone::OutsidePart;
pub use cell_borders::BorderPiece;
pub use raster::{
    options::{Canvas, Filter, ResampleOptions},
    sources::Source,
    warped::Warped,
};
pub use report::{Inspection, Report};
pub use solution::Solution;
pub use static_background::StaticBackground;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_program_holds_goes_from_thread_to_thread() {
        fn check<T: Send + Sync + std::fmt::Debug>() {}
        fn check_clone<T: Clone>() {}
        check::<(Error, InputMesh, Picture<'_>, Solution, Solver, Warped, Report)>();
        check::<(cloud::PointCloud, cloud::CloudSolution, domain::Domain, project::Project)>();
        check::<(distance::Navigation, distance::Distances<'_>, pose::Poser, deform::Pose, weight::SparseWeights)>();
        check_clone::<(Solution, cloud::CloudSolution, distance::Navigation, distance::Distances<'_>, deform::Pose)>();
    }
}
