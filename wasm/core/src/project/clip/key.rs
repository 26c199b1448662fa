//! The pose of a handle at one time.

use glam::DVec2;

use super::super::error::ProjectError;
use super::super::handle::Handle;
use super::super::path::Path;
use super::super::rotation::Rotation;
use super::super::shape::Shape;
use super::super::validate;
use super::Ease;
use crate::display_number::DisplayNumber;

/// The pose of a handle at one time. Values that are left out are interpolated past this key.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Key {
    /// Seconds from the beginning of the clip, up to its duration.
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub time: f64,
    /// The posed corners: one point for a point handle, all corners of a bar or polygon.
    #[cfg_attr(
        feature = "serde",
        serde(skip_serializing_if = "Option::is_none", serialize_with = "super::super::json::posed")
    )]
    #[cfg_attr(feature = "schema", schemars(default, with = "super::super::schema::Posed"))]
    pub posed: Option<Vec<DVec2>>,
    /// The rotation.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(default, with = "Rotation"))]
    pub rotation: Option<Rotation>,
    /// The scale, above 0.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(default, with = "f64", extend("exclusiveMinimum" = 0)))]
    pub scale: Option<f64>,
    /// The depth. A whole number holds until another key.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(feature = "schema", schemars(default, with = "f64"))]
    pub depth: Option<f64>,
    /// How values change to the next key.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub ease: Ease,
}

impl Key {
    /// A key without values.
    #[must_use]
    pub fn new(time: f64, ease: Ease) -> Self {
        Self { time, ease, ..Self::default() }
    }

    /// The same key with posed corners, in the order of the corners at rest.
    #[must_use]
    pub fn posed_at(mut self, points: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        self.posed = Some(points.into_iter().map(Into::into).collect());
        self
    }

    /// The same key with a rotation.
    #[must_use]
    pub fn turned(mut self, rotation: impl Into<Rotation>) -> Self {
        self.rotation = Some(rotation.into());
        self
    }

    /// The same key with a scale, above 0.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        self.scale = Some(scale);
        self
    }

    /// The same key with a depth.
    #[must_use]
    pub fn at_depth(mut self, depth: f64) -> Self {
        self.depth = Some(depth);
        self
    }

    /// Checks the values for a handle. The track checks the time.
    pub(super) fn check(&self, handle: &Handle, at: &Path<'_>) -> Result<(), ProjectError> {
        if let Some(posed) = &self.posed {
            let (wanted, found) = (handle.shape.rest().len(), posed.len());
            let at = at.key("posed");
            match &handle.shape {
                Shape::Point { .. } if found == 1 => validate::point(&at, posed[0])?,
                Shape::Point { .. } => return at.refuse(format_args!("expected a point [x, y], found {found} points")),
                _ if found != wanted => {
                    return at.refuse(format_args!("expected as many points as in rest ({wanted}), found {found}"));
                }
                _ => validate::points(&at, posed, wanted)?,
            }
        }
        if let Some(Rotation::Degrees(degrees)) = self.rotation {
            validate::finite(&at.key("rotation"), degrees)?;
        }
        if let Some(scale) = self.scale {
            validate::finite(&at.key("scale"), scale)?;
            if scale <= 0.0 {
                let found = DisplayNumber(scale);
                return at.key("scale").refuse(format_args!("expected a number above 0, found {found}"));
            }
        }
        self.depth.map_or(Ok(()), |depth| validate::finite(&at.key("depth"), depth))
    }
}
