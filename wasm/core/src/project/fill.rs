//! How the picture behind a part that moves away is filled.

use std::ops::RangeInclusive;

use schemars::JsonSchema;
use serde::Serialize;

use super::cursor::Cursor;
use super::error::ProjectError;

const SEEDS: RangeInclusive<u32> = 0..=u32::MAX;

/// How the picture behind a domain of rings is filled, where the part that bends moves away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[schemars(rename = "Fill", deny_unknown_fields)]
#[non_exhaustive]
pub struct FillSpec {
    /// Where the colours come from.
    #[schemars(default)]
    pub method: FillMethod,
    /// Chooses one of many results, each as good as another. The same seed always gives the same pixels.
    #[schemars(default)]
    pub seed: u32,
}

/// Where the colours of a fill come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum FillMethod {
    /// From patches of the picture around that look alike.
    #[default]
    Patches,
}

impl FillSpec {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let fill = value.object()?;
        fill.allow_only(&["method", "seed"])?;
        let method = |value: Cursor<'_>| value.one_of(&[("patches", FillMethod::Patches)]);
        Ok(Self {
            method: fill.value_or("method", FillMethod::default(), method)?,
            seed: fill.value_or("seed", 0, |value| value.whole_number(&SEEDS))?,
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::project::{FillSpec, Project};

    fn read(fill: &str) -> Result<Project, String> {
        let text = format!(r#"{{"format":"c2warp/1","image":{{"src":"","width":9,"height":9}},{fill}"handles":[]}}"#);
        Project::from_json(&text).map_err(|error| error.to_string())
    }

    #[test]
    fn fills_are_read_with_defaults_and_written() {
        assert_eq!(read("").map(|project| project.fill), Ok(None));
        assert_eq!(read(r#""fill":{},"#).map(|project| project.fill), Ok(Some(FillSpec::default())));
        let project = read(r#""fill":{"method":"patches","seed":4294967295},"#).unwrap();
        assert_eq!(project.fill.map(|fill| fill.seed), Some(u32::MAX));
        assert!(project.to_json().contains(r#""fill": { "method": "patches", "seed": 4294967295 }"#));
        assert_eq!(Project::from_json(&project.to_json()), Ok(project));
        assert!(!read("").unwrap().to_json().contains(r#""fill""#));
    }

    #[test]
    fn invalid_fills_are_refused_by_their_path() {
        let refused = [
            (r#""fill":null,"#, "fill: expected an object, found null"),
            (r#""fill":{"method":"blur"},"#, r#"fill.method: expected "patches", found "blur""#),
            (r#""fill":{"seed":-1},"#, "fill.seed: expected a whole number"),
            (r#""fill":{"seed":0.5},"#, "fill.seed: expected a whole number"),
            (r#""fill":{"seeds":1},"#, "fill.seeds: unknown key; expected one of method, seed"),
        ];
        for (fill, message) in refused {
            let error = read(fill).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
