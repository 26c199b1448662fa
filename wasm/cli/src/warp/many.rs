//! Many pictures of one project, or many projects, each with its own result in a folder.
//!
//! Inputs that fail are reported on standard error, and the others continue. Pictures and solutions that several inputs
//! share are read and solved once: a solution does not depend on poses, clips and colours.
//!
//! Memory: each thread holds one picture with its result. The same number of pictures and solutions is kept for the
//! next inputs.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::io::{self, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use c2warp::{Solution, SolveKey};

use super::Arguments;
use super::targets::Targets;
use crate::error::{self, CliError};
use crate::files;
use crate::fitting::{Fit, FittingProject, stem};
use crate::picture::{self, PictureFile};
use crate::project::{LoadedProject, ProjectFile};
use crate::shared::Shared;
use crate::workers;

/// One result.
struct Job {
    project: PathBuf,
    /// A picture that replaces the project's own.
    image: Option<PathBuf>,
    /// The name of the result, without its folder.
    name: OsString,
    /// Taken by the thread that works on it.
    targets: Mutex<Option<Targets>>,
}

/// Data shared by the jobs.
struct Batch<'a> {
    arguments: &'a Arguments,
    has_many_images: bool,
    projects: Shared<PathBuf, FittingProject>,
    /// Projects from pipes, which can only be read once.
    piped: HashMap<PathBuf, Arc<FittingProject>>,
    /// Pictures by path, and by the size at which a drawing is rendered.
    pictures: Shared<(PathBuf, (u32, u32)), PictureFile>,
    solutions: Shared<SolveKey, Solution>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let images = files(arguments.images())?;
    let projects = arguments.projects();
    let has_many_images = projects.len() == 1;
    if !has_many_images && images.len() > 1 {
        return Err(CliError::ManyOfBoth);
    }
    for folder in [Some(&arguments.output), arguments.stmap.as_ref()].into_iter().flatten() {
        fs::create_dir_all(folder).map_err(CliError::write(folder))?;
    }
    let threads = arguments.threads();
    let kept = threads.get();
    let mut batch = Batch {
        arguments,
        has_many_images,
        projects: Shared::new(kept),
        piped: HashMap::new(),
        pictures: Shared::new(kept),
        solutions: Shared::new(kept),
    };
    if has_many_images {
        // An error about the only project is reported once.
        batch.project(&projects[0])?;
    }
    let failed = AtomicBool::new(false);
    let report = |reason: CliError| {
        error::print(reason);
        failed.store(true, Ordering::Relaxed);
    };
    projects.iter().chain(&images).for_each(|path| files::note_input(path));
    batch.note_own_pictures(&images);
    let jobs = batch.jobs(&images, report);
    let origins = Mutex::new(vec![None; jobs.len()]);
    workers::each(threads, &jobs, |index, job| match batch.work(job) {
        Ok(origin) => origins.lock().unwrap_or_else(PoisonError::into_inner)[index] = Some(origin),
        Err(reason) => report(reason),
    });
    if arguments.drawing.grow {
        let origins = origins.into_inner().unwrap_or_else(PoisonError::into_inner);
        print_origins(&jobs, &origins).map_err(CliError::Print)?;
    }
    if failed.into_inner() { Err(CliError::Reported) } else { Ok(()) }
}

/// The pictures; a folder stands for its files, sorted by name. Hidden files and subfolders are left out.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let entries = fs::read_dir(path).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        let entries = entries.map_err(CliError::read(path))?;
        let visible = entries.iter().filter(|entry| !entry.file_name().to_string_lossy().starts_with('.'));
        let mut inside: Vec<PathBuf> = visible.map(fs::DirEntry::path).filter(|path| !path.is_dir()).collect();
        if inside.is_empty() {
            return Err(CliError::NoFiles { path: path.clone() });
        }
        inside.sort();
        files.append(&mut inside);
    }
    Ok(files)
}

impl Batch<'_> {
    /// Registers the pictures that projects name, so that no result replaces one before it is read. Unreadable projects
    /// are reported later.
    fn note_own_pictures(&mut self, images: &[PathBuf]) {
        for path in self.arguments.projects() {
            if !path.is_file() {
                if let Ok(project) = self.project(path) {
                    self.piped.insert(path.clone(), project);
                }
            } else if (images.is_empty() || self.arguments.fit == Some(Fit::Alpha))
                && let Ok(picture) = ProjectFile::read(path).and_then(|file| file.own_picture_path())
            {
                files::note_input(&picture);
            }
        }
    }

    /// A job for each input. Inputs whose result would replace another file are reported and left out.
    fn jobs(&self, images: &[PathBuf], report: impl Fn(CliError)) -> Vec<Job> {
        let projects = self.arguments.projects();
        let inputs: Vec<(&PathBuf, Option<&PathBuf>)> = if self.has_many_images && !images.is_empty() {
            images.iter().map(|image| (&projects[0], Some(image))).collect()
        } else {
            projects.iter().map(|project| (project, images.first())).collect()
        };
        let mut named: HashMap<PathBuf, &PathBuf> = HashMap::new();
        let mut jobs = Vec::new();
        for (project, image) in inputs {
            let input = image.filter(|_| self.has_many_images).unwrap_or(project);
            let result = |folder: &PathBuf, extension: &str| {
                let mut name = stem(input).into_os_string();
                name.push(extension);
                folder.join(name)
            };
            let output = result(&self.arguments.output, ".png");
            let stmap = self.arguments.stmap.as_ref().map(|folder| result(folder, ".exr"));
            match Targets::open(&output, stmap.as_deref()) {
                Ok(targets) => {
                    let name = output.file_name().unwrap_or_default().to_owned();
                    let (project, image, targets) = (project.clone(), image.cloned(), Mutex::new(Some(targets)));
                    jobs.push(Job { project, image, name, targets });
                    named.insert(output, input);
                }
                Err(CliError::OverOutput { other, .. }) if named.contains_key(&other) => {
                    report(CliError::SameResult { path: input.clone(), other: named[&other].clone() });
                }
                Err(reason) => report(reason),
            }
        }
        jobs
    }

    fn work(&self, job: &Job) -> Result<[i32; 2], CliError> {
        let loaded = self.open(job)?;
        self.arguments.drawing.check(&loaded)?;
        let targets = job.targets.lock().unwrap_or_else(PoisonError::into_inner).take();
        let targets = targets.expect("a job is worked on once");
        let key = SolveKey::new(&loaded.project, &loaded.picture()?).map_err(|reason| loaded.refused(reason))?;
        let solution = self.solutions.get(key, || loaded.solve_filled())?;
        Ok(targets.write(&loaded, &solution, &self.arguments.drawing, NonZero::<usize>::MIN)?.origin)
    }

    fn open(&self, job: &Job) -> Result<LoadedProject, CliError> {
        let project = self.project(&job.project)?;
        let size = project.file().size();
        let read = |path: &Path| picture::read(path, Some(size));
        match &job.image {
            // Each picture is used once.
            Some(path) if self.has_many_images => project.with_picture(Arc::new(read(path)?), path.clone()),
            Some(path) => project.with_picture(self.pictures.get((path.clone(), size), || read(path))?, path.clone()),
            None => {
                let file = project.file();
                let path = file.own_picture_path()?;
                let image = self.pictures.get((path.clone(), size), || file.own_picture().map(|(image, _)| image))?;
                Ok(file.with_picture(image, path, false))
            }
        }
    }

    fn project(&self, path: &Path) -> Result<Arc<FittingProject>, CliError> {
        if let Some(project) = self.piped.get(path) {
            return Ok(Arc::clone(project));
        }
        self.projects.get(path.to_owned(), || {
            let fit = self.arguments.fit;
            FittingProject::new(ProjectFile::read(path)?, fit, self.has_many_images)
        })
    }
}

/// Prints the position of each picture's upper left corner with the name of its result.
fn print_origins(jobs: &[Job], origins: &[Option<[i32; 2]>]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    for (job, origin) in jobs.iter().zip(origins) {
        if let Some([left, top]) = origin {
            writeln!(stdout, "{left},{top} {}", job.name.to_string_lossy())?;
        }
    }
    stdout.flush()
}
