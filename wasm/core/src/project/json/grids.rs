//! Grids over the picture as JSON: stiffness and displacement.

use base64::{Engine, engine::general_purpose::STANDARD};
use serde::Serializer;

use super::cursor::Cursor;
use super::grid_values::{read_bytes, read_sides};
use crate::project::{Displacement, ProjectError, Stiffness, displacement::SIDES, stiffness::CELLS};

impl Stiffness {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let grid = value.object()?;
        grid.allow_only(&["width", "height", "values"])?;
        let sides @ [width, height] = read_sides(&grid, &CELLS)?;
        let values = read_bytes(grid.required("values")?, sides, 1, "cells")?;
        Ok(Self { width, height, values })
    }
}

impl Displacement {
    pub(super) fn read(value: Cursor<'_>) -> Result<Self, ProjectError> {
        let grid = value.object()?;
        grid.allow_only(&["width", "height", "values"])?;
        let sides @ [width, height] = read_sides(&grid, &SIDES)?;
        let bytes = read_bytes(grid.required("values")?, sides, 4, "control points")?;
        let values = bytes.as_chunks::<2>().0.iter().map(|&bytes| i16::from_le_bytes(bytes)).collect();
        Ok(Self { width, height, values })
    }
}

/// Writes bytes.
pub(in crate::project) fn bytes_as_base64<S: Serializer>(values: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&STANDARD.encode(values))
}

/// Writes 16-bit numbers, little-endian.
pub(in crate::project) fn numbers_as_base64<S: Serializer>(values: &[i16], serializer: S) -> Result<S::Ok, S::Error> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    serializer.serialize_str(&STANDARD.encode(bytes))
}
