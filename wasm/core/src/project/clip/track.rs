//! The keys of one handle in a clip.

use super::super::error::ProjectError;
use super::super::handle::Handle;
use super::super::path::Path;
use super::{Key, check_time};
#[cfg(feature = "schema")]
use crate::limits::MAX_NAME;

/// The keys of one handle in a clip.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Track {
    /// The id of the handle.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = MAX_NAME)))]
    pub handle: String,
    /// One or more keys, in ascending order of time.
    #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
    pub keys: Vec<Key>,
}

impl Track {
    /// The track of a handle.
    pub fn new(handle: impl Into<String>, keys: impl IntoIterator<Item = Key>) -> Self {
        Self { handle: handle.into(), keys: keys.into_iter().collect() }
    }

    pub(super) fn check(&self, handle: &Handle, duration: f64, at: &Path<'_>) -> Result<(), ProjectError> {
        let at = at.key("keys");
        if self.keys.is_empty() {
            return at.refuse("expected at least one key, found none");
        }
        let mut earlier = f64::NEG_INFINITY;
        self.keys.iter().enumerate().try_for_each(|(index, key)| {
            let at = at.index(index);
            check_time(&at.key("time"), key.time, duration)?;
            if key.time <= earlier {
                let time = key.time;
                return at
                    .key("time")
                    .refuse(format_args!("expected a time after {earlier}, that of the previous key, found {time}"));
            }
            earlier = key.time;
            key.check(handle, &at)
        })
    }
}
