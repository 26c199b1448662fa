//! Poses of baked rigs for JavaScript: a separate module that only poses.
//!
//! The player loads it when a reader first poses a picture whose poses need the solver.

use c2warp::{deform::HandlePose, pose::Motion, rig::RigPoser};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

/// Poses the handles of a rig.
#[wasm_bindgen]
#[derive(Debug)]
pub struct SectionPoser {
    poser: RigPoser,
}

#[wasm_bindgen]
impl SectionPoser {
    /// Reads the unpacked section `POSR` of a rig.
    ///
    /// # Errors
    /// For a section of another format, or a damaged section.
    #[wasm_bindgen(constructor)]
    pub fn new(section: &[u8]) -> Result<Self, JsError> {
        let poser = RigPoser::from_section(section).map_err(|reason| JsError::new(&reason.to_string()))?;
        Ok(Self { poser })
    }

    /// The motions of all sites for posed handles. Each has seven numbers: angle; strain xx, xy, yy; translation x, y;
    /// depth. `poses` is the flat array of [`HandlePose::from_numbers`].
    ///
    /// # Errors
    /// For poses of other handles, and for poses without valid motions.
    pub fn motions(&self, poses: &[f64]) -> Result<Vec<f64>, JsError> {
        let poses = HandlePose::from_numbers(poses).ok_or_else(|| JsError::new("the poses end within a handle"))?;
        let motions = self.poser.motions(&poses).map_err(|reason| JsError::new(&reason.to_string()))?;
        let numbers = |&Motion { angle, strain, translation, depth, .. }: &Motion| {
            [angle, strain.xx, strain.xy, strain.yy, translation.x, translation.y, depth]
        };
        Ok(motions.iter().flat_map(numbers).collect())
    }
}
