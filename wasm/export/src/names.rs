//! Names that every format accepts.

use std::collections::BTreeSet;

use c2warp::DisplayName;

/// Characters that Godot rejects in names of nodes and animations.
const REFUSED: &[char] = &['.', ':', '@', '/', '"', '%', ',', '[', ']', '\\'];

/// Hands out unique names.
#[derive(Debug, Default)]
pub(crate) struct Names(BTreeSet<String>);

impl Names {
    /// Returns the name with rejected characters replaced, and a number appended if it is taken.
    pub(crate) fn unique(&mut self, name: &str) -> String {
        let is_refused = |c: char| DisplayName::is_escaped(c) || REFUSED.contains(&c);
        let plain: String = name.chars().map(|c| if is_refused(c) { '_' } else { c }).collect();
        let mut unique = plain.clone();
        for number in 2.. {
            if self.0.insert(unique.clone()) {
                break;
            }
            unique = format!("{plain} {number}");
        }
        unique
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn names_are_unique_after_characters_are_replaced() {
        let mut names = Names::default();
        assert_eq!(names.unique("hand"), "hand");
        assert_eq!(names.unique("a/b"), "a_b");
        assert_eq!(names.unique("a:b"), "a_b 2");
        assert_eq!(names.unique("hand"), "hand 2");
        assert_eq!(names.unique("left\n\u{202e}"), "left__");
    }
}
