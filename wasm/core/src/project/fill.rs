//! How the picture behind a part that moves away is filled.

/// How the picture behind a domain of rings is filled where the bending part moves away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Fill", deny_unknown_fields))]
#[non_exhaustive]
pub struct FillSpec {
    /// The source of the colours.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub method: FillMethod,
    /// Chooses one of many equally good results. The same seed always gives the same pixels.
    #[cfg_attr(feature = "schema", schemars(default))]
    pub seed: u32,
}

/// The source of the colours of a fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[non_exhaustive]
pub enum FillMethod {
    /// Similar patches of the surrounding picture.
    #[default]
    Patches,
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
