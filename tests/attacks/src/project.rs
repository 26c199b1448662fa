//! The text of a project file.

use c2warp::project::{Project, ProjectError, clip_from_json, handles_from_json};

use crate::promises::expect_sentence;

/// Reads bytes as a project, as a list of handles, and as a clip of no handles.
///
/// A project that is read is written as text that reads as the same project, and writes as the same text.
///
/// # Panics
/// If that fails, or an error is not one line.
pub fn attack(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Some(project) = read(Project::from_json(text)) {
        let written = project.to_json();
        let again = Project::from_json(&written).expect("a written project is read");
        assert_eq!(again, project);
        assert_eq!(again.to_json(), written);
    }
    read(handles_from_json(text));
    read(clip_from_json(text, &[]));
}

fn read<T>(result: Result<T, ProjectError>) -> Option<T> {
    result.map_err(|error| expect_sentence(&error.to_string())).ok()
}
