//! The shape of a handle: point, bar or polygon, at rest and posed.

use glam::DVec2;
use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Object;
use super::error::ProjectError;
use super::path::Path;
use super::points::{self, Point};
use super::schema::without_default;
use super::validate;

/// The shape of a handle at rest and posed, in image pixels.
///
/// Both have the same number of points, all finite. Point handles at rest keep at least 0.01 px from one another, and
/// from bars and polygons.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Shape {
    /// One point.
    Point {
        /// The point at rest.
        #[serde(serialize_with = "points::point")]
        #[schemars(with = "Point")]
        rest: DVec2,
        /// The posed point. The default is the point at rest.
        #[serde(serialize_with = "points::point")]
        #[schemars(with = "Point", default, transform = without_default)]
        posed: DVec2,
    },
    /// An open line through two or more points.
    Bar {
        /// The corners at rest.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 2))]
        rest: Vec<DVec2>,
        /// The posed corners. The default is the corners at rest.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 2), default, transform = without_default)]
        posed: Vec<DVec2>,
    },
    /// A closed ring of three or more points.
    Polygon {
        /// The corners at rest.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 3))]
        rest: Vec<DVec2>,
        /// The posed corners. The default is the corners at rest.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 3), default, transform = without_default)]
        posed: Vec<DVec2>,
    },
}

impl Shape {
    /// The corners at rest. A point has one.
    #[must_use]
    pub fn rest(&self) -> &[DVec2] {
        match self {
            Self::Point { rest, .. } => std::slice::from_ref(rest),
            Self::Bar { rest, .. } | Self::Polygon { rest, .. } => rest,
        }
    }

    /// The posed corners. A point has one.
    #[must_use]
    pub fn posed(&self) -> &[DVec2] {
        match self {
            Self::Point { posed, .. } => std::slice::from_ref(posed),
            Self::Bar { posed, .. } | Self::Polygon { posed, .. } => posed,
        }
    }

    /// The posed corners, for changing them.
    pub fn posed_mut(&mut self) -> &mut [DVec2] {
        match self {
            Self::Point { posed, .. } => std::slice::from_mut(posed),
            Self::Bar { posed, .. } | Self::Polygon { posed, .. } => posed,
        }
    }

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

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        let (rest, posed, least) = match self {
            Self::Point { rest, posed } => {
                validate::point(&at.key("rest"), *rest)?;
                return validate::point(&at.key("posed"), *posed);
            }
            Self::Bar { rest, posed } => (rest, posed, 2),
            Self::Polygon { rest, posed } => (rest, posed, 3),
        };
        validate::points(&at.key("rest"), rest, least)?;
        validate::points(&at.key("posed"), posed, least)?;
        if posed.len() == rest.len() {
            return Ok(());
        }
        let (wanted, found) = (rest.len(), posed.len());
        at.key("posed").refuse(format_args!("expected as many points as in rest ({wanted}), found {found}"))
    }
}

/// Reads `rest` and `posed` of a bar or polygon.
fn read_lines(handle: Object<'_>) -> Result<(Vec<DVec2>, Vec<DVec2>), ProjectError> {
    let rest = handle.required("rest")?.points()?;
    let posed = handle.value_or("posed", rest.clone(), |value| value.points())?;
    Ok((rest, posed))
}
