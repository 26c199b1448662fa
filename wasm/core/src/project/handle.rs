//! Handles, placed on the picture by the person: H_i of the paper.

use std::collections::BTreeSet;

use glam::DVec2;
use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::{Cursor, Object};
use super::path::Path;
use super::points::{self, Point};
use super::{ProjectError, Rotation, left_out, rules};
use crate::display_number::DisplayNumber;

/// A handle, where it rests and where it was taken.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(extend("unevaluatedProperties" = false))]
#[non_exhaustive]
pub struct Handle {
    /// A name that no other handle of the project has.
    #[schemars(length(min = 1))]
    pub id: String,
    /// Point, bar or polygon, before and after.
    #[serde(flatten)]
    pub shape: Shape,
    /// The turn about the handle's own place, in degrees. The corners of a bar or polygon tell how far it is turned; the number
    /// then tells of the whole turns: each piece is turned by the angle nearest to it.
    #[schemars(default)]
    pub rotation: Rotation,
    /// The growth about the handle's own place, above 0. Of a bar or polygon the growth across its line; along it, the corners
    /// tell. In the rigid mode a point whose rotation is automatic, and a bar, grow by as much of it as what is around them allows.
    #[schemars(default = "default_scale", extend("exclusiveMinimum" = 0))]
    pub scale: f64,
    /// What lies over what where the picture covers itself: more is nearer.
    #[schemars(default)]
    pub depth: f64,
}

/// The shape of a handle before (`rest`) and after (`posed`) in image pixels, as many points in both, all finite. Point handles rest at
/// least 0.01 px from one another and from the line of any other.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Shape {
    /// One point.
    Point {
        /// Before.
        #[serde(serialize_with = "points::point")]
        #[schemars(with = "Point")]
        rest: DVec2,
        /// After; left out: as before.
        #[serde(serialize_with = "points::point")]
        #[schemars(with = "Point", default, transform = left_out)]
        posed: DVec2,
    },
    /// An open line through two or more points.
    Bar {
        /// Before.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 2))]
        rest: Vec<DVec2>,
        /// After; left out: as before.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 2), default, transform = left_out)]
        posed: Vec<DVec2>,
    },
    /// A closed ring of three or more points.
    Polygon {
        /// Before.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 3))]
        rest: Vec<DVec2>,
        /// After; left out: as before.
        #[serde(serialize_with = "points::list")]
        #[schemars(with = "Vec<Point>", length(min = 3), default, transform = left_out)]
        posed: Vec<DVec2>,
    },
}

fn default_scale() -> f64 {
    1.0
}

impl Handle {
    /// A point handle at rest, neither turned nor scaled.
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

    /// A handle that is neither turned nor scaled, at depth 0.
    pub fn new(id: impl Into<String>, shape: Shape) -> Self {
        Self { id: id.into(), shape, rotation: Rotation::default(), scale: default_scale(), depth: 0.0 }
    }

    /// The same handle with its corners posed at other places, in their order; of a point there is one.
    ///
    /// # Panics
    /// Where there are more places than corners, or fewer.
    #[must_use]
    pub fn posed_at(mut self, places: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let places: Vec<DVec2> = places.into_iter().map(Into::into).collect();
        let posed = self.shape.posed_mut();
        assert_eq!(places.len(), posed.len(), "expected one place for each corner");
        posed.copy_from_slice(&places);
        self
    }

    /// The same handle, turned: by degrees, or as suits the handles around it.
    #[must_use]
    pub fn turned(mut self, rotation: impl Into<Rotation>) -> Self {
        self.rotation = rotation.into();
        self
    }

    /// The same handle with a growth, above 0.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        self.scale = scale;
        self
    }

    /// The same handle at another depth: more is nearer.
    #[must_use]
    pub fn at_depth(mut self, depth: f64) -> Self {
        self.depth = depth;
        self
    }

    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let handle = value.object()?;
        handle.only(&["id", "kind", "rest", "posed", "rotation", "scale", "depth"])?;
        Ok(Self {
            id: handle.required("id")?.text()?.to_owned(),
            shape: Shape::read(handle)?,
            rotation: handle.or("rotation", Rotation::default(), Rotation::read)?,
            scale: handle.or("scale", default_scale(), |value| value.number())?,
            depth: handle.or("depth", 0.0, |value| value.number())?,
        })
    }

    fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        if self.id.is_empty() {
            return at.key("id").refuse("expected a name, found an empty text");
        }
        self.shape.check(at)?;
        if let Rotation::Degrees(degrees) = self.rotation {
            rules::finite(&at.key("rotation"), degrees)?;
        }
        rules::finite(&at.key("scale"), self.scale)?;
        if self.scale <= 0.0 {
            return at
                .key("scale")
                .refuse(format_args!("expected a number above 0, found {}", DisplayNumber(self.scale)));
        }
        rules::finite(&at.key("depth"), self.depth)
    }
}

/// Checks each handle, and that no two have one name.
pub(super) fn check(handles: &[Handle], at: &Path<'_>) -> Result<(), ProjectError> {
    let mut ids = BTreeSet::new();
    handles.iter().enumerate().try_for_each(|(index, handle)| {
        let at = at.index(index);
        handle.check(&at)?;
        if ids.insert(&handle.id) {
            Ok(())
        } else {
            at.key("id").refuse(format_args!("{:?} is the name of another handle", handle.id))
        }
    })
}

impl Shape {
    /// The corners before; of a point the one place.
    #[must_use]
    pub fn rest(&self) -> &[DVec2] {
        match self {
            Self::Point { rest, .. } => std::slice::from_ref(rest),
            Self::Bar { rest, .. } | Self::Polygon { rest, .. } => rest,
        }
    }

    /// The corners after.
    #[must_use]
    pub fn posed(&self) -> &[DVec2] {
        match self {
            Self::Point { posed, .. } => std::slice::from_ref(posed),
            Self::Bar { posed, .. } | Self::Polygon { posed, .. } => posed,
        }
    }

    /// The corners after, to be moved.
    pub fn posed_mut(&mut self) -> &mut [DVec2] {
        match self {
            Self::Point { posed, .. } => std::slice::from_mut(posed),
            Self::Bar { posed, .. } | Self::Polygon { posed, .. } => posed,
        }
    }

    fn read(handle: Object<'_>) -> Result<Self, ProjectError> {
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
                Ok(Self::Point { rest, posed: handle.or("posed", rest, |value| value.point())? })
            }
            Kind::Bar => {
                let (rest, posed) = lines(handle)?;
                Ok(Self::Bar { rest, posed })
            }
            Kind::Polygon => {
                let (rest, posed) = lines(handle)?;
                Ok(Self::Polygon { rest, posed })
            }
        }
    }

    fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        let (rest, posed, least) = match self {
            Self::Point { rest, posed } => {
                rules::point(&at.key("rest"), *rest)?;
                return rules::point(&at.key("posed"), *posed);
            }
            Self::Bar { rest, posed } => (rest, posed, 2),
            Self::Polygon { rest, posed } => (rest, posed, 3),
        };
        rules::points(&at.key("rest"), rest, least)?;
        rules::points(&at.key("posed"), posed, least)?;
        if posed.len() == rest.len() {
            return Ok(());
        }
        let (wanted, found) = (rest.len(), posed.len());
        at.key("posed").refuse(format_args!("expected as many points as in rest ({wanted}), found {found}"))
    }
}

/// `rest` and `posed` of a handle that is a line.
fn lines(handle: Object<'_>) -> Result<(Vec<DVec2>, Vec<DVec2>), ProjectError> {
    let rest = handle.required("rest")?.points()?;
    let posed = handle.or("posed", rest.clone(), |value| value.points())?;
    Ok((rest, posed))
}
