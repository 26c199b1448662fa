//! What a pose must match: the handles that were solved.

use serde::{Deserialize, Serialize};

use crate::project::Form;

/// A handle as it was solved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Solved {
    pub(crate) id: String,
    pub(crate) form: Form,
}
