//! The frames of a film, drawn one after another.

use std::sync::Arc;

use c2warp::{
    Canvas, Drawing, Error, Extent, Picture, ResampleOptions, Solution,
    clip::{FrameTimes, Playback},
    deform::Pose,
    project::{Blend, Clip, Project},
};
use wasm_bindgen::prelude::*;

use crate::frame_times::times;

/// The options for the frames of a clip.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FilmOptions {
    /// Frames a second.
    pub(crate) rate: f64,
    /// The part of the clip, in seconds. Without both bounds, the whole clip.
    pub(crate) from: Option<f64>,
    pub(crate) to: Option<f64>,
    pub(crate) resample: ResampleOptions,
}

impl FilmOptions {
    pub(crate) fn times(&self, clip: &Clip) -> Result<FrameTimes, Error> {
        times(clip, self.rate, self.from, self.to)
    }
}

/// A solution along a clip, and the times to draw. It keeps its solution while other projects are solved.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Filming {
    solution: Arc<Solution>,
    playback: Playback,
    blend: Blend,
    times: FrameTimes,
    options: ResampleOptions,
    /// The rectangle of all frames.
    extent: Extent,
}

#[wasm_bindgen]
impl Filming {
    /// Width of all frames in pixels.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.extent.width
    }

    /// Height of all frames in pixels.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.extent.height
    }

    /// Number of frames.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> u32 {
        self.times.count()
    }

    /// Whether the film repeats after its last frame.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn endlessly(&self) -> bool {
        self.times.repeats()
    }
}

impl Filming {
    pub(crate) fn new(
        solution: Arc<Solution>,
        project: &Project,
        clip: Clip,
        times: FrameTimes,
        options: ResampleOptions,
        [width, height]: [u32; 2],
    ) -> Self {
        let playback = Playback::new(solution.poser().clone(), clip, project.handles.clone());
        let extent = Extent { origin: [0, 0], width, height };
        Self { solution, playback, blend: project.pose.blend, times, options, extent }
    }

    /// The whole picture at the scale of the film. It contains the colours of all frames.
    pub(crate) fn picture_at_rest(&self, picture: &Picture<'_>) -> Result<Drawing, Error> {
        Drawing::at_rest(picture, self.options)
    }

    /// A frame, ready to be drawn; `None` if the frame is out of range.
    pub(crate) fn drawing(&mut self, picture: &Picture<'_>, frame: u32) -> Option<Result<Drawing, Error>> {
        let pose = self.pose(frame)?;
        let options = ResampleOptions { canvas: Canvas::Fixed(self.extent), ..self.options };
        Some(pose.and_then(|pose| self.solution.drawing(picture, &pose, options)))
    }

    /// Grows the rectangle of all frames to hold this one; `None` if the frame is out of range.
    pub(crate) fn include(&mut self, picture: &Picture<'_>, frame: u32) -> Option<Result<(), Error>> {
        let pose = self.pose(frame)?;
        let options = ResampleOptions { canvas: Canvas::Grown, ..self.options };
        let extent = pose.and_then(|pose| self.solution.extent(picture, &pose, options));
        let grown = extent.and_then(|extent| self.extent.union(extent));
        Some(grown.map(|extent| self.extent = extent))
    }

    fn pose(&mut self, frame: u32) -> Option<Result<Pose, Error>> {
        let &time = self.times.seconds().get(frame as usize)?;
        Some(self.playback.pose(time, self.blend))
    }
}
