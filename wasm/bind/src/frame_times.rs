//! The times of the frames of a film.

use c2warp::{
    Error,
    clip::FrameTimes,
    project::{Clip, clip_from_json, handles_from_json},
};
use wasm_bindgen::prelude::*;

use crate::error::to_js;

/// The times of a film's frames, in seconds. It takes a clip and its handles as JSON, as in a project, frames a second,
/// and the part of the clip to show. Without `from` and `to`, the film shows the whole clip.
///
/// # Errors
/// With the code `film` for an unsupported rate, part or length. Any deviation of the JSON from the format, by the path
/// of the offending key.
#[wasm_bindgen]
pub fn frame_times(
    clip_json: &str,
    handles_json: &str,
    rate: f64,
    from: Option<f64>,
    to: Option<f64>,
) -> Result<Vec<f64>, JsValue> {
    let seconds = || {
        let clip = clip_from_json(clip_json, &handles_from_json(handles_json)?)?;
        Ok::<_, Error>(times(&clip, rate, from, to)?.seconds().to_vec())
    };
    seconds().map_err(|error| to_js(&error))
}

/// The times of a clip's frames. Without `from` and `to`, those of the whole clip.
pub(crate) fn times(clip: &Clip, rate: f64, from: Option<f64>, to: Option<f64>) -> Result<FrameTimes, Error> {
    let is_part = from.is_some() || to.is_some();
    let range = is_part.then(|| from.unwrap_or(0.0)..to.unwrap_or(clip.duration));
    FrameTimes::new(clip, rate, range)
}
