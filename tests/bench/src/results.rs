//! The measured values. Times are in milliseconds, each the minimum of many runs.

use serde::{Deserialize, Serialize};

use crate::drag::DragTimes;

/// All results.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Times of the native program.
    pub native: Timings,
    /// Times of the same cases in a page.
    pub wasm: Option<Timings>,
    /// Memory of a native program that counts its allocations.
    pub memory: Option<Memory>,
}

/// A value of one run.
pub type Metric = fn(&Timings) -> f64;

/// The times of one run of all cases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timings {
    /// The scenes of Table I, in its order.
    pub scenes: Vec<Solve>,
    /// The gingerbread figure at the resolutions of Table II, from coarse to fine.
    pub resolutions: [Solve; 3],
    /// First solves: the figure at the resolutions of Table II, and with 10,000 samples and the editor's virtual sites.
    pub first: [Solve; 4],
    /// The figure with 10,000 samples.
    pub small: Solve,
    /// The figure at the middle resolution with 60 virtual sites.
    pub many_sites: Solve,
    /// A further handle on the figure at the middle resolution, from one solution to the next.
    pub insertion: Solve,
    /// Distances at the middle resolution.
    pub baseline: Baseline,
    /// Weights of single points of the figure with 60 virtual sites.
    pub evaluation: Evaluation,
    /// Weights at every vertex of the finest resolution, from a solution with 10,000 samples.
    pub fine_evaluation_ms: f64,
    /// A drag of the figure in the rigid mode, with the editor's virtual sites.
    pub drag: DragTimes,
}

/// The times of one solve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Solve {
    /// The number of samples.
    pub samples: usize,
    /// The number of virtual sites.
    pub virtual_sites: usize,
    /// Time for the outline, its triangulation and the handles in it.
    pub domain_ms: f64,
    /// Time for samples and their mesh.
    pub sampling_ms: f64,
    /// Time for distances, cells and virtual sites.
    pub regions_ms: f64,
    /// Time for supports, weights, harmonic fields and the drawn mesh.
    pub weights_ms: f64,
    /// Time for regions and weights.
    pub solve_ms: f64,
    /// Time of all stages.
    pub total_ms: f64,
}

/// Distances from one source to every sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Baseline {
    /// A pass: one unbounded distance field, evaluated at every sample.
    pub pass_ms: f64,
    /// Dijkstra's algorithm along the edges of the samples' mesh.
    pub graph_ms: f64,
}

/// Times of the evaluation of a million points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Evaluation {
    /// Weights with their gradients.
    pub influences_ms: f64,
    /// Only the weights.
    pub weights_ms: f64,
}

/// Memory of the solve at the middle resolution with 60 virtual sites.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// Samples of the solve.
    pub samples: usize,
    /// Virtual sites of the solve.
    pub virtual_sites: usize,
    /// Memory of the solver after solving.
    pub held_bytes: usize,
    /// Peak memory during solving.
    pub peak_bytes: usize,
}

impl Solve {
    /// Returns the time of the solve in passes.
    #[must_use]
    pub fn passes(&self, baseline: &Baseline) -> f64 {
        self.solve_ms / baseline.pass_ms
    }
}
