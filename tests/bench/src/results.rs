//! What was measured. Times in milliseconds, each the least of many runs.

use serde::{Deserialize, Serialize};

/// Everything that was measured, wherever it ran.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// By the native program.
    pub native: Timings,
    /// By the same cases in a page.
    pub wasm: Option<Timings>,
    /// By a native program that counts what it allocates.
    pub memory: Option<Memory>,
}

/// A figure of one run.
pub type Figure = fn(&Timings) -> f64;

/// The times of one run of all cases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timings {
    /// The scenes of Table I, in its order.
    pub scenes: Vec<Solve>,
    /// The gingerbread figure in the resolutions of Table II, from coarse to fine.
    pub resolutions: [Solve; 3],
    /// The figure with 10,000 samples.
    pub small: Solve,
    /// The figure in the middle resolution with 60 virtual sites.
    pub dense: Solve,
    /// One more handle on the figure in the middle resolution, from solution to solution.
    pub insertion: Solve,
    /// Distances over the middle resolution.
    pub yardstick: Yardstick,
    /// Weights of single points of the dense figure.
    pub evaluation: Evaluation,
    /// Time to evaluate the weights of the figure with 10,000 samples at every vertex of the finest resolution.
    pub serving_ms: f64,
    /// Time of a pose of the figure in the rigid mode, for each number of virtual sites.
    pub frames_ms: [f64; 3],
}

/// A solve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Solve {
    /// Samples there came to be.
    pub samples: usize,
    /// Virtual sites there came to be.
    pub virtual_sites: usize,
    /// Samples and their mesh.
    pub sampling_ms: f64,
    /// Distances, cells and virtual sites.
    pub regions_ms: f64,
    /// Supports, weights, harmonic fields and the drawn mesh.
    pub weights_ms: f64,
    /// Regions and weights together.
    pub solve_ms: f64,
    /// All of it, from the request on.
    pub whole_ms: f64,
}

/// Distances from one source to every sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Yardstick {
    /// A field without a bound, asked at every sample: a pass.
    pub pass_ms: f64,
    /// Dijkstra's algorithm along the edges of the samples' mesh.
    pub graph_ms: f64,
}

/// Times for a million points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Evaluation {
    /// Weights with their gradients.
    pub influences_ms: f64,
    /// Weights alone.
    pub weights_ms: f64,
}

/// Memory of the solve in the middle resolution with 60 virtual sites.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// Samples of the solve.
    pub samples: usize,
    /// Virtual sites of the solve.
    pub virtual_sites: usize,
    /// What a solver that has solved holds.
    pub held_bytes: usize,
    /// The most it held while it solved.
    pub peak_bytes: usize,
}

impl Solve {
    /// How many passes the solve takes as long as.
    #[must_use]
    pub fn passes(&self, yardstick: &Yardstick) -> f64 {
        self.solve_ms / yardstick.pass_ms
    }
}
