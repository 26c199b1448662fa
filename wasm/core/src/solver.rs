//! The façade: from a project and its picture to a solution, stage by stage. The only module that knows every stage.

use std::sync::Arc;

use glam::DVec2;

use crate::{
    bone::Track,
    cloud::{CloudSolution, PointCloud},
    distance::{Navigation, Propagation},
    domain::Domain,
    error::Error,
    given_mesh::GivenMesh,
    picture::Picture,
    pose::{HarmonicFields, Poser, Quadrature},
    project::{DomainSpec, PoseMode, Project},
    render_mesh::{RenderMesh, leading_parts},
    request::{Request, Rest, check_picture},
    sample::{Ground, Samples, Scouts, scouts_wanted},
    site::{Obstacles, Regions, Site, SiteGraph, insert_virtual_sites},
    solution::Solution,
    weight::{Basis, Swept, WeightFunctions, support_radii},
};

/// A stage of the solve. Between two stages a caller may look for newer requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The outline: from the picture's alpha or the project's rings.
    Domain,
    /// Samples and the mesh over them.
    Sampling,
    /// Distances, cells and virtual sites.
    Regions,
    /// Supports, weights and harmonic fields.
    Weights,
}

impl Stage {
    /// The stage's name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Domain => "domain",
            Self::Sampling => "sampling",
            Self::Regions => "regions",
            Self::Weights => "weights",
        }
    }
}

/// Solves projects of one picture, stage by stage, and keeps for the next solve what does not depend on point handles: the
/// outline, and the samples and scouts without handles.
///
/// A picture is identified by its size: another one of the same size needs a new solver.
#[derive(Debug, Default)]
pub struct Solver {
    outline: Option<(DomainKey, Arc<Outline>)>,
    ground: Option<Ground>,
    scouts_ground: Option<Ground>,
    propagation: Propagation,
    work: Option<Work>,
    solution: Option<(DomainKey, Request, Solution)>,
}

/// A domain with its triangulation.
#[derive(Debug)]
pub(crate) struct Outline {
    pub(crate) domain: Domain,
    pub(crate) navigation: Navigation,
    /// The picture's size, if there is a picture.
    pub(crate) picture: Option<(u32, u32)>,
    /// The same, if it fades out beyond the outline.
    fading: Option<DVec2>,
}

/// Everything a domain depends on besides the picture's pixels: its definition, and the picture's size.
type DomainKey = (Option<DomainSpec>, (u32, u32));

/// A solve in progress.
#[derive(Debug)]
struct Work {
    request: Request,
    rest: Option<Rest>,
    samples: Option<(Samples, Scouts)>,
    regions: Option<Divided>,
}

/// Sites, and the scores of Algorithm 1.
type Divided = (Vec<Site>, Vec<f64>);

impl Solver {
    /// A solver that has solved nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins a solve, dropping one in progress. All pictures of one size that are passed to a solver must be the same.
    ///
    /// Finds the outline unless it is kept from the last solve. The first call of [`advance`](Self::advance) then checks the
    /// handles and reports [`Stage::Domain`].
    ///
    /// # Errors
    /// [`Error::PictureMismatch`]; [`Error::Project`] for what [`Project::check`] refuses; [`Error::TooManyHandles`],
    /// [`Error::TooManyCorners`]; or an error of [`Domain::new`].
    pub fn begin(&mut self, project: &Project, picture: &Picture) -> Result<(), Error> {
        self.work = None;
        check_picture(project.image.size(), picture)?;
        let request = Request::new(project)?;
        let key = domain_key(project);
        if self.outline.as_ref().is_none_or(|(known, _)| *known != key) {
            let outline = Outline::new(project.domain.as_ref(), picture)?;
            self.outline = Some((key, Arc::new(outline)));
            (self.ground, self.scouts_ground) = (None, None);
        }
        self.work = Some(Work { request, rest: None, samples: None, regions: None });
        Ok(())
    }

    /// Runs the next stage of the solve and returns it; `None` when none is left.
    ///
    /// # Errors
    /// [`Error::HandleOutside`], [`Error::HandlesTooClose`], [`Error::OnHeldBoundary`], [`Error::BarTooShort`],
    /// [`Error::BarsOverlap`], [`Error::TooManySites`]. The solve is then over; the last solution stays.
    pub fn advance(&mut self) -> Result<Option<Stage>, Error> {
        let (Some(mut work), Some((key, outline))) = (self.work.take(), &self.outline) else { return Ok(None) };
        let outline = Arc::clone(outline);
        let stage = match (&work.rest, &work.samples, &work.regions) {
            (None, ..) => {
                work.rest = Some(work.request.rest(&outline)?);
                Stage::Domain
            }
            (Some(rest), None, _) => {
                let ground = ground(&mut self.ground, &outline, rest, work.request.samples, outline.fading);
                let samples = ground.with_sites(&outline.domain, &outline.navigation, &rest.sites());
                work.samples = Some((samples, self.scouts(&outline, rest, &work.request)));
                Stage::Sampling
            }
            (Some(rest), Some((_, scouts)), None) => {
                work.regions = Some(self.divide(&outline, scouts, rest, &work.request)?);
                Stage::Regions
            }
            _ => {
                let (key, request) = (key.clone(), work.request.clone());
                self.solution = Some((key, request, self.finish(work, outline)));
                return Ok(Some(Stage::Weights));
            }
        };
        self.work = Some(work);
        Ok(Some(stage))
    }

    fn scouts(&mut self, outline: &Outline, rest: &Rest, request: &Request) -> Scouts {
        let count = scouts_wanted(request.samples, request.density);
        let ground = match &self.ground {
            // Usually the count is that of the samples, and so is the ground.
            Some(known) if known.is_for(&rest.bones(), count) => known,
            _ => ground(&mut self.scouts_ground, outline, rest, count, None),
        };
        Scouts::new(ground, &outline.domain, &outline.navigation, &rest.sites())
    }

    fn divide(&mut self, outline: &Outline, scouts: &Scouts, rest: &Rest, request: &Request) -> Result<Divided, Error> {
        let (navigation, skeleton) = (&outline.navigation, &rest.skeleton);
        let tracks = skeleton.bones.iter().map(|bone| Track::new(navigation, bone)).collect();
        let held = request.fix_boundary.then_some(&outline.domain);
        let obstacles = Obstacles { skeleton, tracks, held };
        let mut regions = Regions::new(navigation, scouts, &obstacles, &mut self.propagation);
        regions.insert_real_sites(&rest.points)?;
        let scores = insert_virtual_sites(&mut regions, request.density)?;
        regions.measure_cells();
        // Upper bounds of the radii: obstacles found while fields are extended only reduce them.
        for (site, radius) in support_radii(&request.weighting, &regions.sites).into_iter().enumerate() {
            regions.extend_field(site, radius);
        }
        Ok((regions.sites, scores))
    }

    fn finish(&mut self, work: Work, outline: Arc<Outline>) -> Solution {
        let Work { request, rest, samples, regions } = work;
        let Rest { skeleton, outside, .. } = rest.expect("checked in an earlier stage");
        let (samples, _) = samples.expect("sampled in an earlier stage");
        let (mut sites, scores) = regions.expect("divided in an earlier stage");
        let (navigation, weighting) = (&outline.navigation, &request.weighting);
        for (radius, site) in support_radii(weighting, &sites).into_iter().zip(&mut sites) {
            site.support_radius = radius;
            let bound = radius.max(SiteGraph::field_bound(site.cell_radius));
            if site.field.bound() < bound {
                site.field = self.propagation.field(navigation, site.place, site.rest, bound);
            }
        }
        let kinds = request.kinds();
        let basis = Basis::new(weighting.degree, weighting.filling);
        let functions = WeightFunctions::new(navigation, &sites, &skeleton, basis);
        let Swept { mut weights, sums: phi_sums, nearest } = functions.of_samples(navigation, &sites, &samples);
        let graph = SiteGraph::new(&sites, &skeleton);
        let harmonic = HarmonicFields::new(&sites, &graph);
        let quadrature = (request.mode == PoseMode::Rigid)
            .then(|| Quadrature::new(navigation, &sites, &samples, &weights, &functions));
        let poser = Poser::new(&sites, &graph, &harmonic, skeleton, request.handles, request.mode, quadrature);
        let count = samples.len();
        let leading = leading_parts(&nearest, &sites, &harmonic);
        weights.extend_as(&samples.rim.owners);
        let mesh = RenderMesh::new(samples, &leading);
        Solution {
            mesh,
            weights,
            sites,
            graph,
            harmonic,
            poser,
            samples: count,
            nearest,
            phi_sums,
            scores,
            kinds,
            outside,
            functions,
            outline,
        }
    }

    /// The last solution; `None` before the first solve has finished.
    #[must_use]
    pub fn solution(&self) -> Option<&Solution> {
        self.solution.as_ref().map(|(.., solution)| solution)
    }

    /// Whether the last solution is that of a project, apart from its pose and `image.src`.
    #[must_use]
    pub fn has_solved(&self, project: &Project) -> bool {
        self.solution.as_ref().is_some_and(|(domain, request, _)| {
            *domain == domain_key(project) && Request::new(project).is_ok_and(|other| other == *request)
        })
    }

    /// The last solution, by value.
    #[must_use]
    pub fn into_solution(self) -> Option<Solution> {
        self.solution.map(|(.., solution)| solution)
    }
}

fn domain_key(project: &Project) -> DomainKey {
    (project.domain.clone(), project.image.size())
}

/// The kept ground of samples, replaced if it is not the requested one.
fn ground<'a>(
    known: &'a mut Option<Ground>,
    outline: &Outline,
    rest: &Rest,
    count: usize,
    fading: Option<DVec2>,
) -> &'a Ground {
    let bones = rest.bones();
    if known.as_ref().is_some_and(|ground| !ground.is_for(&bones, count)) {
        *known = None;
    }
    known.get_or_insert_with(|| Ground::new(&outline.domain, &outline.navigation, &bones, count, fading))
}

/// Solves a project in one call.
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`].
pub fn solve(project: &Project, picture: &Picture) -> Result<Solution, Error> {
    let mut solver = Solver::new();
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    Ok(solver.into_solution().expect("every stage has run"))
}

/// Intrinsic distances in a project's domain, in pixels, from one point to others; `None` where no path leads. Handles are
/// ignored.
///
/// # Errors
/// [`Error::PictureMismatch`], an error of [`Domain::new`], or [`Error::PointOutside`] where the first point lies outside the domain.
pub fn distances(project: &Project, picture: &Picture, from: DVec2, at: &[DVec2]) -> Result<Vec<Option<f64>>, Error> {
    check_picture(project.image.size(), picture)?;
    let outline = Outline::new(project.domain.as_ref(), picture)?;
    Propagation::default().distances(&outline.navigation, from, at)
}

/// Solves a project in one call on a mesh from the caller: its vertices are the samples, and the only vertices of the
/// solution's mesh, in the caller's order. Handles need not lie on vertices.
///
/// The project's picture and domain are ignored, and its number of samples is the upper limit for the scouts, on which cells
/// are located.
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings.
pub fn solve_mesh(project: &Project, mesh: &GivenMesh) -> Result<Solution, Error> {
    let (request, outline) = (Request::new(project)?, Arc::clone(&mesh.outline));
    let rest = request.rest(&outline)?;
    let mut solver = Solver::new();
    let scouts = solver.scouts(&outline, &rest, &request);
    let regions = solver.divide(&outline, &scouts, &rest, &request)?;
    let work = Work { request, rest: Some(rest), samples: Some((mesh.samples(), scouts)), regions: Some(regions) };
    Ok(solver.finish(work, outline))
}

/// Solves a project in one call on a point cloud, as the paper does: see [`cloud`](crate::cloud).
///
/// The project's picture, domain and number of samples are ignored.
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings; [`Error::Unsupported`] for bars,
/// polygons and a held boundary.
pub fn solve_cloud(project: &Project, cloud: &PointCloud) -> Result<CloudSolution, Error> {
    let request = Request::new(project)?;
    request.check_points_only()?;
    let rest = request.points_at(|p| cloud.contains(p).then_some(((), p)))?;
    let points: Vec<(u32, DVec2)> = rest.points.iter().map(|&(rest, (), handle)| (handle, rest)).collect();
    CloudSolution::new(cloud, &points, request)
}

impl Outline {
    /// The outline of a domain with nothing to draw beyond it.
    pub(crate) fn hard(domain: Domain) -> Self {
        let navigation = Navigation::new(&domain);
        Self { domain, navigation, picture: None, fading: None }
    }

    fn new(spec: Option<&DomainSpec>, picture: &Picture) -> Result<Self, Error> {
        let domain = Domain::new(spec, picture)?;
        let navigation = Navigation::new(&domain);
        let soft = match spec {
            Some(DomainSpec::Alpha { .. }) => true,
            Some(_) => false,
            None => picture.has_transparency(),
        };
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        Ok(Self { domain, navigation, picture: Some(picture.size()), fading: soft.then_some(size) })
    }
}
