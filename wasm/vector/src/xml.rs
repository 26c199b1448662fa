//! XML as text, one element per line, or all in one line.

use std::fmt::{Display, Write};

/// Writes elements in document order.
#[derive(Debug, Default)]
pub(crate) struct Xml {
    text: String,
    /// Whether the start tag of the last element still lacks its `>`.
    is_open: bool,
    /// Whether no white space is added, which would change texts.
    is_one_line: bool,
}

impl Xml {
    /// Elements without white space between them.
    pub(crate) fn in_one_line() -> Self {
        Self { is_one_line: true, ..Self::default() }
    }

    pub(crate) fn open(&mut self, name: &str) {
        self.end_start_tag();
        self.text.push_str(if self.is_one_line { "<" } else { "\n<" });
        self.text.push_str(name);
        self.is_open = true;
    }

    pub(crate) fn attribute(&mut self, name: &str, value: impl Display) {
        let value = value.to_string();
        let _ = write!(self.text, " {name}=\"");
        for character in value.chars() {
            match character {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '"' => self.text.push_str("&quot;"),
                '\n' | '\t' | '\r' => {
                    let _ = write!(self.text, "&#{};", u32::from(character));
                }
                _ => self.text.push(character),
            }
        }
        self.text.push('"');
    }

    pub(crate) fn close(&mut self, name: &str) {
        if self.is_open {
            self.text.push_str("/>");
        } else {
            self.text.push_str(if self.is_one_line { "</" } else { "\n</" });
            let _ = write!(self.text, "{name}>");
        }
        self.is_open = false;
    }

    /// Characters between elements.
    pub(crate) fn text(&mut self, characters: &str) {
        self.end_start_tag();
        for character in characters.chars() {
            match character {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                _ => self.text.push(character),
            }
        }
    }

    /// Complete elements as text.
    pub(crate) fn append(&mut self, elements: &str) {
        self.end_start_tag();
        self.text.push_str(elements);
    }

    pub(crate) fn into_text(self) -> String {
        self.text
    }

    fn end_start_tag(&mut self) {
        if self.is_open {
            self.text.push('>');
            self.is_open = false;
        }
    }
}

/// A number with a given number of decimals, without trailing zeros.
pub(crate) fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_nested_and_attributes_escaped() {
        let mut xml = Xml::default();
        xml.open("g");
        xml.attribute("id", "a<\"&\n");
        xml.open("path");
        xml.close("path");
        xml.close("g");
        assert_eq!(xml.into_text(), "\n<g id=\"a&lt;&quot;&amp;&#10;\">\n<path/>\n</g>");
    }

    #[test]
    fn texts_are_escaped_and_get_no_white_space() {
        let mut xml = Xml::in_one_line();
        xml.open("text");
        xml.text(" a<b]]>&");
        xml.open("tspan");
        xml.close("tspan");
        xml.close("text");
        assert_eq!(xml.into_text(), "<text> a&lt;b]]&gt;&amp;<tspan/></text>");
    }

    #[test]
    fn numbers_have_no_needless_digits() {
        let numbers =
            [(1.5, 3), (-0.000_01, 3), (12.345_67, 2), (100.0, 0)].map(|(value, digits)| number(value, digits));
        assert_eq!(numbers, ["1.5", "0", "12.35", "100"]);
    }
}
