//! Second maxima of weights (the paper's figure 9) on scenes like those of its Table I, counted on the mesh.

use c2warp::{
    Error,
    project::{Project, Support},
    solve,
};
use c2warp_bench::cases::{TABLE_1, table_1};
use c2warp_tests::secondary_maxima::SecondaryMaxima;

use crate::methods::EDITOR_DENSITY;

/// How weights are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weighting {
    /// The paper's supports and as many virtual sites as it had.
    Paper,
    /// What the editor asks for.
    Editor,
}

/// The second maxima of one scene.
#[derive(Debug, Clone)]
pub struct SceneMaxima {
    /// The scene's name.
    pub scene: &'static str,
    /// How its weights are asked for.
    pub weighting: Weighting,
    /// Its second maxima.
    pub maxima: SecondaryMaxima,
}

/// Those of all scenes, each in both ways.
///
/// # Errors
/// None that a scene of the benchmark has.
pub fn maxima() -> Result<Vec<SceneMaxima>, Error> {
    let mut all = Vec::new();
    for (scene, paper) in table_1().iter().zip(TABLE_1) {
        for weighting in [Weighting::Paper, Weighting::Editor] {
            let project = match weighting {
                Weighting::Paper => scene.project(paper.samples, paper.virtual_sites),
                Weighting::Editor => smooth(scene.project(paper.samples, EDITOR_DENSITY)),
            };
            let maxima = SecondaryMaxima::of(&solve(&project, &scene.picture()?)?);
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
    /// What tables call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper's supports",
            Self::Editor => "editor's",
        }
    }
}
