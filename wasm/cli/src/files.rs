//! The files of a run, known by what they are and not by their names. No output replaces an input or another output.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::CliError;

/// The names of standard output. It is never replaced by a new file, because other programs may write to it as well.
const STANDARD_OUTPUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

static FILES: Mutex<Option<Files>> = Mutex::new(None);

/// Inputs and outputs, each with the first name that it was given by.
#[derive(Default)]
struct Files {
    inputs: HashMap<Identity, PathBuf>,
    outputs: HashMap<Identity, PathBuf>,
}

/// What a path leads to.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Identity {
    StandardOutput,
    Existing(Place),
    /// A name in a folder that has no such file yet.
    New(Place, OsString),
}

/// Device and inode: links have those of their file.
#[cfg(any(unix, target_os = "wasi"))]
type Place = (u64, u64);
#[cfg(not(any(unix, target_os = "wasi")))]
type Place = PathBuf;

#[cfg(any(unix, target_os = "wasi"))]
fn place(path: &Path) -> io::Result<Place> {
    Ok(numbers(&rustix::fs::stat(path)?))
}

#[cfg(any(unix, target_os = "wasi"))]
#[allow(clippy::unnecessary_cast, reason = "the types differ between systems")]
fn numbers(stat: &rustix::fs::Stat) -> Place {
    (stat.st_dev as u64, stat.st_ino as u64)
}

#[cfg(not(any(unix, target_os = "wasi")))]
fn place(path: &Path) -> io::Result<Place> {
    fs::canonicalize(path)
}

/// The file that standard input or output was redirected to, if it is one.
#[cfg(any(unix, target_os = "wasi"))]
fn redirected(stream: impl std::os::fd::AsFd) -> Option<Place> {
    let stat = rustix::fs::fstat(stream).ok()?;
    rustix::fs::FileType::from_raw_mode(stat.st_mode).is_file().then(|| numbers(&stat))
}

#[cfg(not(any(unix, target_os = "wasi")))]
fn redirected<T>(_: T) -> Option<Place> {
    None
}

/// Notes a file that is read, before any output is claimed. Pipes and missing files are left out.
pub(crate) fn note_input(path: &Path) {
    let found = match path == Path::new("-") {
        true => redirected(io::stdin()),
        false => fs::metadata(path).ok().filter(fs::Metadata::is_file).and_then(|_| place(path).ok()),
    };
    if let Some(found) = found {
        files(|files| files.inputs.entry(Identity::Existing(found)).or_insert_with(|| path.to_owned()).clone());
    }
}

/// Claims the file or stream at a path for an output. Links have been followed.
///
/// # Errors
/// If it is an input, or claimed already. The error begins with `named`, the path as it was given.
pub(crate) fn claim(path: &Path, named: &Path) -> Result<Identity, CliError> {
    let claimed = identity(path).map_err(CliError::write(named))?;
    if claimed == Identity::StandardOutput
        && let Some(file) = redirected(io::stdout())
    {
        check(&Identity::Existing(file), named)?;
    }
    check(&claimed, named)?;
    note_output(claimed.clone(), named);
    Ok(claimed)
}

/// Checks a claimed path again before a file is moved there. The folder may take other names for the same one.
pub(crate) fn check_again(path: &Path, claimed: &Identity, named: &Path) -> Result<(), CliError> {
    match identity(path).map_err(CliError::write(named))? {
        found if found == *claimed => Ok(()),
        found => check(&found, named),
    }
}

/// Notes the file that was written to a claimed path.
pub(crate) fn note_written(path: &Path, named: &Path) {
    if let Ok(found) = identity(path) {
        note_output(found, named);
    }
}

/// Returns whether two paths lead to the same existing file.
pub(crate) fn is_same_file(one: &Path, other: &Path) -> bool {
    matches!([place(one), place(other)], [Ok(one), Ok(other)] if one == other)
}

/// Returns whether the path is a name of standard output.
pub(crate) fn is_standard_output(path: &Path) -> bool {
    STANDARD_OUTPUT.iter().any(|name| path == Path::new(name))
}

fn identity(path: &Path) -> io::Result<Identity> {
    if is_standard_output(path) {
        return Ok(Identity::StandardOutput);
    }
    match place(path) {
        Err(reason) if reason.kind() == io::ErrorKind::NotFound => {
            let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
            Ok(Identity::New(place(folder)?, path.file_name().unwrap_or_default().to_owned()))
        }
        found => found.map(Identity::Existing),
    }
}

fn check(found: &Identity, named: &Path) -> Result<(), CliError> {
    files(|Files { inputs, outputs }| match (inputs.get(found), outputs.get(found)) {
        (Some(input), _) => Err(CliError::OverInput { path: named.to_owned(), input: input.clone() }),
        (None, Some(other)) => Err(CliError::OverOutput { path: named.to_owned(), other: other.clone() }),
        (None, None) => Ok(()),
    })
}

fn note_output(found: Identity, named: &Path) {
    files(|files| files.outputs.insert(found, named.to_owned()));
}

fn files<T>(work: impl FnOnce(&mut Files) -> T) -> T {
    let mut files: MutexGuard<'_, Option<Files>> = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    work(files.get_or_insert_default())
}
