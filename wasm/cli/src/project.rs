//! A project with its picture: the input of every subcommand.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use c2warp::Picture;
use c2warp::Solution;
use c2warp::clip::Playback;
use c2warp::deform::Pose;
use c2warp::domain::{Domain, OutlineDetail};
use c2warp::project::{Clip, Project};

use crate::carried;
use crate::error::CliError;
use crate::input;
use crate::output::Output;
use crate::picture::{self, PictureFile};

/// The input files of every subcommand.
#[derive(Debug, clap::Args)]
pub(crate) struct InputFiles {
    /// The project file *.c2warp.json, or a PNG that the editor exported. Use - to read this or any other input from
    /// standard input
    project: PathBuf,
    /// Use this picture instead of the project's image.src
    #[arg(long, value_name = "FILE")]
    image: Option<PathBuf>,
}

/// A project and its decoded picture.
#[derive(Debug)]
pub(crate) struct LoadedProject {
    pub(crate) project: Project,
    /// Path of the project, for errors about its contents.
    project_path: PathBuf,
    image: PictureFile,
    /// Path of the picture, for errors about its pixels. If the project holds it, the project's path and the key.
    image_path: PathBuf,
}

impl LoadedProject {
    /// Reads the project and its picture.
    pub(crate) fn open(files: &InputFiles) -> Result<Self, CliError> {
        let path = &files.project;
        let bytes = input::read(path).map_err(CliError::read(path))?;
        let text = carried::project_text(bytes, path)?;
        let project = Project::from_json(&text).map_err(|reason| CliError::Project { path: path.clone(), reason })?;
        let source = project.image.src.as_str();
        let (image, image_path) = match &files.image {
            Some(image_path) => (picture::read(image_path)?, image_path.clone()),
            None if source.is_empty() => return Err(CliError::NoPicture { path: path.clone() }),
            None if carried::is_data_url(source) => {
                let key = PathBuf::from(format!("{}: image.src", path.display()));
                (picture::read_from(&*carried::data_url_bytes(source, path)?, &key)?, key)
            }
            None => {
                let image_path = path.parent().unwrap_or(Path::new("")).join(source);
                (picture::read(&image_path)?, image_path)
            }
        };
        Ok(Self { project, project_path: path.clone(), image, image_path })
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

    /// Prepares an output. It must not replace the project file.
    pub(crate) fn output(&self, path: &Path) -> Result<Output, CliError> {
        match [fs::canonicalize(path), fs::canonicalize(&self.project_path)] {
            [Ok(output), Ok(project)] if output == project => Err(CliError::OverProject { path: path.to_owned() }),
            _ => Output::open(path),
        }
    }

    /// Returns whether a path is that of the project's picture.
    pub(crate) fn is_picture(&self, path: &Path) -> bool {
        matches!([fs::canonicalize(path), fs::canonicalize(&self.image_path)], [Ok(path), Ok(image)] if path == image)
    }

    /// Returns the pixels for the solver.
    pub(crate) fn picture(&self) -> Result<Picture<'_>, CliError> {
        let pixels = &self.image.pixels;
        Picture::new(pixels.width(), pixels.height(), pixels.as_raw()).map_err(CliError::refused(&self.image_path))
    }

    /// Returns the ICC profile of the picture's colours, or `None` for sRGB.
    pub(crate) fn profile(&self) -> Option<&[u8]> {
        self.image.profile.as_deref()
    }

    /// Returns the picture file with its pixels.
    pub(crate) fn picture_file(&self) -> &PictureFile {
        &self.image
    }

    /// Solves the project. Tells on standard error if the outline could not be followed closely.
    pub(crate) fn solve(&self) -> Result<Solution, CliError> {
        let solution = c2warp::solve(&self.project, &self.picture()?).map_err(|reason| self.refused(reason))?;
        if let Some(remark) = remark(solution.domain()) {
            // If standard error is closed, nobody reads it.
            let _ = writeln!(io::stderr(), "c2warp: {}: {remark}", self.image_path.display());
        }
        Ok(solution)
    }

    /// Poses the handles as the project asks.
    pub(crate) fn pose(&self, solution: &Solution) -> Result<Pose, CliError> {
        solution.pose(&self.project).map_err(|reason| self.refused(reason))
    }

    /// Returns an error about a clip of the project, or about the rig of all.
    pub(crate) fn not_baked(&self, reason: c2warp::rig::BakeError) -> CliError {
        CliError::NotBaked { path: self.project_path.clone(), reason }
    }

    /// Poses the handles as a clip does at a time in seconds.
    pub(crate) fn pose_at(&self, solution: &Solution, clip: &Clip, time: f64) -> Result<Pose, CliError> {
        let mut playback = Playback::new(solution.poser().clone(), clip.clone(), self.project.handles.clone());
        playback.pose(time, self.project.pose.blend).map_err(|reason| self.refused(reason))
    }

    /// Returns an error about the contents of the project.
    pub(crate) fn refused(&self, reason: c2warp::Error) -> CliError {
        CliError::Refused { path: self.project_path.clone(), reason }
    }
}

/// A remark on an outline that does not follow the picture closely.
fn remark(domain: &Domain) -> Option<String> {
    match domain.detail() {
        OutlineDetail::Simplified => Some("the outline is very fine, so it is followed less closely".into()),
        OutlineDetail::Bridged => {
            let gap = domain.bridged_gap();
            Some(format!("the outline is too fine to be followed: parts up to {gap} px apart bend together"))
        }
        OutlineDetail::Picture => Some("the outline is too fine to be followed: the whole picture bends".into()),
        _ => None,
    }
}
