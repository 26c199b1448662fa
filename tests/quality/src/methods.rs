//! The methods, and their results for a pose.

use std::hint::black_box;

use c2warp::{
    Error,
    project::{Blend, Handle, PoseMode, Project, Support},
    solve,
};
use c2warp_bench::{
    clock::native_ms,
    measure::{Effort, min_ms},
};
use glam::DVec2;

use crate::{
    comparison_mesh::ComparisonMesh,
    constraints::Constraints,
    dense_arap::{DenseArap, pins},
    least_squares,
    measure::{Distortion, jacobians},
    optimum::Optimizer,
    poses::PosedScene,
};

/// Times are the minimum of some runs, as in the benchmark.
pub(crate) const EFFORT: Effort = Effort { warm_up_ms: 0.0, measured_ms: 20.0, min_runs: 3 };
/// The last frame of a drag, as a fraction of its way.
const FRAME: f64 = 0.01;

/// A method to pose a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The paper's method: harmonic motions, the paper's supports, and no additional virtual sites.
    ///
    /// Automatic rotations of point handles are left to the solver.
    Paper,
    /// The rigid mode with smooth supports.
    Rigid {
        /// The smallest number of virtual sites.
        density: u32,
        /// The blend of motions.
        blend: Blend,
    },
    /// As-rigid-as-possible over the whole mesh.
    Dense,
    /// Moving least squares.
    LeastSquares,
    /// The least energy on the mesh.
    Optimum,
}

/// The number of virtual sites that the editor asks for.
pub const EDITOR_DENSITY: u32 = 150;
/// The editor's method.
pub const EDITOR: Method = Method::Rigid { density: EDITOR_DENSITY, blend: Blend::Linear };

/// Further numbers of samples for the editor's method. The result must not depend on them.
pub const OTHER_SAMPLES: [u32; 5] = [4_000, 6_000, 10_000, 16_000, 31_325];

/// The methods for standard poses, in the order of tables and sheets.
pub const METHODS: [Method; 9] = [
    Method::Paper,
    Method::Rigid { density: 0, blend: Blend::Linear },
    Method::Rigid { density: 30, blend: Blend::Linear },
    Method::Rigid { density: 60, blend: Blend::Linear },
    EDITOR,
    Method::Rigid { density: 200, blend: Blend::Linear },
    Method::Rigid { density: EDITOR_DENSITY, blend: Blend::Rigid },
    Method::Dense,
    Method::LeastSquares,
];

/// The methods for the poses that are compared with the optimum.
pub const METHODS_BESIDE_OPTIMUM: [Method; 6] = [
    EDITOR,
    Method::Rigid { density: 200, blend: Blend::Linear },
    Method::Rigid { density: 400, blend: Blend::Linear },
    Method::Dense,
    Method::LeastSquares,
    Method::Optimum,
];

impl Method {
    /// Returns the name in tables and sheets.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Paper => "paper".into(),
            Self::Rigid { density, blend: Blend::Rigid } => format!("rigid {density}, rigid blend"),
            Self::Rigid { density, .. } => format!("rigid {density}"),
            Self::Dense => "dense".into(),
            Self::LeastSquares => "least squares".into(),
            Self::Optimum => "optimum".into(),
        }
    }
}

/// The result of a method for a pose.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The method.
    pub method: Method,
    /// Posed positions of the vertices of the common mesh.
    pub posed: Vec<DVec2>,
    /// The distortion.
    pub distortion: Distortion,
    /// The largest distance of a handle from its posed position, in pixels.
    pub handle_error: f64,
    /// The number of virtual sites, for the modes of the solver.
    pub virtual_sites: Option<usize>,
    /// Rest and posed positions of the sites.
    pub sites: Vec<(DVec2, DVec2)>,
    /// Time for the motions of the sites without a frame before, in milliseconds.
    pub pose_ms: Option<f64>,
    /// Time from posed handles to posed vertices, in milliseconds. Modes of the solver follow a frame before.
    pub frame_ms: f64,
    /// Iterations of the reference, and the time until its energy is within 1 % of the final energy, in milliseconds.
    pub iterations: Option<(usize, f64)>,
}

/// The results of all methods for one pose.
#[derive(Debug)]
pub struct Comparison {
    /// The picture and its handles.
    pub scene: PosedScene,
    /// The constraints of the pose.
    pub constraints: Constraints,
    /// The common mesh.
    pub mesh: ComparisonMesh,
    /// Results in the order of the methods.
    pub outcomes: Vec<Outcome>,
    /// Methods that failed, with the reason.
    pub failed: Vec<(Method, String)>,
    /// Distortions by [`EDITOR`] with other numbers of samples.
    pub with_other_samples: Vec<Distortion>,
}

impl Comparison {
    /// Runs methods on a pose, and the editor's method with other numbers of samples.
    ///
    /// # Errors
    /// If the scene cannot be solved.
    pub fn of(scene: PosedScene, methods: &[Method], other_samples: &[u32]) -> Result<Self, Error> {
        let mut meshed = scene.project.clone();
        meshed.samples = scene.mesh_samples;
        let mesh = ComparisonMesh::of(&solve(&meshed, &scene.solver_picture())?);
        let constraints = Constraints::of(&scene.project);
        let mut comparison =
            Self { scene, constraints, mesh, outcomes: Vec::new(), failed: Vec::new(), with_other_samples: Vec::new() };
        for &method in methods {
            let outcome = match method {
                Method::Paper => comparison.by_solver(method, PoseMode::Harmonic, Support::Paper, Blend::Linear, 0),
                Method::Rigid { density, blend } => {
                    comparison.by_solver(method, PoseMode::Rigid, Support::Smooth, blend, density)
                }
                Method::Dense => Ok(comparison.by_dense()),
                Method::LeastSquares => Ok(comparison.by_least_squares()),
                Method::Optimum => match comparison.by_optimum() {
                    Some(outcome) => Ok(outcome),
                    None => {
                        comparison.failed.push((method, "no way to the pose without a fold was found".into()));
                        continue;
                    }
                },
            };
            match outcome {
                Ok(outcome) => comparison.outcomes.push(outcome),
                Err(reason) => comparison.failed.push((method, reason.to_string())),
            }
        }
        comparison.with_other_samples =
            other_samples.iter().map(|&count| comparison.with_samples(count)).collect::<Result<_, _>>()?;
        Ok(comparison)
    }

    /// Returns whether the pose is compared with the optimum, found or not.
    #[must_use]
    pub fn is_beside_optimum(&self) -> bool {
        let tried = self.outcomes.iter().map(|outcome| outcome.method);
        tried.chain(self.failed.iter().map(|&(method, _)| method)).any(|method| method == Method::Optimum)
    }

    /// Returns the result of a method, or `None` if it failed.
    #[must_use]
    pub fn outcome_of(&self, method: Method) -> Option<&Outcome> {
        self.outcomes.iter().find(|outcome| outcome.method == method)
    }

    /// Returns a measure of the editor's result over that of dense, or `None` if one of them failed.
    #[must_use]
    pub fn over_dense(&self, of: fn(&Distortion) -> f64) -> Option<f64> {
        let [editor, dense] = [self.outcome_of(EDITOR)?, self.outcome_of(Method::Dense)?];
        Some(of(&editor.distortion) / of(&dense.distortion))
    }

    fn by_solver(
        &self,
        method: Method,
        mode: PoseMode,
        support: Support,
        blend: Blend,
        density: u32,
    ) -> Result<Outcome, Error> {
        let project = self.with_settings(mode, support, blend, density);
        let solution = solve(&project, &self.scene.solver_picture())?;
        let pose = solution.poser().pose(&project.handles, project.pose.blend)?;
        // All modes have the same samples, except those that a solve adds.
        let same = solution.vertices().get(..self.mesh.vertices.len()) == Some(&self.mesh.vertices[..]);
        let map = |p: DVec2| solution.map(&pose, p).map_or(p, |mapped| mapped.posed);
        let posed = match same {
            true => solution.posed_vertices(&pose)[..self.mesh.vertices.len()].to_vec(),
            false => self.mesh.vertices.iter().map(|&p| map(p)).collect(),
        };
        let site = |(at, site): (usize, &c2warp::site::Site)| (site.rest, pose.moved(at, site.rest));
        let before = handles_before(&project.handles);
        // The same pose again would not be computed.
        let pose_both =
            || [&before, &project.handles].map(|handles| solution.poser().pose(handles, project.pose.blend));
        let pose_ms = ms_of(pose_both) / 2.0;
        let before = solution.poser().pose(&before, project.pose.blend)?;
        let next = || solution.poser().follow(&before, &project.handles);
        let frame_ms = ms_of(|| next().map(|pose| solution.posed_vertices(&pose)));
        Ok(Outcome {
            method,
            distortion: Distortion::of(&self.mesh, &posed),
            handle_error: self.handle_error(&posed, map),
            virtual_sites: Some(solution.sites().iter().filter(|site| !site.kind.is_real()).count()),
            sites: solution.sites().iter().enumerate().map(site).collect(),
            pose_ms: Some(pose_ms),
            frame_ms,
            iterations: None,
            posed,
        })
    }

    /// Measures the editor's method with `count` samples, on the mesh over them.
    fn with_samples(&self, count: u32) -> Result<Distortion, Error> {
        let mut project = self.with_editor_settings();
        project.samples = count;
        let solution = solve(&project, &self.scene.solver_picture())?;
        let pose = solution.poser().pose(&project.handles, project.pose.blend)?;
        let mesh = ComparisonMesh::of(&solution);
        Ok(Distortion::of(&mesh, &solution.posed_vertices(&pose)[..mesh.vertices.len()]))
    }

    /// Returns the project with the settings of [`EDITOR`].
    fn with_editor_settings(&self) -> Project {
        let Method::Rigid { density, blend } = EDITOR else { unreachable!("the editor is rigid") };
        self.with_settings(PoseMode::Rigid, Support::Smooth, blend, density)
    }

    /// Returns the project with other settings.
    fn with_settings(&self, mode: PoseMode, support: Support, blend: Blend, density: u32) -> Project {
        let mut project = self.scene.project.clone();
        project.weighting.support = support;
        (project.pose.mode, project.pose.blend, project.pose.density) = (mode, blend, density);
        project
    }

    fn by_dense(&self) -> Outcome {
        let pins = pins(&self.mesh, &self.constraints);
        let dense = DenseArap::new(&self.mesh, &pins);
        let minimize = || dense.minimize(&dense.harmonic(&pins));
        let frame_ms = ms_of(minimize);
        let first = minimize();
        // There may be a lower minimum near the result of a mode. The reference is the lowest one found.
        let others = self.outcomes.iter().map(|outcome| {
            let pinned = outcome.posed.iter().zip(&pins).map(|(&posed, pin)| pin.unwrap_or(posed));
            dense.minimize(&pinned.collect::<Vec<_>>())
        });
        let by_harmonic = first.clone();
        let best = others.fold(first, |best, other| if other.energy < 0.999 * best.energy { other } else { best });
        if best.energy < by_harmonic.energy {
            let (found, harmonic) = (best.energy, by_harmonic.energy);
            eprintln!("    dense: energy {found:.0} from another start, {harmonic:.0} from the harmonic start");
        }
        let near = by_harmonic.descent.iter().position(|&energy| energy <= 1.01 * by_harmonic.energy);
        let near = near.map_or(0.0, |iteration| frame_ms * (iteration + 1) as f64 / by_harmonic.iterations as f64);
        let iterations = Some((by_harmonic.iterations, near));
        Outcome { iterations, ..self.outcome(Method::Dense, best.posed, frame_ms) }
    }

    /// The least minimum near the results so far, and at the end of a path from rest.
    fn by_optimum(&self) -> Option<Outcome> {
        let pins = pins(&self.mesh, &self.constraints);
        let began = native_ms();
        let starts: Vec<&[DVec2]> = self.outcomes.iter().map(|outcome| &outcome.posed[..]).collect();
        let posed = Optimizer::new(&self.mesh, &pins).lowest(&starts)?.posed;
        let frame_ms = native_ms() - began;
        Some(self.outcome(Method::Optimum, posed, frame_ms))
    }

    fn by_least_squares(&self) -> Outcome {
        let mut constraints = self.constraints.clone();
        if constraints.outline_held {
            constraints.points.extend(self.outline().map(|p| (p, p)));
        }
        let spacing = (self.mesh.areas.iter().sum::<f64>() / self.mesh.vertices.len() as f64).sqrt();
        let map = |p| least_squares::posed_point(&constraints, spacing, p);
        let all = || self.mesh.vertices.iter().map(|&p| map(p)).collect::<Vec<_>>();
        let posed = all();
        let handle_error = self.handle_error(&posed, map);
        Outcome { handle_error, ..self.outcome(Method::LeastSquares, posed, ms_of(all)) }
    }

    /// The result of a method that has no sites: a map that is linear in each triangle.
    fn outcome(&self, method: Method, posed: Vec<DVec2>, frame_ms: f64) -> Outcome {
        let map = |p| self.mesh.interpolated(&posed, p).unwrap_or(p);
        Outcome {
            method,
            distortion: Distortion::of(&self.mesh, &posed),
            handle_error: self.handle_error(&posed, map),
            virtual_sites: None,
            sites: Vec::new(),
            pose_ms: None,
            frame_ms,
            iterations: None,
            posed,
        }
    }

    /// Returns the number of flipped triangles that are farther than three of their sides from every handle.
    #[must_use]
    pub fn folds_away_from_handles(&self, outcome: &Outcome) -> usize {
        let jacobians = jacobians(&self.mesh, &outcome.posed);
        let is_away = |&t: &usize| {
            let corners = self.mesh.corners(t, &self.mesh.vertices);
            let side = corners[0].distance(corners[1]);
            let is_far = |distance: f64| distance > 3.0 * side;
            self.constraints.points.iter().all(|(rest, _)| is_far(rest.distance(corners[0])))
                && self.constraints.segments.iter().all(|segment| is_far(segment.nearest(corners[0]).1))
        };
        (0..jacobians.len()).filter(|&t| jacobians[t].determinant() < 0.0).filter(is_away).count()
    }

    /// Returns the vertices on the outline.
    fn outline(&self) -> impl Iterator<Item = DVec2> + '_ {
        let on = self.mesh.on_outline();
        self.mesh.vertices.iter().zip(on).filter(|(_, on)| *on).map(|(&p, _)| p)
    }

    /// Returns the largest distance of a constrained point from its posed position.
    fn handle_error(&self, posed: &[DVec2], map: impl Fn(DVec2) -> DVec2) -> f64 {
        let points = self.constraints.check_points();
        let error = points.iter().map(|&(rest, to)| map(rest).distance(to)).fold(0.0, f64::max);
        let on_outline = self.mesh.on_outline();
        let outline = (0..posed.len()).filter(|&v| self.constraints.outline_held && on_outline[v]);
        outline.map(|v| posed[v].distance(self.mesh.vertices[v])).fold(error, f64::max)
    }
}

/// Returns handles as in the last frame but one of a drag.
fn handles_before(handles: &[Handle]) -> Vec<Handle> {
    let mut handles = handles.to_vec();
    for handle in &mut handles {
        let rest = handle.shape.rest().to_vec();
        for (posed, rest) in handle.shape.posed_mut().iter_mut().zip(rest) {
            *posed = posed.lerp(rest, FRAME);
        }
    }
    handles
}

/// Returns the minimum time of some runs.
fn ms_of<T>(run: impl Fn() -> T) -> f64 {
    min_ms(native_ms, EFFORT, || {
        black_box(run());
    })
}
