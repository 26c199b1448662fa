//! Typed reading of a JSON [`Value`]. A cursor knows the path of its value, so every error can name it.

use std::fmt::Display;
use std::ops::RangeInclusive;

use glam::DVec2;

use super::value::Value;
use crate::project::{ProjectError, path::Path, validate};

/// A position in a JSON document: a value and its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    value: &'a Value,
    path: Path<'a>,
}

impl<'a> Cursor<'a> {
    /// The top of a document.
    pub(super) fn top(value: &'a Value) -> Self {
        Self { value, path: Path::Top }
    }

    /// Returns an error about this value.
    pub(super) fn refuse<T>(&self, message: impl Display) -> Result<T, ProjectError> {
        self.path.refuse(message)
    }

    /// Returns an error about a value of a wrong type.
    pub(super) fn expected<T>(&self, expected: impl Display) -> Result<T, ProjectError> {
        self.refuse(format_args!("expected {expected}, found {}", self.value))
    }

    pub(super) fn bool(&self) -> Result<bool, ProjectError> {
        match self.value {
            Value::Bool(value) => Ok(*value),
            _ => self.expected("true or false"),
        }
    }

    pub(super) fn string(&self) -> Result<&'a str, ProjectError> {
        match self.value {
            Value::String(text) => Ok(text),
            _ => self.expected("a string"),
        }
    }

    /// A number. Numbers in JSON are finite.
    pub(super) fn number(&self) -> Result<f64, ProjectError> {
        match self.value {
            Value::Number(number) => Ok(*number),
            _ => self.expected("a number"),
        }
    }

    /// A whole number. `range` is for the error message only: [`validate`] checks it.
    pub(super) fn whole_number(&self, range: &RangeInclusive<u32>) -> Result<u32, ProjectError> {
        match self.value {
            Value::Number(number) if number.fract() == 0.0 && *number >= 0.0 && *number <= f64::from(u32::MAX) => {
                // The cast is exact: the number is whole and in the range of u32.
                Ok(*number as u32)
            }
            _ => self.expected(validate::whole_numbers(range)),
        }
    }

    /// The value for one of a few names.
    pub(super) fn one_of<T: Copy>(&self, names: &[(&str, T)]) -> Result<T, ProjectError> {
        if let Value::String(text) = self.value
            && let Some((_, value)) = names.iter().find(|(name, _)| name == text)
        {
            return Ok(*value);
        }
        let names: Vec<_> = names.iter().map(|(name, _)| format!("{name:?}")).collect();
        self.expected(names.join(" or "))
    }

    /// A point `[x, y]`.
    pub(super) fn point(&self) -> Result<DVec2, ProjectError> {
        let Value::List(pair) = self.value else {
            return self.expected("a point [x, y]");
        };
        if pair.len() != 2 {
            let plural = if pair.len() == 1 { "" } else { "s" };
            return self.refuse(format_args!("expected a point [x, y], found {} value{plural}", pair.len()));
        }
        Ok(DVec2::new(self.item(0, &pair[0]).number()?, self.item(1, &pair[1]).number()?))
    }

    /// Whether the value is a list that begins with a list.
    pub(super) fn is_list_of_lists(&self) -> bool {
        matches!(self.value, Value::List(items) if matches!(items.first(), Some(Value::List(_))))
    }

    pub(super) fn points(&self) -> Result<Vec<DVec2>, ProjectError> {
        self.list("a list of points [[x, y], …]", |item| item.point())
    }

    /// A list. `read` reads each item.
    pub(super) fn list<T>(
        &self,
        expected: &str,
        read: impl Fn(Cursor<'_>) -> Result<T, ProjectError>,
    ) -> Result<Vec<T>, ProjectError> {
        let Value::List(items) = self.value else {
            return self.expected(expected);
        };
        items.iter().enumerate().map(|(index, item)| read(self.item(index, item))).collect()
    }

    /// An object. [`Object::allow_only`] checks its keys.
    pub(super) fn object(&self) -> Result<Object<'_>, ProjectError> {
        match self.value {
            Value::Object(entries) => Ok(Object { entries, path: &self.path }),
            _ => self.expected("an object"),
        }
    }

    fn item<'b>(&'b self, index: usize, value: &'b Value) -> Cursor<'b> {
        Cursor { value, path: Path::Index(&self.path, index) }
    }
}

/// A JSON object and its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Object<'a> {
    entries: &'a [(String, Value)],
    path: &'a Path<'a>,
}

impl<'a> Object<'a> {
    /// Rejects keys that are not in `known`.
    pub(super) fn allow_only(&self, known: &[&str]) -> Result<(), ProjectError> {
        match self.entries.iter().find(|(key, _)| !known.contains(&key.as_str())) {
            None => Ok(()),
            Some((key, value)) => Cursor { value, path: Path::Key(self.path, key) }
                .refuse(format_args!("unknown key; expected one of {}", known.join(", "))),
        }
    }

    pub(super) fn optional(&self, key: &'a str) -> Option<Cursor<'a>> {
        let (_, value) = self.entries.iter().find(|(known, _)| known == key)?;
        Some(Cursor { value, path: Path::Key(self.path, key) })
    }

    pub(super) fn required(&self, key: &'a str) -> Result<Cursor<'a>, ProjectError> {
        self.optional(key)
            .ok_or_else(|| ProjectError { path: Path::Key(self.path, key).to_string(), message: "missing".to_owned() })
    }

    /// Reads the value of a key with `read`, or returns `default` if the key is missing.
    pub(super) fn value_or<T>(
        &self,
        key: &'a str,
        default: T,
        read: impl Fn(Cursor<'_>) -> Result<T, ProjectError>,
    ) -> Result<T, ProjectError> {
        self.optional(key).map_or(Ok(default), read)
    }
}
