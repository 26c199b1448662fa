//! The name and the form of a handle, which a pose must match.

use serde::{Deserialize, Serialize};

use crate::project::Form;

/// A handle as it was solved, without its places.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct SolvedHandle {
    pub(crate) id: String,
    pub(crate) form: Form,
}
