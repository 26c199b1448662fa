//! A solved project: the mesh, its weights, and the weight functions themselves.

use std::{borrow::Cow, sync::Arc};

use glam::DVec2;

use crate::{
    bone::Outside,
    cell_borders::{BorderPiece, cell_borders},
    distance::Navigation,
    domain::Domain,
    drawing_order::drawn_triangles,
    error::Error,
    inverse,
    picture::Picture,
    pose::{HarmonicFields, Mapped, Pose, Poser},
    prepared_domain::PreparedDomain,
    project::Project,
    raster::{self, options::ResampleOptions, sources::Source, warped::Warped},
    render_mesh::RenderMesh,
    report::{Fingerprint, Report},
    request::check_picture,
    site::{Site, SiteGraph},
    surroundings::Surroundings,
    triangulation::NONE,
    weight::{Influence, SparseWeights, WeightFunctions},
};

/// The result of a solve: of a mesh over the domain and of any point of it, how sites move it. It does not depend on where the
/// handles are posed: its [`poser`](Self::poser) makes the poses that it takes, and no other does.
///
/// ```
/// use c2warp::{Picture, project::{Handle, Project}, solve};
///
/// let rgba = vec![255; 40 * 30 * 4];
/// let mut project = Project::for_picture(40, 30);
/// project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0]).posed_at([[35.0, 10.0]])];
/// let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
/// let pose = solution.pose(&project)?;
/// // A point between the handles, and the vertices of the mesh.
/// let mapped = solution.map(&pose, [25.0, 15.0].into()).unwrap();
/// assert!(mapped.posed.y < 15.0 && mapped.det > 0.0);
/// assert_eq!(solution.posed_vertices(&pose).len(), solution.vertices().len());
/// // What is outside of the domain goes nowhere.
/// assert!(solution.map(&pose, [41.0, 15.0].into()).is_none());
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Solution {
    pub(crate) mesh: RenderMesh,
    pub(crate) surroundings: Surroundings,
    pub(crate) weights: SparseWeights,
    pub(crate) sites: Vec<Site>,
    pub(crate) graph: SiteGraph,
    pub(crate) harmonic: HarmonicFields,
    /// Number of samples: the first vertices of the mesh; the others are the skirt's.
    pub(crate) samples: usize,
    /// The nearest site of each sample, [`NONE`] on an island without sites.
    pub(crate) nearest: Vec<u32>,
    pub(crate) phi_sums: Vec<f64>,
    pub(crate) scores: Vec<f64>,
    /// Numbers of point handles, bars and polygons.
    pub(crate) kinds: [usize; 3],
    pub(crate) outside: Vec<Outside>,
    pub(crate) poser: Poser,
    pub(crate) functions: WeightFunctions,
    pub(crate) prepared: Arc<PreparedDomain>,
}

/// All that a pose draws, in order.
struct Drawn {
    rest: Vec<DVec2>,
    posed: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
}

/// What is drawn.
impl Solution {
    /// Vertices of the mesh at rest, in image pixels: the [`samples`](Self::samples), then those of the skirt, a skirt of some pixels around
    /// soft edges.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.mesh.vertices
    }

    /// Triangles × 3 vertices, drawn later ones over earlier ones as long as no handle has a depth: see
    /// [`drawn_triangles`](Self::drawn_triangles).
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.mesh.triangles
    }

    /// What of the picture lies around the rings of a project that draws its domain: it stays, and is drawn before the
    /// [`triangles`](Self::triangles). Empty for any other domain.
    #[must_use]
    pub fn surroundings(&self) -> &Surroundings {
        &self.surroundings
    }

    /// Number of samples, the first of the [`vertices`](Self::vertices): those in the domain.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// The weights of the vertices (eq. 2), vertices × sites.
    #[must_use]
    pub fn weights(&self) -> &SparseWeights {
        &self.weights
    }
}

/// What moves it.
impl Solution {
    /// The sites, with their cells and supports: point handles and the first sites of bars and of a held boundary from top to bottom,
    /// then others as they were inserted.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// The links of the cell graph (section IV-B): two sites, the lower index first, and the weight of the link, in (0, 1]. Ascending.
    pub fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.graph.iter()
    }

    /// ϖ: the real sites that a site gets its motion from and their shares (eq. 4), which sum to 1 within rounding; ascending by site. Of a
    /// real site itself alone.
    ///
    /// # Panics
    /// For a site that there is not.
    pub fn shares(&self, site: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.harmonic.row(site)
    }

    /// The nearest site of a sample, `None` on an island without sites. Where the support of the nearest site ends before the
    /// sample, as it may in a nook, it can be another one that moves the sample.
    ///
    /// # Panics
    /// For a vertex that is no sample.
    #[must_use]
    pub fn nearest_site(&self, sample: usize) -> Option<usize> {
        let site = self.nearest[sample];
        (site != NONE).then_some(site as usize)
    }

    /// The borders between the cells 𝒱(h_i), in straight pieces within the triangles of the mesh. The sites of one handle have one cell in
    /// common. Cost: two milliseconds for 100 sites and 10,000 samples.
    #[must_use]
    pub fn cell_borders(&self) -> Vec<BorderPiece> {
        cell_borders(&self.mesh, &self.nearest, &self.sites, self.navigation())
    }

    /// Σφ at each sample, by which weights are normalised (eq. 2): near 0, weights are steep.
    #[must_use]
    pub fn phi_sums(&self) -> &[f64] {
        &self.phi_sums
    }

    /// The score δ / r_d of the worst cell before each round of Algorithm 1 (figure 3, right), with δ = r_d minus the greatest radius that
    /// the cell may have, in place of r_d − r_h. Infinite where there is no cell.
    #[must_use]
    pub fn scores(&self) -> &[f64] {
        &self.scores
    }
}

impl Solution {
    /// The domain that was solved.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.prepared.domain
    }

    /// The triangulation of the domain that [distances](Navigation::distances_from) are computed on.
    #[must_use]
    pub fn navigation(&self) -> &Navigation {
        &self.prepared.navigation
    }

    /// Makes poses of this solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.poser
    }

    /// The pose of a project's handles, blended as the project says: see [`Poser::pose`].
    ///
    /// # Errors
    /// Those of [`Poser::pose`].
    pub fn pose(&self, project: &Project) -> Result<Pose, Error> {
        self.poser.pose(&project.handles, project.pose.blend)
    }

    /// The weights at a point and their gradients (eq. 2), or `None` outside the domain. Empty on an island without sites.
    #[must_use]
    pub fn influences_at(&self, p: DVec2) -> Option<Vec<Influence>> {
        let (triangle, p) = self.prepared.navigation.locate(p)?;
        Some(self.functions.at(&self.sites, triangle, p))
    }

    /// The sites that move a point and their weights, ascending by site; `None` outside the domain.
    #[must_use]
    pub fn weights_at(&self, p: DVec2) -> Option<Vec<(usize, f64)>> {
        let influences = self.influences_at(p)?;
        Some(influences.into_iter().map(|influence| (influence.site, influence.weight)).collect())
    }

    /// The weights of points of the caller's, such as the vertices of a mesh, points × sites. The row of a point outside the domain
    /// is empty, as that of a point on an island without sites is: such a point stays.
    ///
    /// Cost: for each point, that of [`weights_at`](Self::weights_at).
    #[must_use]
    pub fn weights_of(&self, points: &[DVec2]) -> SparseWeights {
        let mut weights = SparseWeights::with_capacity(points.len());
        for &p in points {
            weights.push_row(self.weights_at(p).unwrap_or_default().into_iter());
        }
        weights
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

    /// The place of the picture at rest that a pose draws at a point: [`rests_of`](Self::rests_of) one point, at much the same cost.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn rest_at(&self, pose: &Pose, p: DVec2) -> Option<DVec2> {
        self.rests_of(pose, &[p]).pop().flatten()
    }

    /// The places of the picture at rest that a pose draws at points, such as the centres of the result's pixels: of several that it
    /// draws at one the last, which covers the others; `None` where it draws nothing.
    ///
    /// This is the inverse of the mesh as it is drawn, whose triangles are flat, so it gives back what [`map`](Self::map) is given as
    /// closely as flat triangles follow a picture that bends. Cost: that of [`posed_vertices`](Self::posed_vertices), and for each
    /// triangle a look at the points as high up as it.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn rests_of(&self, pose: &Pose, points: &[DVec2]) -> Vec<Option<DVec2>> {
        if self.kinds == [0; 3]
            && let Some((width, height)) = self.prepared.picture
        {
            // Then the picture is drawn as it is, with all that is no part of the domain.
            let size = DVec2::new(f64::from(width), f64::from(height));
            let drawn = |p: &DVec2| p.cmpge(DVec2::ZERO).all() && p.cmple(size).all();
            return points.iter().map(|p| Some(*p).filter(drawn)).collect();
        }
        let (vertices, around) = (&self.mesh.vertices, self.surroundings.vertices());
        let moved = inverse::rests_of(vertices, &self.posed_vertices(pose), &self.drawn_triangles(pose), points);
        let still = inverse::rests_of(around, around, self.surroundings.triangles(), points);
        moved.into_iter().zip(still).map(|(moved, still)| moved.or(still)).collect()
    }

    /// The picture, warped by a pose: what [`raster::warp`] draws of the [surroundings](Self::surroundings) and the mesh, or, where there
    /// is no handle, of the picture as it is, with all that is no part of the domain.
    ///
    /// [`raster::warped_size`] tells the size, unless the canvas grows.
    ///
    /// # Errors
    /// [`Error::Scale`]; [`Error::Canvas`]; [`Error::PictureMismatch`] for a picture of another size than was solved, where a picture was, and not a mesh;
    /// [`Error::PoseOfAnother`].
    pub fn warped(&self, picture: &Picture<'_>, pose: &Pose, options: ResampleOptions) -> Result<Warped, Error> {
        let Drawn { rest, posed, triangles } = self.drawn(picture, pose)?;
        raster::warp(picture, &rest, &posed, &triangles, options)
    }

    /// Where the pixels of a warped picture come from, in rows from top to bottom: [`raster::sources`] of what [`warped`](Self::warped)
    /// made of the same picture and pose in the same way.
    ///
    /// # Errors
    /// [`Error::PictureMismatch`] and [`Error::PoseOfAnother`], as for [`warped`](Self::warped).
    pub fn sources(
        &self,
        picture: &Picture<'_>,
        pose: &Pose,
        options: ResampleOptions,
        warped: &Warped,
    ) -> Result<Vec<Source>, Error> {
        let Drawn { rest, posed, triangles } = self.drawn(picture, pose)?;
        Ok(raster::sources(picture, &rest, &posed, &triangles, options, warped))
    }

    /// All that a pose draws: the surroundings and the mesh, or, where there is no handle, the picture as it is.
    fn drawn(&self, picture: &Picture<'_>, pose: &Pose) -> Result<Drawn, Error> {
        if let Some(size) = self.prepared.picture {
            check_picture(size, picture)?;
        }
        if !self.poser.has_made(pose) {
            return Err(Error::PoseOfAnother);
        }
        if self.kinds == [0; 3] {
            let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
            let corners = [DVec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)];
            return Ok(Drawn { rest: corners.into(), posed: corners.into(), triangles: vec![[0, 1, 2], [0, 2, 3]] });
        }
        let around = self.surroundings.vertices();
        let first = around.len() as u32;
        let drawn = self.drawn_triangles(pose);
        let moved = drawn.iter().map(|triangle| triangle.map(|vertex| first + vertex));
        Ok(Drawn {
            rest: [around, &self.mesh.vertices].concat(),
            posed: [around, &self.posed_vertices(pose)].concat(),
            triangles: self.surroundings.triangles().iter().copied().chain(moved).collect(),
        })
    }

    /// Intrinsic distances from one point of the domain to others, in pixels; `None` where no path leads.
    ///
    /// # Errors
    /// [`Error::PointOutside`] where the first point lies outside the domain.
    pub fn distances(&self, from: DVec2, at: &[DVec2]) -> Result<Vec<Option<f64>>, Error> {
        let distances = self.navigation().distances_from(from)?;
        Ok(at.iter().map(|&p| distances.to(p)).collect())
    }

    /// The solve in numbers, with the folds of a pose.
    ///
    /// # Panics
    /// Where the pose is of another solution.
    #[must_use]
    pub fn report(&self, pose: &Pose) -> Report {
        let real = self.sites.iter().filter(|site| site.kind.is_real()).count();
        let entries = self.weights.offsets()[self.samples] as usize;
        let covers = self.weights.offsets()[..=self.samples].windows(2).map(|row| (row[1] - row[0]) as usize);
        let reached = self.phi_sums.iter().zip(&self.nearest).filter(|&(_, &nearest)| nearest != NONE);
        let offsets = self.weights.offsets().iter().map(|&offset| u64::from(offset));
        let sites = self.weights.sites().iter().map(|&site| u64::from(site));
        let bits = self.weights.weights().iter().map(|weight| weight.to_bits());
        Report {
            samples: self.samples,
            islands: self.domain().islands(),
            holes: self.domain().holes(),
            specks: self.domain().specks(),
            reflex_corners: self.prepared.navigation.reflex_corners().count(),
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
