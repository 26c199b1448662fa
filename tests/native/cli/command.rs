//! Runs the `c2warp` binary of this workspace.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

/// Returns the binary in the folder of this test, and builds it first.
///
/// Cargo builds it by itself only for tests in the binary's own package. With all packages of the workspace in view, it
/// has the features that the tests were built with: otherwise half of its dependencies would be built again.
fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        let test = std::env::current_exe().unwrap();
        let folder = test.ancestors().nth(2).expect("Cargo builds tests into PROFILE/deps");
        let profile = match folder.file_name().and_then(|name| name.to_str()) {
            Some("debug") | None => "dev",
            Some(profile) => profile,
        };
        let built = Command::new(env!("CARGO"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["build", "--quiet", "--workspace", "--bin", "c2warp", "--profile", profile, "--target-dir"])
            .arg(folder.parent().unwrap())
            .status()
            .unwrap();
        assert!(built.success());
        folder.join("c2warp").with_extension(std::env::consts::EXE_EXTENSION)
    })
}

/// Returns the command with arguments separated by spaces, to run in a folder.
pub(crate) fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(binary());
    command.current_dir(folder).args(arguments.split_whitespace());
    command
}

/// Runs the command and returns its standard output. It must succeed with an empty standard error.
pub(crate) fn succeed(folder: &Path, arguments: &str) -> Vec<u8> {
    let Output { status, stdout, stderr } = command(folder, arguments).output().unwrap();
    assert!(status.success() && stderr.is_empty(), "{arguments}: {status}: {}", String::from_utf8_lossy(&stderr));
    stdout
}

/// Runs the command with a reader that closes the pipe at once. It must succeed with an empty standard error.
pub(crate) fn succeed_with_closed_pipe(folder: &Path, arguments: &str) {
    let mut run = command(folder, arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(run.stdout.take());
    let ended = run.wait_with_output().unwrap();
    assert!(ended.status.success() && ended.stderr.is_empty(), "{arguments}: {ended:?}");
}

/// Runs the command and returns its error message. It must exit with status 1 and print one line on standard error.
pub(crate) fn fail(folder: &Path, arguments: &str) -> String {
    let Output { status, stdout, stderr } = command(folder, arguments).output().unwrap();
    let text = String::from_utf8(stderr).unwrap();
    assert_eq!(status.code(), Some(1), "{arguments}: {text}");
    assert!(stdout.is_empty(), "{arguments} printed to standard output");
    let line = text.strip_prefix("c2warp: ").and_then(|text| text.strip_suffix('\n'));
    let line = line.unwrap_or_else(|| panic!("{arguments}: {text:?}"));
    assert!(!line.contains('\n') && line.len() < 300, "{arguments}: {line}");
    line.to_owned()
}
