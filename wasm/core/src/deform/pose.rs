//! The posed position of a point: p′ = Σ w_i(p) T_i(p) (eq. 1), or the rigid blend of [`dual`](super::dual). Where a
//! brush has displaced the picture, sites take p + d(p) instead of p: p′ = Σ w_i(p) T_i(p + d(p)).
//!
//! `web/src/render/warp.vert.glsl` is the only other implementation. Cost: a few floating-point operations for each
//! site that moves the point.

use std::{ops::Add, sync::Arc};

use glam::{DMat2, DVec2};

use super::dual::{Dual, Sums, half_turn, mapped};
use crate::{
    error::Error,
    pose::{DisplacementField, Motion, Poser},
    project::{Blend, Handle, ShapeSample},
    weight::{Influence, SparseWeights},
};

/// The maps of all sites, T_i(p) = posed_i + [a c; b d] (p − rest_i), and how they are blended (eq. 1). Made by
/// [`Poser::pose`].
#[derive(Debug, Clone)]
pub struct Pose {
    rest: Arc<[DVec2]>,
    motions: Vec<Motion>,
    maps: Vec<SiteMap>,
    /// One motion per site, for the rigid blend.
    duals: Option<Vec<Dual>>,
    displacement: Option<Arc<DisplacementField>>,
}

/// T_i in the form used to map vertices, contiguous in memory.
#[derive(Debug, Clone, Copy)]
struct SiteMap {
    rest: DVec2,
    posed: DVec2,
    linear: DMat2,
}

/// The posed position of a point, and the local change of area.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Mapped {
    /// The posed position, p′.
    pub posed: DVec2,
    /// Determinant of the Jacobian: the factor by which areas grow, negative where the picture is inverted.
    pub det: f64,
}

impl Poser {
    /// The pose of handles, given in any order. Their rest positions only matter for the turns of bars and polygons.
    ///
    /// # Errors
    /// - [`Error::PoseMismatch`] if the number of handles differs from the solved one;
    /// - [`Error::PoseMissing`] if a solved handle is not among them;
    /// - [`Error::PoseShape`] for a handle of another kind or number of corners;
    /// - [`Error::Project`] for an invalid handle, such as one with a scale of 0;
    /// - [`Error::PoseNotFinite`] for numbers that overflow;
    /// - [`Error::PoserBytes`] if the poser was read from bytes whose bars contradict its handles.
    pub fn pose(&self, handles: &[Handle], blend: Blend) -> Result<Pose, Error> {
        Ok(self.pose_of(self.motions(handles)?, blend))
    }

    /// The pose of handles in the shape in which a drag has left the picture: see
    /// [`Project::shape`](crate::project::Project::shape). In the harmonic mode and for a shape without samples, same
    /// as [`pose`](Self::pose).
    ///
    /// # Errors
    /// The errors of [`pose`](Self::pose).
    pub fn pose_from(&self, shape: &[ShapeSample], handles: &[Handle], blend: Blend) -> Result<Pose, Error> {
        Ok(self.pose_of(self.motions_from(shape, handles)?, blend))
    }

    /// The shape of a pose, for [`pose_from`](Self::pose_from). In the harmonic mode, it has no samples.
    ///
    /// # Errors
    /// [`Error::PoseOfAnotherSolution`].
    pub fn shape_of(&self, pose: &Pose) -> Result<Vec<ShapeSample>, Error> {
        self.check_own(pose)?;
        Ok(self.samples_of(&pose.motions).unwrap_or_default())
    }

    /// The next frame of a drag: `handles` have moved a little since `pose`, which this poser made. Nothing moves much
    /// farther than they do. The result depends on `pose`, while [`pose`](Self::pose) depends on the handles only and
    /// may jump. In the harmonic mode, both are the same.
    ///
    /// Positions are in image pixels, rotations in degrees. `handles` are all solved handles, in any order, as for
    /// [`pose`](Self::pose). The blend is that of the frame before. Cost: some milliseconds; a step across more than a
    /// twentieth of the picture is divided.
    ///
    /// ```
    /// # use c2warp::{Picture, solve};
    /// # use c2warp::project::{Blend, Handle, Project};
    /// # let rgba = vec![255; 40 * 30 * 4];
    /// let mut handles = [Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
    /// let project = Project::for_picture(40, 30).with_handles(handles.clone());
    /// let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
    /// let poser = solution.poser();
    /// let mut pose = poser.pose(&handles, Blend::Linear)?;
    /// for frame in 1..=10 {
    ///     handles[1] = Handle::point("right", [35.0, 15.0]).posed_at([[35.0, 15.0 - f64::from(frame)]]);
    ///     pose = poser.follow(&pose, &handles)?;
    /// }
    /// assert_eq!(solution.map(&pose, [35.0, 15.0].into()).unwrap().posed, [35.0, 5.0].into());
    /// // The end of the drag.
    /// let pose = poser.settle(&pose, &handles)?;
    /// assert_eq!(solution.map(&pose, [35.0, 15.0].into()).unwrap().posed, [35.0, 5.0].into());
    /// # Ok::<(), c2warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`pose`](Self::pose), and [`Error::PoseOfAnotherSolution`].
    pub fn follow(&self, pose: &Pose, handles: &[Handle]) -> Result<Pose, Error> {
        self.check_own(pose)?;
        Ok(self.pose_of(self.followed(&pose.motions, handles)?, pose.blend()))
    }

    /// The pose in which a drag comes to rest: the nearest one at rest, or that of [`pose`](Self::pose) if it is much
    /// better. In the harmonic mode, same as [`pose`](Self::pose). See the example of [`follow`](Self::follow).
    ///
    /// `handles` are those of the last frame, in any order. Cost: 10 to 20 frames.
    ///
    /// # Errors
    /// The errors of [`follow`](Self::follow).
    pub fn settle(&self, pose: &Pose, handles: &[Handle]) -> Result<Pose, Error> {
        self.check_own(pose)?;
        Ok(self.pose_of(self.settled(&pose.motions, handles)?, pose.blend()))
    }

    /// The pose of [numbers](Pose::motion_numbers), with the same bits.
    ///
    /// # Errors
    /// [`Error::PoseOfAnotherSolution`] for another number of sites, and numbers that are not finite.
    pub fn pose_of_numbers(&self, numbers: &[f64], blend: Blend) -> Result<Pose, Error> {
        let (motions, rest) = numbers.as_chunks::<7>();
        if motions.len() != self.sites() || !rest.is_empty() || !numbers.iter().all(|number| number.is_finite()) {
            return Err(Error::PoseOfAnotherSolution);
        }
        Ok(self.pose_of(motions.iter().map(Motion::from_numbers).collect(), blend))
    }

    fn check_own(&self, pose: &Pose) -> Result<(), Error> {
        if self.has_made(pose) { Ok(()) } else { Err(Error::PoseOfAnotherSolution) }
    }

    /// The pose from the motions of all sites.
    pub(crate) fn pose_of(&self, motions: Vec<Motion>, blend: Blend) -> Pose {
        let displacement = self.displacement().cloned();
        Pose { displacement, ..Pose::new(Arc::clone(self.rest()), motions, blend) }
    }

    /// Whether a pose belongs to the sites of this poser.
    pub(crate) fn has_made(&self, pose: &Pose) -> bool {
        // The poser that made it may be another copy of the same bytes.
        Arc::ptr_eq(&pose.rest, self.rest()) || pose.rest == *self.rest()
    }
}

impl Pose {
    fn blend(&self) -> Blend {
        if self.duals.is_some() { Blend::Rigid } else { Blend::Linear }
    }

    /// A pose without a displacement.
    pub(crate) fn new(rest: Arc<[DVec2]>, motions: Vec<Motion>, blend: Blend) -> Self {
        let sites = || rest.iter().zip(&motions);
        let map = |(&rest, motion): (&DVec2, &Motion)| SiteMap {
            rest,
            posed: rest + motion.translation,
            linear: motion.linear(),
        };
        let maps = sites().map(map).collect();
        let dual = |(&rest, motion)| Dual::new(rest, motion);
        let duals = (blend == Blend::Rigid).then(|| sites().map(dual).collect());
        Self { rest, motions, maps, duals, displacement: None }
    }

    /// T_i(p) for one site: where this site alone would move a point, in pixels.
    ///
    /// # Panics
    /// If `site` is out of bounds.
    #[must_use]
    pub fn moved(&self, site: usize, p: DVec2) -> DVec2 {
        let SiteMap { rest, posed, linear } = self.maps[site];
        posed + linear * (p - rest)
    }

    /// The position of a point before the sites move it, in pixels: p + d(p) if a brush has displaced the picture.
    #[must_use]
    pub fn displaced(&self, p: DVec2) -> DVec2 {
        self.displacement.as_ref().map_or(p, |field| field.place(p))
    }

    /// Whether any part is displaced.
    pub(crate) fn displaces(&self) -> bool {
        self.displacement.is_some()
    }

    /// The posed position of a point, in pixels, from the sites that move it and their weights, for example a row of
    /// [`SparseWeights`]. A point without weights remains at its [displaced](Self::displaced) position.
    ///
    /// # Panics
    /// If a site does not exist in the solution.
    #[must_use]
    pub fn blended(&self, p: DVec2, weights: impl IntoIterator<Item = (usize, f64)>) -> DVec2 {
        self.blended_place(self.displaced(p), weights)
    }

    /// The posed position of a point with a given displaced position.
    pub(crate) fn blended_place(&self, p: DVec2, weights: impl IntoIterator<Item = (usize, f64)>) -> DVec2 {
        let weights = weights.into_iter();
        if let Some(duals) = &self.duals {
            let terms = weights.map(|(site, weight)| weight * duals[site].term(p));
            return terms.reduce(Add::add).map_or(p, |sums: Sums| sums.place(p));
        }
        weights.map(|(site, weight)| weight * self.moved(site, p)).reduce(Add::add).unwrap_or(p)
    }

    /// The posed position of a point, in pixels, and the determinant of the Jacobian there, from the influences of
    /// [`Solution::influences_at`](crate::Solution::influences_at). A point without influences remains at its
    /// [displaced](Self::displaced) position.
    ///
    /// # Panics
    /// If a site does not exist in the solution.
    #[must_use]
    pub fn map(&self, p: DVec2, influences: &[Influence]) -> Mapped {
        let (p, slopes) = match &self.displacement {
            Some(field) => field.place_with_slopes(p),
            None => (p, DMat2::IDENTITY),
        };
        if influences.is_empty() {
            return Mapped { posed: p, det: slopes.determinant() };
        }
        if let Some(duals) = &self.duals {
            let sites = influences.iter().map(|one| (&duals[one.site], one.weight, one.gradient));
            let (posed, derivative) = mapped(p, slopes, sites);
            return Mapped { posed, det: derivative.determinant() };
        }
        let (mut posed, mut derivative) = (DVec2::ZERO, DMat2::ZERO);
        for &Influence { site, weight, gradient } in influences {
            let (moved, linear) = (self.moved(site, p), self.maps[site].linear);
            posed += weight * moved;
            derivative += weight * linear * slopes;
            // Gradients sum to zero: relative to p, fewer digits are lost to cancellation.
            derivative += DMat2::from_cols((moved - p) * gradient.x, (moved - p) * gradient.y);
        }
        Mapped { posed, det: derivative.determinant() }
    }

    /// The posed positions of points, from the row of each in the weights.
    ///
    /// # Panics
    /// If a point has no row, or a site does not exist in the solution.
    pub(crate) fn blend_all(&self, points: &[DVec2], weights: &SparseWeights) -> Vec<DVec2> {
        points.iter().enumerate().map(|(row, &p)| self.blended(p, weights.row(row))).collect()
    }

    /// The posed positions of points with given displaced positions, from the row of each in the weights.
    ///
    /// # Panics
    /// Like [`blend_all`](Self::blend_all).
    pub(crate) fn blend_places(&self, places: &[DVec2], weights: &SparseWeights) -> Vec<DVec2> {
        places.iter().enumerate().map(|(row, &p)| self.blended_place(p, weights.row(row))).collect()
    }

    /// Sites × 12 for a vertex shader: a, b, c, d (the linear part takes x to (a, b) and y to (c, d)), rest x, rest
    /// y, posed x, posed y, depth, angle, cosine and sine of half the angle. Positions are in image pixels, angles in
    /// radians.
    ///
    /// Vertex v of the mesh, at rest at p, is moved by the sites and weights of its row,
    /// `sites[offsets[v]..offsets[v + 1]]` and `weights[offsets[v]..offsets[v + 1]]` of [`SparseWeights`]. Site i alone
    /// would take it to y_i = posed_i + [a c; b d] (p − rest_i). A vertex without a row does not move. The others go to
    ///
    /// ```text
    /// linear  p′ = Σ w_i y_i
    /// rigid   p′ = L + g(|P|²) · P · Σ w_i conj(h_i) (y_i − L)
    ///         with L = Σ w_i y_i, h_i = cos(θ_i/2) + i sin(θ_i/2), P = Σ w_i h_i
    ///         g(s) = 1/s for s ≥ ¼, else 4 (3 − 12 s + 16 s²)
    /// ```
    ///
    /// where products are those of complex numbers, x + iy. Texture coordinates are p / (width, height) of the picture.
    /// The depth of a triangle is the mean of its corners' Σ w_i depth_i, and
    /// [`Solution::drawn_triangles`](crate::Solution::drawn_triangles) sorts by it.
    /// [`Solution::posed_vertices`](crate::Solution::posed_vertices) returns all p′ without any of this.
    #[must_use]
    pub fn packed(&self) -> Vec<f32> {
        let sites = self.maps.iter().zip(&self.motions);
        sites
            .flat_map(|(&SiteMap { rest, posed, linear }, motion)| {
                let [a, b, c, d] = linear.to_cols_array();
                let half = half_turn(motion.angle);
                [a, b, c, d, rest.x, rest.y, posed.x, posed.y, motion.depth, motion.angle, half.x, half.y]
                    .map(|value| value as f32)
            })
            .collect()
    }

    /// The motions in full precision: sites × 7, angle; strain xx, xy, yy; translation x, y; depth. Angles are in
    /// radians, translations in image pixels. [`Poser::pose_of_numbers`] reads them.
    #[must_use]
    pub fn motion_numbers(&self) -> Vec<f64> {
        self.motions.iter().flat_map(Motion::numbers).collect()
    }

    /// The motion of each site, in the order of the sites.
    #[must_use]
    pub fn motions(&self) -> &[Motion] {
        &self.motions
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A product of complex numbers.
    fn times(a: DVec2, b: DVec2) -> DVec2 {
        a.rotate(b)
    }

    /// Where a point goes by the formulas in the documentation of [`Pose::packed`].
    fn by_formula(packed: &[f32], blend: Blend, weights: &[f64], p: DVec2) -> DVec2 {
        let number = |site: usize, k: usize| f64::from(packed[12 * site + k]);
        let pair = |site, k| DVec2::new(number(site, k), number(site, k + 1));
        let y = |site| {
            let [x_axis, y_axis, rest, posed] = [0, 2, 4, 6].map(|k| pair(site, k));
            posed + DMat2::from_cols(x_axis, y_axis) * (p - rest)
        };
        let sum = |term: &dyn Fn(usize) -> DVec2| (0..weights.len()).map(|site| weights[site] * term(site)).sum();
        let linear: DVec2 = sum(&y);
        if blend == Blend::Linear {
            return linear;
        }
        let half: DVec2 = sum(&|site| pair(site, 10));
        let s = half.length_squared();
        let g = if s >= 0.25 { 1.0 / s } else { 4.0 * (3.0 - 12.0 * s + 16.0 * s * s) };
        let conjugate = |z: DVec2| DVec2::new(z.x, -z.y);
        linear + g * times(half, sum(&|site| times(conjugate(pair(site, 10)), y(site) - linear)))
    }

    #[test]
    fn packed_numbers_follow_the_documented_formulas() {
        let rest: Arc<[DVec2]> = [(10.0, 20.0), (90.0, 30.0), (50.0, 80.0)].map(DVec2::from).into();
        let p = DVec2::new(45.0, 40.0);
        let weights = [0.5, 0.3, 0.2];
        // The last angles are so far apart that the blend is not rigid.
        for angles in [[0.3, -0.8, 1.5], [0.0, 5.5, 0.4]] {
            for blend in [Blend::Linear, Blend::Rigid] {
                let motion = |k: usize| {
                    Motion::similarity(angles[k], 1.0 + 0.2 * k as f64, DVec2::new(7.0 * k as f64, 3.0), 0.0)
                };
                let pose = Pose::new(Arc::clone(&rest), (0..3).map(motion).collect(), blend);
                let expected = pose.blended(p, weights.into_iter().enumerate());
                let found = by_formula(&pose.packed(), blend, &weights, p);
                // The numbers are rounded to 32 bits.
                assert!(found.distance(expected) < 1e-4, "{blend:?} of {angles:?}: {found}, not {expected}");
            }
        }
    }
}
