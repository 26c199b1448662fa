//! Checks of numbers and points in a project.

use std::ops::RangeInclusive;

use glam::DVec2;

use super::error::ProjectError;
use super::path::Path;
use crate::{
    display_number::DisplayNumber,
    limits::{MAX_NAME, MAX_POSED},
};

/// Describes a range for messages.
pub(super) fn whole_numbers(range: &RangeInclusive<u32>) -> String {
    match (range.start(), range.end()) {
        (least, &u32::MAX) => format!("a whole number, {least} or more"),
        (least, most) => format!("a whole number from {least} to {most}"),
    }
}

/// Checks the range of a whole number.
pub(super) fn whole_number(at: &Path<'_>, number: u32, range: &RangeInclusive<u32>) -> Result<(), ProjectError> {
    if range.contains(&number) {
        Ok(())
    } else {
        at.refuse(format_args!("expected {}, found {number}", whole_numbers(range)))
    }
}

/// Checks the name of a handle or a clip.
pub(super) fn name(at: &Path<'_>, name: &str) -> Result<(), ProjectError> {
    match name.chars().count() {
        0 => at.refuse("expected a name, found an empty string"),
        1..=MAX_NAME => Ok(()),
        length => at.refuse(format_args!("expected a name of at most {MAX_NAME} characters, found {length}")),
    }
}

/// Checks that a number is finite.
pub(super) fn finite(at: &Path<'_>, number: f64) -> Result<(), ProjectError> {
    if number.is_finite() { Ok(()) } else { at.refuse(format_args!("expected a finite number, found {number}")) }
}

/// Checks that a number is finite, and so are products with it.
pub(super) fn bounded(at: &Path<'_>, number: f64) -> Result<(), ProjectError> {
    if number.abs() <= MAX_POSED {
        return Ok(());
    }
    let found = DisplayNumber(number);
    at.refuse(format_args!("expected a number from −{MAX_POSED:e} to {MAX_POSED:e}, found {found}"))
}

/// Checks that both coordinates of a point are finite.
pub(super) fn point(at: &Path<'_>, point: DVec2) -> Result<(), ProjectError> {
    finite(&at.index(0), point.x)?;
    finite(&at.index(1), point.y)
}

/// Checks that there are at least `least` points, all finite.
pub(super) fn points(at: &Path<'_>, points: &[DVec2], least: usize) -> Result<(), ProjectError> {
    if points.len() < least {
        return at.refuse(format_args!("expected at least {least} points, found {}", points.len()));
    }
    points.iter().enumerate().try_for_each(|(index, &p)| point(&at.index(index), p))
}

/// Checks corners at rest: at least `least` points whose lengths and products are finite as well.
pub(super) fn corners(at: &Path<'_>, corners: &[DVec2], least: usize) -> Result<(), ProjectError> {
    points(at, corners, least)?;
    corners.iter().enumerate().try_for_each(|(index, corner)| {
        let at = at.index(index);
        corner.to_array().into_iter().enumerate().try_for_each(|(axis, number)| bounded(&at.index(axis), number))
    })
}

/// The number of entries of a grid.
pub(super) fn entries([width, height]: [u32; 2]) -> usize {
    width as usize * height as usize
}
