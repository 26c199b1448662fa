//! Handles on the picture: H_i of the paper.

use std::collections::BTreeSet;

use glam::DVec2;

use super::error::ProjectError;
use super::path::Path;
use super::rotation::Rotation;
use super::shape::Shape;
use super::validate;
use crate::display_number::DisplayNumber;
#[cfg(feature = "schema")]
use crate::limits::MAX_NAME;

/// A handle at rest and posed.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(extend("unevaluatedProperties" = false)))]
#[non_exhaustive]
pub struct Handle {
    /// A name of 1 to 200 characters, unique in the project.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = MAX_NAME)))]
    pub id: String,
    /// Point, bar or polygon, at rest and posed.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub shape: Shape,
    /// Rotation about the handle itself, in degrees. The corners of a bar or polygon define its rotation up to whole
    /// turns: each piece takes the angle closest to this number.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub rotation: Rotation,
    /// Scale about the handle itself, above 0. A bar or polygon has this scale across its line, and its corners
    /// define the scale along it. In rigid mode, bars and points with automatic rotation take as much of it as their
    /// surroundings allow.
    #[cfg_attr(feature = "schema", schemars(default = "default_scale", extend("exclusiveMinimum" = 0)))]
    pub scale: f64,
    /// Drawing order where the picture overlaps itself: greater depths are in front.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub depth: f64,
    /// Stiffness of the picture inside a polygon, from 0 to 1: distortion counts more where it is stiff. Other kinds
    /// have no stiffness. It only affects rigid mode.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "super::json::is_default"))]
    #[cfg_attr(feature = "schema", schemars(default, range(min = 0, max = 1)))]
    pub stiffness: f64,
}

pub(super) fn default_scale() -> f64 {
    1.0
}

impl Handle {
    /// A point handle at rest, without rotation or scale.
    ///
    /// ```
    /// use c2warp::project::{Handle, Rotation, Shape};
    ///
    /// let hand = Handle::point("hand", [120.0, 80.0]).posed_at([[140.0, 60.0]]).turned(30.0);
    /// assert_eq!(hand.shape, Shape::Point { rest: [120.0, 80.0].into(), posed: [140.0, 60.0].into() });
    /// let arm = Handle::bar("arm", [[60.0, 90.0], [110.0, 85.0]]).turned(Rotation::Auto).at_depth(1.0);
    /// assert_eq!((arm.rotation, arm.scale, arm.depth), (Rotation::Auto, 1.0, 1.0));
    /// ```
    pub fn point(id: impl Into<String>, rest: impl Into<DVec2>) -> Self {
        let rest = rest.into();
        Self::new(id, Shape::Point { rest, posed: rest })
    }

    /// A bar at rest through two or more corners.
    pub fn bar(id: impl Into<String>, rest: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let rest: Vec<DVec2> = rest.into_iter().map(Into::into).collect();
        Self::new(id, Shape::Bar { posed: rest.clone(), rest })
    }

    /// A polygon at rest through three or more corners.
    pub fn polygon(id: impl Into<String>, rest: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let rest: Vec<DVec2> = rest.into_iter().map(Into::into).collect();
        Self::new(id, Shape::Polygon { posed: rest.clone(), rest })
    }

    /// A handle without rotation or scale, at depth 0.
    pub fn new(id: impl Into<String>, shape: Shape) -> Self {
        Self { id: id.into(), shape, rotation: Rotation::default(), scale: default_scale(), depth: 0.0, stiffness: 0.0 }
    }

    /// The same handle with other posed corners, in the order of the corners at rest.
    ///
    /// # Panics
    /// If the number of points differs from the number of corners. A point handle has one point.
    #[must_use]
    pub fn posed_at(mut self, points: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let points: Vec<DVec2> = points.into_iter().map(Into::into).collect();
        let posed = self.shape.posed_mut();
        assert_eq!(points.len(), posed.len(), "expected one point for each corner");
        posed.copy_from_slice(&points);
        self
    }

    /// The same handle with a rotation: a number of degrees, or [`Rotation::Auto`].
    #[must_use]
    pub fn turned(mut self, rotation: impl Into<Rotation>) -> Self {
        self.rotation = rotation.into();
        self
    }

    /// The same handle with a scale, above 0.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        self.scale = scale;
        self
    }

    /// The same handle at another depth. Greater depths are in front.
    #[must_use]
    pub fn at_depth(mut self, depth: f64) -> Self {
        self.depth = depth;
        self
    }

    /// The same polygon with a stiffness of its inside, from 0 to 1.
    #[must_use]
    pub fn stiffened(mut self, stiffness: f64) -> Self {
        self.stiffness = stiffness;
        self
    }

    fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        validate::name(&at.key("id"), &self.id)?;
        self.shape.check(at)?;
        if let Rotation::Degrees(degrees) = self.rotation {
            validate::finite(&at.key("rotation"), degrees)?;
        }
        validate::finite(&at.key("scale"), self.scale)?;
        if self.scale <= 0.0 {
            return at
                .key("scale")
                .refuse(format_args!("expected a number above 0, found {}", DisplayNumber(self.scale)));
        }
        validate::finite(&at.key("depth"), self.depth)?;
        self.check_stiffness(&at.key("stiffness"))
    }

    fn check_stiffness(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        // NaN is in no range.
        if !(0.0..=1.0).contains(&self.stiffness) {
            return at.refuse(format_args!("expected a number from 0 to 1, found {}", DisplayNumber(self.stiffness)));
        }
        let kind = match self.shape {
            Shape::Polygon { .. } => return Ok(()),
            _ if self.stiffness == 0.0 => return Ok(()),
            Shape::Point { .. } => "point",
            Shape::Bar { .. } => "bar",
        };
        at.refuse(format_args!("only a polygon can be stiff, but {:?} is a {kind}", self.id))
    }
}

/// Checks each handle, and that ids are unique.
pub(super) fn check(handles: &[Handle], at: &Path<'_>) -> Result<(), ProjectError> {
    let mut ids = BTreeSet::new();
    handles.iter().enumerate().try_for_each(|(index, handle)| {
        let at = at.index(index);
        handle.check(&at)?;
        if ids.insert(&handle.id) {
            Ok(())
        } else {
            at.key("id").refuse(format_args!("{:?} is already the id of another handle", handle.id))
        }
    })
}
