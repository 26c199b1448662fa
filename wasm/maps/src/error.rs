//! Why a file of a map or of weights was not written.

/// Why a map was not encoded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// Encoding as OpenEXR failed.
    #[error("cannot write OpenEXR: {0}")]
    Exr(#[from] exr::error::Error),
    /// Encoding as PNG failed.
    #[error("cannot write PNG: {0}")]
    Png(#[from] png::EncodingError),
}

/// Why weights were not written as a table.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum WeightsError {
    /// The project has no handle of this name.
    #[error("there is no handle {name:?}: {}", listed(names))]
    NoHandle {
        /// The name.
        name: String,
        /// The names of all handles.
        names: Vec<String>,
    },
    /// The table is too large.
    #[error(
        "{} numbers need {}: {advice}",
        shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(" × "),
        size(*bytes)
    )]
    TooLarge {
        /// Points or rows and columns of points, then sites.
        shape: Vec<usize>,
        /// Its size.
        bytes: u64,
        /// How to make the table smaller.
        advice: &'static str,
    },
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "the project has no handles".to_owned() } else { format!("the project has {names:?}") }
}

fn size(bytes: u64) -> String {
    format!("{:.1} GB", bytes as f64 / 1e9)
}
