//! The picture that a project was made for.

use schemars::JsonSchema;
use serde::Serialize;

use super::ProjectError;
use super::place::Place;

/// Where the picture is found, and the size that the project's coordinates mean.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ImageRef {
    /// The picture's file name, beside the project file; may be empty for a picture that has none.
    pub src: String,
    /// Width in pixels.
    #[schemars(range(min = 1))]
    pub width: u32,
    /// Height in pixels.
    #[schemars(range(min = 1))]
    pub height: u32,
}

impl ImageRef {
    pub(super) fn read(place: Place<'_>) -> Result<Self, ProjectError> {
        let image = place.object()?;
        image.only(&["src", "width", "height"])?;
        Ok(Self {
            src: image.required("src")?.text()?.to_owned(),
            width: image.required("width")?.whole_number(1..=u32::MAX)?,
            height: image.required("height")?.whole_number(1..=u32::MAX)?,
        })
    }
}
