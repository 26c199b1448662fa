//! The stages of a solve by name, and the time of each.

/// A stage of the solve. Between two stages a caller may decide to solve a newer project instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum Stage {
    /// The outline, from the picture's alpha or the project's rings, and the handles in it.
    Domain,
    /// Samples and the mesh over them.
    Sampling,
    /// Distances, cells and virtual sites.
    Regions,
    /// Supports, weights and harmonic fields.
    Weights,
}

impl Stage {
    /// The stage's name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Domain => "domain",
            Self::Sampling => "sampling",
            Self::Regions => "regions",
            Self::Weights => "weights",
        }
    }
}

/// Milliseconds spent in each stage, and on a pose. The crate has no clock, so the caller measures them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct StageTimes {
    /// Time of the stage `domain`.
    pub domain: f64,
    /// Time of the stage `sampling`.
    pub sampling: f64,
    /// Time of the stage `regions`.
    pub regions: f64,
    /// Time of the stage `weights`.
    pub weights: f64,
    /// A pose: the motions of the sites.
    pub pose: f64,
}

impl StageTimes {
    /// Adds milliseconds to the time of a stage.
    pub fn add(&mut self, stage: Stage, ms: f64) {
        let time = match stage {
            Stage::Domain => &mut self.domain,
            Stage::Sampling => &mut self.sampling,
            Stage::Regions => &mut self.regions,
            Stage::Weights => &mut self.weights,
        };
        *time += ms;
    }
}

#[cfg(test)]
mod tests {
    use schemars::generate::SchemaSettings;

    use super::Stage;

    #[test]
    fn schema_names_stages_as_reports_do() {
        let schema = SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<Stage>();
        let schema = schema.as_value().to_string();
        for stage in [Stage::Domain, Stage::Sampling, Stage::Regions, Stage::Weights] {
            assert!(schema.contains(&format!("\"{}\"", stage.name())), "{schema}");
        }
    }
}
