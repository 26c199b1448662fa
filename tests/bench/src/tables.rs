//! The printed tables, in Markdown.

use crate::{
    aligned::aligned,
    cases::{TABLE_1, TABLE_2},
    requirements::{Requirement, requirements},
    results::{Metric, Results, Solve},
    suite::{EDITOR_SITES, MANY_SITES, SMALL},
};

/// Placeholder for a missing value.
const NONE: &str = "–";

/// Formats all results, with the paper's values and the requirements.
#[must_use]
pub fn tables(results: &Results) -> String {
    let sections = [
        ("Table I: six scenes, times in ms", table_1(results), TABLE_1_NOTE),
        ("Table II: one figure at three resolutions, times in ms", table_2(results), TABLE_2_NOTE),
        ("First solves, times in ms", first_solves(results), FIRST_NOTE),
        ("Single steps, times in ms", steps(results), ""),
        ("Requirements", requirement_table(results), REQUIREMENTS_NOTE),
    ];
    let section = |(title, table, note): (&str, String, &str)| format!("## {title}\n\n{table}{note}");
    sections.map(section).join("\n").trim_end().to_owned() + "\n"
}

const TABLE_1_NOTE: &str = "
The scenes resemble the paper's. Each asks for the paper's number of virtual sites. t_rd is the stage of regions. t_w is
the stage of weights, with harmonic fields and the drawn mesh. The paper used one core of an i7-3740QM.
";

const TABLE_2_NOTE: &str = "
Six point handles that need no virtual site. Native and wasm times are for regions and weights. Sampling is listed
separately, because the paper's vertices were given.
";

const FIRST_NOTE: &str = "
A new solver finds the outline of a picture and samples its domain. Later solves reuse both. Each time is the minimum of
its own stage.
";

const REQUIREMENTS_NOTE: &str = "
Every time is the minimum of many runs. A pass is one unbounded distance field, evaluated at every sample. A solve is
regions and weights. Limits in ms are guidelines for two cores of a cloud machine. Results do not change the exit status.
";

fn table_1(results: &Results) -> String {
    let header = [
        "scene",
        "H_b",
        "H_p",
        "V paper",
        "V",
        "S paper",
        "S",
        "t_rd paper",
        "native",
        "wasm",
        "t_w paper",
        "native",
        "wasm",
    ];
    let row = |(at, paper): (usize, &crate::cases::Table1Row)| {
        let ours = &results.native.scenes[at];
        let wasm = results.wasm.as_ref().map(|timings| &timings.scenes[at]);
        vec![
            paper.name.to_owned(),
            paper.bars.to_string(),
            paper.points.to_string(),
            paper.virtual_sites.to_string(),
            ours.virtual_sites.to_string(),
            thousands(paper.samples as usize),
            thousands(ours.samples),
            milliseconds(paper.regions_ms),
            milliseconds(ours.regions_ms),
            or_none(wasm.map(|solve| solve.regions_ms)),
            milliseconds(paper.weights_ms),
            milliseconds(ours.weights_ms),
            or_none(wasm.map(|solve| solve.weights_ms)),
        ]
    };
    aligned(&header, TABLE_1.iter().enumerate().map(row), 1)
}

fn table_2(results: &Results) -> String {
    let header = ["vertices paper", "ours", "biharmonic", "paper", "native", "wasm", "sampling native", "wasm"];
    let row = |(at, paper): (usize, &crate::cases::Table2Row)| {
        let ours = &results.native.resolutions[at];
        let wasm = results.wasm.as_ref().map(|timings| &timings.resolutions[at]);
        vec![
            thousands(paper.samples as usize),
            thousands(ours.samples),
            or_none(paper.biharmonic_ms),
            milliseconds(paper.paper_ms),
            milliseconds(ours.solve_ms),
            or_none(wasm.map(|solve| solve.solve_ms)),
            milliseconds(ours.sampling_ms),
            or_none(wasm.map(|solve| solve.sampling_ms)),
        ]
    };
    aligned(&header, TABLE_2.iter().enumerate().map(row), 1)
}

fn first_solves(results: &Results) -> String {
    let header = ["S", "V", "", "domain", "sampling", "regions", "weights", "all", "sampling ÷ solve"];
    let row = |target: &str, solve: &Solve| {
        let times = [solve.domain_ms, solve.sampling_ms, solve.regions_ms, solve.weights_ms, solve.total_ms];
        let mut cells = vec![thousands(solve.samples), solve.virtual_sites.to_string(), target.to_owned()];
        cells.extend(times.map(milliseconds));
        cells.push(two_decimals(solve.sampling_ms / solve.solve_ms));
        cells
    };
    let rows = (0..results.native.first.len()).flat_map(|at| {
        let wasm = results.wasm.as_ref().map(|timings| row("wasm", &timings.first[at]));
        [row("native", &results.native.first[at])].into_iter().chain(wasm)
    });
    aligned(&header, rows, 3)
}

fn steps(results: &Results) -> String {
    let [_, middle, fine] = TABLE_2.map(|row| thousands(row.samples as usize));
    let small = thousands(SMALL as usize);
    let steps: [(String, Metric); 19] = [
        (format!("one pass at {middle}"), |t| t.baseline.pass_ms),
        (format!("Dijkstra on the graph at {middle}"), |t| t.baseline.graph_ms),
        (format!("{small}: regions"), |t| t.small.regions_ms),
        (format!("{small}: weights"), |t| t.small.weights_ms),
        (format!("{middle}: regions"), |t| t.resolutions[1].regions_ms),
        (format!("{middle}: weights"), |t| t.resolutions[1].weights_ms),
        (format!("{middle}, {MANY_SITES} virtual sites: regions"), |t| t.many_sites.regions_ms),
        (format!("{middle}, {MANY_SITES} virtual sites: weights"), |t| t.many_sites.weights_ms),
        ("one more handle: sampling".into(), |t| t.insertion.sampling_ms),
        ("one more handle: regions".into(), |t| t.insertion.regions_ms),
        ("one more handle: weights".into(), |t| t.insertion.weights_ms),
        ("a million points: weights and gradients".into(), |t| t.evaluation.influences_ms),
        ("a million points: weights".into(), |t| t.evaluation.weights_ms),
        (format!("weights at {fine} points from {small} samples"), |t| t.fine_evaluation_ms),
        (format!("rigid mode, {EDITOR_SITES} virtual sites: median frame of a drag"), |t| t.drag.frame),
        ("rigid mode: 1 % of the frames take longer".into(), |t| t.drag.slow_frame),
        ("rigid mode: first pose from rest".into(), |t| t.drag.first),
        ("rigid mode: release of a drag".into(), |t| t.drag.settle),
        ("harmonic mode: the same pose".into(), |t| t.drag.harmonic),
    ];
    let row = |(name, time): (String, Metric)| {
        let (native, wasm) = (time(&results.native), results.wasm.as_ref().map(time));
        let ratio = wasm.map_or(NONE.into(), |wasm| format!("{:.2}", wasm / native));
        vec![name, milliseconds(native), or_none(wasm), ratio]
    };
    aligned(&["", "native", "wasm", "wasm ÷ native"], steps.into_iter().map(row), 1)
}

fn requirement_table(results: &Results) -> String {
    let row = |requirement: Requirement| {
        vec![
            requirement.name.clone(),
            format!("≤ {} {}", requirement.limit, requirement.unit),
            two_decimals(requirement.value),
            requirement.verdict().to_owned(),
            requirement.wasm.map_or(NONE.into(), two_decimals),
        ]
    };
    aligned(&["", "limit", "value", "verdict", "in wasm"], requirements(results).into_iter().map(row), 1)
}

fn or_none(ms: Option<f64>) -> String {
    ms.map_or(NONE.into(), milliseconds)
}

/// Formats milliseconds with about three digits.
fn milliseconds(ms: f64) -> String {
    match ms {
        _ if ms < 0.995 => format!("{ms:.3}"),
        _ if ms < 9.95 => format!("{ms:.2}"),
        _ if ms < 99.5 => format!("{ms:.1}"),
        _ => thousands(ms.round() as usize),
    }
}

/// Formats a value with two decimals, or with none from 100 on.
fn two_decimals(value: f64) -> String {
    if value < 100.0 { format!("{value:.2}") } else { format!("{value:.0}") }
}

/// Formats an integer with commas between groups of three digits.
pub(crate) fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let comma = |at: usize| at > 0 && (digits.len() - at).is_multiple_of(3);
    digits.char_indices().flat_map(|(at, digit)| comma(at).then_some(',').into_iter().chain([digit])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        drag::DragTimes,
        results::{Baseline, Evaluation, Memory, Timings},
    };

    fn solve(samples: usize, regions_ms: f64, weights_ms: f64) -> Solve {
        let solve_ms = regions_ms + weights_ms;
        Solve {
            samples,
            virtual_sites: 7,
            domain_ms: 0.5,
            sampling_ms: 1.0,
            regions_ms,
            weights_ms,
            solve_ms,
            total_ms: solve_ms + 1.0,
        }
    }

    /// Timings that meet every requirement exactly, except one that they miss.
    fn timings() -> Timings {
        Timings {
            scenes: TABLE_1.iter().map(|paper| solve(paper.samples as usize, 5.0, 2.0)).collect(),
            resolutions: [solve(627, 0.25, 0.25), solve(31_325, 16.0, 14.0), solve(619_649, 500.0, 400.0)],
            first: [
                solve(627, 0.25, 0.25),
                solve(31_325, 1.0, 2.0),
                solve(619_649, 50.0, 40.0),
                solve(10_000, 6.0, 4.0),
            ],
            small: solve(10_000, 6.0, 4.0),
            many_sites: solve(31_325, 60.0, 30.5),
            insertion: solve(31_325, 5.0, 5.25),
            baseline: Baseline { pass_ms: 7.5, graph_ms: 1.875 },
            evaluation: Evaluation { influences_ms: 300.0, weights_ms: 250.0 },
            fine_evaluation_ms: 240.0,
            drag: DragTimes { frame: 8.0, slow_frame: 14.0, first: 80.0, settle: 60.0, harmonic: 0.03 },
        }
    }

    fn line<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
        let line = text.lines().find(|line| line.trim_start_matches("| ").starts_with(name));
        line.unwrap_or_else(|| panic!("no line {name:?} in {text}")).split('|').map(str::trim).collect()
    }

    #[test]
    fn requirements_are_met_or_missed() {
        let mut wasm = timings();
        wasm.small.solve_ms *= 1.7;
        let memory = Memory { samples: 100, virtual_sites: 60, held_bytes: 40_100, peak_bytes: 80_000 };
        let mut results = Results { native: timings(), wasm: Some(wasm), memory: Some(memory) };
        let text = tables(&results);
        for (name, limit, value, verdict, wasm) in [
            ("one pass ÷ Dijkstra on the graph", "≤ 4 ×", "4.00", "met", "4.00"),
            ("solve of 31,325, 6 handles", "≤ 4 passes", "4.00", "met", "4.00"),
            ("solve of 31,325, 60 virtual sites", "≤ 12 passes", "12.07", "missed", "12.07"),
            ("solve of 619,649 ÷ 31,325", "≤ 30 ×", "30.00", "met", "30.00"),
            ("one more handle at 31,325", "≤ 1.5 passes", "1.50", "met", "1.50"),
            ("sampling ÷ solve of 31,325, first", "≤ 2 ×", "0.33", "met", "0.33"),
            ("outline to weights at 31,325, first", "≤ 10 ms", "4.00", "met", "4.00"),
            ("outline to weights at 619,649, first", "≤ 150 ms", "91.00", "met", "91.00"),
            ("solve of 10,000  ", "≤ 10 ms", "10.00", "met", "17.00"),
            ("solve of 619,649  ", "≤ 900 ms", "900", "met", "900"),
            ("solve of 10,000, then", "≤ 250 ms", "250", "met", "257"),
            ("frame of a drag, 150 virtual sites", "≤ 8 ms", "8.00", "met", "8.00"),
            ("1 % slowest frames of a drag", "≤ 14 ms", "14.00", "met", "14.00"),
            ("first pose from rest", "≤ 80 ms", "80.00", "met", "80.00"),
            ("WebAssembly ÷ native, worst case: small", "≤ 1.6 ×", "1.70", "missed", "–"),
            ("memory per sample, 60 virtual sites (peak 800)", "≤ 400 bytes", "401", "missed", "–"),
        ] {
            assert_eq!(line(&text, name)[2..6], [limit, value, verdict, wasm], "{name}\n{text}");
        }
        results.native.baseline.pass_ms = f64::NAN;
        assert_eq!(line(&tables(&results), "one pass ÷")[4], "missed");
    }

    #[test]
    fn tables_show_the_papers_values() {
        let results = Results { native: timings(), wasm: None, memory: None };
        let text = tables(&results);
        let tower = ["Tower", "12", "0", "113", "7", "7,834", "7,834", "3,750", "5.00", "–", "13.0", "2.00", "–"];
        assert_eq!(line(&text, "Tower")[1..14], tower);
        assert_eq!(line(&text, "31,325 ")[1..7], ["31,325", "31,325", "8,691", "110", "30.0", "–"]);
        assert_eq!(line(&text, "619,649 ")[1..7], ["619,649", "619,649", "–", "20,796", "900", "–"]);
        assert!(!text.contains("WebAssembly ÷") && !text.contains("memory per sample"));
    }

    #[test]
    fn thousands_are_separated_by_commas() {
        assert_eq!(
            [0, 12, 999, 1_000, 619_649, 1_234_567].map(thousands).join(" "),
            "0 12 999 1,000 619,649 1,234,567"
        );
    }
}
