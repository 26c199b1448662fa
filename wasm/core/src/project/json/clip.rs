//! Clips as JSON.

use glam::DVec2;
use serde::Serializer;

use super::cursor::Cursor;
use crate::project::{Clip, Ease, Key, Looping, ProjectError, Rotation, Track, points};

impl Clip {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let clip = value.object()?;
        clip.allow_only(&["name", "duration", "loop", "tracks"])?;
        Ok(Self {
            name: clip.required("name")?.string()?.to_owned(),
            duration: clip.required("duration")?.number()?,
            looping: clip.value_or("loop", Looping::default(), Looping::read)?,
            tracks: clip.required("tracks")?.list("a list of tracks", Track::read)?,
        })
    }
}

impl Track {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let track = value.object()?;
        track.allow_only(&["handle", "keys"])?;
        Ok(Self {
            handle: track.required("handle")?.string()?.to_owned(),
            keys: track.required("keys")?.list("a list of keys", Key::read)?,
        })
    }
}

impl Key {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let key = value.object()?;
        key.allow_only(&["time", "posed", "rotation", "scale", "depth", "ease"])?;
        Ok(Self {
            time: key.required("time")?.number()?,
            posed: key.optional("posed").map(read_posed).transpose()?,
            rotation: key.optional("rotation").map(Rotation::read).transpose()?,
            scale: key.optional("scale").map(|value| value.number()).transpose()?,
            depth: key.optional("depth").map(|value| value.number()).transpose()?,
            ease: key.value_or("ease", Ease::default(), Ease::read)?,
        })
    }
}

impl Ease {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("smooth", Self::Smooth), ("linear", Self::Linear), ("hold", Self::Hold)])
    }
}

impl Looping {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        value.one_of(&[("repeat", Self::Repeat), ("alternate", Self::Alternate), ("none", Self::None)])
    }
}

/// Reads a point, or a list of points.
fn read_posed(value: Cursor<'_>) -> Result<Vec<DVec2>, ProjectError> {
    if value.is_list_of_lists() { value.points() } else { Ok(vec![value.point()?]) }
}

/// Writes a point, or a list of points.
pub(in crate::project) fn posed<S: Serializer>(posed: &Option<Vec<DVec2>>, serializer: S) -> Result<S::Ok, S::Error> {
    match posed.as_deref() {
        Some([point]) => points::point(point, serializer),
        corners => points::list(corners.unwrap_or_default(), serializer),
    }
}
