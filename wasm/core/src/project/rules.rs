//! What numbers and points must be, wherever in a project they stand.

use std::ops::RangeInclusive;

use glam::DVec2;

use super::ProjectError;
use super::path::Path;

/// The numbers of a range in words.
pub(super) fn whole_numbers(range: &RangeInclusive<u32>) -> String {
    match (range.start(), range.end()) {
        (least, &u32::MAX) => format!("a whole number, {least} or more"),
        (least, most) => format!("a whole number from {least} to {most}"),
    }
}

pub(super) fn whole_number(at: &Path<'_>, number: u32, range: &RangeInclusive<u32>) -> Result<(), ProjectError> {
    if range.contains(&number) {
        Ok(())
    } else {
        at.refuse(format_args!("expected {}, found {number}", whole_numbers(range)))
    }
}

pub(super) fn finite(at: &Path<'_>, number: f64) -> Result<(), ProjectError> {
    if number.is_finite() { Ok(()) } else { at.refuse(format_args!("expected a finite number, found {number}")) }
}

pub(super) fn point(at: &Path<'_>, point: DVec2) -> Result<(), ProjectError> {
    finite(&at.index(0), point.x)?;
    finite(&at.index(1), point.y)
}

pub(super) fn points(at: &Path<'_>, points: &[DVec2], least: usize) -> Result<(), ProjectError> {
    if points.len() < least {
        return at.refuse(format_args!("expected at least {least} points, found {}", points.len()));
    }
    points.iter().enumerate().try_for_each(|(index, &p)| point(&at.index(index), p))
}
