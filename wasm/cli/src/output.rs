//! An output file that appears complete or not at all.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// An output file, under a temporary name beside its path until it is [`finish`](Output::finish)ed.
///
/// Created before the work whose result it takes, so that a path that cannot be written is reported at once.
#[derive(Debug)]
pub(crate) struct Output {
    writer: BufWriter<File>,
    path: PathBuf,
    /// The temporary name; `None` for a path that is no regular file, such as `/dev/stdout`, and after finishing.
    temporary: Option<PathBuf>,
}

impl Output {
    /// Checks that the path can be written, and opens the temporary file.
    pub(crate) fn create(path: &Path) -> Result<Self, CliError> {
        Self::open(path).map_err(CliError::write(path))
    }

    fn open(path: &Path) -> io::Result<Self> {
        // A symbolic link is kept and its target written, whether that exists or not.
        let named = |_| fs::read_link(path).map(|to| path.with_file_name("").join(to));
        let path = fs::canonicalize(path).or_else(named).unwrap_or_else(|_| path.to_owned());
        let (file, temporary) = match fs::metadata(&path) {
            Ok(place) if place.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            Ok(place) if !place.is_file() => (OpenOptions::new().write(true).open(&path)?, None),
            Ok(place) if place.permissions().readonly() => return Err(io::ErrorKind::PermissionDenied.into()),
            _ => {
                let temporary = temporary_beside(&path)?;
                (OpenOptions::new().write(true).create_new(true).open(&temporary)?, Some(temporary))
            }
        };
        Ok(Self { writer: BufWriter::new(file), path, temporary })
    }

    /// Calls `write` and renames the file to its path.
    pub(crate) fn finish(mut self, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> Result<(), CliError> {
        write(&mut self.writer)
            .and_then(|()| self.writer.flush())
            .and_then(|()| match self.temporary.take() {
                Some(temporary) => fs::rename(&temporary, &self.path).inspect_err(|_| self.temporary = Some(temporary)),
                None => Ok(()),
            })
            .map_err(CliError::write(&self.path))
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if let Some(temporary) = &self.temporary {
            // A file left behind does no harm, and the error has been reported already.
            let _ = fs::remove_file(temporary);
        }
    }
}

fn temporary_beside(path: &Path) -> io::Result<PathBuf> {
    let name = path.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.part", std::process::id()));
    Ok(path.with_file_name(temporary))
}
