//! The shape of a handle: point, bar or polygon, at rest and posed.

use glam::DVec2;

use super::error::ProjectError;
use super::path::Path;
use super::validate;

/// The shape of a handle at rest and posed, in image pixels.
///
/// Both have the same number of points, all finite. Point handles at rest keep at least 0.01 px from one another, and
/// from bars and polygons.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "lowercase"))]
pub enum Shape {
    /// One point.
    Point {
        /// The point at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::point"))]
        #[cfg_attr(feature = "schema", schemars(with = "super::points::Point"))]
        rest: DVec2,
        /// The posed point. The default is the point at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::point"))]
        #[cfg_attr(feature = "schema", schemars(with = "super::points::Point", default, transform = super::schema::without_default))]
        posed: DVec2,
    },
    /// An open line through two or more points.
    Bar {
        /// The corners at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::points::Point>", length(min = 2)))]
        rest: Vec<DVec2>,
        /// The posed corners. The default is the corners at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::points::Point>", length(min = 2), default, transform = super::schema::without_default))]
        posed: Vec<DVec2>,
    },
    /// A closed ring of three or more points.
    Polygon {
        /// The corners at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::points::Point>", length(min = 3)))]
        rest: Vec<DVec2>,
        /// The posed corners. The default is the corners at rest.
        #[cfg_attr(feature = "serde", serde(serialize_with = "super::points::list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::points::Point>", length(min = 3), default, transform = super::schema::without_default))]
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

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        let (rest, posed, least) = match self {
            Self::Point { rest, posed } => {
                validate::point(&at.key("rest"), *rest)?;
                return validate::point(&at.key("posed"), *posed);
            }
            Self::Bar { rest, posed } => (rest, posed, 2),
            Self::Polygon { rest, posed } => (rest, posed, 3),
        };
        validate::corners(&at.key("rest"), rest, least)?;
        validate::points(&at.key("posed"), posed, least)?;
        if posed.len() == rest.len() {
            return Ok(());
        }
        let (wanted, found) = (rest.len(), posed.len());
        at.key("posed").refuse(format_args!("expected as many points as in rest ({wanted}), found {found}"))
    }
}
