//! Requirements on speed and memory, and whether they are met.
//!
//! Most requirements are ratios of times of one run. Those in milliseconds are guidelines for a cloud machine with two
//! cores.

use crate::{
    cases::TABLE_2,
    results::{Metric, Results, Timings},
    suite::{EDITOR_SITES, MANY_SITES, SMALL},
    tables::thousands,
};

/// A requirement on one measured value.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirement {
    /// The name of the measured value.
    pub name: String,
    /// The largest allowed value.
    pub limit: f64,
    /// The unit of the value and the limit.
    pub unit: &'static str,
    /// The value, measured natively where both targets exist.
    pub value: f64,
    /// The value in WebAssembly, for comparison.
    pub wasm: Option<f64>,
}

impl Requirement {
    /// Returns `met` or `missed`.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        if self.value <= self.limit { "met" } else { "missed" }
    }
}

/// A requirement on a value of each run.
struct Rule {
    name: String,
    limit: f64,
    unit: &'static str,
    metric: Metric,
}

/// Returns all requirements whose values were measured.
#[must_use]
pub fn requirements(results: &Results) -> Vec<Requirement> {
    let evaluate = |Rule { name, limit, unit, metric }| {
        let wasm = results.wasm.as_ref().map(metric);
        Requirement { name, limit, unit, value: metric(&results.native), wasm }
    };
    let mut requirements: Vec<Requirement> = rules().map(evaluate).into();
    let single = |name: &str, limit, unit, value| Requirement { name: name.into(), limit, unit, value, wasm: None };
    if let Some(wasm) = &results.wasm {
        let (case, worst) = slowest(wasm, &results.native);
        requirements.push(single(&format!("WebAssembly ÷ native, worst case: {case}"), 1.6, "×", worst));
    }
    if let Some(memory) = &results.memory {
        let per_sample = |bytes: usize| bytes as f64 / memory.samples as f64;
        let (sites, peak) = (memory.virtual_sites, per_sample(memory.peak_bytes));
        let name = format!("memory per sample, {sites} virtual sites (peak {peak:.0})");
        requirements.push(single(&name, 400.0, "bytes", per_sample(memory.held_bytes)));
    }
    requirements
}

fn rules() -> [Rule; 15] {
    let [_, middle, fine] = TABLE_2.map(|row| thousands(row.samples as usize));
    let small = thousands(SMALL as usize);
    let rule = |name: String, limit, unit, metric| Rule { name, limit, unit, metric };
    [
        rule("one pass ÷ Dijkstra on the graph".into(), 4.0, "×", |t| t.baseline.pass_ms / t.baseline.graph_ms),
        rule(format!("solve of {middle}, 6 handles"), 4.0, "passes", |t| t.resolutions[1].passes(&t.baseline)),
        rule(format!("solve of {middle}, {MANY_SITES} virtual sites"), 12.0, "passes", |t| {
            t.many_sites.passes(&t.baseline)
        }),
        rule(format!("solve of {fine} ÷ {middle}"), 30.0, "×", |t| {
            t.resolutions[2].solve_ms / t.resolutions[1].solve_ms
        }),
        rule(format!("one more handle at {middle}, with sampling"), 1.5, "passes", |t| {
            t.insertion.total_ms / t.baseline.pass_ms
        }),
        rule(format!("sampling ÷ solve of {middle}, first"), 2.0, "×", |t| {
            t.first[1].sampling_ms / t.first[1].solve_ms
        }),
        rule(format!("outline to weights at {middle}, first"), 10.0, "ms", |t| t.first[1].total_ms),
        rule(format!("outline to weights at {fine}, first"), 150.0, "ms", |t| t.first[2].total_ms),
        rule(format!("solve of {small}"), 10.0, "ms", |t| t.small.solve_ms),
        rule(format!("solve of {middle}"), 30.0, "ms", |t| t.resolutions[1].solve_ms),
        rule(format!("solve of {fine}"), 900.0, "ms", |t| t.resolutions[2].solve_ms),
        rule(format!("solve of {small}, then weights at {fine} points"), 250.0, "ms", |t| {
            t.small.solve_ms + t.fine_evaluation_ms
        }),
        rule(format!("frame of a drag, {EDITOR_SITES} virtual sites"), 8.0, "ms", |t| t.drag.frame),
        rule("1 % slowest frames of a drag".into(), 14.0, "ms", |t| t.drag.slow_frame),
        rule("first pose from rest".into(), 80.0, "ms", |t| t.drag.first),
    ]
}

/// Returns the case with the largest ratio of WebAssembly to native time, and this ratio.
fn slowest(wasm: &Timings, native: &Timings) -> (&'static str, f64) {
    let cases: [(_, Metric); 12] = [
        ("first, middle", |t| t.first[1].total_ms),
        ("first, fine", |t| t.first[2].total_ms),
        ("first, editor", |t| t.first[3].total_ms),
        ("small", |t| t.small.solve_ms),
        ("coarse", |t| t.resolutions[0].solve_ms),
        ("middle", |t| t.resolutions[1].solve_ms),
        ("fine", |t| t.resolutions[2].solve_ms),
        ("many virtual sites", |t| t.many_sites.solve_ms),
        ("one more handle", |t| t.insertion.total_ms),
        ("pass", |t| t.baseline.pass_ms),
        ("evaluation", |t| t.evaluation.weights_ms),
        ("frame of a drag", |t| t.drag.frame),
    ];
    let ratios = cases.map(|(case, time)| (case, time(wasm) / time(native)));
    ratios.into_iter().fold(("", 0.0), |worst, ratio| if ratio.1 > worst.1 { ratio } else { worst })
}
