//! Where points go: linearly, p′ = Σ w_i(p) T_i(p) (paper, eq. 1), or by the rigid blend of [`dual`](super::dual).

use std::sync::Arc;

use glam::{DMat2, DVec2};

use super::{
    Motion,
    dual::{Dual, Sums, half_turn, mapped},
};
use crate::{project::Blend, weight::Influence};

/// Where every site is taken: T_i(p) = posed_i + [a c; b d] (p − rest_i).
#[derive(Debug, Clone)]
pub struct Pose {
    rest: Arc<[DVec2]>,
    linear: Vec<DMat2>,
    motions: Vec<Motion>,
    /// By site, for the rigid blend.
    duals: Option<Vec<Dual>>,
}

/// Where a point goes, and what happens around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mapped {
    /// The posed place, p′.
    pub posed: DVec2,
    /// Determinant of the map's derivative: the area's growth, negative where the picture has turned over.
    pub det: f64,
}

impl Pose {
    pub(crate) fn new(rest: Arc<[DVec2]>, motions: Vec<Motion>, blend: Blend) -> Self {
        let linear = motions.iter().map(Motion::linear).collect();
        let dual = |(&rest, motion)| Dual::new(rest, motion);
        let duals = (blend == Blend::Rigid).then(|| rest.iter().zip(&motions).map(dual).collect());
        Self { rest, linear, motions, duals }
    }

    /// Where the sites rest.
    pub(super) fn rest(&self) -> &Arc<[DVec2]> {
        &self.rest
    }

    /// T_i(p) for one site.
    ///
    /// # Panics
    /// For a site that the solution has not.
    #[must_use]
    pub fn moved(&self, site: usize, p: DVec2) -> DVec2 {
        let rest = self.rest[site];
        rest + self.motions[site].translation + self.linear[site] * (p - rest)
    }

    /// Where a point goes, from weights alone. With no weights it stays.
    ///
    /// # Panics
    /// For a site that the solution has not.
    #[must_use]
    pub fn blended(&self, p: DVec2, weights: impl Iterator<Item = (usize, f64)>) -> DVec2 {
        if let Some(duals) = &self.duals {
            let sums = weights.fold(None, |sums: Option<Sums>, (site, weight)| {
                Some(sums.unwrap_or_default() + weight * duals[site].term(p))
            });
            return sums.map_or(p, |sums| sums.place(p));
        }
        let sum = weights.fold(None, |sum: Option<DVec2>, (site, weight)| {
            Some(sum.unwrap_or(DVec2::ZERO) + weight * self.moved(site, p))
        });
        sum.unwrap_or(p)
    }

    /// Where a point goes, and the derivative of that. With no influence the point stays.
    ///
    /// # Panics
    /// For a site that the solution has not.
    #[must_use]
    pub fn map(&self, p: DVec2, influences: &[Influence]) -> Mapped {
        if influences.is_empty() {
            return Mapped { posed: p, det: 1.0 };
        }
        if let Some(duals) = &self.duals {
            let sites = influences.iter().map(|one| (&duals[one.site], one.weight, one.gradient));
            let (posed, derivative) = mapped(p, sites);
            return Mapped { posed, det: derivative.determinant() };
        }
        let (mut posed, mut derivative) = (DVec2::ZERO, DMat2::ZERO);
        for &Influence { site, weight, gradient } in influences {
            let (moved, linear) = (self.moved(site, p), self.linear[site]);
            posed += weight * moved;
            derivative += weight * linear;
            // Gradients sum to zero: relative to p, fewer digits cancel.
            derivative += DMat2::from_cols((moved - p) * gradient.x, (moved - p) * gradient.y);
        }
        Mapped { posed, det: derivative.determinant() }
    }

    /// Sites × 12 for the vertex shader: a, b, c, d (the linear part takes x to (a, b) and y to (c, d)), rest x, rest y, posed x,
    /// posed y, depth, angle, cosine and sine of half the angle.
    #[must_use]
    pub fn packed(&self) -> Vec<f32> {
        let sites = self.rest.iter().zip(&self.linear).zip(&self.motions);
        sites
            .flat_map(|((&rest, linear), motion)| {
                let ([a, b, c, d], posed) = (linear.to_cols_array(), rest + motion.translation);
                let half = half_turn(motion.angle);
                [a, b, c, d, rest.x, rest.y, posed.x, posed.y, motion.depth, motion.angle, half.x, half.y]
                    .map(|value| value as f32)
            })
            .collect()
    }

    /// The motion of each site.
    #[must_use]
    pub fn motions(&self) -> &[Motion] {
        &self.motions
    }
}
