//! Points from a CSV file with the header `x,y`, or from the command line.

use std::path::Path;

use glam::DVec2;

use crate::error::CliError;
use crate::input;

/// Reads a CSV file: the header, then exactly two finite numbers on every line.
pub(crate) fn read(path: &Path) -> Result<Vec<DVec2>, CliError> {
    parse_csv(&input::read(path).map_err(CliError::read(path))?, path)
}

/// Reads the contents of a CSV file.
pub(crate) fn parse_csv(bytes: &[u8], path: &Path) -> Result<Vec<DVec2>, CliError> {
    let to_error = |reason: csv::Error| match reason.into_kind() {
        csv::ErrorKind::Io(reason) => CliError::Read { path: path.to_owned(), reason },
        _ => CliError::PointsText { path: path.to_owned() },
    };
    let mut lines = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(bytes);
    // Spreadsheets write a byte order mark before the header.
    let header = lines.headers().map_err(to_error)?;
    if header.iter().map(|name| name.trim_start_matches('\u{feff}')).ne(["x", "y"]) {
        return Err(CliError::PointsHeader { path: path.to_owned() });
    }
    lines
        .records()
        .map(|record| {
            let record = record.map_err(to_error)?;
            let fields: Vec<_> = record.iter().collect();
            point(&fields).ok_or_else(|| CliError::Point {
                path: path.to_owned(),
                line: record.position().map_or(0, csv::Position::line),
                found: fields.join(","),
            })
        })
        .collect()
}

/// Parses `X,Y`.
pub(crate) fn parse(text: &str) -> Result<DVec2, String> {
    let fields: Vec<_> = text.split(',').map(str::trim).collect();
    point(&fields).ok_or_else(|| "expected two finite numbers X,Y".to_owned())
}

fn point(fields: &[&str]) -> Option<DVec2> {
    let [x, y] = fields else {
        return None;
    };
    Some(DVec2::new(x.parse().ok()?, y.parse().ok()?)).filter(|point| point.is_finite())
}

#[cfg(test)]
mod tests {
    use super::{DVec2, parse};

    #[test]
    fn parse_accepts_two_finite_numbers_only() {
        assert_eq!(parse("-1.5, 2e1"), Ok(DVec2::new(-1.5, 20.0)));
        for text in ["", "1", "1,2,3", "1,x", "1,NaN", "inf,0", "1;2"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
