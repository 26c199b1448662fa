//! Compares intrinsic distances with exact geodesics: those of the solver, and the paper's (section V-B).
//!
//! The paper uses Dijkstra's algorithm on the edges of the mesh between samples.

use std::hint::black_box;

use c2warp::{
    distance::Located,
    domain::Domain,
    project::{Handle, Project},
    solve_domain,
};
use c2warp_bench::{
    clock::native_ms,
    measure::{Effort, min_ms},
    suite::graph_of_samples,
};
use c2warp_tests::{
    outlines,
    visibility::{Viewpoint, VisibilityGraph},
};
use glam::DVec2;

const EFFORT: Effort = Effort { warm_up_ms: 0.0, measured_ms: 20.0, min_runs: 3 };

/// The requested numbers of samples.
const SAMPLES: [u32; 3] = [2_000, 8_000, 31_000];
/// The number of sources.
const SOURCES: usize = 4;
/// The number of samples at which distances are compared.
const COMPARED: usize = 400;
/// Relative errors of distances below this length refer to this length, in pixels.
const SHORTEST: f64 = 1.0;

/// Relative errors of distances.
#[derive(Debug, Clone, Copy, Default)]
pub struct Errors {
    /// The mean error.
    pub mean: f64,
    /// The largest error.
    pub greatest: f64,
}

/// Distances in one domain with one number of samples. Times are per source.
#[derive(Debug, Clone)]
pub struct Distances {
    /// The name of the domain.
    pub domain: &'static str,
    /// The number of corners of its outline.
    pub corners: usize,
    /// The number of samples.
    pub samples: usize,
    /// Errors of the solver.
    pub solver: Errors,
    /// Errors of Dijkstra's algorithm on the mesh edges.
    pub graph: Errors,
    /// Time of the solver for all samples, in ms.
    pub solver_ms: f64,
    /// Time of Dijkstra's algorithm, in ms.
    pub graph_ms: f64,
}

/// Measures distances in all domains with each number of samples.
#[must_use]
pub fn distances() -> Vec<Distances> {
    let domains = [
        ("gingerbread", outlines::polygon(&outlines::gingerbread())),
        ("spiral", outlines::polygon(&outlines::spiral())),
        ("square with a hole", outlines::polygon(&outlines::holed_square())),
        ("comb", outlines::polygon(&outlines::comb())),
        ("outline of a picture", outlines::alpha()),
    ];
    domains.iter().flat_map(|(name, domain)| of_domain(name, domain)).collect()
}

fn of_domain(name: &'static str, domain: &Domain) -> Vec<Distances> {
    let geodesics = VisibilityGraph::new(domain.rings());
    let sources = outlines::scattered(&geodesics, 0, SOURCES);
    SAMPLES.iter().map(|&count| of_samples(name, domain, &geodesics, &sources, count)).collect()
}

fn of_samples(
    name: &'static str,
    domain: &Domain,
    geodesics: &VisibilityGraph,
    sources: &[DVec2],
    count: u32,
) -> Distances {
    // Handles are samples, so both methods have the same sources.
    let handles = sources.iter().enumerate().map(|(at, &source)| Handle::point(at.to_string(), source));
    let mut project = Project::for_picture(outlines::SIZE, outlines::SIZE).with_handles(handles);
    project.samples = count;
    let solution = solve_domain(&project, domain).expect("the domain has room for four handles");
    let (navigation, samples) = (solution.navigation(), solution.samples());
    let points = &solution.vertices()[..samples];
    let locate = |&p| navigation.located(p).expect("samples lie in the domain");
    let located: Vec<Located> = points.iter().map(locate).collect();
    let graph = graph_of_samples(&solution);
    let solve = |source: DVec2| -> Vec<f64> {
        let distances = navigation.distances_from(source).expect("sources lie in the domain");
        located.iter().map(|&p| distances.to_located(p).unwrap_or(f64::INFINITY)).collect()
    };
    let dijkstra = |source: DVec2| {
        let at = points.iter().position(|&p| p == source).expect("handles are samples");
        graph.distances(points, at)
    };

    // Rounding decides whether samples on the outline are inside, so leave the outside ones out.
    let inner: Vec<usize> = (0..samples).filter(|&i| geodesics.contains(points[i])).collect();
    let compared: Vec<usize> = inner.iter().copied().step_by(inner.len().div_ceil(COMPARED)).collect();
    let viewpoints: Vec<Viewpoint> = compared.iter().map(|&i| geodesics.viewpoint(points[i])).collect();
    let (mut of_solver, mut of_graph) = (Vec::new(), Vec::new());
    for &source in sources {
        let (found, by_graph) = (solve(source), dijkstra(source));
        for (&i, exact) in compared.iter().zip(geodesics.distances(source, &viewpoints)) {
            let error = |distance: f64| (distance - exact).abs() / exact.max(SHORTEST);
            of_solver.push(error(found[i]));
            of_graph.push(error(by_graph[i]));
        }
    }
    let time = |run: &dyn Fn(DVec2) -> Vec<f64>| min_ms(native_ms, EFFORT, || drop(black_box(run(sources[0]))));
    Distances {
        domain: name,
        corners: domain.rings().iter().map(Vec::len).sum(),
        samples,
        solver: errors(&of_solver),
        graph: errors(&of_graph),
        solver_ms: time(&solve),
        graph_ms: time(&dijkstra),
    }
}

fn errors(all: &[f64]) -> Errors {
    Errors { mean: all.iter().sum::<f64>() / all.len() as f64, greatest: greatest(all.iter().copied()) }
}

/// Returns the largest value. NaN counts as larger than any number.
pub(crate) fn greatest(values: impl Iterator<Item = f64>) -> f64 {
    values.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
