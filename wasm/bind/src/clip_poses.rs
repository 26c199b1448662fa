//! The poses of handles along a clip.

use c2warp::{
    Error,
    project::{Clip, Handle, clip_from_json, handles_from_json},
};
use wasm_bindgen::prelude::*;

use crate::{error::to_js, handle_poses::write};

/// A clip and the handles that it poses. JSON is read once, so a pose takes microseconds.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ClipPoses {
    clip: Clip,
    handles: Vec<Handle>,
}

#[wasm_bindgen]
impl ClipPoses {
    /// Takes a clip and handles as JSON, as in a project.
    ///
    /// # Errors
    /// Any deviation from the format, with the path of the offending key. The path starts at the clip, or at the list
    /// of handles.
    #[wasm_bindgen(constructor)]
    pub fn new(clip_json: &str, handles_json: &str) -> Result<Self, JsValue> {
        Self::try_new(clip_json, handles_json).map_err(|error| to_js(&error))
    }

    /// The poses of the handles, in their order, at any time in seconds. The layout is that of `handle_poses`.
    #[must_use]
    pub fn at(&self, time: f64) -> Vec<f64> {
        let mut numbers = Vec::new();
        write(&self.clip.at(time, &self.handles), &mut numbers);
        numbers
    }
}

impl ClipPoses {
    fn try_new(clip_json: &str, handles_json: &str) -> Result<Self, Error> {
        let handles = handles_from_json(handles_json)?;
        Ok(Self { clip: clip_from_json(clip_json, &handles)?, handles })
    }
}
