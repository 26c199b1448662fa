//! Handles as JSON.

use glam::DVec2;
use serde::{Serialize, Serializer};

use super::cursor::{Cursor, Object};
use crate::project::{Handle, ProjectError, Rotation, Shape, handle::default_scale};

impl Handle {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let handle = value.object()?;
        handle.allow_only(&["id", "kind", "rest", "posed", "rotation", "scale", "depth", "stiffness"])?;
        Ok(Self {
            id: handle.required("id")?.string()?.to_owned(),
            shape: Shape::read(handle)?,
            rotation: handle.value_or("rotation", Rotation::default(), Rotation::read)?,
            scale: handle.value_or("scale", default_scale(), |value| value.number())?,
            depth: handle.value_or("depth", 0.0, |value| value.number())?,
            stiffness: handle.value_or("stiffness", 0.0, |value| value.number())?,
        })
    }
}

impl Shape {
    pub(super) fn read(handle: Object<'_>) -> Result<Self, ProjectError> {
        #[derive(Clone, Copy)]
        enum Kind {
            Point,
            Bar,
            Polygon,
        }
        let kind = handle.required("kind")?.one_of(&[
            ("point", Kind::Point),
            ("bar", Kind::Bar),
            ("polygon", Kind::Polygon),
        ])?;
        match kind {
            Kind::Point => {
                let rest = handle.required("rest")?.point()?;
                Ok(Self::Point { rest, posed: handle.value_or("posed", rest, |value| value.point())? })
            }
            Kind::Bar => {
                let (rest, posed) = read_lines(handle)?;
                Ok(Self::Bar { rest, posed })
            }
            Kind::Polygon => {
                let (rest, posed) = read_lines(handle)?;
                Ok(Self::Polygon { rest, posed })
            }
        }
    }
}

/// Reads `rest` and `posed` of a bar or polygon.
fn read_lines(handle: Object<'_>) -> Result<(Vec<DVec2>, Vec<DVec2>), ProjectError> {
    let rest = handle.required("rest")?.points()?;
    let posed = handle.value_or("posed", rest.clone(), |value| value.points())?;
    Ok((rest, posed))
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
