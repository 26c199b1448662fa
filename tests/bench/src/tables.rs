//! The results as a person reads them: tables in Markdown, aligned.

use crate::{
    aligned::aligned,
    bars::bars,
    cases::{TABLE_1, TABLE_2},
    results::{Figure, Results},
    suite::{DENSE, POSED, SMALL},
};

/// What stands where there is no figure.
const NONE: &str = "–";

/// Everything that was measured, beside what the paper says, and which bars it meets.
#[must_use]
pub fn tables(results: &Results) -> String {
    let parts = [
        ("Table I: regions and weights of six scenes, ms", table_1(results), TABLE_1_NOTE),
        ("Table II: one figure in three resolutions, ms", table_2(results), TABLE_2_NOTE),
        ("Parts, ms", parts(results), ""),
        ("Bars", bar_table(results), BARS_NOTE),
    ];
    let part = |(title, table, note): (&str, String, &str)| format!("## {title}\n\n{table}{note}");
    parts.map(part).join("\n").trim_end().to_owned() + "\n"
}

const TABLE_1_NOTE: &str = "
Scenes drawn to resemble the paper's. Each scene asks for as many
virtual sites as the paper's had. t_rd is the stage of regions, t_w that of weights (harmonic fields and drawn mesh
included). The paper: one core of an i7-3740QM.
";

const TABLE_2_NOTE: &str = "
Six point handles that need no virtual site. Ours: regions and weights; the sampling stands apart, as the paper's
vertices were given.
";

const BARS_NOTE: &str = "
Every time is the least of many runs. A pass is one distance field without a bound, asked at every sample. A solve is
regions and weights. Bars in ms are for orientation, on two cores of a cloud machine. No verdict changes the exit status.
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
    let row = |(at, paper): (usize, &crate::cases::PaperScene)| {
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
    let row = |(at, paper): (usize, &crate::cases::PaperResolution)| {
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

fn parts(results: &Results) -> String {
    let [_, middle, fine] = TABLE_2.map(|row| thousands(row.samples as usize));
    let small = thousands(SMALL as usize);
    let [few, more, most] = POSED;
    let frame = |sites: u32| format!("a frame in the rigid mode, {sites} virtual sites");
    let cases: [(String, Figure); 17] = [
        (format!("one pass at {middle}"), |t| t.yardstick.pass_ms),
        (format!("one graph Dijkstra at {middle}"), |t| t.yardstick.graph_ms),
        (format!("{small}: regions"), |t| t.small.regions_ms),
        (format!("{small}: weights"), |t| t.small.weights_ms),
        (format!("{middle}: regions"), |t| t.resolutions[1].regions_ms),
        (format!("{middle}: weights"), |t| t.resolutions[1].weights_ms),
        (format!("{middle}, {DENSE} virtual sites: regions"), |t| t.dense.regions_ms),
        (format!("{middle}, {DENSE} virtual sites: weights"), |t| t.dense.weights_ms),
        ("one more handle: sampling".into(), |t| t.insertion.sampling_ms),
        ("one more handle: regions".into(), |t| t.insertion.regions_ms),
        ("one more handle: weights".into(), |t| t.insertion.weights_ms),
        ("a million points: weights and gradients".into(), |t| t.evaluation.influences_ms),
        ("a million points: weights".into(), |t| t.evaluation.weights_ms),
        (format!("weights of {fine} points from {small} samples"), |t| t.serving_ms),
        (frame(few), |t| t.frames_ms[0]),
        (frame(more), |t| t.frames_ms[1]),
        (frame(most), |t| t.frames_ms[2]),
    ];
    let row = |(what, time): (String, Figure)| {
        let (native, wasm) = (time(&results.native), results.wasm.as_ref().map(time));
        let ratio = wasm.map_or(NONE.into(), |wasm| format!("{:.2}", wasm / native));
        vec![what, milliseconds(native), or_none(wasm), ratio]
    };
    aligned(&["", "native", "wasm", "wasm ÷ native"], cases.into_iter().map(row), 1)
}

fn bar_table(results: &Results) -> String {
    let row = |bar: crate::bars::Bar| {
        vec![
            bar.what.clone(),
            format!("≤ {} {}", bar.limit, bar.unit),
            figure(bar.figure),
            bar.verdict().to_owned(),
            bar.wasm.map_or(NONE.into(), figure),
        ]
    };
    aligned(&["", "bar", "figure", "verdict", "in wasm"], bars(results).into_iter().map(row), 1)
}

fn or_none(ms: Option<f64>) -> String {
    ms.map_or(NONE.into(), milliseconds)
}

/// Milliseconds to about three digits.
fn milliseconds(ms: f64) -> String {
    match ms {
        _ if ms < 0.995 => format!("{ms:.3}"),
        _ if ms < 9.95 => format!("{ms:.2}"),
        _ if ms < 99.5 => format!("{ms:.1}"),
        _ => thousands(ms.round() as usize),
    }
}

/// The figure of a bar, to a digit more than its limit has.
fn figure(value: f64) -> String {
    if value < 100.0 { format!("{value:.2}") } else { format!("{value:.0}") }
}

/// A whole number with a comma after each three digits.
pub(crate) fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let comma = |at: usize| at > 0 && (digits.len() - at).is_multiple_of(3);
    digits.char_indices().flat_map(|(at, digit)| comma(at).then_some(',').into_iter().chain([digit])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::{Evaluation, Memory, Solve, Timings, Yardstick};

    fn solve(samples: usize, regions_ms: f64, weights_ms: f64) -> Solve {
        let solve_ms = regions_ms + weights_ms;
        Solve {
            samples,
            virtual_sites: 7,
            sampling_ms: 1.0,
            regions_ms,
            weights_ms,
            solve_ms,
            whole_ms: solve_ms + 1.0,
        }
    }

    /// Timings that meet every bar by exactly nothing but one, which they miss.
    fn timings() -> Timings {
        Timings {
            scenes: TABLE_1.iter().map(|paper| solve(paper.samples as usize, 5.0, 2.0)).collect(),
            resolutions: [solve(627, 0.25, 0.25), solve(31_325, 16.0, 14.0), solve(619_649, 500.0, 400.0)],
            small: solve(10_000, 6.0, 4.0),
            dense: solve(31_325, 60.0, 30.5),
            insertion: solve(31_325, 5.0, 5.25),
            yardstick: Yardstick { pass_ms: 7.5, graph_ms: 1.875 },
            evaluation: Evaluation { influences_ms: 300.0, weights_ms: 250.0 },
            serving_ms: 240.0,
            frames_ms: [0.04, 0.25, 1.0],
        }
    }

    fn line<'a>(text: &'a str, what: &str) -> Vec<&'a str> {
        let line = text.lines().find(|line| line.trim_start_matches("| ").starts_with(what));
        line.unwrap_or_else(|| panic!("no line {what:?} in {text}")).split('|').map(str::trim).collect()
    }

    #[test]
    fn bars_say_pass_or_short_as_the_figures_are() {
        let mut wasm = timings();
        wasm.small.solve_ms *= 1.7;
        let memory = Memory { samples: 100, virtual_sites: 60, held_bytes: 40_100, peak_bytes: 80_000 };
        let mut results = Results { native: timings(), wasm: Some(wasm), memory: Some(memory) };
        let text = tables(&results);
        for (what, limit, figure, verdict, wasm) in [
            ("one pass ÷ one graph Dijkstra", "≤ 4 ×", "4.00", "pass", "4.00"),
            ("solve of 31,325, 6 handles", "≤ 4 passes", "4.00", "pass", "4.00"),
            ("solve of 31,325, 60 virtual sites", "≤ 12 passes", "12.07", "short", "12.07"),
            ("solve of 619,649 ÷ 31,325", "≤ 30 ×", "30.00", "pass", "30.00"),
            ("one more handle at 31,325", "≤ 1.5 passes", "1.50", "pass", "1.50"),
            ("solve of 10,000  ", "≤ 10 ms", "10.00", "pass", "17.00"),
            ("solve of 619,649  ", "≤ 900 ms", "900", "pass", "900"),
            ("solve of 10,000, then", "≤ 250 ms", "250", "pass", "257"),
            ("a rigid pose, 200 virtual sites", "≤ 1 ms", "1.00", "pass", "1.00"),
            ("WebAssembly ÷ native, at worst: small", "≤ 1.6 ×", "1.70", "short", "–"),
            ("memory a sample, 60 virtual sites (800 while solving)", "≤ 400 bytes", "401", "short", "–"),
        ] {
            assert_eq!(line(&text, what)[2..6], [limit, figure, verdict, wasm], "{what}\n{text}");
        }
        results.native.yardstick.pass_ms = f64::NAN;
        assert_eq!(line(&tables(&results), "one pass ÷")[4], "short");
    }

    #[test]
    fn the_papers_figures_stand_beside_ours() {
        let results = Results { native: timings(), wasm: None, memory: None };
        let text = tables(&results);
        let tower = ["Tower", "12", "0", "113", "7", "7,834", "7,834", "3,750", "5.00", "–", "13.0", "2.00", "–"];
        assert_eq!(line(&text, "Tower")[1..14], tower);
        assert_eq!(line(&text, "31,325 ")[1..7], ["31,325", "31,325", "8,691", "110", "30.0", "–"]);
        assert_eq!(line(&text, "619,649 ")[1..7], ["619,649", "619,649", "–", "20,796", "900", "–"]);
        assert!(!text.contains("WebAssembly ÷") && !text.contains("memory a sample"));
    }

    #[test]
    fn numbers_are_grouped() {
        assert_eq!(
            [0, 12, 999, 1_000, 619_649, 1_234_567].map(thousands).join(" "),
            "0 12 999 1,000 619,649 1,234,567"
        );
    }
}
