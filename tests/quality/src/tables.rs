//! The results as a person reads them: tables in Markdown, aligned.

use std::fmt::Write;

use c2warp_bench::aligned::aligned;

use crate::{
    bars::{Bar, bars, distance_bars, maxima_bars},
    distances::{Distances, greatest},
    maxima::SceneMaxima,
    measure::MOST_ENERGY,
    methods::{Compared, EDITOR, Method, OTHER_SAMPLES, Outcome},
    poses::SAMPLES,
};

/// What stands where there is no figure.
const NONE: &str = "–";

/// Everything that was measured, and which bars it meets.
#[must_use]
pub fn tables(
    distances: &[Distances],
    maxima: &[SceneMaxima],
    all: &[Compared],
    unsolved: &[(&'static str, String)],
) -> String {
    let mut text = String::new();
    if !distances.is_empty() {
        write!(text, "## Distances\n\n{}{DISTANCE_NOTES}\n", distance_table(distances)).expect("memory");
    }
    if !maxima.is_empty() {
        write!(text, "## Second maxima of weights\n\n{}{MAXIMA_NOTES}\n", maxima_table(maxima)).expect("memory");
    }
    if !all.is_empty() || !unsolved.is_empty() {
        text += &poses(all, unsolved);
    }
    let bars = distance_bars(distances).into_iter().chain(maxima_bars(maxima)).chain(all.iter().flat_map(bars));
    write!(text, "## Bars\n\n{}", bar_table(bars)).expect("memory");
    text
}

fn poses(all: &[Compared], unsolved: &[(&'static str, String)]) -> String {
    let mut text = format!("## Quality of a pose\n\n{}{}", outcomes(all), notes());
    for compared in all {
        for (method, reason) in &compared.refused {
            writeln!(text, "{}: {} is left out: {reason}", compared.pose.name, method.name()).expect("memory");
        }
    }
    for (pose, reason) in unsolved {
        writeln!(text, "{pose} is left out: {reason}").expect("memory");
    }
    write!(text, "\n## {} with other numbers of samples\n\n{}", EDITOR.name(), other_samples(all)).expect("memory");
    text + "\nE mean, least stretch and folds, each on the mesh over the samples.\n\n"
}

const DISTANCE_NOTES: &str = "
Relative errors against the geodesic of the polygon, which a visibility graph over the reflex corners finds without the solver's help:
at 400 samples, from each of four sources. Graph: Dijkstra's algorithm along the edges of the samples' mesh, the paper's way. Times:
one source to all samples, on one core. Where an error is 0 both have added up the same square roots in the same order.
";

fn distance_table(all: &[Distances]) -> String {
    let header = ["domain", "corners", "samples", "c2warp mean", "greatest", "ms", "graph mean", "greatest", "ms"];
    let row = |d: &Distances| {
        vec![
            d.domain.to_owned(),
            d.corners.to_string(),
            d.samples.to_string(),
            digits(d.solver.mean),
            digits(d.solver.greatest),
            digits(d.solver_ms),
            percent(d.graph.mean),
            percent(d.graph.greatest),
            digits(d.graph_ms),
        ]
    };
    aligned(&header, all.iter().map(row), 1)
}

const MAXIMA_NOTES: &str = "
The paper saw none in its examples. Counted on the mesh: maxima that rise by more than 0.01 above the pass to a higher one, and how high
the highest rises. Eq. 2 does not rule them out: in a dead end that two supports reach, the weight of the one that ends farther in grows
from the entrance on. Handles: the fields by which they move the picture, sums of the weights of all sites by eq. 4.
";

fn maxima_table(all: &[SceneMaxima]) -> String {
    let header = ["scene", "weighting", "sites", "second maxima", "highest", "of handles", "highest"];
    let row = |SceneMaxima { scene, weighting, maxima }: &SceneMaxima| {
        let highest = |rises: &[f64]| match rises {
            [] => NONE.into(),
            some => digits(greatest(some.iter().copied())),
        };
        vec![
            (*scene).to_owned(),
            weighting.name().to_owned(),
            maxima.sites.to_string(),
            maxima.of_sites.len().to_string(),
            highest(&maxima.of_sites),
            maxima.of_handles.len().to_string(),
            highest(&maxima.of_handles),
        ]
    };
    aligned(&header, all.iter().map(row), 2)
}

fn percent(share: f64) -> String {
    digits(100.0 * share) + " %"
}

fn notes() -> String {
    format!(
        "
All on one mesh of about {SAMPLES} samples, figures by triangle and weighted by area. E: symmetric Dirichlet energy
|J|² + |J⁻¹|² − 4, {MOST_ENERGY} at most and for a triangle that is turned over. ARAP: mean of |J − R|², which dense minimises.
Stretch: largest and least singular value of J, negative where turned over. Bending: Σ over inner edges of length ÷ distance
between centroids · |J₁ − J₂|², without a unit. Off: farthest off a handle or a held outline. Moved: share of the area that
went farther than half a pixel. Pose: motions of the sites; frame: posed handles to posed vertices, on one core; the least time of
some runs, as in the benchmark. Dense: the lowest minimum found from the harmonic start and from every other row's result; its time is
from the harmonic start until the energy falls by less than 1e-9 of itself in a turn, the factorisation left out, and in brackets until
it is within 1 % of that. Its pins are single vertices: on a finer mesh they hold less, and its energy gathers around them.
"
    )
}

fn outcomes(all: &[Compared]) -> String {
    let header = [
        "pose", "method", "virtual", "E mean", "E 99 %", "ARAP", "stretch", "least", "folds", "bending", "off px",
        "moved", "pose ms", "frame ms", "÷ dense",
    ];
    let row = |compared: &Compared, outcome: &Outcome| {
        let d = &outcome.distortion;
        let dense = compared.by(Method::Dense);
        let of_dense = |ratio: &dyn Fn(&Outcome) -> f64| dense.map_or(NONE.into(), |dense| digits(ratio(dense)));
        let near = outcome.turns.map_or(String::new(), |(_, near)| format!(" ({})", digits(near)));
        vec![
            compared.pose.name.to_owned(),
            outcome.method.name(),
            outcome.virtual_sites.map_or(NONE.into(), |count| count.to_string()),
            digits(d.energy),
            digits(d.energy_99),
            digits(d.rigidity),
            format!("{:.2}", d.most_stretch),
            format!("{:.2}", d.least_stretch),
            d.folds.to_string(),
            digits(d.bending),
            if outcome.off_handles < 1e-9 { "0".into() } else { format!("{:.0e}", outcome.off_handles) },
            format!("{:.0} %", 100.0 * d.moved),
            outcome.pose_ms.map_or(NONE.into(), digits),
            digits(outcome.frame_ms) + &near,
            of_dense(&|dense| d.energy / dense.distortion.energy),
        ]
    };
    let rows = all.iter().flat_map(|compared| compared.outcomes.iter().map(move |outcome| row(compared, outcome)));
    aligned(&header, rows, 2)
}

fn other_samples(all: &[Compared]) -> String {
    let counts = OTHER_SAMPLES.map(|count| count.to_string());
    let header: Vec<&str> = std::iter::once("pose").chain(counts.iter().map(String::as_str)).collect();
    let row = |compared: &Compared| {
        let figures =
            compared.others.iter().map(|d| format!("{} {:.2} {}", digits(d.energy), d.least_stretch, d.folds));
        std::iter::once(compared.pose.name.to_owned()).chain(figures).collect()
    };
    aligned(&header, all.iter().map(row), 1)
}

fn bar_table(bars: impl Iterator<Item = Bar>) -> String {
    let row = |bar: Bar| {
        let limit = if bar.limit.is_finite() { format!("≤ {}", bar.limit) } else { NONE.into() };
        vec![bar.of.to_owned(), bar.what.to_owned(), limit, digits(bar.figure), bar.verdict().to_owned()]
    };
    aligned(&["of", "", "bar", "", ""], bars.map(row), 2)
}

/// A figure to about three digits.
fn digits(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if size < 1e-3 => format!("{value:.0e}"),
        size if size < 0.995 => format!("{value:.3}"),
        size if size < 9.95 => format!("{value:.2}"),
        size if size < 99.5 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
