//! A JSON document as a tree.
//!
//! It keeps the order of keys and rejects duplicate keys, whereas `serde_json::Value` silently keeps the last
//! duplicate.

use std::{collections::HashSet, fmt};

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_path_to_error::{Segment, Segments};

use crate::display_number::DisplayNumber;
use crate::project::{ProjectError, path::Path};

/// One JSON value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    Null,
    Bool(bool),
    Number(f64),
    String(String),
    List(Vec<Value>),
    Object(Vec<(String, Value)>),
}

impl Value {
    /// Parses a whole document.
    ///
    /// # Errors
    /// For text that is not JSON, a number outside the range of f64, and a duplicate key. The path ends where reading
    /// stopped.
    pub(super) fn parse(text: &str) -> Result<Self, ProjectError> {
        // Editors on Windows write a byte order mark first. JSON has no such value.
        let mut json = serde_json::Deserializer::from_str(text.trim_start_matches('\u{feff}'));
        let value = serde_path_to_error::deserialize(&mut json).map_err(|error| {
            let path = path_text(Path::Top, error.path().iter());
            ProjectError { path, message: error.into_inner().to_string() }
        })?;
        json.end().map_err(|error| ProjectError { path: String::new(), message: error.to_string() })?;
        Ok(value)
    }
}

/// Writes the known rest of a path.
fn path_text(at: Path<'_>, mut rest: Segments<'_>) -> String {
    match rest.next() {
        Some(Segment::Seq { index }) => path_text(at.index(*index), rest),
        Some(Segment::Map { key }) => path_text(at.key(key), rest),
        _ => at.to_string(),
    }
}

impl fmt::Display for Value {
    /// Describes the value in an error: short values as JSON, long ones by their type.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const LONGEST_QUOTE: usize = 40;
        match self {
            Value::Null => f.write_str("null"),
            Value::Bool(value) => write!(f, "{value}"),
            Value::Number(value) => DisplayNumber(*value).fmt(f),
            Value::String(text) if text.chars().count() <= LONGEST_QUOTE => write!(f, "{text:?}"),
            Value::String(_) => f.write_str("a long string"),
            Value::List(items) if items.is_empty() => f.write_str("an empty list"),
            Value::List(_) => f.write_str("a list"),
            Value::Object(_) => f.write_str("an object"),
        }
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Bool(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(Value::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(Value::Number(value as f64))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
        Ok(Value::Number(value))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::String(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element()? {
            items.push(item);
        }
        Ok(Value::List(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        let (mut entries, mut known) = (Vec::new(), HashSet::new());
        while let Some(key) = object.next_key::<String>()? {
            if !known.insert(key.clone()) {
                return Err(A::Error::custom(format_args!("duplicate key {}", Value::String(key))));
            }
            let value = object.next_value()?;
            entries.push((key, value));
        }
        Ok(Value::Object(entries))
    }
}

#[cfg(test)]
mod tests {
    use super::Value;

    #[test]
    fn refuses_duplicate_keys() {
        let error = Value::parse(r#"{"a": [{"b": 1, "b": 2}]}"#).unwrap_err();
        assert!(error.message.contains(r#"duplicate key "b""#), "{error}");
        assert!(error.path.starts_with("a[0]"), "{error}");
    }

    #[test]
    fn finds_a_duplicate_among_many_keys() {
        // Comparing all pairs of keys would take minutes.
        let keys: Vec<String> = (0..300_000).map(|i| format!("\"k{i}\":0")).collect();
        let error = Value::parse(&format!("{{{},\"k7\":0}}", keys.join(","))).unwrap_err();
        assert!(error.message.contains(r#"duplicate key "k7""#), "{error}");
    }

    #[test]
    fn refuses_text_that_is_not_json() {
        for text in ["", "{", "[1,]", "NaN", "[1e999]", "[Infinity]", "{} {}", "{\"a\": nan}"] {
            assert!(Value::parse(text).is_err(), "{text}");
        }
        assert!(Value::parse(&"[".repeat(100_000)).is_err());
    }

    #[test]
    fn path_of_a_broken_value_is_one_line() {
        let error = Value::parse("{\"a\\nb\": [0, {\"c\": (}]}").unwrap_err();
        assert_eq!(error.path, r#"["a\nb"][1].c"#);
    }

    #[test]
    fn description_is_one_short_line() {
        let long = format!("[{:?}]", "x".repeat(99));
        assert_eq!(Value::parse("\"a\\nb\"").unwrap().to_string(), r#""a\nb""#);
        assert_eq!(Value::parse("12").unwrap().to_string(), "12");
        let Value::List(items) = Value::parse(&long).unwrap() else {
            panic!("a list was given");
        };
        assert_eq!(items[0].to_string(), "a long string");
    }
}
