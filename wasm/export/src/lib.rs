//! Solved pictures as rigs for game engines: a mesh with bones, weights and baked clips.
//!
//! [`EngineRig::new`] builds a rig from a solution, and [`EngineRig::files`] writes it in a [`Format`]. The crate does
//! not access files or decode pictures, so it also runs in a browser. The same input gives the same bytes.
//!
//! ```
//! use c2warp::{Picture, project::{Handle, Project}, solve};
//! use c2warp_export::{EngineRig, Format, Options};
//!
//! let rgba = vec![255; 40 * 30 * 4];
//! let picture = Picture::new(40, 30, &rgba)?;
//! let mut project = Project::for_picture(40, 30);
//! project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
//! let solution = solve(&project, &picture)?;
//! let rig = EngineRig::new("card", &project, &solution, &picture, Options { vertices: 60, ..Options::default() })?;
//! let files = rig.files(Format::Spine, &[])?;
//! assert_eq!(files.iter().map(|file| file.ending).collect::<Vec<_>>(), [".spine.json", ".atlas"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - `rig`: the rig. `bones`, `weights`, `motions`: fit the rig. `poses`: the poses that it is fitted to. `loss`: its
//!   errors.
//! - `chart`, `keys`: how a format poses bones, and the keys of clips.
//! - `spine`, `dragonbones`, `gltf`, `godot`: one file per format. `texture`: the picture beside it.

mod bones;
mod chart;
mod cholesky;
mod dragonbones;
mod error;
mod format;
mod gltf;
mod godot;
mod keys;
mod loss;
mod motions;
mod names;
mod number;
mod options;
mod poses;
mod rig;
mod spine;
mod texture;
mod weights;

pub use error::ExportError;
pub use format::{Format, RigFile};
pub use keys::KEY_TOLERANCE_PX;
pub use loss::{Errors, Loss};
pub use options::{MOST_BONES, Options};
pub use rig::{EngineRig, FRAMES_PER_SECOND};
pub use texture::texture;
