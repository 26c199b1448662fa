//! Solves in a worker: one picture, and one project after another.

use c2warp::{Error, Inspection, Picture, Solver, StageTimes, project::Project, raster};
use wasm_bindgen::prelude::*;

use crate::{
    error::{to_js, with_code},
    solution::Solution,
};

/// A picture, and the solver that keeps what it knows about it.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Session {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
    solver: Solver,
    /// The project begun last, and whether its solve has finished.
    project: Option<Project>,
    finished: bool,
    ms: StageTimes,
}

#[wasm_bindgen]
impl Session {
    /// A session without a picture.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes a picture: straight RGBA, rows from top to bottom.
    ///
    /// # Errors
    /// For a size that cannot be warped; the picture in hand stays.
    pub fn set_picture(&mut self, width: u32, height: u32, rgba: Vec<u8>) -> Result<(), JsValue> {
        Picture::new(width, height, &rgba).map_err(|error| to_js(&error))?;
        *self = Self { width, height, rgba, ..Self::default() };
        Ok(())
    }

    /// Begins to solve a project, dropping a solve under way.
    ///
    /// # Errors
    /// For a project that cannot be solved with this picture.
    pub fn begin(&mut self, project_json: &str) -> Result<(), JsValue> {
        self.try_begin(project_json).map_err(|error| to_js(&error))
    }

    /// Runs the next stage and names it; `undefined` when the solve has finished.
    ///
    /// # Errors
    /// For handles that cannot be solved; the solve is then over.
    pub fn advance(&mut self) -> Result<Option<String>, JsValue> {
        self.try_advance().map(|stage| stage.map(String::from)).map_err(|error| to_js(&error))
    }

    /// What was solved last.
    ///
    /// # Errors
    /// Before a solve has finished.
    pub fn solution(&self) -> Result<Solution, JsValue> {
        match (&self.project, self.solver.solution()) {
            (Some(project), Some(solution)) if self.finished => {
                let start = now_ms();
                let pose = solution.poser().pose(&project.handles, project.pose.blend);
                let pose = pose.map_err(|error| to_js(&error))?;
                let ms = StageTimes { pose: now_ms() - start, ..self.ms.clone() };
                let report = Inspection { report: solution.report(&pose), ms };
                let report = serde_json::to_string(&report).expect("numbers under names are JSON");
                Ok(Solution::new(solution, report))
            }
            _ => Err(with_code("there is no solution yet", "engine")),
        }
    }

    /// The warped picture at full quality: straight RGBA of the picture's size times `scale`. Solves first if it must.
    ///
    /// # Errors
    /// As [`Session::begin`] and [`Session::advance`].
    pub fn warp(&mut self, project_json: &str, scale: f64) -> Result<Vec<u8>, JsValue> {
        self.try_warp(project_json, scale).map_err(|error| to_js(&error))
    }
}

impl Session {
    fn try_begin(&mut self, project_json: &str) -> Result<(), Error> {
        self.finished = false;
        let project = Project::from_json(project_json)?;
        let start = now_ms();
        let picture = Picture::new(self.width, self.height, &self.rgba)?;
        self.solver.begin(&project, &picture)?;
        self.ms = StageTimes { domain: now_ms() - start, ..StageTimes::default() };
        self.project = Some(project);
        Ok(())
    }

    fn try_advance(&mut self) -> Result<Option<&'static str>, Error> {
        let start = now_ms();
        let stage = self.solver.advance()?;
        let Some(stage) = stage else {
            self.finished = true;
            return Ok(None);
        };
        self.ms.add(stage, now_ms() - start);
        Ok(Some(stage.name()))
    }

    fn try_warp(&mut self, project_json: &str, scale: f64) -> Result<Vec<u8>, Error> {
        let project = Project::from_json(project_json)?;
        let (width, height) = (self.width, self.height);
        // A solve takes time that a scale which is none is not worth.
        raster::warped_size(width, height, scale)?;
        if !self.solver.has_solved(&project) {
            self.try_begin(project_json)?;
            while self.try_advance()?.is_some() {}
        }
        let solution = self.solver.solution().expect("every stage has run");
        let pose = solution.poser().pose(&project.handles, project.pose.blend)?;
        Ok(solution.warped(&Picture::new(width, height, &self.rgba)?, &pose, scale)?.rgba)
    }
}

/// Milliseconds since some moment, in a worker or a page; zero where there is no clock.
fn now_ms() -> f64 {
    let clock = js_sys::Reflect::get(&js_sys::global(), &"performance".into());
    let clock = clock.ok().and_then(|clock| clock.dyn_into::<web_sys::Performance>().ok());
    clock.map_or(0.0, |clock| clock.now())
}
