//! Many pictures of one project, or many projects, each with its own result in a folder.
//!
//! Inputs that fail are reported on standard error, and the others continue. Pictures and solutions that several inputs
//! share are read and solved once: a solution does not depend on poses, clips and colours.
//!
//! Memory: each thread holds one picture with its result. The same number of pictures and solutions is kept for the
//! next inputs.

use std::collections::HashMap;
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
use crate::fitting::{FittingProject, stem};
use crate::picture::{self, PictureFile};
use crate::project::{LoadedProject, ProjectFile};
use crate::shared::Shared;
use crate::workers;

/// One result.
struct Job {
    project: PathBuf,
    /// A picture that replaces the project's own.
    image: Option<PathBuf>,
    output: PathBuf,
    stmap: Option<PathBuf>,
}

impl Job {
    /// The input that names the result.
    fn input(&self, of: &Batch<'_>) -> &Path {
        match &self.image {
            Some(image) if of.has_many_images => image,
            _ => &self.project,
        }
    }
}

/// Data shared by the jobs.
struct Batch<'a> {
    arguments: &'a Arguments,
    has_many_images: bool,
    projects: Shared<PathBuf, FittingProject>,
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
    let jobs: Vec<Job> = if has_many_images {
        images.into_iter().map(|image| arguments.job(&projects[0], Some(image.clone()), &image)).collect()
    } else {
        projects.iter().map(|path| arguments.job(path, images.first().cloned(), path)).collect()
    };
    for folder in [Some(&arguments.output), arguments.stmap.as_ref()].into_iter().flatten() {
        fs::create_dir_all(folder).map_err(CliError::write(folder))?;
    }
    let threads = arguments.threads();
    let kept = threads.get();
    let batch = Batch {
        arguments,
        has_many_images,
        projects: Shared::new(kept),
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
    let jobs = batch.with_own_results(jobs, report);
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

impl Arguments {
    /// A result with the name of an input.
    fn job(&self, project: &Path, image: Option<PathBuf>, named: &Path) -> Job {
        let name = |folder: &PathBuf, extension: &str| {
            let mut name = stem(named).into_os_string();
            name.push(extension);
            folder.join(name)
        };
        let output = name(&self.output, ".png");
        let stmap = self.stmap.as_ref().map(|folder| name(folder, ".exr"));
        Job { project: project.to_owned(), image, output, stmap }
    }
}

impl Batch<'_> {
    /// The jobs, except those whose result has the same name as another result.
    fn with_own_results(&self, jobs: Vec<Job>, report: impl Fn(CliError)) -> Vec<Job> {
        let mut first: HashMap<PathBuf, PathBuf> = HashMap::new();
        let is_own = |job: &Job| {
            let input = job.input(self).to_owned();
            if let Some(other) = first.get(&job.output) {
                report(CliError::SameResult { path: input, other: other.clone() });
                return false;
            }
            first.insert(job.output.clone(), input);
            true
        };
        jobs.into_iter().filter(is_own).collect()
    }

    fn work(&self, job: &Job) -> Result<[i32; 2], CliError> {
        let loaded = self.open(job)?;
        self.arguments.drawing.check(&loaded)?;
        if loaded.is_picture(&job.output) {
            return Err(CliError::OverPicture { path: job.output.clone() });
        }
        let targets = Targets::open(&loaded, &job.output, job.stmap.as_deref())?;
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
        if let (Some([left, top]), Some(name)) = (origin, job.output.file_name()) {
            writeln!(stdout, "{left},{top} {}", name.to_string_lossy())?;
        }
    }
    stdout.flush()
}
