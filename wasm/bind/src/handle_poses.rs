//! Poses of handles as one flat array. The array is passed to the module once per frame.
//!
//! [`HandlePose::from_numbers`] describes it, and `web/src/document/handle_poses.ts` writes it.

use c2warp::{deform::HandlePose, project::Rotation};
use glam::DVec2;
use wasm_bindgen::JsValue;

use crate::error::with_code;

/// # Errors
/// For an array that ends within a handle.
pub(crate) fn read(numbers: &[f64]) -> Result<Vec<HandlePose>, JsValue> {
    HandlePose::from_numbers(numbers)
        .ok_or_else(|| with_code("the array of handle poses ends within a handle", "engine"))
}

/// Appends poses in the same layout.
pub(crate) fn write(poses: &[HandlePose], numbers: &mut Vec<f64>) {
    for pose in poses {
        let rotation = match pose.rotation {
            Rotation::Degrees(degrees) => degrees,
            Rotation::Auto => f64::NAN,
        };
        numbers.extend([pose.posed.len() as f64, rotation, pose.scale, pose.depth]);
        numbers.extend(pose.posed.iter().flat_map(DVec2::to_array));
    }
}
