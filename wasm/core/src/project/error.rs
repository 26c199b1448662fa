//! Why a project was refused, and where in it.

use std::fmt;

/// A project that was refused: the offending key and one sentence about it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ProjectError {
    /// Path of the offending key, as `handles[2].rest[0]`; empty for the project as a whole.
    pub path: String,
    /// What is wrong there.
    pub message: String,
}

impl fmt::Display for ProjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { f.write_str(&self.message) } else { write!(f, "{}: {}", self.path, self.message) }
    }
}

impl std::error::Error for ProjectError {}
