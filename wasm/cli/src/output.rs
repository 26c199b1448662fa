//! Outputs: a file that appears complete or not at all, or a stream.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use tempfile::TempPath;

use crate::error::CliError;
use crate::files::{self, Identity, is_standard_output};
use crate::{progress, signals};

/// A CSV writer for an output.
pub(crate) type Table<'a> = csv::Writer<&'a mut dyn Write>;

/// An output that is checked before the work starts, so that an unwritable path is reported at once.
#[derive(Debug)]
pub(crate) struct Output {
    path: PathBuf,
    target: Target,
}

#[derive(Debug)]
enum Target {
    Stream(Stream),
    File(Replacement),
}

#[derive(Debug)]
enum Stream {
    Standard,
    /// A pipe or a device.
    Named(File),
}

impl Output {
    /// Opens a stream, or checks that a file can be written. All inputs are known by now.
    ///
    /// # Errors
    /// If the path leads to an input or to another output of this run, or cannot be written.
    pub(crate) fn open(path: &Path) -> Result<Self, CliError> {
        Ok(Self { path: path.to_owned(), target: Target::open(path)? })
    }

    /// Writes the output by calling `write`. If that fails, an existing file keeps its contents.
    pub(crate) fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
        if let Target::Stream(_) = &self.target {
            // The stream may be the terminal that shows progress.
            progress::clear();
        }
        match self.target {
            Target::Stream(Stream::Standard) => write_buffered(io::stdout(), write),
            Target::Stream(Stream::Named(stream)) => write_buffered(stream, write),
            Target::File(file) => return file.write(write, &self.path),
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
    fn open(named: &Path) -> Result<Self, CliError> {
        let refused = |kind: io::ErrorKind| Err(CliError::write(named)(kind.into()));
        if is_standard_output(named) {
            files::claim(named, named)?;
            return Ok(Self::Stream(Stream::Standard));
        }
        let permissions = match fs::metadata(named) {
            Ok(metadata) if metadata.is_dir() => return refused(io::ErrorKind::IsADirectory),
            Ok(metadata) if !metadata.is_file() => {
                files::claim(named, named)?;
                let stream = OpenOptions::new().write(true).open(named).map_err(CliError::write(named))?;
                return Ok(Self::Stream(Stream::Named(stream)));
            }
            Ok(metadata) => Some(metadata),
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => None,
            Err(reason) => return Err(CliError::write(named)(reason)),
        };
        let mut path = named.to_owned();
        // Keep symbolic links and write their target, even if it does not exist yet.
        while let Ok(to) = fs::read_link(&path) {
            path = path.with_file_name("").join(to);
        }
        let claimed = files::claim(&path, named)?;
        if permissions.as_ref().is_some_and(|metadata| is_read_only(named, metadata)) {
            return refused(io::ErrorKind::PermissionDenied);
        }
        let file = Replacement { path, claimed, permissions: permissions.map(|metadata| metadata.permissions()) };
        // Creating a file proves that the folder is writable.
        file.unnamed().map_err(CliError::write(named))?;
        Ok(Self::File(file))
    }
}

/// A file that is written without a name, and gets it once it is complete. A run that is killed leaves nothing behind.
#[derive(Debug)]
struct Replacement {
    path: PathBuf,
    claimed: Identity,
    /// The permissions of the file that is replaced, if it exists.
    permissions: Option<Permissions>,
}

impl Replacement {
    fn folder(&self) -> &Path {
        self.path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."))
    }

    /// Creates a file in the folder that is gone once it is closed. Some systems remove its name after that only.
    fn unnamed(&self) -> io::Result<File> {
        let _deferred = signals::defer();
        tempfile::tempfile_in(self.folder())
    }

    fn create(&self) -> io::Result<(File, TempPath)> {
        let mut names = tempfile::Builder::new();
        names.prefix(".c2warp-").suffix(".part");
        let (file, name) = names.make_in(self.folder(), |name| File::create_new(name))?.into_parts();
        if let Some(permissions) = &self.permissions
            && file.metadata()?.permissions() != *permissions
        {
            file.set_permissions(permissions.clone())?;
        }
        Ok((file, name))
    }

    fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>, named: &Path) -> Result<(), CliError> {
        let refused = |reason| CliError::write(named)(reason);
        let mut whole = self.unnamed().map_err(refused)?;
        write_buffered(&whole, write).and_then(|()| whole.rewind()).map_err(refused)?;
        let _deferred = signals::defer();
        files::check_again(&self.path, &self.claimed, named)?;
        let (mut file, name) = self.create().map_err(refused)?;
        io::copy(&mut whole, &mut file).map_err(refused)?;
        name.persist(&self.path).map_err(|error| refused(error.error))?;
        files::note_written(&self.path, named);
        Ok(())
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
