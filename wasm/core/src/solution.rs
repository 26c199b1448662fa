//! A solved project: the mesh, its weights, and the weight functions themselves.

use std::{borrow::Cow, sync::Arc};

use glam::DVec2;

use crate::{
    bone::Outside,
    distance::Propagation,
    domain::{Domain, Ring},
    drawing_order::drawn_triangles,
    error::Error,
    inverse,
    outline::Outline,
    picture::Picture,
    pose::{HarmonicFields, Mapped, Pose, Poser},
    raster::{self, Canvas, Warped},
    render_mesh::RenderMesh,
    report::{Fingerprint, Report},
    request::check_picture,
    site::{Site, SiteGraph},
    weight::{Influence, SparseWeights, WeightFunctions},
};

/// The result of a solve. It does not depend on where the handles are posed: its [`poser`](Self::poser) makes the poses that it takes,
/// and no other does.
#[derive(Debug)]
pub struct Solution {
    /// What is drawn.
    pub mesh: RenderMesh,
    /// The weights of the mesh's vertices.
    pub weights: SparseWeights,
    /// Point handles and the first sites of bars and of a held boundary from top to bottom, then others as they were inserted.
    pub sites: Vec<Site>,
    /// The cell graph.
    pub graph: SiteGraph,
    /// ϖ, by site.
    pub harmonic: HarmonicFields,
    /// Number of samples: the first vertices of the mesh; the others are the rim's.
    pub samples: usize,
    /// The nearest site of each sample, `u32::MAX` on an island without sites. Where the support of the nearest site ends before the
    /// sample, as it may in a nook, it can be another one that moves the sample.
    pub nearest: Vec<u32>,
    /// Σφ at each sample.
    pub phi_sums: Vec<f64>,
    /// The score δ / r_d of the worst cell before each round of Algorithm 1 (figure 3, right), with δ = r_d −
    /// `Site::reach_limit` in place of r_d − r_h.
    pub scores: Vec<f64>,
    /// Numbers of point handles, bars and polygons.
    pub(crate) kinds: [usize; 3],
    pub(crate) outside: Vec<Outside>,
    pub(crate) poser: Poser,
    pub(crate) functions: WeightFunctions,
    pub(crate) outline: Arc<Outline>,
}

impl Solution {
    /// The domain that was solved.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.outline.domain
    }

    /// The outline, as rings in image pixels.
    #[must_use]
    pub fn rings(&self) -> &[Ring] {
        self.outline.domain.rings()
    }

    /// Makes poses of this solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.poser
    }

    /// The weights at a point and their gradients (eq. 2), or `None` outside the domain. Empty on an island without sites.
    #[must_use]
    pub fn influences_at(&self, p: DVec2) -> Option<Vec<Influence>> {
        let (triangle, p) = self.outline.navigation.locate(p)?;
        Some(self.functions.at(&self.sites, triangle, p))
    }

    /// The sites that move a point and their weights, ascending by site; `None` outside the domain.
    #[must_use]
    pub fn weights_at(&self, p: DVec2) -> Option<Vec<(usize, f64)>> {
        let influences = self.influences_at(p)?;
        Some(influences.into_iter().map(|influence| (influence.site, influence.weight)).collect())
    }

    /// Parts of bars and polygons that lie outside the domain, or on its held boundary: they move nothing.
    #[must_use]
    pub fn outside(&self) -> &[Outside] {
        &self.outside
    }

    /// Where a point goes (eq. 1), and how its surroundings grow; `None` outside the domain.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn map(&self, pose: &Pose, p: DVec2) -> Option<Mapped> {
        self.expect_own(pose);
        Some(pose.map(p, &self.influences_at(p)?))
    }

    /// Where the mesh's vertices go.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn posed_vertices(&self, pose: &Pose) -> Vec<DVec2> {
        self.expect_own(pose);
        let vertices = self.mesh.vertices.iter().enumerate();
        vertices.map(|(v, &p)| pose.blended(p, self.weights.row(v))).collect()
    }

    /// The mesh's triangles in the order in which a pose has them drawn, later ones over earlier ones: by the depths of the handles.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn drawn_triangles(&self, pose: &Pose) -> Cow<'_, [[u32; 3]]> {
        self.expect_own(pose);
        let depths: Vec<f64> = pose.motions().iter().map(|motion| motion.depth).collect();
        drawn_triangles(&self.mesh, &self.weights, &depths)
    }

    /// The place of the picture at rest that a pose draws at a point: of several that it draws there the last, which covers the others;
    /// `None` where it draws nothing.
    ///
    /// This is the inverse of the mesh as it is drawn, whose triangles are flat, so it gives back what [`map`](Self::map) is given as
    /// closely as flat triangles follow a picture that bends. Cost: that of [`posed_vertices`](Self::posed_vertices).
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn rest_at(&self, pose: &Pose, p: DVec2) -> Option<DVec2> {
        if self.kinds == [0; 3]
            && let Some((width, height)) = self.outline.picture
        {
            // Then the picture is drawn as it is, with all that is no part of the domain.
            let size = DVec2::new(f64::from(width), f64::from(height));
            return (p.cmpge(DVec2::ZERO).all() && p.cmple(size).all()).then_some(p);
        }
        inverse::rest_at(&self.mesh.vertices, &self.posed_vertices(pose), &self.drawn_triangles(pose), p)
    }

    /// The picture, warped by a pose: what [`raster::warp`] draws of the mesh, or, where there is no handle, of the picture as it is, with
    /// all that is no part of the domain.
    ///
    /// `scale` is pixels of the result for a pixel of the picture: [`raster::warped_size`] tells the size, unless the canvas grows.
    ///
    /// # Errors
    /// [`Error::Scale`]; [`Error::Canvas`]; [`Error::PictureMismatch`] for a picture of another size than was solved, where a picture was, and not a mesh;
    /// [`Error::PoseOfAnother`].
    pub fn warped(&self, picture: &Picture<'_>, pose: &Pose, scale: f64, canvas: Canvas) -> Result<Warped, Error> {
        if let Some(size) = self.outline.picture {
            check_picture(size, picture)?;
        }
        if !self.poser.has_made(pose) {
            return Err(Error::PoseOfAnother);
        }
        if self.kinds == [0; 3] {
            let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
            let corners = [DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
            return raster::warp(picture, &corners, &corners, &[[0, 1, 2], [0, 2, 3]], scale, canvas);
        }
        let posed = self.posed_vertices(pose);
        raster::warp(picture, &self.mesh.vertices, &posed, &self.drawn_triangles(pose), scale, canvas)
    }

    /// Intrinsic distances from one point of the domain to others, in pixels; `None` where no path leads.
    ///
    /// # Errors
    /// [`Error::PointOutside`] where the first point lies outside the domain.
    pub fn distances(&self, from: DVec2, at: &[DVec2]) -> Result<Vec<Option<f64>>, Error> {
        Propagation::default().distances(&self.outline.navigation, from, at)
    }

    /// The solve in numbers, with the folds of a pose.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn report(&self, pose: &Pose) -> Report {
        let real = self.sites.iter().filter(|site| site.kind.is_real()).count();
        let entries = self.weights.offsets[self.samples] as usize;
        let covers = self.weights.offsets[..=self.samples].windows(2).map(|row| (row[1] - row[0]) as usize);
        let reached = self.phi_sums.iter().zip(&self.nearest).filter(|&(_, &nearest)| nearest != u32::MAX);
        let offsets = self.weights.offsets.iter().map(|&offset| u64::from(offset));
        let sites = self.weights.sites.iter().map(|&site| u64::from(site));
        let bits = self.weights.weights.iter().map(|weight| weight.to_bits());
        Report {
            samples: self.samples,
            islands: self.domain().islands(),
            holes: self.domain().holes(),
            specks: self.domain().specks(),
            reflex_corners: self.outline.navigation.reflex_corners().count(),
            point_handles: self.kinds[0],
            bar_handles: self.kinds[1],
            polygon_handles: self.kinds[2],
            outside: self.outside.clone(),
            real_sites: real,
            virtual_sites: self.sites.len() - real,
            scores: self.scores.iter().copied().filter(|score| score.is_finite()).collect(),
            cover_mean: entries as f64 / self.samples as f64,
            cover_max: covers.max().unwrap_or(0),
            min_phi_sum: reached.map(|(&sum, _)| sum).reduce(f64::min).unwrap_or(0.0),
            folded_triangles: self.folded_triangles(pose),
            weights_hash: Fingerprint::of(offsets.chain(sites).chain(bits)).to_string(),
        }
    }

    /// Triangles over the domain that a pose turns over.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn folded_triangles(&self, pose: &Pose) -> usize {
        let posed = self.posed_vertices(pose);
        let inner = self.mesh.triangles.iter().filter(|t| t.iter().all(|&v| (v as usize) < self.samples));
        let area = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| posed[v as usize]);
            (b - a).perp_dot(c - a)
        };
        inner.filter(|t| area(t) < 0.0).count()
    }

    fn expect_own(&self, pose: &Pose) {
        assert!(self.poser.has_made(pose), "{}", Error::PoseOfAnother);
    }
}
