//! Solves projects for one picture, one after another, in a worker.

use std::sync::Arc;

use c2warp::{
    Error, Filter, Inspection, Picture, ResampleOptions, Solver, Stage, StageTimes,
    deform::Pose,
    domain::Domain,
    fit::{Fitted, Fitter},
    project::{Project, clip_from_json},
    raster,
    suggest::{SuggestedHandle, SuggestedRole, suggest_beside},
};
use glam::DVec2;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::{
    cell_borders::CellBorders,
    drawing::{Canvas, Drawing},
    error::{to_js, with_code},
    fill::Fill,
    filming::{FilmOptions, Filming},
    history::History,
    json::json,
    solution::Solution,
};

/// A picture, and the solver with its cache for it.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Session {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
    solver: Solver,
    /// The solve in progress, and the one that produced the solver's solution.
    solving: Option<Solve>,
    solved: Option<Solve>,
}

/// A project, and the time of each stage.
#[derive(Debug)]
struct Solve {
    project: Project,
    ms: StageTimes,
}

/// A project for the present picture, and the ids of handles that were moved into its outline.
#[derive(Debug, Serialize)]
struct FittedProject<'a> {
    project: &'a Project,
    moved: Vec<String>,
}

/// Point handles for the present picture, beside those of a project.
#[derive(Debug, Serialize)]
struct Suggestion {
    handles: Vec<SuggestedPoint>,
    /// Whether the handles follow an outline. Otherwise they are in even rows.
    outlined: bool,
}

#[derive(Debug, Serialize)]
struct SuggestedPoint {
    id: String,
    rest: [f64; 2],
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
    /// For a size that cannot be warped. The previous picture remains.
    pub fn set_picture(&mut self, width: u32, height: u32, rgba: Vec<u8>) -> Result<(), JsValue> {
        Picture::new(width, height, &rgba).map_err(|error| to_js(&error))?;
        *self = Self { width, height, rgba, ..Self::default() };
        Ok(())
    }

    /// Begins to solve a project and drops a solve in progress. The last solution remains until this solve has
    /// finished.
    ///
    /// # Errors
    /// For a project that cannot be solved with this picture.
    pub fn begin(&mut self, project_json: &str) -> Result<(), JsValue> {
        let project = Project::from_json(project_json).map_err(Error::from);
        project.and_then(|project| self.try_begin(project)).map_err(|error| to_js(&error))
    }

    /// Runs the next stage and names it; `undefined` when the solve has finished.
    ///
    /// # Errors
    /// For handles that cannot be solved. The error ends the solve, and the last solution remains.
    pub fn advance(&mut self) -> Result<Option<String>, JsValue> {
        self.try_advance().map(|stage| stage.map(String::from)).map_err(|error| to_js(&error))
    }

    /// The last solution.
    ///
    /// # Errors
    /// If no solve has finished yet.
    pub fn solution(&self) -> Result<Solution, JsValue> {
        let (Some(Solve { project, ms }), Some(solution)) = (&self.solved, self.solver.solution()) else {
            return Err(with_code("there is no solution yet", "engine"));
        };
        let start = now_ms();
        let pose = solution.pose(project).map_err(|error| to_js(&error))?;
        let mut ms = *ms;
        ms.pose = now_ms() - start;
        let report = Inspection { report: solution.report(&pose), ms };
        Ok(Solution::new(solution, json(&report)))
    }

    /// Begins to fill the background of a solved project.
    ///
    /// # Errors
    /// For a project that breaks the format.
    pub fn begin_fill(&mut self, project_json: &str) -> Result<(), JsValue> {
        let project = Project::from_json(project_json).map_err(|error| to_js(&error.into()))?;
        self.solver.begin_fill(&project);
        Ok(())
    }

    /// Runs the next step of the fill. Returns the completed fraction, from 0 to 1; `undefined` when the fill has
    /// finished.
    ///
    /// # Errors
    /// For a domain that covers the whole picture.
    pub fn advance_fill(&mut self) -> Result<Option<f64>, JsValue> {
        let picture = Picture::new(self.width, self.height, &self.rgba);
        picture.and_then(|picture| self.solver.advance_fill(&picture)).map_err(|error| to_js(&error))
    }

    /// The fill behind the last solution, if the project has one and it is finished.
    #[must_use]
    pub fn fill(&self) -> Option<Fill> {
        self.solver.solution().and_then(c2warp::Solution::fill).map(Fill::from)
    }

    /// Prepares to draw the warped picture at full quality. Solves first if necessary.
    ///
    /// Its size is that of the picture times `scale`, unless the canvas differs. `pixelated` is for pixel art. Without
    /// a history, the pose depends only on the project and its handles.
    ///
    /// # Errors
    /// The errors of [`Session::begin`] and [`Session::advance`], and one for a result that is empty or too large.
    pub fn draw(
        &mut self,
        project_json: &str,
        scale: f64,
        canvas: Canvas,
        pixelated: bool,
        history: Option<History>,
    ) -> Result<Drawing, JsValue> {
        let drawing = self.try_draw(project_json, options(scale, canvas, pixelated), history);
        drawing.map(Drawing::from).map_err(|error| to_js(&error))
    }

    /// Continues the pose of a project as in a drag, to the handles of the project `next_json`. With `settles`, the
    /// pose comes to rest there. Returns the [shape](c2warp::deform::Pose::shape) of the pose, for
    /// [`History::of_shape`]. Solves first if necessary.
    ///
    /// # Errors
    /// The errors of [`map`](Self::map), and one for a project with other handles.
    pub fn next_pose(
        &mut self,
        project_json: &str,
        history: Option<History>,
        next_json: &str,
        settles: bool,
    ) -> Result<Vec<f64>, JsValue> {
        self.try_next_pose(project_json, history, next_json, settles).map_err(|error| to_js(&error))
    }

    /// Prepares to draw the frames of a film of a clip, given as JSON. `rate` is in frames a second. Without `from` and
    /// `to`, in seconds, the film shows the whole clip. Solves first if necessary.
    ///
    /// # Errors
    /// The errors of [`draw`](Self::draw), and one with the code `film` for an unsupported rate, part or length.
    #[allow(clippy::too_many_arguments, reason = "wasm-bindgen has no structs of plain values")]
    pub fn film(
        &mut self,
        project_json: &str,
        clip_json: &str,
        rate: f64,
        from: Option<f64>,
        to: Option<f64>,
        scale: f64,
        pixelated: bool,
    ) -> Result<Filming, JsValue> {
        let film = FilmOptions { rate, from, to, resample: options(scale, Canvas::Picture, pixelated) };
        self.try_film(project_json, clip_json, film).map_err(|error| to_js(&error))
    }

    /// Grows all frames of a film to hold everything that the given frame draws, counted from 0. Call it for each frame
    /// before drawing any.
    ///
    /// # Errors
    /// The errors of [`frame`](Self::frame), and one for frames that would be too large.
    pub fn include(&self, filming: &mut Filming, frame: u32) -> Result<(), JsValue> {
        let picture = Picture::new(self.width, self.height, &self.rgba);
        of_frame(picture.and_then(|picture| filming.include(&picture, frame).transpose()))
    }

    /// Prepares to draw a frame of a film, counted from 0.
    ///
    /// # Errors
    /// If the frame is out of range, or its handles have no pose.
    pub fn frame(&self, filming: &mut Filming, frame: u32) -> Result<Drawing, JsValue> {
        let picture = Picture::new(self.width, self.height, &self.rgba);
        of_frame(picture.and_then(|picture| filming.drawing(&picture, frame).transpose())).map(Drawing::from)
    }

    /// Draws rows of a drawing of the present picture: straight RGBA.
    ///
    /// # Errors
    /// If the rows do not exist.
    pub fn rows(&self, drawing: &Drawing, from: u32, to: u32) -> Result<Vec<u8>, JsValue> {
        let picture = Picture::new(self.width, self.height, &self.rgba).map_err(|error| to_js(&error))?;
        drawing.rows(&picture, from..to).ok_or_else(|| with_code("the rows are out of range", "engine"))
    }

    /// Prepares to draw the whole picture at the scale of a film, which has the colours of all its frames.
    ///
    /// # Errors
    /// Without a picture.
    pub fn picture_at_rest(&self, filming: &Filming) -> Result<Drawing, JsValue> {
        let picture = Picture::new(self.width, self.height, &self.rgba);
        let drawing = picture.and_then(|picture| filming.picture_at_rest(&picture));
        drawing.map(Drawing::from).map_err(|error| to_js(&error))
    }

    /// A project for another picture, fitted to this one, as the JSON of `FittedProject`.
    ///
    /// With the project's own picture in straight RGBA, the outlines of both are aligned, if both have transparency.
    /// Otherwise the rectangle of its picture is stretched to this one.
    ///
    /// # Errors
    /// The errors of `c2warp::fit`.
    #[allow(clippy::needless_pass_by_value, reason = "wasm-bindgen takes no optional slices")]
    pub fn fit(&self, project_json: &str, own_rgba: Option<Vec<u8>>) -> Result<String, JsValue> {
        self.try_fit(project_json, own_rgba.as_deref()).map_err(|error| to_js(&error))
    }

    /// Point handles where an animator would begin, in addition to those of the project, as the JSON of `Suggestion`.
    ///
    /// # Errors
    /// For a project without a domain in this picture.
    pub fn suggest(&self, project_json: &str) -> Result<String, JsValue> {
        self.try_suggest(project_json).map_err(|error| to_js(&error))
    }

    /// The borders between the cells of a project's solution. Solves first if necessary.
    ///
    /// # Errors
    /// The errors of [`Session::begin`] and [`Session::advance`].
    pub fn cell_borders(&mut self, project_json: &str) -> Result<CellBorders, JsValue> {
        self.solved_as(project_json).map(|solution| solution.cell_borders().into())
    }

    /// A project's solution, explained as the JSON of `Study`. Solves first if necessary.
    ///
    /// # Errors
    /// The errors of [`Session::begin`] and [`Session::advance`].
    pub fn study(&mut self, project_json: &str) -> Result<String, JsValue> {
        self.solved_as(project_json).map(|solution| json(&solution.study()))
    }

    /// The weights and paths of a rest point, as the JSON of `Lens`; `undefined` outside the domain. Solves first if
    /// necessary.
    ///
    /// # Errors
    /// The errors of [`Session::begin`] and [`Session::advance`].
    pub fn lens(&mut self, project_json: &str, x: f64, y: f64) -> Result<Option<String>, JsValue> {
        self.solved_as(project_json).map(|solution| solution.lens(DVec2::new(x, y)).map(|lens| json(&lens)))
    }
}

impl Session {
    pub(crate) fn solved_as(&mut self, project_json: &str) -> Result<&c2warp::Solution, JsValue> {
        let solved = Project::from_json(project_json).map_err(Error::from).and_then(|project| self.try_solve(&project));
        solved.map_err(|error| to_js(&error))
    }

    fn try_fit(&self, project_json: &str, own_rgba: Option<&[u8]>) -> Result<String, Error> {
        let project = Project::from_json(project_json)?;
        let picture = Picture::new(self.width, self.height, &self.rgba)?;
        let own = own_rgba.map(|rgba| Picture::new(project.image.width, project.image.height, rgba)).transpose()?;
        let fitter = match own {
            Some(own) if own.has_transparency() && picture.has_transparency() => Fitter::by_alpha(project, &own)?,
            _ => Fitter::by_box(project),
        };
        let Fitted { project, moved, .. } = fitter.fit(&picture)?;
        let moved = moved.into_iter().map(|handle| handle.id).collect();
        Ok(json(&FittedProject { project: &project, moved }))
    }

    fn try_suggest(&self, project_json: &str) -> Result<String, Error> {
        let project = Project::from_json(project_json)?;
        let picture = Picture::new(self.width, self.height, &self.rgba)?;
        let domain = Domain::new(project.domain.as_ref(), &picture)?;
        let suggested = suggest_beside(&domain, &project.handles);
        let outlined = suggested.iter().any(|handle| handle.role != SuggestedRole::Spread);
        let point = |handle: SuggestedHandle| SuggestedPoint { id: handle.id, rest: handle.rest.to_array() };
        let handles = suggested.into_iter().map(point).collect();
        Ok(json(&Suggestion { handles, outlined }))
    }

    fn try_begin(&mut self, project: Project) -> Result<(), Error> {
        self.solving = None;
        let start = now_ms();
        let picture = Picture::new(self.width, self.height, &self.rgba)?;
        self.solver.begin(&project, &picture)?;
        let mut ms = StageTimes::default();
        ms.add(Stage::Domain, now_ms() - start);
        self.solving = Some(Solve { project, ms });
        Ok(())
    }

    fn try_advance(&mut self) -> Result<Option<&'static str>, Error> {
        let Some(mut solve) = self.solving.take() else { return Ok(None) };
        let start = now_ms();
        let Some(stage) = self.solver.advance()? else { return Ok(None) };
        solve.ms.add(stage, now_ms() - start);
        // The last stage makes the solution.
        let goes_on = stage != Stage::Weights;
        *(if goes_on { &mut self.solving } else { &mut self.solved }) = Some(solve);
        Ok(Some(stage.name()))
    }

    fn try_draw(
        &mut self,
        project_json: &str,
        options: ResampleOptions,
        history: Option<History>,
    ) -> Result<c2warp::Drawing, Error> {
        let project = Project::from_json(project_json)?;
        let options = ResampleOptions { edges: project.edges, ..options };
        // Invalid scales are rejected before the solve, because it takes time.
        raster::warped_size(self.width, self.height, options.scale)?;
        self.try_solve_filled(&project)?;
        let (solution, pose) = self.try_pose(&project, history)?;
        solution.drawing(&Picture::new(self.width, self.height, &self.rgba)?, &pose, options)
    }

    /// The solution of a project and its pose, which continues a history if one is given.
    pub(crate) fn try_pose(
        &mut self,
        project: &Project,
        history: Option<History>,
    ) -> Result<(Arc<c2warp::Solution>, Pose), Error> {
        self.try_solve(project)?;
        let solution = self.solver.shared_solution().expect("it has just been solved");
        let pose = match history {
            Some(history) => history.pose(&solution, project)?,
            None => solution.pose(project)?,
        };
        Ok((solution, pose))
    }

    fn try_next_pose(
        &mut self,
        project_json: &str,
        history: Option<History>,
        next_json: &str,
        settles: bool,
    ) -> Result<Vec<f64>, Error> {
        let [project, next] = [Project::from_json(project_json)?, Project::from_json(next_json)?];
        let (solution, pose) = self.try_pose(&project, history)?;
        let poser = solution.poser();
        let next = if settles { poser.settle(&pose, &next.handles) } else { poser.follow(&pose, &next.handles) }?;
        Ok(next.motion_numbers())
    }

    fn try_film(&mut self, project_json: &str, clip_json: &str, film: FilmOptions) -> Result<Filming, Error> {
        let project = Project::from_json(project_json)?;
        let clip = clip_from_json(clip_json, &project.handles)?;
        // Invalid options are rejected before the solve, because it takes time.
        let times = film.times(&clip)?;
        let (width, height) = raster::warped_size(self.width, self.height, film.resample.scale)?;
        self.try_solve_filled(&project)?;
        let solution = self.solver.shared_solution().expect("it has just been solved");
        let options = ResampleOptions { edges: project.edges, ..film.resample };
        Ok(Filming::new(solution, &project, clip, times, options, [width, height]))
    }

    /// Like [`try_solve`](Self::try_solve), with the fill behind the domain.
    fn try_solve_filled(&mut self, project: &Project) -> Result<(), Error> {
        self.try_solve(project)?;
        self.solver.begin_fill(project);
        let picture = Picture::new(self.width, self.height, &self.rgba)?;
        while self.solver.advance_fill(&picture)?.is_some() {}
        Ok(())
    }

    /// The solution of a project. The last solution is reused if it fits.
    pub(crate) fn try_solve(&mut self, project: &Project) -> Result<&c2warp::Solution, Error> {
        if !self.solver.has_solved(project) {
            self.try_begin(project.clone())?;
            while self.try_advance()?.is_some() {}
        }
        Ok(self.solver.solution().expect("every stage has run"))
    }
}

/// Returns the result for a frame, or an error if the frame is out of range.
fn of_frame<T>(answer: Result<Option<T>, Error>) -> Result<T, JsValue> {
    match answer {
        Ok(Some(answer)) => Ok(answer),
        Ok(None) => Err(with_code("the frame is out of range", "engine")),
        Err(error) => Err(to_js(&error)),
    }
}

fn options(scale: f64, canvas: Canvas, pixelated: bool) -> ResampleOptions {
    let filter = if pixelated { Filter::Nearest } else { Filter::Cubic };
    ResampleOptions { scale, canvas: canvas.into(), filter, ..ResampleOptions::default() }
}

/// Milliseconds since a fixed moment, in a worker or a page; zero without a clock.
fn now_ms() -> f64 {
    let clock = js_sys::Reflect::get(&js_sys::global(), &"performance".into());
    let clock = clock.ok().and_then(|clock| clock.dyn_into::<web_sys::Performance>().ok());
    clock.map_or(0.0, |clock| clock.now())
}
