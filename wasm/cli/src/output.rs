//! An output file that appears complete or not at all, or a stream.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::TempPath;

use crate::error::CliError;

/// The names of standard output. A file that it leads to is never replaced, as others write there, too.
const STANDARD_OUTPUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// A table on its way to an output.
pub(crate) type Table<'a> = csv::Writer<&'a mut dyn Write>;

/// An output, opened or checked before the work whose result it takes, so that a path that cannot be written is reported at once.
pub(crate) struct Output {
    path: PathBuf,
    target: Target,
}

enum Target {
    Stream(Box<dyn Write>),
    File(Replacement),
}

impl Output {
    /// Checks that the path can be written.
    pub(crate) fn create(path: &Path) -> Result<Self, CliError> {
        let target = Target::open(path).map_err(CliError::write(path))?;
        Ok(Self { path: path.to_owned(), target })
    }

    /// Whether both are the same file, by whatever names, or standard output.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        match (&self.target, &other.target) {
            (Target::File(file), Target::File(other)) => file.place() == other.place(),
            _ => is_standard_output(&self.path) && is_standard_output(&other.path) || self.path == other.path,
        }
    }

    /// Writes what `write` does; a file stays as it was if that fails.
    pub(crate) fn finish(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
        match self.target {
            Target::Stream(stream) => written(stream, write),
            Target::File(file) => file.written(write),
        }
        .map_err(CliError::write(self.path))
    }

    /// Writes a CSV table, as [`finish`](Self::finish).
    pub(crate) fn finish_table(self, write: impl FnOnce(&mut Table<'_>) -> csv::Result<()>) -> Result<(), CliError> {
        self.finish(|writer| {
            let mut table = csv::Writer::from_writer(writer);
            write(&mut table).map_err(|reason| match reason.into_kind() {
                // Otherwise its kind is lost.
                csv::ErrorKind::Io(reason) => reason,
                reason => io::Error::other(format!("{reason:?}")),
            })?;
            table.flush()
        })
    }
}

impl Target {
    fn open(path: &Path) -> io::Result<Self> {
        if is_standard_output(path) {
            return Ok(Self::Stream(Box::new(io::stdout())));
        }
        let earlier = match fs::metadata(path) {
            Ok(place) if place.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            // Such as a pipe.
            Ok(place) if !place.is_file() => {
                return Ok(Self::Stream(Box::new(OpenOptions::new().write(true).open(path)?)));
            }
            Ok(place) if place.permissions().readonly() => return Err(io::ErrorKind::PermissionDenied.into()),
            Ok(place) => Some(place.permissions()),
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => None,
            Err(reason) => return Err(reason),
        };
        let mut path = path.to_owned();
        // Symbolic links are kept and their target written, whether that exists or not.
        while let Ok(to) = fs::read_link(&path) {
            path = path.with_file_name("").join(to);
        }
        let file = Replacement { path, earlier };
        // One that stood here during the work would be left behind by whatever ends the process.
        file.create()?;
        Ok(Self::File(file))
    }
}

/// A file that is written beside its path, under a name that no other process has, and renamed.
struct Replacement {
    path: PathBuf,
    /// The permissions of the file that is replaced.
    earlier: Option<Permissions>,
}

impl Replacement {
    /// The path without links and detours in its folder.
    fn place(&self) -> PathBuf {
        let folder = self.path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
        self.path.file_name().map_or(folder.clone(), |name| folder.join(name))
    }

    fn create(&self) -> io::Result<(File, TempPath)> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let mut names = tempfile::Builder::new();
        names.prefix(".c2warp-").suffix(".part");
        let (file, name) = names.make_in(folder, |name| File::create_new(name))?.into_parts();
        if let Some(earlier) = &self.earlier
            && file.metadata()?.permissions() != *earlier
        {
            file.set_permissions(earlier.clone())?;
        }
        Ok((file, name))
    }

    fn written(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let (file, name) = self.create()?;
        written(file, write)?;
        name.persist(self.path).map_err(|refusal| refusal.error)
    }
}

fn written(to: impl Write, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut writer = BufWriter::new(to);
    write(&mut writer)?;
    writer.flush()
}

/// Whether the path is a name of standard output.
pub(crate) fn is_standard_output(path: &Path) -> bool {
    STANDARD_OUTPUT.iter().any(|name| path == Path::new(name))
}
