//! A project with its picture: the input of every subcommand.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use c2warp::clip::Playback;
use c2warp::deform::Pose;
use c2warp::domain::{Domain, OutlineDetail};
use c2warp::project::{Clip, Project};
use c2warp::{Picture, Solution, Solver, Stage};
use c2warp_vector::{Drawing, VectorError};

use crate::carried;
use crate::error::{self, CliError};
use crate::files;
use crate::fitting::{Fit, FittingProject};
use crate::input;
use crate::picture::{self, PictureFile};
use crate::progress;

/// The input files of a subcommand.
#[derive(Debug, clap::Args)]
pub(crate) struct InputFiles {
    /// The project file *.c2warp.json, or a PNG that the editor exported. Use - to read this or any other input from
    /// standard input
    project: PathBuf,
    /// Use this picture instead of the project's image.src. If it has another size, the project is scaled
    #[arg(long, value_name = "FILE")]
    image: Option<PathBuf>,
    /// Fit the project to a picture of other proportions, or with its outline in another place
    #[arg(long, requires = "image")]
    fit: Option<Fit>,
}

/// A project with its path.
#[derive(Debug, Clone)]
pub(crate) struct ProjectFile {
    pub(crate) project: Project,
    pub(crate) path: PathBuf,
}

impl InputFiles {
    /// Path of the project, for errors.
    pub(crate) fn project(&self) -> &Path {
        &self.project
    }
}

/// A project and its decoded picture.
#[derive(Debug)]
pub(crate) struct LoadedProject {
    pub(crate) project: Project,
    project_path: PathBuf,
    image: Arc<PictureFile>,
    /// Path of the picture, for errors about its pixels. If the project holds it, the project's path and the key.
    image_path: PathBuf,
    /// Whether errors about the contents of the project name its picture, because the project suits other pictures.
    names_picture: bool,
}

impl ProjectFile {
    /// Reads a project, without its picture.
    pub(crate) fn read(path: &Path) -> Result<Self, CliError> {
        let text = Self::text(path)?;
        let refused = |reason| CliError::Project { path: path.to_owned(), reason };
        Ok(Self { project: Project::from_json(&text).map_err(refused)?, path: path.to_owned() })
    }

    /// Reads the text of a project.
    pub(crate) fn text(path: &Path) -> Result<String, CliError> {
        carried::project_text(input::read(path).map_err(CliError::read(path))?, path)
    }

    /// The size of the project's picture.
    pub(crate) fn size(&self) -> (u32, u32) {
        (self.project.image.width, self.project.image.height)
    }

    /// Reads the picture that the project names or holds. Returns its path as well.
    pub(crate) fn own_picture(&self) -> Result<(PictureFile, PathBuf), CliError> {
        let (path, source, size) = (self.own_picture_path()?, self.project.image.src.as_str(), Some(self.size()));
        let image = if carried::is_data_url(source) {
            picture::read_from(&*carried::data_url_bytes(source, &self.path)?, &path, size)?
        } else {
            picture::read(&path, size)?
        };
        Ok((image, path))
    }

    /// Returns the path of the project's picture. If the project holds it, the project's path and the key.
    pub(crate) fn own_picture_path(&self) -> Result<PathBuf, CliError> {
        let (path, source) = (&self.path, self.project.image.src.as_str());
        if source.is_empty() {
            return Err(CliError::NoPicture { path: path.clone() });
        }
        Ok(if carried::is_data_url(source) {
            PathBuf::from(format!("{}: image.src", path.display()))
        } else {
            path.parent().unwrap_or(Path::new("")).join(source)
        })
    }

    /// The project with a picture of its size.
    ///
    /// `names_picture` is for errors about the contents of the project: they name the picture instead of the project.
    pub(crate) fn with_picture(
        &self,
        image: Arc<PictureFile>,
        image_path: PathBuf,
        names_picture: bool,
    ) -> LoadedProject {
        let Self { project, path } = self.clone();
        LoadedProject { project, project_path: path, image, image_path, names_picture }
    }
}

impl LoadedProject {
    /// Reads a project and its picture.
    pub(crate) fn open(files: &InputFiles) -> Result<Self, CliError> {
        Self::read(&files.project, files.image.as_deref(), files.fit)
    }

    /// Reads a project with its own picture, or with another one that it is fitted to.
    pub(crate) fn read(project: &Path, image: Option<&Path>, fit: Option<Fit>) -> Result<Self, CliError> {
        Self::of(ProjectFile::read(project)?, image, fit)
    }

    /// Reads the picture of a project.
    pub(crate) fn with_picture(project: Project, files: &InputFiles) -> Result<Self, CliError> {
        let file = ProjectFile { project, path: files.project.clone() };
        Self::of(file, files.image.as_deref(), files.fit)
    }

    fn of(file: ProjectFile, image: Option<&Path>, fit: Option<Fit>) -> Result<Self, CliError> {
        match image {
            Some(path) => {
                let image = picture::read(path, Some(file.size()))?;
                FittingProject::new(file, fit, false)?.with_picture(Arc::new(image), path.to_owned())
            }
            None => {
                let (image, path) = file.own_picture()?;
                Ok(file.with_picture(Arc::new(image), path, false))
            }
        }
    }

    /// Returns the path of the project, for errors about its contents.
    pub(crate) fn path(&self) -> &Path {
        &self.project_path
    }

    /// Returns the clip with a name.
    pub(crate) fn clip(&self, name: &str) -> Result<&Clip, CliError> {
        let clips = &self.project.clips;
        clips.iter().find(|clip| clip.name == name).ok_or_else(|| {
            let names = clips.iter().map(|clip| clip.name.clone()).collect();
            CliError::NoClip { path: self.project_path.clone(), name: name.to_owned(), names }
        })
    }

    /// Returns whether a path is that of the project's picture.
    pub(crate) fn is_picture(&self, path: &Path) -> bool {
        files::is_same_file(path, &self.image_path)
    }

    /// Returns the name of the picture's file, without its folder.
    pub(crate) fn picture_name(&self) -> String {
        self.image_path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }

    /// Returns the pixels for the solver.
    pub(crate) fn picture(&self) -> Result<Picture<'_>, CliError> {
        self.image.picture(&self.image_path)
    }

    /// Returns the ICC profile of the picture's colours, or `None` for sRGB.
    pub(crate) fn profile(&self) -> Option<&[u8]> {
        self.image.profile.as_deref()
    }

    /// Returns the picture as a drawing, or `None` for pixels.
    pub(crate) fn drawing(&self) -> Option<&Drawing> {
        self.image.drawing.as_ref()
    }

    /// Returns an error about the contents of the drawing.
    pub(crate) fn drawing_refused(&self, reason: VectorError) -> CliError {
        CliError::Drawing { path: self.image_path.clone(), reason }
    }

    /// Returns the picture file with its pixels.
    pub(crate) fn picture_file(&self) -> &PictureFile {
        &self.image
    }

    /// Solves the project. Reports on standard error if the outline could not be followed closely.
    pub(crate) fn solve(&self) -> Result<Solution, CliError> {
        self.solve_by(|_| Ok(()))
    }

    /// Solves the project with the fill behind the domain, for results that show pixels.
    pub(crate) fn solve_filled(&self) -> Result<Solution, CliError> {
        self.solve_by(|solver| {
            let picture = self.picture()?;
            while let Some(done) = solver.advance_fill(&picture).map_err(|reason| self.refused(reason))? {
                progress::count("filling the background: percent", (100.0 * done) as usize, 100);
            }
            Ok(())
        })
    }

    fn solve_by(&self, finish: impl Fn(&mut Solver) -> Result<(), CliError>) -> Result<Solution, CliError> {
        let mut solver = Solver::new();
        self.solve_stages(&mut solver, &self.picture()?).map_err(|reason| self.refused(reason))?;
        finish(&mut solver)?;
        let solution = solver.into_solution().expect("every stage has run");
        if let Some(remark) = remark(solution.domain()) {
            error::print(format_args!("{}: {remark}", self.image_path.display()));
        }
        progress::show("drawing");
        Ok(solution)
    }

    /// Solves the project stage by stage, and shows the stages.
    pub(crate) fn solve_stages(&self, solver: &mut Solver, picture: &Picture<'_>) -> Result<(), c2warp::Error> {
        progress::show("finding the outline");
        solver.begin(&self.project, picture)?;
        while let Some(stage) = solver.advance()? {
            progress::show(match stage {
                Stage::Domain => "solving: samples",
                Stage::Sampling => "solving: distances and regions",
                _ => "solving: weights",
            });
        }
        Ok(())
    }

    /// Poses the handles as the project asks.
    pub(crate) fn pose(&self, solution: &Solution) -> Result<Pose, CliError> {
        solution.pose(&self.project).map_err(|reason| self.refused(reason))
    }

    /// Returns an error about a clip of the project, or about the rig of all clips.
    pub(crate) fn not_baked(&self, reason: c2warp::rig::BakeError) -> CliError {
        CliError::NotBaked { path: self.project_path.clone(), reason }
    }

    /// Poses the handles of a clip at a time in seconds.
    pub(crate) fn pose_at(&self, solution: &Solution, clip: &Clip, time: f64) -> Result<Pose, CliError> {
        let pose = self.playback(solution, clip).pose(time, self.project.pose.blend);
        pose.map_err(|reason| self.refused(reason))
    }

    /// Poses along a clip.
    pub(crate) fn playback(&self, solution: &Solution, clip: &Clip) -> Playback {
        Playback::new(solution.poser().clone(), clip.clone(), self.project.handles.clone())
    }

    /// Returns an error about the contents of the project.
    pub(crate) fn refused(&self, reason: c2warp::Error) -> CliError {
        let path = if self.names_picture { &self.image_path } else { &self.project_path };
        CliError::Refused { path: path.clone(), reason }
    }
}

/// A remark on an outline that does not follow the picture closely.
pub(crate) fn remark(domain: &Domain) -> Option<String> {
    match domain.detail() {
        OutlineDetail::Simplified => Some("the outline is very detailed, so it is followed less closely".into()),
        OutlineDetail::Bridged => {
            let gap = domain.bridged_gap();
            Some(format!("the outline is too detailed to follow: parts up to {gap} px apart bend together"))
        }
        OutlineDetail::Picture => Some("the outline is too detailed to follow: the whole picture bends".into()),
        _ => None,
    }
}
