//! The printed tables, in Markdown.

use std::fmt::Write;

use c2warp::suggest::SuggestedRole;
use c2warp_bench::aligned::aligned;

use crate::{
    continuity::{STEPS_PX, SceneContinuity},
    distances::{Distances, greatest},
    drag_tables::drag_tables,
    drags::SampleDrags,
    fills::Filled,
    maxima::SceneMaxima,
    measure::MAX_ENERGY,
    methods::{Comparison, EDITOR, METHODS_BESIDE_OPTIMUM, Method, OTHER_SAMPLES, Outcome},
    poses::SAMPLES,
    requirements::{
        Requirement, continuity_requirements, distance_requirements, drag_requirements, maxima_requirements,
        optimum_requirements, pose_requirements, suggestion_requirements,
    },
    suggestions::Suggested,
};
use c2warp::project::Continuity;

const FILL_NOTES: &str = "
Four things are pasted into each picture and taken out again. Colour: mean error in levels. Gradient: mean error in
levels per pixel. Texture: mean gradient, divided by that of the truth.
";

/// The errors of fills by each method.
#[must_use]
pub fn fill_table(filled: &[Filled]) -> String {
    let mut rows = Vec::new();
    for filled in filled {
        for (at, (method, measured)) in filled.methods.into_iter().zip(&filled.measured).enumerate() {
            rows.push(vec![
                if at == 0 { filled.name.clone() } else { String::new() },
                method.to_owned(),
                format!("{:.1}", measured.colour),
                format!("{:.1}", measured.gradient),
                format!("{:.2}", measured.texture),
                if at == 0 { format!("{:.0}", filled.ms) } else { NONE.to_owned() },
            ]);
        }
    }
    aligned(&["picture", "method", "colour", "gradient", "texture", "ms"], rows.into_iter(), 2)
}

/// Placeholder for a missing value.
pub(crate) const NONE: &str = "–";

/// All results. Parts that did not run are empty.
#[derive(Debug, Default)]
pub struct Measured {
    /// Errors of distances.
    pub distances: Vec<Distances>,
    /// Second maxima of weights.
    pub maxima: Vec<SceneMaxima>,
    /// Jumps of the derivatives of weights.
    pub continuity: Vec<SceneContinuity>,
    /// Suggested handles.
    pub suggested: Vec<Suggested>,
    /// Fills.
    pub filled: Vec<Filled>,
    /// Drags of the editor's samples.
    pub drags: Vec<SampleDrags>,
    /// Poses by all methods.
    pub comparisons: Vec<Comparison>,
    /// Poses that failed, with the reason.
    pub failed: Vec<(String, String)>,
}

/// Formats all results and requirements.
#[must_use]
pub fn tables(measured: &Measured) -> String {
    let Measured { distances, maxima, continuity, suggested, filled, drags, comparisons, failed } = measured;
    let mut text = String::new();
    if !distances.is_empty() {
        write!(text, "## Distances\n\n{}{DISTANCE_NOTES}\n", distance_table(distances)).expect("memory");
    }
    if !maxima.is_empty() {
        write!(text, "## Secondary maxima of weights\n\n{}{MAXIMA_NOTES}\n", maxima_table(maxima)).expect("memory");
    }
    if !continuity.is_empty() {
        write!(text, "## Continuity of weights\n\n{}{CONTINUITY_NOTES}\n", continuity_table(continuity))
            .expect("memory");
    }
    if !suggested.is_empty() {
        write!(text, "## Suggested handles\n\n{}\n", suggestion_table(suggested)).expect("memory");
    }
    if !filled.is_empty() {
        write!(text, "## Fills\n\n{}{FILL_NOTES}\n", fill_table(filled)).expect("memory");
    }
    if !drags.is_empty() {
        text += &drag_tables(drags);
    }
    let (beside_optimum, standard): (Vec<&Comparison>, Vec<&Comparison>) =
        comparisons.iter().partition(|comparison| comparison.is_beside_optimum());
    if !standard.is_empty() || !failed.is_empty() {
        text += &poses(&standard, failed);
    }
    if !beside_optimum.is_empty() {
        write!(text, "## Beside the optimum\n\n{}{OPTIMUM_NOTES}\n", optimum_table(&beside_optimum)).expect("memory");
    }
    let requirements = distance_requirements(distances)
        .into_iter()
        .chain(maxima_requirements(maxima))
        .chain(continuity_requirements(continuity))
        .chain(suggestion_requirements(suggested))
        .chain(drag_requirements(drags))
        .chain(standard.iter().flat_map(|comparison| pose_requirements(comparison)))
        .chain(optimum_requirements(&beside_optimum));
    write!(text, "## Requirements\n\n{}", requirement_table(requirements)).expect("memory");
    text
}

fn poses(comparisons: &[&Comparison], failed: &[(String, String)]) -> String {
    let mut text = format!("## Quality of a pose\n\n{}{}", outcomes(comparisons), notes());
    for comparison in comparisons {
        for (method, reason) in &comparison.failed {
            writeln!(text, "{}: {} failed: {reason}", comparison.scene.name, method.name()).expect("memory");
        }
    }
    for (pose, reason) in failed {
        writeln!(text, "{pose} failed: {reason}").expect("memory");
    }
    write!(text, "\n## {} with other numbers of samples\n\n{}", EDITOR.name(), other_samples(comparisons))
        .expect("memory");
    text + "\nMean E, smallest stretch and folds, each on the mesh over the samples.\n\n"
}

const DISTANCE_NOTES: &str = "
Relative errors against exact geodesics at 400 samples, from each of four sources. A visibility graph over the reflex
corners finds the geodesics without the solver. Graph: Dijkstra's algorithm on the edges of the mesh between samples, as
in the paper. Times are for one source and all samples, on one core. An error of 0 means that the solver and the visibility
graph added the same square roots in the same order.
";

fn distance_table(all: &[Distances]) -> String {
    let header = ["domain", "corners", "samples", "c2warp mean", "largest", "ms", "graph mean", "largest", "ms"];
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
The paper saw none in its examples. A maximum counts if it rises by more than 0.01 above the pass to a higher one. The
table shows the number of them and the largest rise. Eq. 2 does not exclude them: if two supports reach a dead end, the
weight of the deeper one grows from the entrance on. Handles: the fields that move the picture, sums of all weights by
eq. 4.
";

fn maxima_table(all: &[SceneMaxima]) -> String {
    let header = ["scene", "weighting", "sites", "secondary maxima", "largest rise", "of handles", "largest rise"];
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

const CONTINUITY_NOTES: &str = "
Cut: sites whose supports hold points with two shortest paths. Crease: the largest jump of a gradient there, over the
largest gradient. The next two columns are the largest jump of a second derivative across shadow lines, over the largest
second derivative, measured with two steps. A jump stays as the step shrinks; a continuous derivative leaves a
thousandth. Lines are followed from 3 px off their corner. Times are the minimum of some solves.
";

fn continuity_table(all: &[SceneContinuity]) -> String {
    let [coarse, fine] = STEPS_PX.map(|step| format!("over {step} px"));
    let header = ["scene", "continuity", "sites", "cut", "crease", &coarse, &fine, "solve ms"];
    let row = |one: &SceneContinuity| {
        vec![
            one.scene.clone(),
            if one.continuity == Continuity::C2 { "c2" } else { "exact" }.to_owned(),
            one.sites.to_string(),
            one.cut_sites.to_string(),
            digits(one.crease),
            digits(one.shadows[0]),
            digits(one.shadows[1]),
            digits(one.solve_ms),
        ]
    };
    aligned(&header, all.iter().map(row), 2)
}

/// Formats a fraction as a percentage.
pub(crate) fn percent(fraction: f64) -> String {
    digits(100.0 * fraction) + " %"
}

fn notes() -> String {
    format!(
        "
All methods are compared on one mesh of about {SAMPLES} samples. Values are per triangle, weighted by area.

- E: symmetric Dirichlet energy |J|² + |J⁻¹|² − 4. It is capped at {MAX_ENERGY}, also for flipped triangles.
- ARAP: mean of |J − R|², the energy that dense minimises.
- Stretch: largest and smallest singular value of J, negative if flipped.
- Bending: Σ over inner edges of length ÷ distance between centroids · |J₁ − J₂|², without a unit.
- Error: largest error at a handle or a held outline.
- Moved: fraction of the area that moved by more than half a pixel.
- Pose: time for the motions of the sites, from rest. Frame: time from posed handles to posed vertices, after a frame in
  which handles were 1 % nearer to rest. Both are the minimum of some runs on one core.
- Dense: the lowest minimum found from the harmonic start and from the results of the other methods. Its time is from the
  harmonic start until an iteration lowers the energy by less than 1e-9 of it, without the factorisation. The time in
  brackets is until the energy is within 1 % of that. Its pins are single vertices. On a finer mesh they hold less, and
  the energy concentrates around them.
"
    )
}

fn outcomes(comparisons: &[&Comparison]) -> String {
    let header = [
        "pose", "method", "virtual", "E mean", "E 99 %", "ARAP", "stretch", "smallest", "folds", "bending", "error px",
        "moved", "pose ms", "frame ms", "÷ dense",
    ];
    let row = |comparison: &Comparison, outcome: &Outcome| {
        let d = &outcome.distortion;
        let dense = comparison.outcome_of(Method::Dense);
        let ratio_to_dense = |ratio: &dyn Fn(&Outcome) -> f64| dense.map_or(NONE.into(), |dense| digits(ratio(dense)));
        let near = outcome.iterations.map_or(String::new(), |(_, near)| format!(" ({})", digits(near)));
        vec![
            comparison.scene.name.clone(),
            outcome.method.name(),
            outcome.virtual_sites.map_or(NONE.into(), |count| count.to_string()),
            digits(d.energy),
            digits(d.energy_percentile_99),
            digits(d.rigidity),
            format!("{:.2}", d.max_stretch),
            format!("{:.2}", d.min_stretch),
            d.folds.to_string(),
            digits(d.bending),
            if outcome.handle_error < 1e-9 { "0".into() } else { format!("{:.0e}", outcome.handle_error) },
            format!("{:.0} %", 100.0 * d.moved),
            outcome.pose_ms.map_or(NONE.into(), digits),
            digits(outcome.frame_ms) + &near,
            ratio_to_dense(&|dense| d.energy / dense.distortion.energy),
        ]
    };
    let rows = comparisons
        .iter()
        .flat_map(|&comparison| comparison.outcomes.iter().map(move |outcome| row(comparison, outcome)));
    aligned(&header, rows, 2)
}

fn other_samples(comparisons: &[&Comparison]) -> String {
    let counts = OTHER_SAMPLES.map(|count| count.to_string());
    let header: Vec<&str> = std::iter::once("pose").chain(counts.iter().map(String::as_str)).collect();
    let row = |comparison: &&Comparison| {
        let figures = comparison
            .with_other_samples
            .iter()
            .map(|d| format!("{} {:.2} {}", digits(d.energy), d.min_stretch, d.folds));
        std::iter::once(comparison.scene.name.clone()).chain(figures).collect()
    };
    aligned(&header, comparisons.iter().map(row), 1)
}

const OPTIMUM_NOTES: &str = "
E of the optimum, and the other energies over it. The optimum is the least E on a mesh of about 3,000 samples, with the
vertices on handles pinned: the lowest minimum near the results of the other methods and at the end of a path that moves
the pins from rest. On the way no triangle turns over. Without a row's optimum, no such path was found. Folds: triangles
turned over, of the editor's method, the first one. The optimum has none. Times are for the motions of the sites, and
for all minima of the optimum together.

Turning: the angles between successive edges of the posed outline, over those of dense. Bending: over that of dense.
Both are of the editor's method.
";

fn optimum_table(comparisons: &[&Comparison]) -> String {
    let others: Vec<Method> = METHODS_BESIDE_OPTIMUM.into_iter().filter(|&method| method != Method::Optimum).collect();
    let header = ["pose", "vertices", "optimum"]
        .map(str::to_owned)
        .into_iter()
        .chain(others.iter().map(|method| method.name()))
        .chain(["folds", "turning", "bending", "pose ms", "optimum s"].map(str::to_owned));
    let header: Vec<String> = header.collect();
    let row = |comparison: &&Comparison| {
        let optimum = comparison.outcome_of(Method::Optimum);
        let ratio = |&method: &Method| {
            let energy = comparison.outcome_of(method).map(|outcome| outcome.distortion.energy);
            energy.zip(optimum).map_or(NONE.into(), |(energy, best)| digits(energy / best.distortion.energy))
        };
        let editor = comparison.outcome_of(EDITOR);
        let start = [
            comparison.scene.name.clone(),
            comparison.mesh.vertices.len().to_string(),
            optimum.map_or(NONE.into(), |best| digits(best.distortion.energy)),
        ];
        let end = [
            editor.map_or(NONE.into(), |editor| editor.distortion.folds.to_string()),
            comparison.over_dense(|d| d.turning).map_or(NONE.into(), digits),
            comparison.over_dense(|d| d.bending).map_or(NONE.into(), digits),
            editor.and_then(|editor| editor.pose_ms).map_or(NONE.into(), digits),
            optimum.map_or(NONE.into(), |best| digits(best.frame_ms / 1e3)),
        ];
        start.into_iter().chain(others.iter().map(ratio)).chain(end).collect()
    };
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    aligned(&header, comparisons.iter().map(row), 1)
}

fn suggestion_table(all: &[Suggested]) -> String {
    let roles = [SuggestedRole::Middle, SuggestedRole::End, SuggestedRole::Joint, SuggestedRole::Spread];
    let row = |suggested: &Suggested| {
        let counts = roles.map(|role| suggested.count(role).to_string());
        let start = [suggested.name.clone(), suggested.handles.len().to_string()];
        start.into_iter().chain(counts).chain([suggested.least_widths(), suggested.ms].map(digits)).collect()
    };
    aligned(
        &["picture", "handles", "middle", "end", "joint", "spread", "least distance, widths", "ms"],
        all.iter().map(row),
        1,
    )
}

fn requirement_table(requirements: impl Iterator<Item = Requirement>) -> String {
    let row = |requirement: Requirement| {
        let limit = if requirement.limit.is_finite() { format!("≤ {}", requirement.limit) } else { NONE.into() };
        let verdict = requirement.verdict().to_owned();
        vec![requirement.subject, requirement.name.to_owned(), limit, digits(requirement.value), verdict]
    };
    aligned(&["subject", "", "limit", "value", "verdict"], requirements.map(row), 2)
}

/// Formats a number with about three digits.
pub(crate) fn digits(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if size < 1e-3 => format!("{value:.0e}"),
        size if size < 0.995 => format!("{value:.3}"),
        size if size < 9.95 => format!("{value:.2}"),
        size if size < 99.5 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
