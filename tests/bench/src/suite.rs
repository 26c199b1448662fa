//! Runs every case.

use std::hint::black_box;

use c2warp::{
    Error, Picture, Solution, Solver, StageTimes,
    distance::{Located, graph::Graph},
    project::{PoseMode, Project, Rotation, Shape, Support},
    solve as solve_once,
};
use glam::DVec2;

use crate::{
    cases::{Scene, TABLE_1, TABLE_2, gingerbread, one_more, raised, spread, table_1},
    clock::Clock,
    measure::{Effort, least, least_ms, runs},
    results::{Evaluation, Solve, Timings, Yardstick},
};

/// Samples that answer quickly, and serve finer meshes by evaluation.
pub const SMALL: u32 = 10_000;
/// Virtual sites of the dense case.
pub const DENSE: u32 = 60;
/// Virtual sites of the figure that is posed: what the editor asks for, and more.
pub const POSED: [u32; 3] = [30, 120, 200];
/// The least number of samples that a project may ask for.
const LEAST_SAMPLES: u32 = 100;

/// Where, how long and how large the cases run.
#[derive(Debug, Clone, Copy)]
pub struct Suite {
    /// What tells the time.
    pub clock: Clock,
    /// What goes into each figure.
    pub effort: Effort,
    /// Share of the samples and points that the cases are meant to have: 1, or less for a trial.
    pub share: f64,
}

/// Milliseconds of one solve.
#[derive(Debug, Clone, Copy, Default)]
struct Times {
    stages: StageTimes,
    whole: f64,
}

impl Suite {
    /// All cases as they are meant.
    #[must_use]
    pub fn full(clock: Clock) -> Self {
        Self { clock, effort: Effort::FULL, share: 1.0 }
    }

    /// Runs every case, and tells the name of each before.
    ///
    /// # Errors
    /// None, unless a scene cannot be solved any more.
    pub fn timings(&self, mut tell: impl FnMut(&str)) -> Result<Timings, Error> {
        let mut scenes = Vec::new();
        for (scene, paper) in table_1().iter().zip(TABLE_1) {
            tell(paper.name);
            let project = scene.project(self.count(paper.samples), paper.virtual_sites);
            scenes.push(self.solved(scene, &project)?.0);
        }
        let figure = gingerbread();
        let project = |samples: u32, virtual_sites| figure.project(self.count(samples), virtual_sites);
        let [coarse, middle, fine] = TABLE_2.map(|row| project(row.samples, 0));
        tell("Gingerbread figure, three resolutions");
        let coarse_solve = self.solved(&figure, &coarse)?.0;
        let (middle_solve, middle_solution) = self.solved(&figure, &middle)?;
        let (fine_solve, fine_solution) = self.solved(&figure, &fine)?;
        tell("Evaluation at every vertex");
        let vertices = &fine_solution.vertices()[..fine_solution.samples()];
        let (small, small_solution) = self.solved(&figure, &project(SMALL, 0))?;
        let serving_ms = self.evaluation(&small_solution, vertices, Solution::weights_at);
        tell("Distances");
        let yardstick = self.yardstick(&middle_solution, &middle);
        tell("Virtual sites and evaluation");
        let (dense, dense_solution) = self.solved(&figure, &project(TABLE_2[1].samples, DENSE))?;
        let evaluation = self.evaluations(&dense_solution, &figure);
        tell("One more handle");
        let insertion = self.insertion(&figure, &middle)?;
        tell("A frame in the rigid mode");
        let mut frames_ms = [0.0; POSED.len()];
        for (frame_ms, virtual_sites) in frames_ms.iter_mut().zip(POSED) {
            *frame_ms = self.frame(&figure, &project(SMALL, virtual_sites))?;
        }
        let resolutions = [coarse_solve, middle_solve, fine_solve];
        Ok(Timings { scenes, resolutions, small, dense, insertion, yardstick, evaluation, serving_ms, frames_ms })
    }

    fn count(&self, samples: u32) -> u32 {
        ((f64::from(samples) * self.share) as u32).max(LEAST_SAMPLES)
    }

    /// Solves a project again and again with one solver, as an editor does: the outline stays.
    fn solved(&self, scene: &Scene, project: &Project) -> Result<(Solve, Solution), Error> {
        let picture = scene.picture()?;
        let mut solver = Solver::new();
        let times = runs(self.clock, self.effort, || self.times(&mut solver, project, &picture))?;
        let solution = solver.into_solution().expect("solved at least once");
        Ok((solve(&times, &solution), solution))
    }

    /// From a solution to that with one more handle.
    fn insertion(&self, scene: &Scene, project: &Project) -> Result<Solve, Error> {
        let picture = scene.picture()?;
        let mut more = project.clone();
        more.handles.push(one_more());
        let mut solver = Solver::new();
        let times = runs(self.clock, self.effort, || {
            self.times(&mut solver, project, &picture)?;
            self.times(&mut solver, &more, &picture)
        })?;
        Ok(solve(&times, solver.solution().expect("every stage has run")))
    }

    /// The motions of all sites in the rigid mode, with every rotation left to the solver.
    fn frame(&self, scene: &Scene, project: &Project) -> Result<f64, Error> {
        let mut project = project.clone();
        (project.pose.mode, project.weighting.support) = (PoseMode::Rigid, Support::Smooth);
        raised(&mut project.handles);
        for handle in &mut project.handles {
            handle.rotation = Rotation::Auto;
        }
        let solution = solve_once(&project, &scene.picture()?)?;
        solution.poser().pose(&project.handles, project.pose.blend)?;
        Ok(least_ms(self.clock, self.effort, || {
            let _ = black_box(solution.poser().pose(&project.handles, project.pose.blend));
        }))
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
        Ok(Times { stages, whole: last - start })
    }

    /// A pass and a Dijkstra over the same samples, from each handle in turn.
    fn yardstick(&self, solution: &Solution, project: &Project) -> Yardstick {
        let navigation = solution.navigation();
        let points = &solution.vertices()[..solution.samples()];
        let sources: Vec<DVec2> = project.handles.iter().filter_map(|handle| point(&handle.shape)).collect();
        let locate = |&p| navigation.located(p).expect("samples lie in the domain");
        let located: Vec<Located> = points.iter().map(locate).collect();
        let mut distances = vec![0.0; points.len()];
        let passes = least_ms(self.clock, self.effort, || {
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
        let graphs = least_ms(self.clock, self.effort, || {
            for &source in &at {
                black_box(graph.distances(points, source));
            }
        });
        let sources = sources.len() as f64;
        Yardstick { pass_ms: passes / sources, graph_ms: graphs / sources }
    }

    /// Times for a million points all over the domain.
    fn evaluations(&self, solution: &Solution, scene: &Scene) -> Evaluation {
        let image = &scene.project.image;
        let size = DVec2::new(f64::from(image.width), f64::from(image.height));
        let inside = |&p: &DVec2| solution.weights_at(p).is_some();
        let count = (100_000.0 * self.share).ceil();
        let points: Vec<DVec2> = spread(size).filter(inside).take(count as usize).collect();
        let million = 1e6 / count;
        Evaluation {
            influences_ms: self.evaluation(solution, &points, Solution::influences_at) * million,
            weights_ms: self.evaluation(solution, &points, Solution::weights_at) * million,
        }
    }

    fn evaluation<T>(&self, solution: &Solution, points: &[DVec2], at: impl Fn(&Solution, DVec2) -> T) -> f64 {
        least_ms(self.clock, self.effort, || {
            for &p in points {
                black_box(at(solution, p));
            }
        })
    }
}

/// The paper's graph: the edges of the mesh between the samples of a solution.
#[must_use]
pub fn graph_of_samples(solution: &Solution) -> Graph {
    let samples = solution.samples();
    let between = |triangle: &&[u32; 3]| triangle.iter().all(|&v| (v as usize) < samples);
    let triangles: Vec<[u32; 3]> = solution.triangles().iter().filter(between).copied().collect();
    Graph::of_triangles(samples, &triangles)
}

/// The least times of many solves with the same outcome, each stage for itself.
fn solve(times: &[Times], solution: &Solution) -> Solve {
    let of = |part: fn(&Times) -> f64| least(times.iter().map(part));
    Solve {
        samples: solution.samples(),
        virtual_sites: solution.sites().iter().filter(|site| !site.kind.is_real()).count(),
        sampling_ms: of(|t| t.stages.sampling),
        regions_ms: of(|t| t.stages.regions),
        weights_ms: of(|t| t.stages.weights),
        solve_ms: of(|t| t.stages.regions + t.stages.weights),
        whole_ms: of(|t| t.whole),
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
    fn every_case_solves() {
        let suite = Suite { clock: native_ms, effort: Effort::TRIAL, share: 0.02 };
        let mut told = Vec::new();
        let timings = suite.timings(|name| told.push(name.to_owned())).unwrap();
        assert_eq!(told[..6], TABLE_1.map(|scene| scene.name.to_owned()));
        for (scene, paper) in timings.scenes.iter().zip(TABLE_1) {
            assert!(scene.virtual_sites >= paper.virtual_sites as usize, "{}: {scene:?}", paper.name);
        }
        for solve in timings.resolutions.iter().chain([&timings.small]) {
            assert_eq!(solve.virtual_sites, 0, "the figure needs no virtual site: {solve:?}");
            assert!(solve.whole_ms >= solve.sampling_ms && solve.solve_ms > 0.0, "{solve:?}");
        }
        assert!((60..66).contains(&timings.dense.virtual_sites), "{:?}", timings.dense);
        let Yardstick { pass_ms, graph_ms } = timings.yardstick;
        assert!(pass_ms > 0.0 && graph_ms > 0.0 && timings.serving_ms > 0.0);
        assert!(timings.frames_ms.iter().all(|&ms| ms > 0.0), "{:?}", timings.frames_ms);
    }

    #[test]
    fn the_figure_has_about_the_samples_of_table_2() {
        let suite = Suite { clock: native_ms, effort: Effort::TRIAL, share: 1.0 };
        let figure = gingerbread();
        let [coarse, middle, _] = TABLE_2.map(|row| row.samples);
        for (asked, share) in [(coarse, 0.1), (middle, 0.01)] {
            let (solve, _) = suite.solved(&figure, &figure.project(asked, 0)).unwrap();
            assert!((solve.samples as f64 / f64::from(asked) - 1.0).abs() < share, "{asked}: {}", solve.samples);
        }
    }
}
