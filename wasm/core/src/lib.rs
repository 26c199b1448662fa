//! c2warp bends pictures: handles are placed on a picture and dragged, and the picture follows, smoothly, locally and along
//! the shape of what it shows.
//!
//! The method is that of Xian, Jin and Wang, "Efficient C²-Weighting for Image Warping": closed-form weights on intrinsic
//! distances, virtual handles, harmonic motions. The pipeline, in the order of the modules:
//!
//! ```text
//! picture ─► domain ─► sample ─► distance ─► site ─► weight ─► pose ─► raster
//!               Ω      𝒫, mesh    d(p, h)    cells,    eq. 2    eq. 4,   picture
//!                                          Algorithm 1          eq. 1
//! ```
//!
//! [`solve`] runs it whole; a [`Solver`] runs it stage by stage; [`solve_mesh`] runs it on a mesh that the caller brings, [`solve_cloud`] on a point cloud. [`Solution`] answers for any point of the domain, not for
//! samples only: distances and weights are evaluated, never interpolated.
//!
//! ```
//! use c2warp::{Picture, project::Project, solve};
//!
//! let rgba = vec![255; 64 * 48 * 4];
//! let picture = Picture::new(64, 48, &rgba)?;
//! let project = Project::from_json(r#"{
//!     "format": "c2warp/1",
//!     "image": { "src": "white.png", "width": 64, "height": 48 },
//!     "samples": 500,
//!     "handles": [
//!         { "id": "left", "kind": "point", "rest": [10, 24] },
//!         { "id": "right", "kind": "point", "rest": [54, 24], "posed": [54, 30] }
//!     ]
//! }"#).map_err(c2warp::Error::from)?;
//! let solution = solve(&project, &picture)?;
//! let pose = solution.poser().pose(&project.handles, project.pose.blend)?;
//! let mapped = solution.map(&pose, [54.0, 24.0].into()).expect("inside the picture");
//! assert_eq!(mapped.posed, [54.0, 30.0].into());
//! let warped = solution.warped(&picture, &pose, 0.5)?;
//! assert_eq!((warped.width, warped.height, warped.rgba.len()), (32, 24, 32 * 24 * 4));
//! # Ok::<(), c2warp::Error>(())
//! ```
//!
//! Units: image pixels, pixel centres at +0.5, y down, origin at the top left; radians. The same input gives the same bits on
//! every platform.

mod bone;
pub mod cloud;
pub mod distance;
pub mod domain;
mod drawing_order;
mod error;
mod given_mesh;
mod inverse;
mod least;
mod locate;
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
pub use picture::{MAX_PIXELS, MAX_SIDE, MIN_SIDE, Picture, check_size};
pub use raster::Warped;
pub use render_mesh::RenderMesh;
pub use report::{Inspection, Outside, Report, StageTimes};
pub use solution::Solution;
pub use solver::{Solver, Stage, distances, solve, solve_cloud, solve_mesh};
