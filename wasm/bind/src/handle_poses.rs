//! Poses of handles as one flat array. It crosses the border once a frame.
//!
//! Each handle has the number n of its corners (1 for a point), rotation, scale, depth, and n × 2 coordinates. The
//! rotation is in degrees, and NaN is automatic. `web/src/document/handle_poses.ts` writes the array.

use c2warp::{deform::HandlePose, project::Rotation};
use glam::DVec2;
use wasm_bindgen::JsValue;

use crate::error::with_code;

/// Numbers of a handle before its corners.
const HEAD: usize = 4;

/// # Errors
/// For an array that ends within a handle.
pub(crate) fn read(mut numbers: &[f64]) -> Result<Vec<HandlePose>, JsValue> {
    let mut poses = Vec::new();
    while let Some((&[corners, rotation, scale, depth], rest)) = numbers.split_first_chunk::<HEAD>() {
        let length = 2 * corners as usize;
        let Some((coordinates, rest)) = rest.split_at_checked(length) else { return Err(malformed()) };
        let posed = coordinates.as_chunks::<2>().0.iter().copied().map(DVec2::from_array).collect();
        let rotation = if rotation.is_nan() { Rotation::Auto } else { Rotation::Degrees(rotation) };
        poses.push(HandlePose { posed, rotation, scale, depth });
        numbers = rest;
    }
    if numbers.is_empty() { Ok(poses) } else { Err(malformed()) }
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

fn malformed() -> JsValue {
    with_code("the array of handle poses ends within a handle", "engine")
}
