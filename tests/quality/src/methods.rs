//! The methods, and what each makes of a pose.

use std::hint::black_box;

use c2warp::{
    Error,
    project::{Blend, PoseMode, Project, Support},
    solve,
};
use c2warp_bench::{
    clock::native_ms,
    measure::{Effort, least_ms},
};
use glam::DVec2;

use crate::{
    dense::{Dense, pins},
    fine::Fine,
    least_squares,
    measure::{Distortion, jacobians},
    poses::StandardPose,
    targets::Targets,
};

/// Times are the least of some runs, as the benchmark's are.
const EFFORT: Effort = Effort { warm_up_ms: 0.0, measured_ms: 20.0, least_runs: 3 };

/// A way to pose a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The paper's: harmonic motions, the paper's supports, no more virtual sites than it needs. Rotations of point handles are
    /// left to the solver where the pose leaves them.
    Paper,
    /// The rigid mode with smooth supports and at least so many virtual sites.
    Rigid {
        /// Virtual sites at least.
        density: u32,
        /// How motions are blended.
        blend: Blend,
    },
    /// As rigid as possible over the whole mesh.
    Dense,
    /// Moving least squares.
    LeastSquares,
}

/// Virtual sites that the editor asks for.
pub const EDITOR_DENSITY: u32 = 100;
/// What the editor asks for.
pub const EDITOR: Method = Method::Rigid { density: EDITOR_DENSITY, blend: Blend::Linear };

/// Numbers of samples that the editor's way is tried with besides: what comes out must not hang on one of them.
pub const OTHER_SAMPLES: [u32; 5] = [4_000, 6_000, 10_000, 16_000, 31_325];

/// In the order of tables and sheets.
pub const METHODS: [Method; 9] = [
    Method::Paper,
    Method::Rigid { density: 0, blend: Blend::Linear },
    Method::Rigid { density: 30, blend: Blend::Linear },
    Method::Rigid { density: 60, blend: Blend::Linear },
    EDITOR,
    Method::Rigid { density: 200, blend: Blend::Linear },
    Method::Rigid { density: 100, blend: Blend::Rigid },
    Method::Dense,
    Method::LeastSquares,
];

impl Method {
    /// What tables and sheets call it.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Paper => "paper".into(),
            Self::Rigid { density, blend: Blend::Rigid } => format!("rigid {density}, rigid blend"),
            Self::Rigid { density, .. } => format!("rigid {density}"),
            Self::Dense => "dense".into(),
            Self::LeastSquares => "least squares".into(),
        }
    }
}

/// What a method made of a pose.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The method.
    pub method: Method,
    /// Where the vertices of the common mesh went.
    pub posed: Vec<DVec2>,
    /// Figures of it.
    pub distortion: Distortion,
    /// How far a handle is from where it should be, at worst, in pixels.
    pub off_handles: f64,
    /// Virtual sites, of the modes of the solver.
    pub virtual_sites: Option<usize>,
    /// Where the sites rest and go.
    pub sites: Vec<(DVec2, DVec2)>,
    /// Milliseconds for the motions of the sites.
    pub pose_ms: Option<f64>,
    /// Milliseconds from posed handles to posed vertices.
    pub frame_ms: f64,
    /// Turns of the reference, and the milliseconds until its energy is within 1 % of where it ends.
    pub turns: Option<(usize, f64)>,
}

/// A pose by every method that can do it.
#[derive(Debug)]
pub struct Compared {
    /// The pose.
    pub pose: StandardPose,
    /// What is demanded.
    pub targets: Targets,
    /// The common mesh.
    pub fine: Fine,
    /// In the order of [`METHODS`].
    pub outcomes: Vec<Outcome>,
    /// Methods that cannot do it, and why.
    pub refused: Vec<(Method, String)>,
    /// What [`EDITOR`] makes of it with each of [`OTHER_SAMPLES`].
    pub others: Vec<Distortion>,
}

impl Compared {
    /// Runs every method on a pose.
    ///
    /// # Errors
    /// Where the pose itself cannot be solved by the paper's method: then there is no mesh to compare on.
    pub fn of(pose: StandardPose) -> Result<Self, Error> {
        let picture = pose.solver_picture();
        let fine = Fine::of(&solve(&pose.project, &picture)?);
        let targets = Targets::of(&pose.project);
        let mut compared = Self { pose, targets, fine, outcomes: Vec::new(), refused: Vec::new(), others: Vec::new() };
        for method in METHODS {
            let outcome = match method {
                Method::Paper => compared.by_solver(method, PoseMode::Harmonic, Support::Paper, Blend::Linear, 0),
                Method::Rigid { density, blend } => {
                    compared.by_solver(method, PoseMode::Rigid, Support::Smooth, blend, density)
                }
                Method::Dense => Ok(compared.by_dense()),
                Method::LeastSquares => Ok(compared.by_least_squares()),
            };
            match outcome {
                Ok(outcome) => compared.outcomes.push(outcome),
                Err(reason) => compared.refused.push((method, reason.to_string())),
            }
        }
        compared.others =
            OTHER_SAMPLES.into_iter().map(|count| compared.with_samples(count)).collect::<Result<_, _>>()?;
        Ok(compared)
    }

    /// What one method made of it.
    #[must_use]
    pub fn by(&self, method: Method) -> Option<&Outcome> {
        self.outcomes.iter().find(|outcome| outcome.method == method)
    }

    fn by_solver(
        &self,
        method: Method,
        mode: PoseMode,
        support: Support,
        blend: Blend,
        density: u32,
    ) -> Result<Outcome, Error> {
        let project = self.asking(mode, support, blend, density);
        let solution = solve(&project, &self.pose.solver_picture())?;
        let pose = solution.poser().pose(&project.handles, project.pose.blend)?;
        // The same samples whatever the mode, but for those that a solve adds.
        let same = solution.vertices().get(..self.fine.vertices.len()) == Some(&self.fine.vertices[..]);
        let map = |p: DVec2| solution.map(&pose, p).map_or(p, |mapped| mapped.posed);
        let posed = match same {
            true => solution.posed_vertices(&pose)[..self.fine.vertices.len()].to_vec(),
            false => self.fine.vertices.iter().map(|&p| map(p)).collect(),
        };
        let site = |(at, site): (usize, &c2warp::site::Site)| (site.rest, pose.moved(at, site.rest));
        let posed_again = || solution.poser().pose(&project.handles, project.pose.blend);
        let pose_ms = ms_of(posed_again);
        let frame_ms = ms_of(|| posed_again().map(|pose| solution.posed_vertices(&pose)));
        Ok(Outcome {
            method,
            distortion: Distortion::of(&self.fine, &posed),
            off_handles: self.off_handles(&posed, map),
            virtual_sites: Some(solution.sites().iter().filter(|site| !site.kind.is_real()).count()),
            sites: solution.sites().iter().enumerate().map(site).collect(),
            pose_ms: Some(pose_ms),
            frame_ms,
            turns: None,
            posed,
        })
    }

    /// The editor's way with so many samples, on the mesh over them.
    fn with_samples(&self, count: u32) -> Result<Distortion, Error> {
        let Method::Rigid { density, blend } = EDITOR else { unreachable!("the editor is rigid") };
        let mut project = self.asking(PoseMode::Rigid, Support::Smooth, blend, density);
        project.samples = count;
        let solution = solve(&project, &self.pose.solver_picture())?;
        let pose = solution.poser().pose(&project.handles, blend)?;
        let fine = Fine::of(&solution);
        Ok(Distortion::of(&fine, &solution.posed_vertices(&pose)[..fine.vertices.len()]))
    }

    /// The pose's project with other settings.
    fn asking(&self, mode: PoseMode, support: Support, blend: Blend, density: u32) -> Project {
        let mut project = self.pose.project.clone();
        project.weighting.support = support;
        (project.pose.mode, project.pose.blend, project.pose.density) = (mode, blend, density);
        project
    }

    fn by_dense(&self) -> Outcome {
        let pins = pins(&self.fine, &self.targets);
        let dense = Dense::new(&self.fine, &pins);
        let settle = || dense.settled(&dense.harmonic(&pins));
        let frame_ms = ms_of(settle);
        let first = settle();
        // There may be a lower minimum near where a mode of the solver ends: the reference is the lowest that was found.
        let others = self.outcomes.iter().map(|outcome| {
            let pinned = outcome.posed.iter().zip(&pins).map(|(&posed, pin)| pin.unwrap_or(posed));
            dense.settled(&pinned.collect::<Vec<_>>())
        });
        let by_harmonic = first.clone();
        let best = others.fold(first, |best, other| if other.energy < 0.999 * best.energy { other } else { best });
        if best.energy < by_harmonic.energy {
            let (found, harmonic) = (best.energy, by_harmonic.energy);
            eprintln!("    dense: {found:.0} from another start, {harmonic:.0} from the harmonic one");
        }
        let near = by_harmonic.descent.iter().position(|&energy| energy <= 1.01 * by_harmonic.energy);
        let near = near.map_or(0.0, |turn| frame_ms * (turn + 1) as f64 / by_harmonic.turns as f64);
        let map = |p| self.fine.interpolated(&best.posed, p).unwrap_or(p);
        Outcome {
            method: Method::Dense,
            distortion: Distortion::of(&self.fine, &best.posed),
            off_handles: self.off_handles(&best.posed, map),
            virtual_sites: None,
            sites: Vec::new(),
            pose_ms: None,
            frame_ms,
            turns: Some((by_harmonic.turns, near)),
            posed: best.posed,
        }
    }

    fn by_least_squares(&self) -> Outcome {
        let mut targets = self.targets.clone();
        if targets.outline_held {
            targets.points.extend(self.outline().map(|p| (p, p)));
        }
        let spacing = (self.fine.areas.iter().sum::<f64>() / self.fine.vertices.len() as f64).sqrt();
        let map = |p| least_squares::moved(&targets, spacing, p);
        let all = || self.fine.vertices.iter().map(|&p| map(p)).collect::<Vec<_>>();
        let posed = all();
        Outcome {
            method: Method::LeastSquares,
            distortion: Distortion::of(&self.fine, &posed),
            off_handles: self.off_handles(&posed, map),
            virtual_sites: None,
            sites: Vec::new(),
            pose_ms: None,
            frame_ms: ms_of(all),
            turns: None,
            posed,
        }
    }

    /// Triangles that are turned over and lie farther than three of their sides from every handle.
    #[must_use]
    pub fn folds_away_from_handles(&self, outcome: &Outcome) -> usize {
        let jacobians = jacobians(&self.fine, &outcome.posed);
        let is_away = |&t: &usize| {
            let corners = self.fine.corners(t, &self.fine.vertices);
            let side = corners[0].distance(corners[1]);
            let is_far = |distance: f64| distance > 3.0 * side;
            self.targets.points.iter().all(|(rest, _)| is_far(rest.distance(corners[0])))
                && self.targets.pieces.iter().all(|piece| is_far(piece.nearest(corners[0]).1))
        };
        (0..jacobians.len()).filter(|&t| jacobians[t].determinant() < 0.0).filter(is_away).count()
    }

    fn outline(&self) -> impl Iterator<Item = DVec2> + '_ {
        let on = self.fine.on_outline();
        self.fine.vertices.iter().zip(on).filter(|(_, on)| *on).map(|(&p, _)| p)
    }

    /// How far the places that handles demand are from where they should be, at worst.
    fn off_handles(&self, posed: &[DVec2], map: impl Fn(DVec2) -> DVec2) -> f64 {
        let places = self.targets.places();
        let off = places.iter().map(|&(rest, to)| map(rest).distance(to)).fold(0.0, f64::max);
        let on_outline = self.fine.on_outline();
        let outline = (0..posed.len()).filter(|&v| self.targets.outline_held && on_outline[v]);
        outline.map(|v| posed[v].distance(self.fine.vertices[v])).fold(off, f64::max)
    }
}

/// The least time of some runs.
fn ms_of<T>(run: impl Fn() -> T) -> f64 {
    least_ms(native_ms, EFFORT, || {
        black_box(run());
    })
}
