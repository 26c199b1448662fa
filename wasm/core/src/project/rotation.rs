//! The rotation of a handle.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};

use super::cursor::Cursor;
use super::error::ProjectError;

/// The rotation of a handle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rotation {
    /// Degrees, clockwise on the screen, as y points down.
    Degrees(f64),
    /// Automatic: fitted to the surrounding handles.
    Auto,
}

impl Default for Rotation {
    fn default() -> Self {
        Self::Degrees(0.0)
    }
}

impl From<f64> for Rotation {
    fn from(degrees: f64) -> Self {
        Self::Degrees(degrees)
    }
}

impl Rotation {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        if value.string().is_ok_and(|text| text == "auto") {
            return Ok(Self::Auto);
        }
        match value.number() {
            Ok(degrees) => Ok(Self::Degrees(degrees)),
            Err(_) => value.expected("a number of degrees or \"auto\""),
        }
    }
}

impl Serialize for Rotation {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Degrees(degrees) => serializer.serialize_f64(*degrees),
            Self::Auto => serializer.serialize_str("auto"),
        }
    }
}

impl JsonSchema for Rotation {
    fn schema_name() -> Cow<'static, str> {
        "Rotation".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Degrees, clockwise on the screen, or automatic: fitted to the surrounding handles.",
            "anyOf": [{ "type": "number" }, { "const": "auto" }]
        })
    }
}
