//! The core of c2warp for JavaScript: thin wrappers that convert typed arrays, JSON and errors.
//!
//! [`Session`] solves in a worker; [`PosedPicture`] runs in the page and answers questions about a solution. Arrays are
//! copied out once, into typed arrays that the caller may transfer: views of the module's memory become invalid when it
//! grows.

mod cell_borders;
mod clip_playback;
mod clip_poses;
mod drawing;
mod error;
mod fill;
mod filming;
mod frame_times;
mod handle_poses;
mod history;
mod json;
mod points;
mod posed_picture;
mod session;
mod solution;

use c2warp::project::Project;
use wasm_bindgen::prelude::*;

pub use cell_borders::CellBorders;
pub use clip_playback::ClipPlayback;
pub use clip_poses::ClipPoses;
pub use drawing::{Canvas, Drawing};
pub use fill::Fill;
pub use filming::Filming;
pub use frame_times::frame_times;
pub use history::History;
pub use points::{PointWeights, PosedMesh};
pub use posed_picture::{PictureArrays, PosedPicture};
pub use session::Session;
pub use solution::Solution;

/// Checks a project file.
///
/// # Errors
/// Any deviation from the format, with the path of the offending key.
#[wasm_bindgen]
pub fn project_check(json: &str) -> Result<(), JsValue> {
    Project::from_json(json).map_err(|reason| error::to_js(&reason.into()))?;
    Ok(())
}

/// The version of this module.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}
