//! The way from the top of a file to a value in it, kept on the stack until an error wants it in words.

use std::fmt;

/// A way into the file, one step longer than its parent's.
#[derive(Debug, Clone, Copy)]
pub(super) enum Path<'a> {
    /// The file itself.
    Top,
    /// A key of an object.
    Key(&'a Path<'a>, &'a str),
    /// A place in a list, from 0.
    Index(&'a Path<'a>, usize),
}

impl fmt::Display for Path<'_> {
    /// Writes `handles[2].rest[0]`; a key that is no plain word is quoted: `image["a b"]`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Path::Top => Ok(()),
            Path::Index(parent, index) => write!(f, "{parent}[{index}]"),
            Path::Key(parent, key) if !is_word(key) => write!(f, "{parent}[{key:?}]"),
            Path::Key(Path::Top, key) => f.write_str(key),
            Path::Key(parent, key) => write!(f, "{parent}.{key}"),
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
    fn reads_as_code_would_address_it() {
        let handles = Path::Key(&Path::Top, "handles");
        let third = Path::Index(&handles, 2);
        let rest = Path::Key(&third, "rest");
        assert_eq!(Path::Index(&rest, 0).to_string(), "handles[2].rest[0]");
        assert_eq!(Path::Key(&third, "a\nb").to_string(), r#"handles[2]["a\nb"]"#);
        assert_eq!(Path::Top.to_string(), "");
    }
}
