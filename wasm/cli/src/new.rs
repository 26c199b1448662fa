//! `c2warp new`: a project for a picture, with given or suggested handles and the settings of the editor.

use std::fs;
use std::path::{Component, Path, PathBuf};

use c2warp::domain::Domain;
use c2warp::project::{DomainSpec, Handle, ImageRef, Project};
use c2warp::suggest::{SuggestedRole, suggest};
use c2warp::{Picture, Solver};
use glam::DVec2;

use crate::error::{self, CliError};
use crate::files;
use crate::output::Output;
use crate::points;
use crate::project::remark;
use crate::{carried, picture};

/// Maximum number of suggested handles. More handles would hinder each other.
const MOST: u16 = 100;

/// Makes a project for a picture, with the handles at given points or with suggested ones
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: a project with handles where an animator would begin\n  \
                        c2warp new cat.png --suggest -o suggested.c2warp.json")]
pub(crate) struct Arguments {
    /// The picture, or - for standard input
    picture: PathBuf,
    #[command(flatten)]
    handles: Handles,
    /// The project file, or - for standard output. The default is beside the picture: cat.c2warp.json for cat.png
    #[arg(short, long, value_name = "OUT.c2warp.json")]
    output: Option<PathBuf>,
    /// Replace an existing project file
    #[arg(long)]
    force: bool,
}

#[derive(Debug, clap::Args)]
#[group(required = true, multiple = false)]
struct Handles {
    /// Points for handles, in pixels from the upper left corner
    #[arg(long, value_name = "X,Y", num_args = 1.., value_parser = points::parse)]
    handles: Option<Vec<DVec2>>,
    /// Suggest handles: at the ends of limbs, at necks and bends, and in the middle. Suggests 5 to 14 handles, or N if
    /// there is room. A picture without transparency gets even rows
    #[arg(long, value_name = "N", num_args = 0..=1, value_parser = clap::value_parser!(u16).range(1..=i64::from(MOST)))]
    suggest: Option<Option<u16>>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let path = &arguments.picture;
    let file = picture::read(path, None)?;
    let (width, height) = file.pixels.dimensions();
    let picture = Picture::new(width, height, file.pixels.as_raw()).map_err(CliError::refused(path))?;
    let target = match &arguments.output {
        Some(output) => output.clone(),
        None if path == Path::new("-") => PathBuf::from("-"),
        None => path.with_extension("c2warp.json"),
    };
    if !arguments.force && !files::is_standard_output(&target) && target.is_file() {
        return Err(CliError::Exists { path: target });
    }
    let output = Output::open(&target)?;
    let mut project = Project::new(ImageRef::new(source(path, &target), width, height));
    let domain = Domain::default_spec(&picture);
    // The edges of an opaque picture would leave gaps behind them. The editor holds them too.
    project.fix_boundary = domain == DomainSpec::Image;
    project.domain = Some(domain);
    project.handles = match &arguments.handles {
        Handles { handles: Some(points), .. } => {
            let numbered = points.iter().enumerate();
            numbered.map(|(at, &rest)| Handle::point(format!("handle-{}", at + 1), rest)).collect()
        }
        Handles { suggest: count, .. } => suggested(&project, &picture, path, count.flatten())?,
    };
    let project = project.with_editor_settings();
    check(&project, &picture).map_err(CliError::refused(path))?;
    output.write(|writer| writer.write_all(project.to_json().as_bytes()))
}

/// Suggests handles. Reports on standard error if the picture has no outline to follow closely.
fn suggested(
    project: &Project,
    picture: &Picture<'_>,
    path: &Path,
    count: Option<u16>,
) -> Result<Vec<Handle>, CliError> {
    let domain = Domain::new(project.domain.as_ref(), picture).map_err(CliError::refused(path))?;
    let suggested = suggest(&domain, count.map(usize::from));
    let is_spread = suggested.iter().all(|handle| handle.role == SuggestedRole::Spread);
    let no_outline = || "the picture has no outline to follow, so the handles are in even rows".to_owned();
    if let Some(remark) = remark(&domain).or_else(|| is_spread.then(no_outline)) {
        error::print(format_args!("{}: {remark}", path.display()));
    }
    Ok(suggested.into_iter().map(|handle| Handle::point(handle.id, handle.rest)).collect())
}

/// Rejects handles that cannot be solved: outside the domain, or too close to each other.
fn check(project: &Project, picture: &Picture<'_>) -> Result<(), c2warp::Error> {
    let mut solver = Solver::new();
    solver.begin(project, picture)?;
    solver.advance().map(|_| ())
}

/// The address of the picture, relative to the project file. A picture from standard input has no address.
fn source(picture: &Path, project: &Path) -> String {
    if picture == Path::new("-") {
        return String::new();
    }
    let folder = |path: &Path| {
        let parent = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        fs::canonicalize(parent).ok()
    };
    // A project on standard output is looked up in the current folder.
    let project = if files::is_standard_output(project) { Path::new("project") } else { project };
    let relative = folder(picture).zip(folder(project)).zip(picture.file_name());
    let path = relative.map(|((picture, project), name)| from_folder(&project, &picture.join(name)));
    let path = path.unwrap_or_else(|| picture.to_owned());
    let address = path.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/");
    // A file with such a name would be read as the picture itself.
    if carried::is_data_url(&address) { format!("./{address}") } else { address }
}

/// The path from a folder to a file, both absolute.
fn from_folder(folder: &Path, file: &Path) -> PathBuf {
    let (folder, file): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (folder.components().collect(), file.components().collect());
    let common = folder.iter().zip(&file).take_while(|(one, other)| one == other).count();
    if common == 0 {
        // Another drive.
        return file.iter().collect();
    }
    let up = folder[common..].iter().map(|_| Component::ParentDir);
    up.chain(file[common..].iter().copied()).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::from_folder;

    #[cfg(unix)]
    #[test]
    fn pictures_are_found_from_the_folder_of_the_project() {
        for (folder, file, path) in [
            ("/a/b", "/a/b/cat.png", "cat.png"),
            ("/a/b", "/a/b/c/cat.png", "c/cat.png"),
            ("/a/b/c", "/a/cat.png", "../../cat.png"),
            ("/x", "/a/cat.png", "../a/cat.png"),
        ] {
            assert_eq!(from_folder(Path::new(folder), Path::new(file)), Path::new(path));
        }
    }
}
