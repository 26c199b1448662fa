//! Counts secondary maxima of weights (the paper's figure 9) on scenes after its Table I.

use c2warp::{
    Error,
    project::{Project, Support},
    solve,
};
use c2warp_bench::cases::{TABLE_1, table_1};
use c2warp_tests::secondary_maxima::SecondaryMaxima;

use crate::methods::EDITOR_DENSITY;

/// The weighting of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weighting {
    /// The paper's supports and numbers of virtual sites.
    Paper,
    /// The editor's supports and numbers of virtual sites.
    Editor,
}

/// The secondary maxima of one scene.
#[derive(Debug, Clone)]
pub struct SceneMaxima {
    /// The name of the scene.
    pub scene: &'static str,
    /// The weighting.
    pub weighting: Weighting,
    /// The secondary maxima.
    pub maxima: SecondaryMaxima,
}

/// Finds the secondary maxima of all scenes with both weightings.
///
/// # Errors
/// If a scene cannot be solved.
pub fn maxima() -> Result<Vec<SceneMaxima>, Error> {
    let mut all = Vec::new();
    for (case, paper) in table_1().iter().zip(TABLE_1) {
        for weighting in [Weighting::Paper, Weighting::Editor] {
            let project = match weighting {
                Weighting::Paper => case.project(paper.samples, paper.virtual_sites),
                Weighting::Editor => smooth(case.project(paper.samples, EDITOR_DENSITY)),
            };
            let maxima = SecondaryMaxima::of(&solve(&project, &case.picture()?)?);
            all.push(SceneMaxima { scene: paper.name, weighting, maxima });
        }
    }
    Ok(all)
}

fn smooth(mut project: Project) -> Project {
    project.weighting.support = Support::Smooth;
    project
}

impl Weighting {
    /// Returns the name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper's supports",
            Self::Editor => "editor's",
        }
    }
}
