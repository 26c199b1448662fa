//! The weight of distortion at each point of the picture at rest, in the energy of the rigid mode.
//!
//! A point of stiffness s, from 0 to 1, has the factor Mˢ, where M is [`MOST`]. It grows exponentially with s: a half
//! has the geometric mean of soft and stiff. The stiffness is the maximum of the mask, which is bilinear between the
//! centres of its cells, and of all polygons. A polygon has its stiffness inside, by the even-odd rule, and loses it
//! within a [`RIM`] around it.
//!
//! Cost: for each point, the corners of all stiff polygons.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec2;

use super::quadrature::Node;
use crate::{
    domain::{contains, edges},
    project::{Handle, Project, Shape, Stiffness, bilinear},
    segment::segment_distance,
};

/// The factor of a stiff point. A stiff disc in a bend then has less than a hundredth of its energy. With five times as
/// much, it has even less, but the picture around it bends and folds more.
const MOST: f64 = 300.0;
/// A part has the greatest stiffness of its centroid and of points at this distance from it, as a fraction of its
/// width. With 0, a disc of a twentieth of the picture keeps up to 6 % of its energy: it is hardly wider than a part.
const REACH: f64 = 0.5;
/// The eight directions are exactly symmetric.
const DIRECTIONS: [DVec2; 8] = [
    DVec2::X,
    DVec2::Y,
    DVec2::NEG_X,
    DVec2::NEG_Y,
    DVec2::new(FRAC_1_SQRT_2, FRAC_1_SQRT_2),
    DVec2::new(-FRAC_1_SQRT_2, FRAC_1_SQRT_2),
    DVec2::new(FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
    DVec2::new(-FRAC_1_SQRT_2, -FRAC_1_SQRT_2),
];
/// Width of the rim in which the stiffness of a polygon is lost, as a fraction of the diagonal of its box.
const RIM: f64 = 0.125;

/// The stiffness of a picture.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct StiffnessField {
    mask: Option<StiffnessMask>,
    polygons: Vec<StiffPolygon>,
}

/// A mask over a picture of a given size in pixels.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct StiffnessMask {
    pub(crate) size: DVec2,
    pub(crate) columns: u32,
    pub(crate) rows: u32,
    pub(crate) values: Vec<u8>,
}

#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
struct StiffPolygon {
    stiffness: f64,
    corners: Vec<DVec2>,
    /// Width of the rim, in pixels.
    rim: f64,
}

impl StiffnessField {
    pub(crate) fn new(project: &Project) -> Self {
        let (width, height) = project.image.size();
        let mask = |&Stiffness { width: columns, height: rows, ref values }: &Stiffness| StiffnessMask {
            size: DVec2::new(width.into(), height.into()),
            columns,
            rows,
            values: values.clone(),
        };
        let is_stiff = |mask: &&Stiffness| mask.values.iter().any(|&value| value > 0);
        Self::of(project.stiffness.as_ref().filter(is_stiff).map(mask), &project.handles)
    }

    /// The stiffness of a mask and of polygons.
    pub(crate) fn of(mask: Option<StiffnessMask>, handles: &[Handle]) -> Self {
        let polygons = handles.iter().filter_map(|handle| match &handle.shape {
            Shape::Polygon { rest, .. } if handle.stiffness > 0.0 => {
                Some(StiffPolygon::new(rest.clone(), handle.stiffness))
            }
            _ => None,
        });
        Self { mask, polygons: polygons.collect() }
    }

    /// The mask; `None` if it is soft everywhere.
    pub(crate) fn mask(&self) -> Option<&StiffnessMask> {
        self.mask.as_ref()
    }

    /// Whether data read from bytes is consistent.
    pub(super) fn is_whole(&self) -> bool {
        let is_stiffness = |value: f64| (0.0..=1.0).contains(&value);
        self.mask.as_ref().is_none_or(|mask| {
            mask.size.is_finite()
                && mask.size.min_element() > 0.0
                && mask.columns.min(mask.rows) > 0
                && mask.values.len() as u64 == u64::from(mask.columns) * u64::from(mask.rows)
        }) && self.polygons.iter().all(|polygon| {
            is_stiffness(polygon.stiffness) && polygon.rim >= 0.0 && polygon.corners.iter().all(|p| p.is_finite())
        })
    }

    /// The stiffness at a point, from 0 to 1.
    pub(crate) fn at(&self, at: DVec2) -> f64 {
        let mask = self.mask.as_ref().map_or(0.0, |mask| mask.at(at));
        self.polygons.iter().map(|polygon| polygon.at(at)).fold(mask, f64::max)
    }

    /// Whether nothing is stiff.
    pub(crate) fn is_soft(&self) -> bool {
        self.mask.is_none() && self.polygons.is_empty()
    }

    /// The factors at nodes, divided by their harmonic mean. So they are 1 if the picture is equally stiff everywhere.
    pub(super) fn factors(&self, nodes: &[Node]) -> Vec<f64> {
        if self.is_soft() {
            return vec![1.0; nodes.len()];
        }
        let factors: Vec<f64> = nodes.iter().map(|node| self.factor(node.at, node.area.sqrt())).collect();
        let area: f64 = nodes.iter().map(|node| node.area).sum();
        let mean = area / nodes.iter().zip(&factors).map(|(node, factor)| node.area / factor).sum::<f64>();
        factors.into_iter().map(|factor| factor / mean).collect()
    }

    /// The factor of a part of the picture around a point: that of its stiffest point. 1 if nothing is stiff.
    fn factor(&self, at: DVec2, width: f64) -> f64 {
        let around = DIRECTIONS.map(|direction| self.at(at + REACH * width * direction));
        let stiffness = around.into_iter().fold(self.at(at), f64::max);
        libm::exp(stiffness * libm::log(MOST))
    }
}

impl StiffnessMask {
    fn at(&self, at: DVec2) -> f64 {
        bilinear([self.columns, self.rows], &self.values, at / self.size)
    }
}

impl StiffPolygon {
    fn new(corners: Vec<DVec2>, stiffness: f64) -> Self {
        let corner = |pick: fn(DVec2, DVec2) -> DVec2| corners.iter().copied().reduce(pick).unwrap_or_default();
        let rim = RIM * corner(DVec2::min).distance(corner(DVec2::max));
        Self { stiffness, corners, rim }
    }

    fn at(&self, at: DVec2) -> f64 {
        if contains(&self.corners, at) {
            return self.stiffness;
        }
        let distance = edges(&self.corners).map(|(a, b)| segment_distance(at, a, b)).fold(f64::INFINITY, f64::min);
        // Smoothstep, from 1 on the polygon to 0 at the end of the rim.
        let left = (1.0 - distance / self.rim).max(0.0);
        self.stiffness * left * left * (3.0 - 2.0 * left)
    }
}
