//! The picture that a project was made for.

use std::ops::RangeInclusive;

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::path::Path;
use super::{ProjectError, rules};

/// What the solver can warp is less; a project may be read without its picture.
const SIDES: RangeInclusive<u32> = 1..=u32::MAX;

/// Where the picture is found, and the size that the project's coordinates mean.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct ImageRef {
    /// The picture's file name, beside the project file; may be empty for a picture that has none.
    pub src: String,
    /// Width in pixels, 1 or more; the solver takes 2 to 16,384.
    #[schemars(range(min = 1))]
    pub width: u32,
    /// Height in pixels, likewise.
    #[schemars(range(min = 1))]
    pub height: u32,
}

impl ImageRef {
    /// The picture in a file of this name, with its size in pixels.
    #[must_use]
    pub fn new(src: impl Into<String>, width: u32, height: u32) -> Self {
        Self { src: src.into(), width, height }
    }

    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let image = value.object()?;
        image.only(&["src", "width", "height"])?;
        Ok(Self {
            src: image.required("src")?.text()?.to_owned(),
            width: image.required("width")?.whole_number(&SIDES)?,
            height: image.required("height")?.whole_number(&SIDES)?,
        })
    }

    /// Width and height.
    pub(crate) fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        rules::whole_number(&at.key("width"), self.width, &SIDES)?;
        rules::whole_number(&at.key("height"), self.height, &SIDES)
    }
}
