//! `c2warp check`: the problems of a project, all at once.
//!
//! Parts of the project with errors are reported and left out, so the rest is checked as well.

use c2warp::deform::Pose;
use c2warp::project::{Clip, Displacement, LooseParts, Project, ProjectError};
use c2warp::{DisplayName, Error, Solution, Solver};
use serde_json::{Value, json};

use crate::error::{CliError, one_line};
use crate::output;
use crate::project::{InputFiles, LoadedProject, ProjectFile, remark};

/// Further errors are not reported: few people would read more at once.
const MOST: usize = 100;
/// Times of a clip that are checked for folds.
const MOST_KEYS: usize = 200;

/// Checks a project: reads it, solves it and prints all problems. The exit status is 1 if there is an error
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the problems of a project for another program\n  \
                        c2warp check cat.c2warp.json --json")]
pub(crate) struct Arguments {
    #[command(flatten)]
    files: InputFiles,
    /// Print one JSON object instead of lines
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let files = &arguments.files;
    let mut problems = Problems::default();
    if let Some(project) = problems.read(&ProjectFile::text(files.project())?) {
        let loaded = LoadedProject::with_picture(project, files);
        match loaded.and_then(|loaded| loaded.picture().map(|_| ()).map(|()| loaded)) {
            Ok(mut loaded) => problems.solve(&mut loaded)?,
            Err(reason) => problems.error("image.src", "picture", reason.to_string()),
        }
    }
    let errors = problems.errors();
    let text = if arguments.json { format!("{:#}\n", problems.json()) } else { problems.lines() };
    output::print(text.as_bytes())?;
    match errors {
        0 => Ok(()),
        _ => Err(CliError::Faulty { path: files.project().to_owned(), errors }),
    }
}

/// A problem, and the key of the project that it concerns, if any.
struct Problem {
    is_error: bool,
    path: String,
    code: &'static str,
    message: String,
}

#[derive(Default)]
struct Problems {
    all: Vec<Problem>,
    /// For each handle of the checked project, its index in the file.
    handles: Vec<usize>,
}

impl Problems {
    /// Reads a project. Returns the project without its rejected parts, if that is a valid project.
    fn read(&mut self, text: &str) -> Option<Project> {
        let mut text = text.to_owned();
        let mut left_out = LeftOut::default();
        loop {
            let ProjectError { path, message, .. } = match Project::from_json(&text) {
                Ok(project) => {
                    self.handles = left_out.indices("handles", project.handles.len());
                    return Some(project);
                }
                Err(reason) => reason,
            };
            let shown = left_out.path(&path);
            // Without a handle, its tracks are wrong as well.
            if !(left_out.handles.is_some() && path.ends_with(".handle")) {
                self.error(&shown, "project", message);
            }
            let mut project: Value = serde_json::from_str(&text).ok().filter(|_| self.all.len() < MOST)?;
            left_out.remove(&mut project, &path)?;
            text = project.to_string();
        }
    }

    /// Solves a project, without rejected handles.
    fn solve(&mut self, loaded: &mut LoadedProject) -> Result<(), CliError> {
        let mut solver = Solver::new();
        while let Err(reason) = loaded.solve_stages(&mut solver, &loaded.picture()?) {
            let handles = &loaded.project.handles;
            let at = refused_handle(&reason).and_then(|id| handles.iter().position(|handle| handle.id == id));
            let path = match (at, &reason) {
                (Some(at), _) => format!("handles[{}]", self.handles[at]),
                (None, Error::PictureMismatch { .. }) => "image".to_owned(),
                (None, _) => String::new(),
            };
            self.error(&path, reason.code(), reason.to_string());
            match at {
                Some(at) if self.all.len() < MOST => {
                    let id = loaded.project.handles.remove(at).id;
                    self.handles.remove(at);
                    loaded.project.clips.iter_mut().for_each(|clip| clip.tracks.retain(|track| track.handle != id));
                }
                _ => return Ok(()),
            }
        }
        let solution = solver.solution().expect("every stage has run");
        match solution.pose(&loaded.project) {
            Ok(pose) => self.warn(loaded, solution, &pose),
            Err(reason) => self.error("handles", reason.code(), reason.to_string()),
        }
        Ok(())
    }

    /// Warns about content that can be solved but is probably unintended.
    fn warn(&mut self, loaded: &LoadedProject, solution: &Solution, pose: &Pose) {
        let Project { clips, handles, loose_parts, displacement, .. } = &loaded.project;
        let domain = solution.domain();
        if let Some(remark) = remark(domain) {
            self.warning("domain", "outline", remark);
        }
        let report = solution.report(pose);
        if handles.is_empty() {
            // A displaced picture moves without them.
            if displacement.as_ref().is_none_or(Displacement::is_zero) {
                self.warning("handles", "no-handles", "the project has no handles: nothing moves".to_owned());
            }
        } else if report.loose_islands > 0 && *loose_parts == LooseParts::Stay {
            let parts = numbered(report.loose_islands, "part of the picture has", "parts of the picture have");
            self.warning("loose_parts", "loose-parts", format!("{parts} no handle: no pose moves anything there"));
        }
        for part in &report.outside {
            let at = handles.iter().position(|handle| handle.id == part.handle);
            let path = at.map(|at| format!("handles[{}].rest", self.handles[at])).unwrap_or_default();
            let (from, to) = (part.from, part.to);
            let message = format!(
                "“{}” lies outside the domain from {from} to {to}: it moves nothing there",
                DisplayName(&part.handle)
            );
            self.warning(&path, "outside", message);
        }
        if report.folded_triangles > 0 {
            let folds = numbered(report.folded_triangles, "triangle", "triangles");
            self.warning(
                "handles",
                "folds",
                format!("the pose turns {folds} of the mesh over: the picture folds there"),
            );
        }
        for (at, clip) in clips.iter().enumerate() {
            if let Some((time, folded)) = most_folded(clip, loaded, solution) {
                let folds = numbered(folded, "triangle", "triangles");
                let message = format!(
                    "clip “{}” turns {folds} of the mesh over at {time} s: the picture folds there",
                    DisplayName(&clip.name)
                );
                self.warning(&format!("clips[{at}]"), "folds", message);
            }
        }
    }

    fn error(&mut self, path: &str, code: &'static str, message: String) {
        self.all.push(Problem { is_error: true, path: path.to_owned(), code, message });
    }

    fn warning(&mut self, path: &str, code: &'static str, message: String) {
        self.all.push(Problem { is_error: false, path: path.to_owned(), code, message });
    }

    fn errors(&self) -> usize {
        self.all.iter().filter(|problem| problem.is_error).count()
    }

    fn lines(&self) -> String {
        let line = |Problem { is_error, path, message, .. }: &Problem| {
            let severity = if *is_error { "error" } else { "warning" };
            let place = if path.is_empty() { String::new() } else { format!("{path}: ") };
            one_line(&format!("{severity}: {place}{message}")) + "\n"
        };
        if self.all.is_empty() { "no problems\n".to_owned() } else { self.all.iter().map(line).collect() }
    }

    fn json(&self) -> Value {
        let problem = |Problem { is_error, path, code, message }: &Problem| {
            let severity = if *is_error { "error" } else { "warning" };
            json!({ "severity": severity, "path": path, "code": code, "message": message })
        };
        json!({ "ok": self.errors() == 0, "problems": self.all.iter().map(problem).collect::<Vec<_>>() })
    }
}

/// The parts of a project that were left out. They map the remaining parts to their paths in the file.
#[derive(Default)]
struct LeftOut {
    /// The index in the file of each remaining handle; empty while no handle is left out.
    handles: Option<Vec<usize>>,
    clips: Option<Vec<usize>>,
}

impl LeftOut {
    fn list(&mut self, name: &str) -> &mut Option<Vec<usize>> {
        if name == "handles" { &mut self.handles } else { &mut self.clips }
    }

    /// The indices in the file of the `count` remaining items.
    fn indices(&mut self, name: &str, count: usize) -> Vec<usize> {
        self.list(name).clone().unwrap_or_else(|| (0..count).collect())
    }

    /// The path in the file.
    fn path(&mut self, path: &str) -> String {
        match item(path) {
            Some((name, at, rest)) => {
                let at = self.list(name).as_ref().map_or(at, |indices| indices[at]);
                format!("{name}[{at}]{rest}")
            }
            None => path.to_owned(),
        }
    }

    /// Removes the handle, the clip or the setting with a path, unless a project needs it.
    fn remove(&mut self, project: &mut Value, path: &str) -> Option<()> {
        match item(path) {
            Some((name, at, _)) => {
                let items = project.get_mut(name)?.as_array_mut().filter(|items| at < items.len())?;
                let count = items.len();
                items.remove(at);
                self.list(name).get_or_insert_with(|| (0..count).collect()).remove(at);
            }
            None => {
                let key = path.split(['.', '[']).next().filter(|key| !["format", "image", "handles"].contains(key))?;
                project.as_object_mut()?.remove(key)?;
            }
        }
        Some(())
    }
}

/// Divides a path such as `handles[2].rest` into the list, the index and the rest.
fn item(path: &str) -> Option<(&'static str, usize, &str)> {
    ["handles", "clips"].into_iter().find_map(|name| {
        let (index, rest) = path.strip_prefix(name)?.strip_prefix('[')?.split_once(']')?;
        Some((name, index.parse().ok()?, rest))
    })
}

/// The handle that must change, if an error is about handles. If it names two, the second.
fn refused_handle(reason: &Error) -> Option<&str> {
    match reason {
        Error::HandleOutside { id, .. }
        | Error::BarTooShort { id, .. }
        | Error::OnHeldBoundary { id }
        | Error::TooManyCorners { id, .. }
        | Error::PoseNotFinite { id }
        | Error::HandlesTooClose { second: id, .. }
        | Error::BarsOverlap { second: id, .. } => Some(id),
        _ => None,
    }
}

/// The key of a clip at which the picture folds most: its time, and the number of folded triangles.
fn most_folded(clip: &Clip, loaded: &LoadedProject, solution: &Solution) -> Option<(f64, usize)> {
    let mut times: Vec<f64> = clip.tracks.iter().flat_map(|track| &track.keys).map(|key| key.time).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut playback = loaded.playback(solution, clip);
    let folded = |&time: &f64| {
        let pose = playback.pose(time, loaded.project.pose.blend).ok()?;
        Some((time, solution.folded_triangles(&pose)))
    };
    let most = times.iter().take(MOST_KEYS).filter_map(folded);
    let most = most.reduce(|most, next| if next.1 > most.1 { next } else { most });
    most.filter(|&(_, folded)| folded > 0)
}

/// A number with a noun in the singular or plural.
fn numbered(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}
