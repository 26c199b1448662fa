//! The parts of the JSON schema that cannot be derived from the types of a project.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::points::Point;
use super::rotation::Rotation;

/// Removes the default from the schema of a key. The real default depends on other keys, so the generated one is wrong.
pub(super) fn without_default(schema: &mut Schema) {
    schema.remove("default");
}

/// A posed point, or posed corners.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "a type only for the schema")]
pub(super) enum Posed {
    Point(Point),
    Corners(#[schemars(length(min = 2))] Vec<Point>),
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
