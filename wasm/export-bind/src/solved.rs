//! A solved project, the first step of several kinds of exports.

use std::fmt;

use c2warp::{Picture, Solution, clip::Playback, deform::Pose, project::Project};
use js_sys::{Error as JsError, Function};
use wasm_bindgen::prelude::*;

use crate::solution::solution;

/// The completed fraction of the work once the project is solved.
const SOLVED: f64 = 0.2;

/// A solved project with its picture.
#[wasm_bindgen]
#[derive(Debug)]
pub struct SolvedProject {
    pub(crate) project: Project,
    pub(crate) solution: Solution,
    pub(crate) size: [u32; 2],
    rgba: Vec<u8>,
    on_progress: Function,
}

pub(crate) fn refused(reason: impl fmt::Display) -> JsError {
    JsError::new(&reason.to_string())
}

#[wasm_bindgen]
impl SolvedProject {
    /// Solves a project.
    ///
    /// `rgba` is straight, rows from top to bottom. `on_progress` receives the completed fraction of the export, from 0
    /// to 1.
    ///
    /// # Errors
    /// For a project that cannot be solved with this picture.
    #[wasm_bindgen(constructor)]
    pub fn new(
        project_json: &str,
        width: u32,
        height: u32,
        rgba: Vec<u8>,
        on_progress: Function,
    ) -> Result<Self, JsError> {
        let project = Project::from_json(project_json).map_err(refused)?;
        let solution = solution(&project, &Picture::new(width, height, &rgba).map_err(refused)?).map_err(refused)?;
        let solved = Self { project, solution, size: [width, height], rgba, on_progress };
        solved.report(0.0);
        Ok(solved)
    }
}

impl SolvedProject {
    pub(crate) fn picture(&self) -> Result<Picture<'_>, JsError> {
        let [width, height] = self.size;
        Picture::new(width, height, &self.rgba).map_err(refused)
    }

    pub(crate) fn pose(&self, clip: Option<String>, seconds: f64) -> Result<Pose, JsError> {
        let Self { project, solution, .. } = self;
        let Some(name) = clip else {
            return solution.pose(project).map_err(refused);
        };
        let clip = project.clips.iter().find(|clip| clip.name == name);
        let clip = clip.ok_or_else(|| refused(format!("the project has no clip {name:?}")))?.clone();
        let mut playback = Playback::new(solution.poser().clone(), clip, project.handles.clone());
        playback.pose(seconds, project.pose.blend).map_err(refused)
    }

    pub(crate) fn report(&self, part: f64) {
        // Nothing can be done about a listener that fails.
        let _ = self.on_progress.call1(&JsValue::NULL, &(SOLVED + (1.0 - SOLVED) * part).into());
    }
}
