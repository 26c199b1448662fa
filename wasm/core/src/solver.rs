//! The façade: from a project and its picture to a solution, stage by stage. The only module that knows every stage.

use std::sync::Arc;

use glam::DVec2;

use crate::{
    bone::Track,
    cloud::{CloudSolution, PointCloud},
    distance::{Navigation, Propagation},
    domain::Domain,
    error::Error,
    input_mesh::InputMesh,
    picture::Picture,
    pose::{HarmonicFields, Poser, PoserInput, Quadrature},
    prepared_domain::{DomainKey, PreparedDomain},
    project::{PoseMode, Project},
    render_mesh::{RenderMesh, leading_parts},
    request::{Request, Rest, check_picture},
    sample::{CoarseSamples, Samples, SamplingCache, coarse_sample_count},
    site::{Obstacles, Regions, Scores, Site, SiteGraph, insert_virtual_sites},
    solution::Solution,
    stage::Stage,
    static_background::StaticBackground,
    weight::{Basis, Swept, WeightFunctions, support_radii},
};

/// Solves projects of one picture, stage by stage, and keeps for the next solve what does not depend on point handles: the
/// outline, and the samples and coarse samples without handles.
///
/// A picture is identified by its size: another one of the same size needs a new solver.
///
/// ```
/// use c2warp::{Picture, Solver, project::{Handle, Project}};
///
/// let rgba = vec![255; 40 * 30 * 4];
/// let picture = Picture::new(40, 30, &rgba)?;
/// let mut project = Project::for_picture(40, 30).with_handles([Handle::point("left", [5.0, 15.0])]);
/// let mut solver = Solver::new();
/// for x in [25.0, 35.0] {
///     project.handles.push(Handle::point(format!("at {x}"), [x, 15.0]));
///     solver.begin(&project, &picture)?;
///     while let Some(stage) = solver.advance()? {
///         println!("{} is done: is there anything newer to solve?", stage.name());
///     }
/// }
/// assert_eq!(solver.solution().map(|solution| solution.sites().len() >= 3), Some(true));
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Default)]
pub struct Solver {
    kept: Option<Kept>,
    propagation: Propagation,
    work: Option<Work>,
    solved: Option<Solved>,
}

/// What does not depend on point handles.
#[derive(Debug)]
struct Kept {
    key: DomainKey,
    prepared: Arc<PreparedDomain>,
    cache: SamplingCache,
}

/// A solve in progress.
#[derive(Debug)]
struct Work {
    request: Request,
    progress: Progress,
}

/// What the stages so far have made that later ones need.
#[derive(Debug)]
enum Progress {
    /// The outline alone, which the solver keeps.
    Begun,
    Located(Rest),
    Sampled {
        rest: Rest,
        samples: Samples,
        coarse: CoarseSamples,
    },
    Divided {
        rest: Rest,
        samples: Samples,
        divided: Divided,
    },
}

/// The domain, divided into cells.
#[derive(Debug)]
struct Divided {
    sites: Vec<Site>,
    scores: Scores,
}

/// A solution, and what it is of.
#[derive(Debug)]
struct Solved {
    key: DomainKey,
    request: Request,
    solution: Solution,
}

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
    /// [`Error::TooManyCorners`]; or an error of [`Domain::new`](crate::domain::Domain::new).
    pub fn begin(&mut self, project: &Project, picture: &Picture<'_>) -> Result<(), Error> {
        self.work = None;
        check_picture(project.image.size(), picture)?;
        let request = Request::new(project)?;
        let key = DomainKey::of(project);
        if self.kept.as_ref().is_none_or(|kept| kept.key != key) {
            let prepared = Arc::new(PreparedDomain::new(project.domain.as_ref(), picture)?);
            self.kept = Some(Kept { key, prepared, cache: SamplingCache::default() });
        }
        self.work = Some(Work { request, progress: Progress::Begun });
        Ok(())
    }

    /// Runs the next stage of the solve and returns it; `None` when none is left.
    ///
    /// # Errors
    /// [`Error::HandleOutside`], [`Error::HandlesTooClose`], [`Error::OnHeldBoundary`], [`Error::BarTooShort`],
    /// [`Error::BarsOverlap`], [`Error::TooManySites`]. The solve is then over; the last solution stays.
    pub fn advance(&mut self) -> Result<Option<Stage>, Error> {
        let Self { kept: Some(Kept { key, prepared, cache }), propagation, work, solved } = self else {
            return Ok(None);
        };
        let Some(Work { request, progress }) = work.take() else { return Ok(None) };
        let (stage, progress) = match progress {
            Progress::Begun => (Stage::Domain, Progress::Located(request.rest(prepared)?)),
            Progress::Located(rest) => {
                let samples = samples(cache, prepared, &rest, &request);
                let coarse = coarse_samples(cache, prepared, &rest, &request);
                (Stage::Sampling, Progress::Sampled { rest, samples, coarse })
            }
            Progress::Sampled { rest, samples, coarse } => {
                let divided = divide(propagation, prepared, &coarse, &rest, &request)?;
                (Stage::Regions, Progress::Divided { rest, samples, divided })
            }
            Progress::Divided { rest, samples, divided } => {
                let solution = weigh(propagation, Arc::clone(prepared), &request, rest, samples, divided);
                *solved = Some(Solved { key: key.clone(), request, solution });
                return Ok(Some(Stage::Weights));
            }
        };
        *work = Some(Work { request, progress });
        Ok(Some(stage))
    }

    /// The last solution; `None` before the first solve has finished.
    #[must_use]
    pub fn solution(&self) -> Option<&Solution> {
        self.solved.as_ref().map(|solved| &solved.solution)
    }

    /// Whether the last solution is that of a project, apart from its pose and `image.src`.
    #[must_use]
    pub fn has_solved(&self, project: &Project) -> bool {
        self.solved.as_ref().is_some_and(|solved| {
            solved.key == DomainKey::of(project) && Request::new(project).is_ok_and(|other| other == solved.request)
        })
    }

    /// The last solution, by value.
    #[must_use]
    pub fn into_solution(self) -> Option<Solution> {
        self.solved.map(|solved| solved.solution)
    }
}

/// Samples of [`Stage::Sampling`].
fn samples(cache: &mut SamplingCache, prepared: &PreparedDomain, rest: &Rest, request: &Request) -> Samples {
    cache.fine(prepared, &rest.bones(), request.samples).with_sites(prepared, &rest.sites())
}

/// Coarse samples of [`Stage::Sampling`].
fn coarse_samples(
    cache: &mut SamplingCache,
    prepared: &PreparedDomain,
    rest: &Rest,
    request: &Request,
) -> CoarseSamples {
    let count = coarse_sample_count(request.samples, request.density);
    CoarseSamples::new(cache.coarse(prepared, &rest.bones(), count), prepared, &rest.sites())
}

/// The cells, of [`Stage::Regions`].
fn divide(
    propagation: &mut Propagation,
    prepared: &PreparedDomain,
    coarse: &CoarseSamples,
    rest: &Rest,
    request: &Request,
) -> Result<Divided, Error> {
    let (navigation, skeleton) = (&prepared.navigation, &rest.skeleton);
    let tracks = skeleton.bones.iter().map(|bone| Track::new(navigation, bone)).collect();
    let held = request.fix_boundary.then_some(&prepared.domain);
    let obstacles = Obstacles { skeleton, tracks, held };
    let mut regions = Regions::new(navigation, coarse, &obstacles, propagation);
    regions.insert_real_sites(&rest.points)?;
    let scores = insert_virtual_sites(&mut regions, request.density)?;
    regions.measure_cells();
    // Upper bounds of the radii: obstacles found while fields are extended only reduce them.
    for (site, radius) in support_radii(&request.weighting, &regions.sites).into_iter().enumerate() {
        regions.extend_field(site, radius);
    }
    Ok(Divided { sites: regions.sites, scores })
}

/// The weights and all that follows from them, of [`Stage::Weights`].
fn weigh(
    propagation: &mut Propagation,
    prepared: Arc<PreparedDomain>,
    request: &Request,
    rest: Rest,
    samples: Samples,
    divided: Divided,
) -> Solution {
    let Rest { skeleton, outside, .. } = rest;
    let Divided { mut sites, scores } = divided;
    let (navigation, weighting) = (&prepared.navigation, &request.weighting);
    for (radius, site) in support_radii(weighting, &sites).into_iter().zip(&mut sites) {
        site.support_radius = radius;
        let bound = radius.max(SiteGraph::field_bound(site.cell_radius));
        if site.field.bound() < bound {
            site.field = propagation.field(navigation, site.triangle, site.rest, bound);
        }
    }
    let basis = Basis::new(weighting.degree, weighting.filling);
    let functions = WeightFunctions::new(navigation, &sites, &skeleton, basis);
    let Swept { mut weights, sums: phi_sums, nearest } = functions.of_samples(navigation, &sites, &samples);
    let graph = SiteGraph::new(&sites, &skeleton);
    let harmonic = HarmonicFields::new(&sites, &graph);
    let quadrature =
        (request.mode == PoseMode::Rigid).then(|| Quadrature::new(navigation, &sites, &samples, &weights, &functions));
    let poser = Poser::new(PoserInput {
        sites: &sites,
        graph: &graph,
        harmonic: &harmonic,
        skeleton,
        handles: request.handles.clone(),
        mode: request.mode,
        quadrature,
    });
    let count = samples.len();
    let leading = leading_parts(&nearest, &sites, &harmonic);
    weights.extend_as(&samples.skirt.owners);
    let background = prepared.background_size.map(|size| StaticBackground::new(&samples, size)).unwrap_or_default();
    let mesh = RenderMesh::new(samples, &leading);
    Solution {
        mesh,
        background,
        weights,
        sites,
        graph,
        harmonic,
        poser,
        samples: count,
        nearest,
        phi_sums,
        scores,
        kinds: request.kinds(),
        outside,
        functions,
        prepared,
    }
}

/// Solves a project in one call.
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`].
pub fn solve(project: &Project, picture: &Picture<'_>) -> Result<Solution, Error> {
    let mut solver = Solver::new();
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    Ok(solver.into_solution().expect("every stage has run"))
}

/// Intrinsic distances in a project's domain, in pixels, from one point to others; `None` where no path leads. Handles are
/// ignored. Without a picture, or for one source after another, use [`Navigation`].
///
/// # Errors
/// [`Error::PictureMismatch`], an error of [`Domain::new`](crate::domain::Domain::new), or [`Error::PointOutside`] where the
/// first point lies outside the domain.
pub fn distances(
    project: &Project,
    picture: &Picture<'_>,
    from: DVec2,
    at: &[DVec2],
) -> Result<Vec<Option<f64>>, Error> {
    check_picture(project.image.size(), picture)?;
    let navigation = Navigation::new(&Domain::new(project.domain.as_ref(), picture)?);
    let distances = navigation.distances_from(from)?;
    Ok(at.iter().map(|&p| distances.to(p)).collect())
}

/// Solves a project in one call in a domain from the caller, without a picture.
///
/// The project's picture and domain are ignored. The solution draws any picture that the caller lays over the domain.
///
/// ```
/// use c2warp::{domain::Domain, glam::DVec2, project::{Handle, Project}, solve_domain};
///
/// let ring = [(-1.0, -1.0), (3.0, -1.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (-1.0, 3.0)];
/// let domain = Domain::from_rings(&[ring.map(|corner| 100.0 * DVec2::from(corner)).to_vec()])?;
/// // Of another size or none: the picture plays no part.
/// let mut project = Project::for_picture(1, 1);
/// project.handles = vec![Handle::point("right", [200.0, 0.0]), Handle::point("down", [0.0, 200.0])];
/// let solution = solve_domain(&project, &domain)?;
/// // The sites that move a point, with weights and their gradients.
/// let influences = solution.influences_at([50.0, 50.0].into()).unwrap();
/// let (sum, slope) = influences.iter().fold((0.0, DVec2::ZERO), |(w, g), one| (w + one.weight, g + one.gradient));
/// assert!((sum - 1.0).abs() < 1e-12 && slope.length() < 1e-12);
/// # Ok::<(), c2warp::Error>(())
/// ```
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings.
pub fn solve_domain(project: &Project, domain: &Domain) -> Result<Solution, Error> {
    let (request, prepared) = (Request::new(project)?, Arc::new(PreparedDomain::without_picture(domain.clone())));
    let rest = request.rest(&prepared)?;
    let mut cache = SamplingCache::default();
    let samples = samples(&mut cache, &prepared, &rest, &request);
    let coarse = coarse_samples(&mut cache, &prepared, &rest, &request);
    let mut propagation = Propagation::default();
    let divided = divide(&mut propagation, &prepared, &coarse, &rest, &request)?;
    Ok(weigh(&mut propagation, prepared, &request, rest, samples, divided))
}

/// Solves a project in one call on a mesh from the caller: its vertices are the samples, and the only vertices of the
/// solution's mesh, in the caller's order. Handles need not lie on vertices.
///
/// The project's picture and domain are ignored, and its number of samples is the upper limit for the coarse samples, on which cells
/// are located.
///
/// # Errors
/// Those of [`Solver::begin`] and [`Solver::advance`] that concern handles and settings.
pub fn solve_mesh(project: &Project, mesh: &InputMesh) -> Result<Solution, Error> {
    let (request, prepared) = (Request::new(project)?, Arc::clone(&mesh.prepared));
    let rest = request.rest(&prepared)?;
    let coarse = coarse_samples(&mut SamplingCache::default(), &prepared, &rest, &request);
    let mut propagation = Propagation::default();
    let divided = divide(&mut propagation, &prepared, &coarse, &rest, &request)?;
    Ok(weigh(&mut propagation, prepared, &request, rest, mesh.samples(), divided))
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
    CloudSolution::new(cloud, &rest.points, request)
}
