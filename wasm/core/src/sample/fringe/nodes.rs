//! The nodes of a fringe away from the outline.

use glam::DVec2;

use super::{super::lattice::ROW_HEIGHT, CLEARANCE};
use crate::opacity::Opacity;

/// Approximate maximum number of nodes of the lattice.
const MAX_NODES: f64 = 8000.0;
/// Minimum distance of nodes from each other, in pixels.
const MIN_SPACING: f64 = 4.0;

/// Distance between nodes over an area in square pixels.
pub(in crate::sample) fn spacing(area: f64) -> f64 {
    (area / (ROW_HEIGHT * MAX_NODES)).sqrt().max(MIN_SPACING)
}

/// A triangular lattice over the visible parts of a picture. One node is at its centre.
pub(super) struct Lattice<'a> {
    opacity: &'a Opacity,
    centre: DVec2,
    pub(super) spacing: f64,
}

impl<'a> Lattice<'a> {
    /// A lattice that is symmetric if the picture is symmetric about the centre.
    pub(super) fn new(opacity: &'a Opacity, centre: DVec2, spacing: f64) -> Self {
        Self { opacity, centre, spacing }
    }

    /// The nodes within the picture, clear of its border.
    pub(super) fn inner_nodes(&self) -> impl Iterator<Item = DVec2> + '_ {
        let clearance = CLEARANCE * self.spacing;
        let rows = self.steps(1, ROW_HEIGHT, 0.0).map(|(row, y)| (if row % 2 == 0 { 0.0 } else { 0.5 }, y));
        let all = rows.flat_map(|(shift, y)| self.steps(0, 1.0, shift).map(move |(_, x)| DVec2::new(x, y)));
        let within =
            move |p: &DVec2| p.cmpge(DVec2::splat(clearance)).all() && p.cmple(self.opacity.size() - clearance).all();
        all.filter(within).filter(|&p| self.is_near(p))
    }

    /// The corners of the picture, and nodes on its border.
    pub(super) fn border_nodes(&self) -> impl Iterator<Item = DVec2> + '_ {
        let size = self.opacity.size();
        let corners = [DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
        let across = self.steps(0, 1.0, 0.0).flat_map(move |(_, x)| [0.0, size.y].map(|y| DVec2::new(x, y)));
        let down = self.steps(1, ROW_HEIGHT, 0.0).flat_map(move |(_, y)| [0.0, size.x].map(|x| DVec2::new(x, y)));
        corners.into_iter().chain(across.chain(down).filter(|&p| self.is_near(p)))
    }

    /// The coordinates along an axis, in steps of a multiple of the spacing, with the number of each step.
    fn steps(&self, axis: usize, multiple: f64, shift: f64) -> impl Iterator<Item = (i64, f64)> + use<> {
        let (centre, step) = (self.centre[axis], multiple * self.spacing);
        let first = (-centre / step - shift).ceil() as i64;
        let last = ((self.opacity.size()[axis] - centre) / step - shift).floor() as i64;
        (first..=last).map(move |k| (k, centre + (k as f64 + shift) * step))
    }

    /// Whether any pixel is visible around a node.
    fn is_near(&self, p: DVec2) -> bool {
        self.opacity.any_in(p - self.spacing, p + self.spacing)
    }
}
