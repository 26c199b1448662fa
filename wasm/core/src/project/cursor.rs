//! Typed reading of a [`Value`]: every getter knows the path of its value, so that every error can state it.

use std::fmt::Display;
use std::ops::RangeInclusive;

use glam::DVec2;

use super::ProjectError;
use super::path::Path;
use super::rules;
use super::value::Value;

/// A value in the file and its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    value: &'a Value,
    path: Path<'a>,
}

impl<'a> Cursor<'a> {
    /// The top of a file.
    pub(super) fn top(value: &'a Value) -> Self {
        Self { value, path: Path::Top }
    }

    /// An error about this value.
    pub(super) fn refuse<T>(&self, message: impl Display) -> Result<T, ProjectError> {
        self.path.refuse(message)
    }

    pub(super) fn expected<T>(&self, what: impl Display) -> Result<T, ProjectError> {
        self.refuse(format_args!("expected {what}, found {}", self.value))
    }

    pub(super) fn bool(&self) -> Result<bool, ProjectError> {
        match self.value {
            Value::Bool(value) => Ok(*value),
            _ => self.expected("true or false"),
        }
    }

    pub(super) fn text(&self) -> Result<&'a str, ProjectError> {
        match self.value {
            Value::Text(text) => Ok(text),
            _ => self.expected("a text"),
        }
    }

    /// A number; numbers in JSON are finite.
    pub(super) fn number(&self) -> Result<f64, ProjectError> {
        match self.value {
            Value::Number(number) => Ok(*number),
            _ => self.expected("a number"),
        }
    }

    /// A whole number; `range` tells what is expected of it where this is none.
    pub(super) fn whole_number(&self, range: &RangeInclusive<u32>) -> Result<u32, ProjectError> {
        match self.value {
            Value::Number(number) if number.fract() == 0.0 && *number >= 0.0 && *number <= f64::from(u32::MAX) => {
                // Exact: a whole number within the range of u32.
                Ok(*number as u32)
            }
            _ => self.expected(rules::whole_numbers(range)),
        }
    }

    /// One of a few names, each with its value.
    pub(super) fn one_of<T: Copy>(&self, names: &[(&str, T)]) -> Result<T, ProjectError> {
        if let Value::Text(text) = self.value
            && let Some((_, value)) = names.iter().find(|(name, _)| name == text)
        {
            return Ok(*value);
        }
        let names: Vec<_> = names.iter().map(|(name, _)| format!("{name:?}")).collect();
        self.expected(names.join(" or "))
    }

    /// The pair `[x, y]`.
    pub(super) fn point(&self) -> Result<DVec2, ProjectError> {
        let Value::List(pair) = self.value else {
            return self.expected("a point [x, y]");
        };
        if pair.len() != 2 {
            return self.refuse(format_args!("expected a point [x, y], found {} values", pair.len()));
        }
        Ok(DVec2::new(self.item(0, &pair[0]).number()?, self.item(1, &pair[1]).number()?))
    }

    pub(super) fn points(&self) -> Result<Vec<DVec2>, ProjectError> {
        self.list("a list of points [[x, y], …]", |item| item.point())
    }

    /// A list, every item read by `read`.
    pub(super) fn list<T>(
        &self,
        what: &str,
        read: impl Fn(Cursor<'_>) -> Result<T, ProjectError>,
    ) -> Result<Vec<T>, ProjectError> {
        let Value::List(items) = self.value else {
            return self.expected(what);
        };
        items.iter().enumerate().map(|(index, item)| read(self.item(index, item))).collect()
    }

    /// An object, its keys not checked yet.
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

/// An object in the file and its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Object<'a> {
    entries: &'a [(String, Value)],
    path: &'a Path<'a>,
}

impl<'a> Object<'a> {
    /// Refuses every key that is not among `known`.
    pub(super) fn only(&self, known: &[&str]) -> Result<(), ProjectError> {
        match self.entries.iter().find(|(key, _)| !known.contains(&key.as_str())) {
            None => Ok(()),
            Some((key, value)) => Cursor { value, path: Path::Key(self.path, key) }
                .refuse(format_args!("unknown key; the keys here are {}", known.join(", "))),
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

    /// The value of a key by `read`, or `default` if the key is missing.
    pub(super) fn or<T>(
        &self,
        key: &'a str,
        default: T,
        read: impl Fn(Cursor<'_>) -> Result<T, ProjectError>,
    ) -> Result<T, ProjectError> {
        self.optional(key).map_or(Ok(default), read)
    }
}
