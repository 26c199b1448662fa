//! A picture that is posed along a clip.

use c2warp::{
    Error, clip,
    project::{clip_from_json, handles_from_json},
};
use wasm_bindgen::prelude::*;

use crate::{error::to_js, posed_picture::PosedPicture};

/// The poses of one solution along a clip, without the jumps of the rigid mode. They depend only on the time, not on
/// earlier times.
///
/// The first request for a later time poses every sixtieth of a second up to it. After that, a request needs one or two
/// poses.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ClipPlayback(clip::Playback);

#[wasm_bindgen]
impl ClipPlayback {
    /// Takes the picture to pose, a clip as JSON, and the solved handles as JSON, in their present poses. Handles
    /// without a track keep their present pose.
    ///
    /// # Errors
    /// Any deviation from the format, with the path of the offending key. The path starts at the clip, or at the list
    /// of handles.
    #[wasm_bindgen(constructor)]
    pub fn new(picture: &PosedPicture, clip_json: &str, handles_json: &str) -> Result<Self, JsValue> {
        Self::try_new(picture, clip_json, handles_json).map_err(|error| to_js(&error))
    }

    /// Poses the picture at any time in seconds. Returns the motions of all sites, as
    /// [`set_pose`](PosedPicture::set_pose).
    ///
    /// # Errors
    /// For a picture of another solution, and for handles that have no pose at that time. The present pose then
    /// remains.
    pub fn pose(&mut self, picture: &mut PosedPicture, time: f64, rigid: bool) -> Result<Vec<f32>, JsValue> {
        let pose = self.0.pose(time, crate::posed_picture::blend(rigid));
        pose.and_then(|pose| picture.show(pose)).map_err(|error| to_js(&error))
    }
}

impl ClipPlayback {
    fn try_new(picture: &PosedPicture, clip_json: &str, handles_json: &str) -> Result<Self, Error> {
        let handles = handles_from_json(handles_json)?;
        let clip = clip_from_json(clip_json, &handles)?;
        Ok(Self(clip::Playback::new(picture.poser().clone(), clip, handles)))
    }
}
