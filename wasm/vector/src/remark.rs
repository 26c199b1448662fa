//! Parts of a drawing that do not bend, or that are left out.

use std::fmt;

/// Maximum number of remarks on a drawing.
const MOST: usize = 20;
/// Maximum number of characters of a quotation in a remark.
const MOST_CHARACTERS: usize = 60;

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
    /// A picture in the drawing cannot be read.
    Picture,
    /// A property or attribute that affects the drawing is ignored.
    Property(String),
    /// A value that cannot be resolved is left out.
    Value {
        /// The property.
        property: String,
        /// Its value.
        value: String,
    },
    /// Rules of a style sheet are left out, by their selectors or conditions.
    Rules(String),
    /// Further remarks were dropped.
    More,
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
            Self::Picture => write!(f, "a picture in the drawing cannot be read, and is left out"),
            Self::Property(name) => write!(f, "the property {name} is not supported, and is left out"),
            Self::Value { property, value } => write!(f, "{property}: the value “{value}” is left out"),
            Self::Rules(rules) => write!(f, "the style rules of “{rules}” are left out"),
            Self::Pictures => write!(f, "pictures in the drawing move as a whole and do not bend"),
            Self::More => write!(f, "more parts are left out"),
        }
    }
}

impl Remark {
    pub(crate) fn value(property: &str, value: &str) -> Self {
        Self::Value { property: property.to_owned(), value: short(value) }
    }

    pub(crate) fn rules(rules: &str) -> Self {
        Self::Rules(short(rules))
    }
}

/// The start of a text, on one line.
fn short(text: &str) -> String {
    let words = text.split_whitespace().take(MOST_CHARACTERS).collect::<Vec<_>>();
    let line = words.join(" ");
    let start: String = line.chars().take(MOST_CHARACTERS).collect();
    if start == line { line } else { start + "…" }
}

/// Different remarks, up to [`MOST`].
#[derive(Debug, Clone, Default)]
pub(crate) struct Remarks(Vec<Remark>);

impl Remarks {
    pub(crate) fn note(&mut self, remark: Remark) {
        if self.0.len() > MOST || self.0.contains(&remark) {
            return;
        }
        self.0.push(if self.0.len() < MOST { remark } else { Remark::More });
    }

    pub(crate) fn all(&self) -> &[Remark] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn remarks_are_recorded_once_and_up_to_a_limit() {
        let mut remarks = Remarks::default();
        for at in 0..100 {
            remarks.note(Remark::Property(format!("p{}", at / 2)));
        }
        assert_eq!(remarks.all().len(), MOST + 1);
        assert_eq!(remarks.all().last(), Some(&Remark::More));
        let long = Remark::rules(&"a\n ".repeat(90)).to_string();
        assert!(long.ends_with("…” are left out") && !long.contains('\n'), "{long}");
    }
}
