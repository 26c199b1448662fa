//! The samples of a shape as JSON.

use super::cursor::Cursor;
use crate::project::{ProjectError, ShapeSample};

impl ShapeSample {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let expected = "a sample of eight numbers";
        let numbers = value.list(expected, |number| number.number())?;
        match <[f64; 8]>::try_from(numbers) {
            Ok(numbers) => Ok(Self::from_numbers(numbers)),
            Err(numbers) => value.refuse(format_args!("expected {expected}, found {}", numbers.len())),
        }
    }
}
