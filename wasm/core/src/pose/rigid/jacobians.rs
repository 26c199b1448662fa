//! The Jacobians of several nodes side by side, for SIMD.

use std::ops::{Add, Mul};

use glam::DMat2;
use wide::f64x4;

/// Jacobians of [`Jacobians::LANES`] nodes, by their columns.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Jacobians {
    x: [f64x4; 2],
    y: [f64x4; 2],
}

impl Jacobians {
    pub(crate) const LANES: usize = 4;

    #[inline]
    pub(crate) fn new(all: [DMat2; Self::LANES]) -> Self {
        let lanes = |entry: fn(&DMat2) -> f64| f64x4::new(all.each_ref().map(entry));
        Self {
            x: [lanes(|j| j.x_axis.x), lanes(|j| j.x_axis.y)], //
            y: [lanes(|j| j.y_axis.x), lanes(|j| j.y_axis.y)],
        }
    }

    #[inline]
    pub(crate) fn to_array(self) -> [DMat2; Self::LANES] {
        let [[xx, xy], [yx, yy]] = [self.x, self.y].map(|column| column.map(f64x4::to_array));
        std::array::from_fn(|lane| DMat2::from_cols_array(&[xx[lane], xy[lane], yx[lane], yy[lane]]))
    }

    /// |J|².
    #[inline]
    pub(crate) fn square(&self) -> f64x4 {
        self.dot(self)
    }

    /// Σ of the products of entries.
    #[inline]
    pub(crate) fn dot(&self, other: &Self) -> f64x4 {
        dot(self.x, other.x) + dot(self.y, other.y)
    }

    #[inline]
    pub(crate) fn det(&self) -> f64x4 {
        cross(self.x, self.y)
    }

    /// Derivative of det J along another matrix.
    #[inline]
    pub(crate) fn det_along(&self, along: &Self) -> f64x4 {
        cross(self.x, along.y) + cross(along.x, self.y)
    }

    /// The gradient of det J.
    #[inline]
    pub(crate) fn cofactors(&self) -> Self {
        let ([xx, xy], [yx, yy]) = (self.x, self.y);
        Self { x: [yy, -yx], y: [-xy, xx] }
    }
}

impl Add for Jacobians {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let sum = |[a, b]: [f64x4; 2], [c, d]: [f64x4; 2]| [a + c, b + d];
        Self { x: sum(self.x, other.x), y: sum(self.y, other.y) }
    }
}

impl Mul<Jacobians> for f64x4 {
    type Output = Jacobians;

    #[inline]
    fn mul(self, Jacobians { x, y }: Jacobians) -> Jacobians {
        Jacobians { x: x.map(|entry| self * entry), y: y.map(|entry| self * entry) }
    }
}

fn dot([a, b]: [f64x4; 2], [c, d]: [f64x4; 2]) -> f64x4 {
    a * c + b * d
}

fn cross([a, b]: [f64x4; 2], [c, d]: [f64x4; 2]) -> f64x4 {
    a * d - b * c
}
