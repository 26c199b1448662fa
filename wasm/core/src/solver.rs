//! Solves a project stage by stage, and caches results that do not depend on point handles for the next solve.
//!
//! Cost: see `pipeline`. A solve that only changes point handles reuses the outline and the base samples.

use std::sync::Arc;

use crate::{
    distance::Propagation,
    error::Error,
    picture::Picture,
    pipeline,
    prepared_domain::{DomainKey, PreparedDomain},
    project::Project,
    sample::{CoarseSamples, Samples, SamplingCache},
    site::Partition,
    solution::Solution,
    solve_input::{LocatedHandles, SolveInput, check_picture},
    stage::Stage,
};

/// Solves projects of one picture, stage by stage.
///
/// It caches results that do not depend on point handles for the next solve: the outline, and the samples without
/// handles.
///
/// A picture is identified by its size. For another picture of the same size, create a new solver.
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
///         println!("{} is done: a newer project may be solved instead", stage.name());
///     }
/// }
/// assert_eq!(solver.solution().map(|solution| solution.sites().len() >= 3), Some(true));
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Default)]
pub struct Solver {
    domain: Option<DomainCache>,
    propagation: Propagation,
    #[cfg(feature = "raster")]
    pub(crate) fill: crate::kept_fill::KeptFill,
    pending: Option<PendingSolve>,
    pub(crate) finished: Option<FinishedSolve>,
}

/// The parts of a solve that do not depend on point handles.
#[derive(Debug)]
struct DomainCache {
    key: DomainKey,
    prepared: Arc<PreparedDomain>,
    sampling: SamplingCache,
}

/// A solve in progress.
#[derive(Debug)]
struct PendingSolve {
    input: SolveInput,
    progress: Progress,
}

/// Results of the last stage that later ones need.
#[derive(Debug)]
enum Progress {
    /// The outline, cached by the solver.
    Begun,
    /// The last solution differs only in stiffness and displacement.
    Solved,
    Located(LocatedHandles),
    Sampled {
        located: LocatedHandles,
        samples: Samples,
        coarse: CoarseSamples,
    },
    Partitioned {
        located: LocatedHandles,
        samples: Samples,
        partition: Partition,
    },
}

/// A solution with its input.
#[derive(Debug)]
pub(crate) struct FinishedSolve {
    pub(crate) key: DomainKey,
    input: SolveInput,
    pub(crate) solution: Arc<Solution>,
}

impl Solver {
    /// A solver without a solution.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins a solve and drops one in progress. All pictures of one size that are passed to a solver must be the same.
    ///
    /// Finds the outline unless it is cached from the last solve. The first call of [`advance`](Self::advance) then
    /// checks the handles and returns [`Stage::Domain`].
    ///
    /// # Errors
    /// - [`Error::PictureMismatch`].
    /// - [`Error::Project`] if [`Project::check`] fails.
    /// - [`Error::TooManyHandles`], [`Error::TooManyCorners`].
    /// - [`Error::PoseNotFinite`] for a pose that no solution accepts.
    /// - The errors of [`Domain::new`](crate::domain::Domain::new).
    pub fn begin(&mut self, project: &Project, picture: &Picture<'_>) -> Result<(), Error> {
        self.pending = None;
        check_picture(project.image.size(), picture)?;
        let input = SolveInput::new(project)?;
        let key = DomainKey::of(project);
        if self.domain.as_ref().is_none_or(|known| known.key != key) {
            let prepared = Arc::new(PreparedDomain::new(project, picture)?);
            self.domain = Some(DomainCache { key, prepared, sampling: SamplingCache::default() });
        }
        #[cfg(feature = "raster")]
        self.begin_fill(project);
        let domain = self.domain.as_ref().map(|domain| &domain.key);
        let known = self.finished.as_ref().filter(|finished| Some(&finished.key) == domain);
        let is_solved = known.is_some_and(|known| known.input.differs_only_in_poser(&input));
        let progress = if is_solved { Progress::Solved } else { Progress::Begun };
        self.pending = Some(PendingSolve { input, progress });
        Ok(())
    }

    /// Runs the next stage of the solve and returns it; `None` after the last stage. If only stiffness or displacement
    /// has changed since the last solution, only the last stage runs.
    ///
    /// # Errors
    /// [`Error::OutlineTooLong`], [`Error::HandleOutside`], [`Error::HandlesTooClose`], [`Error::HandlesCrowded`],
    /// [`Error::OnHeldBoundary`], [`Error::BarTooShort`], [`Error::BarsOverlap`], [`Error::HeldTooFine`],
    /// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`]. An error ends the solve; the last
    /// solution remains.
    pub fn advance(&mut self) -> Result<Option<Stage>, Error> {
        let Self { domain: Some(DomainCache { key, prepared, sampling }), propagation, pending, finished, .. } = self
        else {
            return Ok(None);
        };
        let Some(PendingSolve { input, progress }) = pending.take() else { return Ok(None) };
        let (stage, progress) = match progress {
            Progress::Solved => {
                let finished = finished.as_mut().expect("a finished solve has a solution");
                let solution = Arc::make_mut(&mut finished.solution);
                let poser = &mut solution.solved.poser;
                if finished.input.stiffness != input.stiffness {
                    poser.set_stiffness(input.stiffness.clone());
                }
                poser.set_displacement(input.displacement.clone());
                finished.input = input;
                return Ok(Some(Stage::Weights));
            }
            Progress::Begun => (Stage::Domain, Progress::Located(input.locate(prepared)?)),
            Progress::Located(located) => {
                let (samples, coarse) = pipeline::sample(sampling, prepared, &located, &input);
                (Stage::Sampling, Progress::Sampled { located, samples, coarse })
            }
            Progress::Sampled { located, samples, coarse } => {
                let partition = pipeline::partition(propagation, prepared, &coarse, &located, &input)?;
                (Stage::Regions, Progress::Partitioned { located, samples, partition })
            }
            Progress::Partitioned { located, samples, partition } => {
                let prepared = Arc::clone(prepared);
                let solution = pipeline::compute_weights(propagation, prepared, &input, located, samples, partition)?;
                #[cfg(feature = "raster")]
                let solution = Solution { fill: self.fill.behind(key), ..solution };
                *finished = Some(FinishedSolve { key: key.clone(), input, solution: Arc::new(solution) });
                return Ok(Some(Stage::Weights));
            }
        };
        *pending = Some(PendingSolve { input, progress });
        Ok(Some(stage))
    }

    /// The last solution; `None` before the first solve has finished.
    #[must_use]
    pub fn solution(&self) -> Option<&Solution> {
        self.finished.as_ref().map(|finished| &*finished.solution)
    }

    /// The last solution, shared so that it can be kept during other solves.
    #[must_use]
    pub fn shared_solution(&self) -> Option<Arc<Solution>> {
        self.finished.as_ref().map(|finished| Arc::clone(&finished.solution))
    }

    /// Whether the last solution belongs to a project, apart from its pose and `image.src`.
    #[must_use]
    pub fn has_solved(&self, project: &Project) -> bool {
        self.finished.as_ref().is_some_and(|finished| {
            finished.key == DomainKey::of(project)
                && SolveInput::new(project).is_ok_and(|input| input == finished.input)
        })
    }

    /// The last solution, by value.
    #[must_use]
    pub fn into_solution(self) -> Option<Solution> {
        self.finished.map(|finished| Arc::unwrap_or_clone(finished.solution))
    }
}
