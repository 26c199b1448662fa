//! Poses in the page: the motions of all sites, once a frame.

use c2warp::{
    Error, pose,
    project::{Blend, handles_from_json},
};
use wasm_bindgen::prelude::*;

use crate::error::to_js;

/// Makes poses of one solution.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Poser(pose::Poser);

#[wasm_bindgen]
impl Poser {
    /// Takes the bytes of a solution's `poser`.
    ///
    /// # Errors
    /// For any other bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8]) -> Result<Self, JsValue> {
        pose::Poser::from_bytes(bytes).map(Self).map_err(|error| to_js(&error))
    }

    /// The motions of all sites for the project's `handles` as JSON: sites × 12 numbers, which are a, b, c, d, rest x, rest
    /// y, posed x, posed y, depth, angle, cosine and sine of half the angle, for T(p) = posed + [a c; b d] (p − rest).
    ///
    /// # Errors
    /// For handles that deviate from the format, or are not those that were solved.
    pub fn pose(&self, handles_json: &str) -> Result<Vec<f32>, JsValue> {
        // Motions do not depend on the blend, which the page computes.
        let pose = handles_from_json(handles_json)
            .map_err(Error::from)
            .and_then(|handles| self.0.pose(&handles, Blend::Linear));
        pose.map(|pose| pose.packed()).map_err(|error| to_js(&error))
    }
}
