//! Why a project was rejected, and at which key.

use std::fmt;

/// An error in a project: the offending key, and a message about its value.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ProjectError {
    /// Path of the offending key, for example `handles[2].rest[0]`. It is empty for the project as a whole.
    pub path: String,
    /// The expected and the found value.
    pub message: String,
}

impl fmt::Display for ProjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { f.write_str(&self.message) } else { write!(f, "{}: {}", self.path, self.message) }
    }
}

impl std::error::Error for ProjectError {}
