//! The path from the top of a project to a value in it. It lives on the stack and becomes text only in an error.

use std::fmt;

use super::error::ProjectError;

/// Characters of a key in a message. Those of the format are shorter.
const LONGEST_KEY: usize = 40;

/// A path into the project: one step after its parent.
#[derive(Debug, Clone, Copy)]
pub(super) enum Path<'a> {
    /// The project itself.
    Top,
    /// A key of an object.
    Key(&'a Path<'a>, &'a str),
    /// An index in a list, from 0.
    Index(&'a Path<'a>, usize),
}

impl Path<'_> {
    /// The path to a key of the object at this path.
    pub(super) fn key<'b>(&'b self, key: &'b str) -> Path<'b> {
        Path::Key(self, key)
    }

    /// The path to an item of the list at this path.
    pub(super) fn index(&self, index: usize) -> Path<'_> {
        Path::Index(self, index)
    }

    /// Returns an error about the value at this path.
    pub(super) fn refuse<T>(&self, message: impl fmt::Display) -> Result<T, ProjectError> {
        Err(ProjectError { path: self.to_string(), message: message.to_string() })
    }
}

impl fmt::Display for Path<'_> {
    /// Writes `handles[2].rest[0]`. A key that is not a word is quoted: `image["a b"]`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Path::Top => Ok(()),
            Path::Index(parent, index) => write!(f, "{parent}[{index}]"),
            Path::Key(parent, key) => {
                let start = key.char_indices().nth(LONGEST_KEY).map_or(*key, |(end, _)| &key[..end]);
                let rest = if start.len() < key.len() { "…" } else { "" };
                match parent {
                    _ if !is_word(start) => write!(f, "{parent}[{start:?}{rest}]"),
                    Path::Top => write!(f, "{start}{rest}"),
                    parent => write!(f, "{parent}.{start}{rest}"),
                }
            }
        }
    }
}

fn is_word(key: &str) -> bool {
    !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-$".contains(c))
}

#[cfg(test)]
mod tests {
    use super::Path;

    #[test]
    fn path_reads_like_code() {
        let handles = Path::Key(&Path::Top, "handles");
        let third = Path::Index(&handles, 2);
        let rest = Path::Key(&third, "rest");
        assert_eq!(Path::Index(&rest, 0).to_string(), "handles[2].rest[0]");
        assert_eq!(Path::Key(&third, "a\nb").to_string(), r#"handles[2]["a\nb"]"#);
        assert_eq!(Path::Top.to_string(), "");
        assert_eq!(Path::Key(&third, &"é".repeat(41)).to_string(), format!("handles[2].{}…", "é".repeat(40)));
    }
}
