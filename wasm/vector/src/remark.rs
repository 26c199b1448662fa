//! Parts of a drawing that do not bend, or that are left out.

use std::fmt;

/// A remark on a part of a drawing.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Remark {
    /// Scripts and attributes with scripts are left out.
    Scripts,
    /// Animations are left out.
    Animations,
    /// Content of another language, such as HTML, is left out.
    Foreign,
    /// Another file is needed, and is not loaded.
    External(String),
    /// A text is left out, because it has no font.
    Text(String),
    /// A text is drawn in another font.
    Font {
        /// The families that the drawing requests.
        wanted: String,
        /// The family that is used instead.
        used: String,
    },
    /// Pictures move as a whole.
    Pictures,
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scripts => write!(f, "scripts are left out"),
            Self::Animations => write!(f, "animations are left out"),
            Self::Foreign => write!(f, "content that is not SVG is left out"),
            Self::External(address) => write!(f, "other files are never loaded, so {address:?} is left out"),
            Self::Text(text) => {
                write!(f, "the text “{text}” is left out: convert it to paths, or install its font")
            }
            Self::Font { wanted, used } => {
                write!(f, "the font {wanted:?} is not installed, so {used:?} is used instead")
            }
            Self::Pictures => write!(f, "pictures in the drawing move as a whole and do not bend"),
        }
    }
}
