//! Runs all cases.

use std::hint::black_box;

use c2warp::{
    Error, Picture, Solution, Solver, StageTimes,
    distance::{Located, graph::Graph},
    project::{PoseMode, Project, Shape},
    solve as solve_once,
};
use glam::DVec2;

use crate::{
    cases::{Case, TABLE_1, TABLE_2, gingerbread, knee_handle, raised_hand, spread, table_1},
    clock::Clock,
    drag::{DragTimes, exceeded_by, first_pose, follow},
    measure::{Effort, min_ms, minimum, repeat},
    results::{Baseline, Evaluation, Solve, Timings},
};

/// The number of samples of the small solve, whose weights are also evaluated on a finer mesh.
pub const SMALL: u32 = 10_000;
/// The number of virtual sites of the case with many sites.
pub const MANY_SITES: u32 = 60;
/// The number of virtual sites that the editor asks for.
pub const EDITOR_SITES: u32 = 150;
/// Frames of a drag in each direction.
const DRAG_FRAMES: f64 = 100.0;
/// The smallest number of samples of a project.
const MIN_SAMPLES: u32 = 100;

/// The clock, effort and size of the cases.
#[derive(Debug, Clone, Copy)]
pub struct Suite {
    /// The clock.
    pub clock: Clock,
    /// The effort for each measurement.
    pub effort: Effort,
    /// Fraction of the samples and points of each case: 1, or less for a test.
    pub fraction: f64,
}

/// Milliseconds of one solve.
#[derive(Debug, Clone, Copy, Default)]
struct Times {
    stages: StageTimes,
    total: f64,
}

impl Suite {
    /// Returns the suite for published results.
    #[must_use]
    pub fn full(clock: Clock) -> Self {
        Self { clock, effort: Effort::FULL, fraction: 1.0 }
    }

    /// Runs all cases. Calls `on_case` with the name of each case before it runs.
    ///
    /// # Errors
    /// If a case cannot be solved.
    pub fn timings(&self, mut on_case: impl FnMut(&str)) -> Result<Timings, Error> {
        let mut scenes = Vec::new();
        for (case, paper) in table_1().iter().zip(TABLE_1) {
            on_case(paper.name);
            let project = case.project(self.count(paper.samples), paper.virtual_sites);
            scenes.push(self.solved(case, &project)?.0);
        }
        let figure = gingerbread();
        let project = |samples: u32, virtual_sites| figure.project(self.count(samples), virtual_sites);
        let [coarse, middle, fine] = TABLE_2.map(|row| project(row.samples, 0));
        on_case("Gingerbread figure at three resolutions");
        let coarse_solve = self.solved(&figure, &coarse)?.0;
        let (middle_solve, middle_solution) = self.solved(&figure, &middle)?;
        let (fine_solve, fine_solution) = self.solved(&figure, &fine)?;
        on_case("First solves");
        let [first_coarse, first_middle, first_fine] = [&coarse, &middle, &fine].map(|p| self.first(&figure, p));
        let first_small = self.first(&figure, &project(SMALL, EDITOR_SITES));
        let first = [first_coarse?, first_middle?, first_fine?, first_small?];
        on_case("Evaluation at every vertex");
        let vertices = &fine_solution.vertices()[..fine_solution.samples()];
        let (small, small_solution) = self.solved(&figure, &project(SMALL, 0))?;
        let fine_evaluation_ms = self.evaluation(&small_solution, vertices, Solution::weights_at);
        on_case("Distances");
        let baseline = self.baseline(&middle_solution, &middle);
        on_case("Many virtual sites, and evaluation");
        let (many_sites, many_sites_solution) = self.solved(&figure, &project(TABLE_2[1].samples, MANY_SITES))?;
        let evaluation = self.evaluations(&many_sites_solution, &figure);
        on_case("One more handle");
        let insertion = self.insertion(&figure, &middle)?;
        on_case("A drag in the rigid mode");
        let drag = self.drag(&figure, project(SMALL, EDITOR_SITES))?;
        let resolutions = [coarse_solve, middle_solve, fine_solve];
        Ok(Timings {
            scenes,
            resolutions,
            first,
            small,
            many_sites,
            insertion,
            baseline,
            evaluation,
            fine_evaluation_ms,
            drag,
        })
    }

    fn count(&self, samples: u32) -> u32 {
        ((f64::from(samples) * self.fraction) as u32).max(MIN_SAMPLES)
    }

    /// Solves a project repeatedly with one solver, as an editor does. The outline is reused.
    fn solved(&self, case: &Case, project: &Project) -> Result<(Solve, Solution), Error> {
        let picture = case.picture()?;
        let mut solver = Solver::new();
        let times = repeat(self.clock, self.effort, || self.times(&mut solver, project, &picture))?;
        let solution = solver.into_solution().expect("solved at least once");
        Ok((solve(&times, &solution), solution))
    }

    /// Solves a project with a new solver each time, from the outline to the weights.
    fn first(&self, case: &Case, project: &Project) -> Result<Solve, Error> {
        let picture = case.picture()?;
        let times = repeat(self.clock, self.effort, || self.times(&mut Solver::new(), project, &picture))?;
        Ok(solve(&times, &solve_once(project, &picture)?))
    }

    /// Adds a handle to a solved project.
    fn insertion(&self, case: &Case, project: &Project) -> Result<Solve, Error> {
        let picture = case.picture()?;
        let mut more = project.clone();
        more.handles.push(knee_handle());
        let mut solver = Solver::new();
        let times = repeat(self.clock, self.effort, || {
            self.times(&mut solver, project, &picture)?;
            self.times(&mut solver, &more, &picture)
        })?;
        Ok(solve(&times, solver.solution().expect("every stage has run")))
    }

    /// Drags a hand out and back. All rotations are left to the solver.
    fn drag(&self, case: &Case, project: Project) -> Result<DragTimes, Error> {
        let (project, picture) = (project.with_editor_settings(), case.picture()?);
        let handles = &project.handles;
        let drag = raised_hand();
        let ends = drag.handles_at(handles, 1.0);
        let rigid = solve_once(&project, &picture)?;
        let rigid = rigid.poser();
        let first = repeat(self.clock, self.effort, || first_pose(self.clock, rigid, &ends).map(|(_, ms)| ms))?;
        let at_rest = rigid.pose(handles, project.pose.blend)?;
        let count = (DRAG_FRAMES * self.fraction).ceil() as u32;
        let mut frames = Vec::new();
        let mut by = |pose, shares| {
            let path = drag.frames(handles, shares, count);
            follow(self.clock, rigid, pose, path, |_, ms| frames.push(ms))
        };
        // The first drag warms up.
        let out = by(at_rest, [0.0, 1.0])?;
        let home = by(out, [1.0, 0.0])?;
        let end = by(home, [0.0, 1.0])?;
        by(end.clone(), [1.0, 0.0])?;
        frames.drain(..frames.len() / 2);
        let mut harmonic = project.clone();
        harmonic.pose.mode = PoseMode::Harmonic;
        let harmonic = solve_once(&harmonic, &picture)?;
        Ok(DragTimes {
            frame: exceeded_by(0.5, &frames),
            slow_frame: exceeded_by(0.01, &frames),
            first: minimum(first),
            // A poser keeps its last pose from rest, and a copy does not.
            settle: min_ms(self.clock, self.effort, || {
                let _ = black_box(rigid.clone().settle(&end, &ends));
            }),
            harmonic: min_ms(self.clock, self.effort, || {
                let _ = black_box(harmonic.poser().pose(&ends, project.pose.blend));
            }),
        })
    }

    fn times(&self, solver: &mut Solver, project: &Project, picture: &Picture) -> Result<Times, Error> {
        let mut stages = StageTimes::default();
        let start = (self.clock)();
        solver.begin(project, picture)?;
        let mut last = start;
        while let Some(stage) = solver.advance()? {
            let now = (self.clock)();
            stages.add(stage, now - last);
            last = now;
        }
        Ok(Times { stages, total: last - start })
    }

    /// Times a pass and Dijkstra's algorithm on the same samples, from each handle in turn.
    fn baseline(&self, solution: &Solution, project: &Project) -> Baseline {
        let navigation = solution.navigation();
        let points = &solution.vertices()[..solution.samples()];
        let sources: Vec<DVec2> = project.handles.iter().filter_map(|handle| point(&handle.shape)).collect();
        let locate = |&p| navigation.located(p).expect("samples lie in the domain");
        let located: Vec<Located> = points.iter().map(locate).collect();
        let mut distances = vec![0.0; points.len()];
        let passes = min_ms(self.clock, self.effort, || {
            for &source in &sources {
                let from = navigation.distances_from(source).expect("handles lie in the domain");
                for (distance, &p) in distances.iter_mut().zip(&located) {
                    *distance = from.to_located(p).unwrap_or(f64::INFINITY);
                }
                black_box(&mut distances);
            }
        });
        let graph = graph_of_samples(solution);
        let at = |source: &DVec2| points.iter().position(|p| p == source).expect("handles are samples");
        let at: Vec<usize> = sources.iter().map(at).collect();
        let graphs = min_ms(self.clock, self.effort, || {
            for &source in &at {
                black_box(graph.distances(points, source));
            }
        });
        let sources = sources.len() as f64;
        Baseline { pass_ms: passes / sources, graph_ms: graphs / sources }
    }

    /// Times the evaluation of points over the whole domain, and scales it to a million points.
    fn evaluations(&self, solution: &Solution, case: &Case) -> Evaluation {
        let image = &case.project.image;
        let size = DVec2::new(f64::from(image.width), f64::from(image.height));
        let inside = |&p: &DVec2| solution.weights_at(p).is_some();
        let count = (100_000.0 * self.fraction).ceil();
        let points: Vec<DVec2> = spread(size).filter(inside).take(count as usize).collect();
        let million = 1e6 / count;
        Evaluation {
            influences_ms: self.evaluation(solution, &points, Solution::influences_at) * million,
            weights_ms: self.evaluation(solution, &points, Solution::weights_at) * million,
        }
    }

    fn evaluation<T>(&self, solution: &Solution, points: &[DVec2], at: impl Fn(&Solution, DVec2) -> T) -> f64 {
        min_ms(self.clock, self.effort, || {
            for &p in points {
                black_box(at(solution, p));
            }
        })
    }
}

/// Returns the paper's graph: the mesh edges between the samples of a solution.
#[must_use]
pub fn graph_of_samples(solution: &Solution) -> Graph {
    let samples = solution.samples();
    let between = |triangle: &&[u32; 3]| triangle.iter().all(|&v| (v as usize) < samples);
    let triangles: Vec<[u32; 3]> = solution.triangles().iter().filter(between).copied().collect();
    Graph::of_triangles(samples, &triangles)
}

/// Returns the minimum time of each stage over many solves of the same project.
fn solve(times: &[Times], solution: &Solution) -> Solve {
    let of = |part: fn(&Times) -> f64| minimum(times.iter().map(part));
    Solve {
        samples: solution.samples(),
        virtual_sites: solution.sites().iter().filter(|site| !site.kind.is_real()).count(),
        domain_ms: of(|t| t.stages.domain),
        sampling_ms: of(|t| t.stages.sampling),
        regions_ms: of(|t| t.stages.regions),
        weights_ms: of(|t| t.stages.weights),
        solve_ms: of(|t| t.stages.regions + t.stages.weights),
        total_ms: of(|t| t.total),
    }
}

fn point(shape: &Shape) -> Option<DVec2> {
    match shape {
        Shape::Point { rest, .. } => Some(*rest),
        Shape::Bar { .. } | Shape::Polygon { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clock::native_ms;

    #[test]
    fn every_case_can_be_solved() {
        let suite = Suite { clock: native_ms, effort: Effort::TRIAL, fraction: 0.02 };
        let mut names = Vec::new();
        let timings = suite.timings(|name| names.push(name.to_owned())).unwrap();
        assert_eq!(names[..6], TABLE_1.map(|row| row.name.to_owned()));
        for (solve, paper) in timings.scenes.iter().zip(TABLE_1) {
            assert!(solve.virtual_sites >= paper.virtual_sites as usize, "{}: {solve:?}", paper.name);
        }
        for solve in timings.resolutions.iter().chain([&timings.small]) {
            assert_eq!(solve.virtual_sites, 0, "the figure needs no virtual site: {solve:?}");
            assert!(solve.total_ms >= solve.sampling_ms && solve.solve_ms > 0.0, "{solve:?}");
        }
        assert!((60..66).contains(&timings.many_sites.virtual_sites), "{:?}", timings.many_sites);
        let Baseline { pass_ms, graph_ms } = timings.baseline;
        assert!(pass_ms > 0.0 && graph_ms > 0.0 && timings.fine_evaluation_ms > 0.0);
        let DragTimes { frame, slow_frame, first, settle, harmonic } = timings.drag;
        assert!(frame <= slow_frame && [frame, first, settle, harmonic].iter().all(|&ms| ms > 0.0));
    }

    #[test]
    fn figure_has_about_the_sample_count_of_table_2() {
        let suite = Suite { clock: native_ms, effort: Effort::TRIAL, fraction: 1.0 };
        let figure = gingerbread();
        let [coarse, middle, _] = TABLE_2.map(|row| row.samples);
        for (asked, tolerance) in [(coarse, 0.1), (middle, 0.01)] {
            let (solve, _) = suite.solved(&figure, &figure.project(asked, 0)).unwrap();
            assert!((solve.samples as f64 / f64::from(asked) - 1.0).abs() < tolerance, "{asked}: {}", solve.samples);
        }
    }
}
