//! The picture of a project: its file and its size.

use std::ops::RangeInclusive;

use super::error::ProjectError;
use super::path::Path;
use super::validate;

/// The solver accepts fewer sizes, but a project can be read without its picture.
pub(super) const SIDES: RangeInclusive<u32> = 1..=u32::MAX;

/// The file of the picture, and the size in pixels that the project's coordinates refer to.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct ImageRef {
    /// File name of the picture, relative to the project file. It may be empty.
    pub src: String,
    /// Width in pixels, at least 1. The solver accepts 2 to 16,384.
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub width: u32,
    /// Height in pixels, at least 1. The solver accepts 2 to 16,384.
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub height: u32,
}

impl ImageRef {
    /// A picture by its file name and its size in pixels.
    #[must_use]
    pub fn new(src: impl Into<String>, width: u32, height: u32) -> Self {
        Self { src: src.into(), width, height }
    }

    /// Width and height, in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        validate::whole_number(&at.key("width"), self.width, &SIDES)?;
        validate::whole_number(&at.key("height"), self.height, &SIDES)
    }
}
