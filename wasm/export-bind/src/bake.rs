//! The rig of a web page.

use std::fmt;

use c2warp::{
    Picture,
    project::Project,
    rig::{Posable, Rig, RigPicture},
};
use js_sys::{Error as JsError, Function};
use wasm_bindgen::prelude::*;

use crate::solution::solution;

/// Solves a project, and bakes its clips.
///
/// `rgba` is straight, rows from top to bottom. `picture_file` is a PNG, WebP or JPEG file of the same picture.
/// `posable`: readers may pose the handles in the rigid mode, too. `on_progress` receives the completed fraction, from
/// 0 to 1.
///
/// # Errors
/// For a project that cannot be solved with this picture, and for clips that do not fit in a rig.
#[wasm_bindgen]
pub fn bake(
    project_json: &str,
    width: u32,
    height: u32,
    rgba: &[u8],
    picture_file: Vec<u8>,
    posable: bool,
    on_progress: &Function,
) -> Result<Vec<u8>, JsError> {
    let refused = |reason: &dyn fmt::Display| JsError::new(&reason.to_string());
    let project = Project::from_json(project_json).map_err(|reason| refused(&reason))?;
    let picture = Picture::new(width, height, rgba).map_err(|reason| refused(&reason))?;
    let solution = solution(&project, &picture).map_err(|reason| refused(&reason))?;
    let posable = if posable { Posable::Always } else { Posable::WithoutSolver };
    let picture = RigPicture { width, height, file: picture_file };
    let mut on_progress = |part: f64| {
        // Nothing can be done about a listener that fails.
        let _ = on_progress.call1(&JsValue::NULL, &part.into());
    };
    let rig = Rig::bake_with_progress(&project, &solution, picture, posable, &mut on_progress);
    rig.and_then(|rig| rig.to_bytes()).map_err(|reason| refused(&reason))
}
