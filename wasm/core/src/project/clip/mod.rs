//! Clips: poses of handles over time.

mod ease;
mod key;
mod looping;
mod track;

use std::collections::BTreeSet;

pub use self::ease::Ease;
pub use self::key::Key;
pub use self::looping::Looping;
pub use self::track::Track;

use super::error::ProjectError;
use super::handle::Handle;
use super::path::Path;
use super::validate;
use crate::display_number::DisplayNumber;
#[cfg(feature = "schema")]
use crate::limits::MAX_NAME;

/// An hour. No exporter writes longer films.
const MOST_SECONDS: f64 = 3600.0;

/// Poses of handles over time.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Clip {
    /// A name of 1 to 200 characters, unique in the project.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = MAX_NAME)))]
    pub name: String,
    /// Length in seconds, above 0 and up to 3,600.
    #[cfg_attr(feature = "schema", schemars(range(max = MOST_SECONDS), extend("exclusiveMinimum" = 0)))]
    pub duration: f64,
    /// What happens after the end.
    #[cfg_attr(feature = "serde", serde(rename = "loop"))]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub looping: Looping,
    /// The moving handles, each at most once. Other handles keep their pose.
    pub tracks: Vec<Track>,
}

impl Clip {
    /// A clip with a length in seconds, without tracks.
    pub fn new(name: impl Into<String>, duration: f64, looping: Looping) -> Self {
        Self { name: name.into(), duration, looping, tracks: Vec::new() }
    }

    /// The same clip with these tracks instead of its own.
    #[must_use]
    pub fn with_tracks(mut self, tracks: impl IntoIterator<Item = Track>) -> Self {
        self.tracks = tracks.into_iter().collect();
        self
    }

    pub(super) fn check(&self, handles: &[Handle], at: &Path<'_>) -> Result<(), ProjectError> {
        validate::name(&at.key("name"), &self.name)?;
        if !(self.duration > 0.0 && self.duration <= MOST_SECONDS) {
            return at.key("duration").refuse(format_args!(
                "expected seconds above 0 and up to {MOST_SECONDS}, found {}",
                DisplayNumber(self.duration)
            ));
        }
        let tracks = at.key("tracks");
        let mut moved = BTreeSet::new();
        self.tracks.iter().enumerate().try_for_each(|(index, track)| {
            let at = tracks.index(index);
            validate::name(&at.key("handle"), &track.handle)?;
            let Some(handle) = handles.iter().find(|handle| handle.id == track.handle) else {
                return at.key("handle").refuse(format_args!("there is no handle {:?}", track.handle));
            };
            if !moved.insert(&track.handle) {
                return at.key("handle").refuse(format_args!("{:?} already has a track", track.handle));
            }
            track.check(handle, self.duration, &at)
        })
    }
}

/// Checks each clip, and that names are unique.
pub(super) fn check(clips: &[Clip], handles: &[Handle]) -> Result<(), ProjectError> {
    let top = Path::Top.key("clips");
    let mut names = BTreeSet::new();
    clips.iter().enumerate().try_for_each(|(index, clip)| {
        let at = top.index(index);
        clip.check(handles, &at)?;
        if names.insert(&clip.name) {
            Ok(())
        } else {
            at.key("name").refuse(format_args!("{:?} is already the name of another clip", clip.name))
        }
    })
}

/// Checks that a number is a time in seconds within a clip.
fn check_time(at: &Path<'_>, time: f64, duration: f64) -> Result<(), ProjectError> {
    validate::finite(at, time)?;
    if (0.0..=duration).contains(&time) {
        Ok(())
    } else {
        at.refuse(format_args!("expected seconds from 0 to {duration}, found {}", DisplayNumber(time)))
    }
}
