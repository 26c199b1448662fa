//! Why a file of a map or of weights was not made.

/// A map that could not be encoded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// The OpenEXR file.
    #[error("the OpenEXR file could not be made: {0}")]
    Exr(#[from] exr::error::Error),
    /// The PNG file.
    #[error("the PNG file could not be made: {0}")]
    Png(#[from] png::EncodingError),
}

/// Weights that make no table.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum WeightsError {
    /// The project has no handle of this name.
    #[error("there is no handle {name:?}: {}", listed(names))]
    NoHandle {
        /// The name.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// A table that is too large.
    #[error("{} numbers take {}: {advice}", shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(" × "), size(*bytes))]
    TooLarge {
        /// Points or rows and columns of points, then sites.
        shape: Vec<usize>,
        /// Its size.
        bytes: u64,
        /// How to make it smaller.
        advice: &'static str,
    },
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "the project has none".to_owned() } else { format!("the project has {names:?}") }
}

fn size(bytes: u64) -> String {
    format!("{:.1} GB", bytes as f64 / 1e9)
}
