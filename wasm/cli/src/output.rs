//! Outputs: a file that appears complete or not at all, or a stream.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::TempPath;

use crate::error::CliError;
use crate::progress;

/// The names of standard output. It is never replaced by a new file, because other programs may write to it as well.
const STANDARD_OUTPUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// A CSV writer for an output.
pub(crate) type Table<'a> = csv::Writer<&'a mut dyn Write>;

/// An output that is checked before the work starts, so that an unwritable path is reported at once.
pub(crate) struct Output {
    path: PathBuf,
    target: Target,
}

enum Target {
    Stream(Box<dyn Write>),
    File(Replacement),
}

impl Output {
    /// Opens a stream, or checks that a file can be written.
    pub(crate) fn open(path: &Path) -> Result<Self, CliError> {
        let target = Target::open(path).map_err(CliError::write(path))?;
        Ok(Self { path: path.to_owned(), target })
    }

    /// Returns whether both outputs are the same file, under any name, or both are standard output.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        match (&self.target, &other.target) {
            (Target::File(file), Target::File(other)) => file.resolved_path() == other.resolved_path(),
            _ => is_standard_output(&self.path) && is_standard_output(&other.path) || self.path == other.path,
        }
    }

    /// Writes the output by calling `write`. If that fails, an existing file keeps its contents.
    pub(crate) fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
        if let Target::Stream(_) = &self.target {
            // The stream may be the terminal that shows progress.
            progress::clear();
        }
        match self.target {
            Target::Stream(stream) => write_buffered(stream, write),
            Target::File(file) => file.write(write),
        }
        .map_err(CliError::write(self.path))
    }

    /// Writes a CSV table. Failures are handled as in [`write`](Self::write).
    pub(crate) fn write_table(self, write: impl FnOnce(&mut Table<'_>) -> csv::Result<()>) -> Result<(), CliError> {
        self.write(|writer| {
            let mut table = csv::Writer::from_writer(writer);
            write(&mut table).map_err(|reason| match reason.into_kind() {
                // `From<csv::Error>` would lose the kind.
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
        let permissions = match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
            // A pipe or a device.
            Ok(metadata) if !metadata.is_file() => {
                return Ok(Self::Stream(Box::new(OpenOptions::new().write(true).open(path)?)));
            }
            Ok(metadata) if is_read_only(path, &metadata) => return Err(io::ErrorKind::PermissionDenied.into()),
            Ok(metadata) => Some(metadata.permissions()),
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => None,
            Err(reason) => return Err(reason),
        };
        let mut path = path.to_owned();
        // Keep symbolic links and write their target, even if it does not exist yet.
        while let Ok(to) = fs::read_link(&path) {
            path = path.with_file_name("").join(to);
        }
        let file = Replacement { path, permissions };
        // Creating a file proves that the folder is writable. It is dropped at once: if it stayed during the work, a
        // killed process would leave it behind.
        file.create()?;
        Ok(Self::File(file))
    }
}

/// A file that is written under a unique temporary name in the same folder, and then renamed.
struct Replacement {
    path: PathBuf,
    /// The permissions of the file that is replaced, if it exists.
    permissions: Option<Permissions>,
}

impl Replacement {
    /// Returns the path with its folder made canonical.
    fn resolved_path(&self) -> PathBuf {
        let folder = self.path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
        self.path.file_name().map_or(folder.clone(), |name| folder.join(name))
    }

    fn create(&self) -> io::Result<(File, TempPath)> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let mut names = tempfile::Builder::new();
        names.prefix(".c2warp-").suffix(".part");
        let (file, name) = names.make_in(folder, |name| File::create_new(name))?.into_parts();
        if let Some(permissions) = &self.permissions
            && file.metadata()?.permissions() != *permissions
        {
            file.set_permissions(permissions.clone())?;
        }
        Ok((file, name))
    }

    fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let (file, name) = self.create()?;
        write_buffered(file, write)?;
        name.persist(self.path).map_err(|error| error.error)
    }
}

fn write_buffered(to: impl Write, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut writer = BufWriter::new(to);
    write(&mut writer)?;
    writer.flush()
}

/// Prints to standard output.
pub(crate) fn print(bytes: &[u8]) -> Result<(), CliError> {
    progress::clear();
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(CliError::Print)
}

fn is_read_only(path: &Path, metadata: &fs::Metadata) -> bool {
    if cfg!(target_os = "wasi") {
        // It has no permissions, but the system outside refuses to open such a file.
        OpenOptions::new().append(true).open(path).is_err()
    } else {
        metadata.permissions().readonly()
    }
}

/// Returns whether two paths lead to the same existing file.
pub(crate) fn is_same_file(one: &Path, other: &Path) -> bool {
    matches!([fs::canonicalize(one), fs::canonicalize(other)], [Ok(one), Ok(other)] if one == other)
}

/// Returns whether the path is a name of standard output.
pub(crate) fn is_standard_output(path: &Path) -> bool {
    STANDARD_OUTPUT.iter().any(|name| path == Path::new(name))
}
