//! Points as the file writes them: `[x, y]`.

use glam::DVec2;
use serde::{Serialize, Serializer};

/// A point `[x, y]` in image pixels, with pixel centres at +0.5 and y down.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Point(f64, f64);

impl From<&DVec2> for Point {
    fn from(point: &DVec2) -> Self {
        Self(point.x, point.y)
    }
}

pub(super) fn point<S: Serializer>(point: &DVec2, serializer: S) -> Result<S::Ok, S::Error> {
    Point::from(point).serialize(serializer)
}

pub(super) fn list<S: Serializer>(points: &[DVec2], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(points.iter().map(Point::from))
}

pub(super) fn rings<S: Serializer>(rings: &[Vec<DVec2>], serializer: S) -> Result<S::Ok, S::Error> {
    let ring = |ring: &Vec<DVec2>| ring.iter().map(Point::from).collect::<Vec<_>>();
    serializer.collect_seq(rings.iter().map(ring))
}
