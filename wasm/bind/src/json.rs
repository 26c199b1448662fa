//! Reports and explanations as JSON.

use std::io::{Result, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

/// Writes numbers with the standard library, as messages do, because serde_json would add large tables.
struct Compact;

impl Formatter for Compact {
    fn write_f64<W: Write + ?Sized>(&mut self, writer: &mut W, value: f64) -> Result<()> {
        write!(writer, "{value:?}")
    }
}

pub(crate) fn json(value: &impl Serialize) -> String {
    let mut text = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut text, Compact)).expect("a map of numbers is valid JSON");
    String::from_utf8(text).expect("JSON is UTF-8")
}
