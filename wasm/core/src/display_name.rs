//! Names in messages.

use std::fmt;

/// A name of a handle or a clip in a message: one line, in which characters that are not drawn are seen.
///
/// Control characters, and those that change the direction of text, are escaped. They could change the rest of a
/// message, or the state of a terminal.
///
/// ```
/// use c2warp::DisplayName;
///
/// assert_eq!(DisplayName("left\nhand\u{202e}").to_string(), r"left\nhand\u{202e}");
/// ```
#[derive(Debug, Clone, Copy)]
pub struct DisplayName<'a>(pub &'a str);

impl DisplayName<'_> {
    /// Whether a character is escaped. `web/src/texts/shown_name.ts` has the same ones.
    #[must_use]
    pub fn is_escaped(character: char) -> bool {
        let is_direction = matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        is_direction || character.is_control() || matches!(character, '\u{2028}' | '\u{2029}' | '\u{feff}')
    }
}

impl fmt::Display for DisplayName<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.0;
        while let Some((at, character)) = rest.char_indices().find(|&(_, character)| Self::is_escaped(character)) {
            f.write_str(&rest[..at])?;
            match character {
                '\n' => f.write_str("\\n"),
                '\r' => f.write_str("\\r"),
                '\t' => f.write_str("\\t"),
                _ => write!(f, "{}", character.escape_unicode()),
            }?;
            rest = &rest[at + character.len_utf8()..];
        }
        f.write_str(rest)
    }
}

#[cfg(test)]
mod tests {
    use super::DisplayName;

    #[test]
    fn characters_that_are_not_drawn_are_seen() {
        for (name, shown) in [
            ("left hand", "left hand"),
            ("naïve 手 🖐\u{1f3fd}", "naïve 手 🖐\u{1f3fd}"),
            ("\u{1b}[31mred\u{9b}0m", r"\u{1b}[31mred\u{9b}0m"),
            ("a\tb\r\n", r"a\tb\r\n"),
            ("\u{202e}dnah\u{2066}\u{200f}\u{2028}\u{feff}", r"\u{202e}dnah\u{2066}\u{200f}\u{2028}\u{feff}"),
        ] {
            assert_eq!(DisplayName(name).to_string(), shown);
        }
    }
}
