//! What the program promises of its speed and size, and whether it keeps it.
//!
//! Times are promised as ratios of figures of one run. The bars in milliseconds are for orientation: they were set for a
//! cloud machine of two cores.

use crate::{
    cases::TABLE_2,
    results::{Figure, Results, Timings},
    suite::{DENSE, POSED, SMALL},
    tables::thousands,
};

/// A promise about one figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// What the figure is.
    pub what: String,
    /// The greatest it may be.
    pub limit: f64,
    /// What figure and limit count.
    pub unit: &'static str,
    /// What it is natively, or at all.
    pub figure: f64,
    /// What it is in WebAssembly, to compare with.
    pub wasm: Option<f64>,
}

impl Bar {
    /// `pass` where the promise is kept, else `short`.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        if self.figure <= self.limit { "pass" } else { "short" }
    }
}

/// A bar that each run has a figure for.
struct Rule {
    what: String,
    limit: f64,
    unit: &'static str,
    figure: Figure,
}

/// All bars that there are figures for.
#[must_use]
pub fn bars(results: &Results) -> Vec<Bar> {
    let held = |Rule { what, limit, unit, figure }| {
        let wasm = results.wasm.as_ref().map(figure);
        Bar { what, limit, unit, figure: figure(&results.native), wasm }
    };
    let mut bars: Vec<Bar> = rules().map(held).into();
    let single = |what: &str, limit, unit, figure| Bar { what: what.into(), limit, unit, figure, wasm: None };
    if let Some(wasm) = &results.wasm {
        let (case, worst) = slowest(wasm, &results.native);
        bars.push(single(&format!("WebAssembly ÷ native, at worst: {case}"), 1.6, "×", worst));
    }
    if let Some(memory) = &results.memory {
        let share = |bytes: usize| bytes as f64 / memory.samples as f64;
        let (sites, peak) = (memory.virtual_sites, share(memory.peak_bytes));
        let what = format!("memory a sample, {sites} virtual sites ({peak:.0} while solving)");
        bars.push(single(&what, 400.0, "bytes", share(memory.held_bytes)));
    }
    bars
}

fn rules() -> [Rule; 10] {
    let [_, middle, fine] = TABLE_2.map(|row| thousands(row.samples as usize));
    let small = thousands(SMALL as usize);
    let rule = |what: String, limit, unit, figure| Rule { what, limit, unit, figure };
    [
        rule("one pass ÷ one graph Dijkstra".into(), 4.0, "×", |t| t.yardstick.pass_ms / t.yardstick.graph_ms),
        rule(format!("solve of {middle}, 6 handles"), 4.0, "passes", |t| t.resolutions[1].passes(&t.yardstick)),
        rule(format!("solve of {middle}, {DENSE} virtual sites"), 12.0, "passes", |t| t.dense.passes(&t.yardstick)),
        rule(format!("solve of {fine} ÷ {middle}"), 30.0, "×", |t| {
            t.resolutions[2].solve_ms / t.resolutions[1].solve_ms
        }),
        rule(format!("one more handle at {middle}, samples and all"), 1.5, "passes", |t| {
            t.insertion.whole_ms / t.yardstick.pass_ms
        }),
        rule(format!("solve of {small}"), 10.0, "ms", |t| t.small.solve_ms),
        rule(format!("solve of {middle}"), 30.0, "ms", |t| t.resolutions[1].solve_ms),
        rule(format!("solve of {fine}"), 900.0, "ms", |t| t.resolutions[2].solve_ms),
        rule(format!("solve of {small}, then weights of {fine} points"), 250.0, "ms", |t| {
            t.small.solve_ms + t.serving_ms
        }),
        rule(format!("a rigid pose, {} virtual sites", POSED[2]), 1.0, "ms", |t| t.frames_ms[2]),
    ]
}

/// The case in which WebAssembly lags most, and how many times as long it takes.
fn slowest(wasm: &Timings, native: &Timings) -> (&'static str, f64) {
    let cases: [(_, Figure); 9] = [
        ("small", |t| t.small.solve_ms),
        ("coarse", |t| t.resolutions[0].solve_ms),
        ("middle", |t| t.resolutions[1].solve_ms),
        ("fine", |t| t.resolutions[2].solve_ms),
        ("virtual sites", |t| t.dense.solve_ms),
        ("one more handle", |t| t.insertion.whole_ms),
        ("a pass", |t| t.yardstick.pass_ms),
        ("evaluation", |t| t.evaluation.weights_ms),
        ("a frame", |t| t.frames_ms[2]),
    ];
    let ratios = cases.map(|(case, time)| (case, time(wasm) / time(native)));
    ratios.into_iter().fold(("", 0.0), |worst, ratio| if ratio.1 > worst.1 { ratio } else { worst })
}
