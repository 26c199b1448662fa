//! A solved project: the mesh, its weights, and the weight functions themselves.

use std::{borrow::Cow, sync::Arc};

use glam::DVec2;

use crate::{
    bone::OutsidePart,
    cell_borders::{BorderPiece, cell_borders},
    deform::{Adjacency, DepthOrder, DrawnPose, FoldingMesh, Mapped, Pose, PosedMesh, depths, rest_points},
    distance::Navigation,
    domain::Domain,
    error::Error,
    loose::Loose,
    pose::Poser,
    prepared_domain::PreparedDomain,
    project::{Project, Weighting},
    render_mesh::RenderMesh,
    report::{Fingerprint, Report},
    sample::Feather,
    site::{Round, Site},
    solved_sites::SolvedSites,
    static_background::StaticBackground,
    triangulation::NONE,
    weight::{Influence, SparseWeights, WeightFunctions},
};

/// The result of a solve: how sites move a mesh over the domain, and any point of the domain. It does not depend on the
/// pose of the handles. Only its own [`poser`](Self::poser) computes poses for it.
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
/// // Points outside the domain have no posed position.
/// assert!(solution.map(&pose, [41.0, 15.0].into()).is_none());
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Solution {
    pub(crate) mesh: RenderMesh,
    pub(crate) background: StaticBackground,
    pub(crate) feather: Feather,
    pub(crate) weights: SparseWeights,
    pub(crate) solved: SolvedSites,
    /// Number of samples, the first vertices of the mesh. The other vertices belong to the skirt.
    pub(crate) samples: usize,
    pub(crate) phi_sums: Vec<f64>,
    /// Numbers of point handles, bars and polygons.
    pub(crate) handle_counts: [usize; 3],
    pub(crate) outside: Vec<OutsidePart>,
    pub(crate) functions: WeightFunctions,
    pub(crate) weighting: Weighting,
    pub(crate) rounds: Vec<Round>,
    /// Islands without sites that follow other islands.
    pub(crate) loose: Loose,
    pub(crate) prepared: Arc<PreparedDomain>,
    /// The picture behind the mesh, once it is filled.
    #[cfg(feature = "raster")]
    pub(crate) fill: Option<Arc<crate::fill::Fill>>,
}

/// The mesh.
impl Solution {
    /// Vertices of the mesh at rest, in image pixels: the [`samples`](Self::samples), then those of the skirt around
    /// them, for soft edges and other visible content outside the domain.
    #[must_use]
    pub fn vertices(&self) -> &[DVec2] {
        &self.mesh.vertices
    }

    /// The [`vertices`](Self::vertices) before the handles pose them: displaced as the project says.
    #[must_use]
    pub fn displaced_vertices(&self) -> Cow<'_, [DVec2]> {
        self.solved.poser.displaced(&self.mesh.vertices)
    }

    /// Triangles × 3 vertices. Later triangles are drawn over earlier ones while no handle has a depth: see
    /// [`drawn_triangles`](Self::drawn_triangles).
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.mesh.triangles
    }

    /// The part of the picture outside a domain of polygons. It does not move, and is drawn before the
    /// [`triangles`](Self::triangles). Empty for other domains.
    #[must_use]
    pub fn static_background(&self) -> &StaticBackground {
        &self.background
    }

    /// The soft rim around the mesh. It is drawn before the [`triangles`](Self::triangles). Empty for a domain without
    /// a feather, and for a boundary that is held.
    #[must_use]
    pub fn feather(&self) -> &Feather {
        &self.feather
    }

    /// Number of samples, the first [`vertices`](Self::vertices). They lie in the domain.
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

/// The sites.
impl Solution {
    /// The sites, with the sizes of their cells and supports. First come point handles and the first sites of bars and
    /// of a held boundary, from top to bottom. Others follow in the order of insertion.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.solved.sites
    }

    /// The links of the cell graph (section IV-B), ascending: two sites, the lower index first, and a weight in (0, 1].
    pub fn links(&self) -> impl Iterator<Item = (usize, usize, f64)> + Clone + '_ {
        self.solved.graph.iter()
    }

    /// ϖ: the real sites that determine the motion of a site, and their weights (eq. 4), ascending by site. They sum to
    /// 1 within rounding. A real site has only itself.
    ///
    /// # Panics
    /// If `site` is out of bounds.
    pub fn harmonic_weights(&self, site: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.solved.harmonic.row(site)
    }

    /// The nearest site of a sample, `None` on an island without sites. Its support may end before the sample, for
    /// example beside an acute joint. Then other sites move the sample.
    ///
    /// # Panics
    /// If `sample` is out of bounds.
    #[must_use]
    pub fn nearest_site(&self, sample: usize) -> Option<usize> {
        self.solved.nearest_site(sample)
    }

    /// The borders between the cells 𝒱(h_i), in straight pieces within the triangles of the mesh. The sites of one
    /// handle share one cell. Cost: two milliseconds for 100 sites and 10,000 samples.
    #[must_use]
    pub fn cell_borders(&self) -> Vec<BorderPiece> {
        let SolvedSites { sites, nearest, .. } = &self.solved;
        cell_borders(&self.mesh, nearest, sites, self.functions.fields(), self.navigation())
    }

    /// Σφ at each sample, by which weights are normalised (eq. 2): near 0, weights are steep.
    #[must_use]
    pub fn phi_sums(&self) -> &[f64] {
        &self.phi_sums
    }

    /// The rounds of Algorithm 1. Their scores are the curve of figure 3 (right); −∞ without cells.
    #[must_use]
    pub fn rounds(&self) -> &[Round] {
        &self.rounds
    }
}

impl Solution {
    /// The domain that was solved.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.prepared.domain
    }

    /// Whether pixels around the domain move with it, as for a picture that is cut out by its alpha.
    pub(crate) fn draws_around(&self) -> bool {
        self.prepared.around.is_some()
    }

    /// The triangulation of the domain for computing [distances](Navigation::distances_from).
    #[must_use]
    pub fn navigation(&self) -> &Navigation {
        &self.prepared.navigation
    }

    /// The poser of this solution.
    #[must_use]
    pub fn poser(&self) -> &Poser {
        &self.solved.poser
    }

    /// The pose of a project's handles, with the project's blend: see [`Poser::pose`].
    ///
    /// # Errors
    /// The errors of [`Poser::pose`].
    pub fn pose(&self, project: &Project) -> Result<Pose, Error> {
        self.solved.pose(project)
    }

    /// The weights at a point and their gradients (eq. 2), or `None` outside the domain. Empty on an island without
    /// sites.
    #[must_use]
    pub fn influences_at(&self, p: DVec2) -> Option<Vec<Influence>> {
        let navigation = &self.prepared.navigation;
        let (triangle, p) = navigation.locate(p)?;
        let Some((triangle, leader)) = self.loose.leader(navigation.island_of(triangle)) else {
            return Some(self.functions.at(triangle, p));
        };
        let mut influences = self.functions.at(triangle, leader);
        influences.iter_mut().for_each(|influence| influence.gradient = DVec2::ZERO);
        Some(influences)
    }

    /// The sites that move a point and their weights, ascending by site; `None` outside the domain.
    #[must_use]
    pub fn weights_at(&self, p: DVec2) -> Option<Vec<(usize, f64)>> {
        let influences = self.influences_at(p)?;
        Some(influences.into_iter().map(|influence| (influence.site, influence.weight)).collect())
    }

    /// The weights of any points, such as the vertices of another mesh, points × sites. A point outside the domain or
    /// on an island without sites has an empty row, and does not move.
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
    pub fn outside(&self) -> &[OutsidePart] {
        &self.outside
    }

    /// The posed position of a point (eq. 1), and the growth of areas there; `None` outside the domain.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn map(&self, pose: &Pose, p: DVec2) -> Option<Mapped> {
        self.solved.expect_own(pose);
        Some(pose.map(p, &self.influences_at(p)?))
    }

    /// The posed positions of the vertices.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn posed_vertices(&self, pose: &Pose) -> Vec<DVec2> {
        self.solved.expect_own(pose);
        pose.blend_all(&self.mesh.vertices, &self.weights)
    }

    /// The triangles in the drawing order of a pose, later ones over earlier ones: by the depths of the handles. Where
    /// two parts of the picture cross, one lies completely in front of the other.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn drawn_triangles(&self, pose: &Pose) -> Cow<'_, [[u32; 3]]> {
        self.solved.expect_own(pose);
        match self.drawn_pose(pose, &self.posed_vertices(pose)).triangles {
            Cow::Borrowed(_) => Cow::Borrowed(&self.mesh.triangles),
            Cow::Owned(triangles) => Cow::Owned(triangles),
        }
    }

    /// The drawing order of the posed vertices of a pose.
    pub(crate) fn drawn_pose<'a>(&'a self, pose: &Pose, posed: &'a [DVec2]) -> DrawnPose<'a> {
        let RenderMesh { vertices: rest, triangles } = &self.mesh;
        let order = DepthOrder::new(triangles, &self.weights, &depths(pose.motions()));
        order.drawn(PosedMesh { rest, posed, triangles }, &Adjacency::new(triangles))
    }

    /// The rest point that a pose draws at a point. Costs nearly as much as [`rest_points`](Self::rest_points) of many.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn rest_point(&self, pose: &Pose, p: DVec2) -> Option<DVec2> {
        self.rest_points(pose, &[p]).pop().flatten()
    }

    /// The rest points that a pose draws at given points, such as the centres of pixels. If the picture covers itself,
    /// the point drawn last; `None` if nothing is drawn there.
    ///
    /// This inverts the drawn mesh, whose triangles are flat, so it inverts [`map`](Self::map) up to the error of flat
    /// triangles. Cost: that of [`posed_vertices`](Self::posed_vertices), and for each triangle, a visit of the points
    /// within its range of y.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn rest_points(&self, pose: &Pose, points: &[DVec2]) -> Vec<Option<DVec2>> {
        if self.is_at_rest(pose)
            && let Some((width, height)) = self.prepared.picture
        {
            // Without handles the whole picture is drawn, with the parts outside the domain.
            let size = DVec2::new(f64::from(width), f64::from(height));
            let drawn = |p: &DVec2| p.cmpge(DVec2::ZERO).all() && p.cmple(size).all();
            return points.iter().map(|p| Some(*p).filter(drawn)).collect();
        }
        let (vertices, around) = (&self.mesh.vertices, self.background.vertices());
        let posed = self.posed_vertices(pose);
        let moved = rest_points(vertices, &posed, &self.drawn_pose(pose, &posed).triangles, points);
        let still = rest_points(around, around, self.background.triangles(), points);
        moved.into_iter().zip(still).map(|(moved, still)| moved.or(still)).collect()
    }

    /// The posed positions of points of the picture: that of [`map`](Self::map) in the domain. Around it, the position
    /// in the drawn mesh; `None` where the picture has no mesh.
    ///
    /// Cost: that of [`map`](Self::map) for each point, and of [`posed_vertices`](Self::posed_vertices).
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn posed_points(&self, pose: &Pose, points: &[DVec2]) -> Vec<Option<DVec2>> {
        if self.is_at_rest(pose) {
            return points.iter().copied().map(Some).collect();
        }
        let mut posed: Vec<_> = points.iter().map(|&p| self.map(pose, p).map(|at| at.posed)).collect();
        let around: Vec<usize> = (0..points.len()).filter(|&i| posed[i].is_none()).collect();
        if !around.is_empty() {
            let outside: Vec<DVec2> = around.iter().map(|&i| points[i]).collect();
            let RenderMesh { vertices, triangles } = &self.mesh;
            // The inverse of the inverse: the mesh at rest is the one that is looked at.
            let moved = rest_points(&self.posed_vertices(pose), vertices, triangles, &outside);
            let still = self.background.vertices();
            let still = rest_points(still, still, self.background.triangles(), &outside);
            for ((i, moved), still) in around.into_iter().zip(moved).zip(still) {
                posed[i] = moved.or(still);
            }
        }
        posed
    }

    /// Values at the vertices of the mesh, interpolated at points of the picture at rest; `None` where the picture has
    /// no mesh.
    ///
    /// # Panics
    /// If the number of values differs from the number of vertices.
    #[must_use]
    pub fn interpolated(&self, values: &[f64], points: &[DVec2]) -> Vec<Option<f64>> {
        let RenderMesh { vertices, triangles } = &self.mesh;
        let values: Vec<DVec2> = values.iter().map(|&value| DVec2::new(value, 0.0)).collect();
        assert_eq!(values.len(), vertices.len(), "each vertex has a value");
        rest_points(&values, vertices, triangles, points).into_iter().map(|found| found.map(|value| value.x)).collect()
    }

    /// Whether the whole picture is at rest: without handles, and not displaced.
    pub(crate) fn is_at_rest(&self, pose: &Pose) -> bool {
        self.handle_counts == [0; 3] && !pose.displaces()
    }

    /// Intrinsic distances from one point of the domain to others, in pixels; `None` if no path exists.
    ///
    /// # Errors
    /// [`Error::PointOutside`] if the first point lies outside the domain.
    pub fn distances(&self, from: DVec2, at: &[DVec2]) -> Result<Vec<Option<f64>>, Error> {
        let distances = self.navigation().distances_from(from)?;
        Ok(at.iter().map(|&p| distances.to(p)).collect())
    }

    /// The figures of the solve, and the number of folds in a pose.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn report(&self, pose: &Pose) -> Report {
        let real = self.solved.sites.iter().filter(|site| site.kind.is_real()).count();
        let entries = self.weights.offsets()[self.samples] as usize;
        let covers = self.weights.offsets()[..=self.samples].windows(2).map(|row| (row[1] - row[0]) as usize);
        let reached = self.phi_sums.iter().zip(&self.solved.nearest).filter(|&(_, &nearest)| nearest != NONE);
        let offsets = self.weights.offsets().iter().map(|&offset| u64::from(offset));
        let sites = self.weights.sites().iter().map(|&site| u64::from(site));
        let bits = self.weights.weights().iter().map(|weight| weight.to_bits());
        Report {
            samples: self.samples,
            islands: self.domain().islands(),
            holes: self.domain().holes(),
            loose_islands: self.loose_islands(),
            specks: self.domain().specks(),
            outline: self.domain().detail(),
            bridged_gap: self.domain().bridged_gap(),
            reflex_corners: self.prepared.navigation.reflex_corners().count(),
            point_handles: self.handle_counts[0],
            bar_handles: self.handle_counts[1],
            polygon_handles: self.handle_counts[2],
            outside: self.outside.clone(),
            real_sites: real,
            virtual_sites: self.solved.sites.len() - real,
            scores: self.rounds.iter().map(|round| round.score).filter(|score| score.is_finite()).collect(),
            cover_mean: entries as f64 / self.samples as f64,
            cover_max: covers.max().unwrap_or(0),
            min_phi_sum: reached.map(|(&sum, _)| sum).reduce(f64::min).unwrap_or(0.0),
            folded_triangles: self.folded_triangles(pose),
            weights_hash: Fingerprint::of(offsets.chain(sites).chain(bits)).to_string(),
        }
    }

    /// The point that determines the motion of another point: the point itself, unless it belongs to a loose part.
    pub(crate) fn leading_point(&self, p: DVec2) -> DVec2 {
        let navigation = &self.prepared.navigation;
        let leader = navigation.locate(p).and_then(|(triangle, _)| self.loose.leader(navigation.island_of(triangle)));
        leader.map_or(p, |(_, leader)| leader)
    }

    /// The number of islands without a handle; all islands if there are no handles.
    fn loose_islands(&self) -> usize {
        self.domain().islands() - self.functions.islands().len()
    }

    /// The triangles over the domain that a pose flips, each with its vertices.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn folds(&self, pose: &Pose) -> Vec<[u32; 3]> {
        let posed = self.posed_vertices(pose);
        FoldingMesh::new(&self.mesh.vertices, &self.mesh.triangles, self.samples).folded(&posed).collect()
    }

    /// The number of [`folds`](Self::folds).
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn folded_triangles(&self, pose: &Pose) -> usize {
        self.folds(pose).len()
    }
}
