//! The stiffness of the picture: a small grid over it.

use std::ops::RangeInclusive;

use glam::{DAffine2, DVec2};

use super::error::ProjectError;
use super::path::Path;
use super::validate;

/// With more cells, a mask would be finer than the motions that it affects.
const MOST_CELLS: u32 = 128;
pub(super) const CELLS: RangeInclusive<u32> = 1..=MOST_CELLS;

/// The stiffness of each point of the picture at rest: a grid of equal cells that covers the picture, regardless of its
/// aspect ratio.
///
/// Between the centres of cells, values are bilinear; beyond the outermost centres, they are constant.
///
/// ```
/// use c2warp::project::{Project, Stiffness};
///
/// let mut project = Project::for_picture(640, 480);
/// // The right half is stiff.
/// project.stiffness = Some(Stiffness::new(4, 3, [0, 0, 255, 255].repeat(3)));
/// assert!(project.to_json().contains(r#""stiffness": { "width": 4, "height": 3, "values": "AAD//wAA//8AAP//" }"#));
/// assert_eq!(Project::from_json(&project.to_json())?, project);
/// # Ok::<(), c2warp::project::ProjectError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Stiffness {
    /// Number of columns, from 1 to 128.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = MOST_CELLS)))]
    pub width: u32,
    /// Number of rows, from 1 to 128.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = MOST_CELLS)))]
    pub height: u32,
    /// A byte for each cell in base64, rows from top to bottom: 0 is as soft as without a mask, 255 is stiff.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::json::bytes_as_base64"))]
    #[cfg_attr(feature = "schema", schemars(with = "String", extend("contentEncoding" = "base64", "pattern" = "^[A-Za-z0-9+/]+={0,2}$")))]
    pub values: Vec<u8>,
}

impl Stiffness {
    /// A grid of cells, with rows from top to bottom.
    #[must_use]
    pub fn new(width: u32, height: u32, values: Vec<u8>) -> Self {
        Self { width, height, values }
    }

    /// The stiffness at a point given as fractions of the picture's width and height: from 0 to 1, bilinear.
    ///
    /// # Panics
    /// If the number of values differs from the number of cells.
    #[must_use]
    pub fn at(&self, place: DVec2) -> f64 {
        bilinear([self.width, self.height], &self.values, place)
    }

    /// The mask for another picture of a given size in pixels, related to this one by a map. Cells cover as much of the
    /// picture as before. `None` if nothing is stiff.
    pub(super) fn mapped(&self, map: &DAffine2, from: DVec2, to: DVec2) -> Option<Self> {
        let per_cell = from / DVec2::new(self.width.into(), self.height.into());
        let cells = |side: f64, cell: f64| (side / cell).round().clamp(1.0, MOST_CELLS.into()) as u32;
        let width = cells(to.x, per_cell.x * map.matrix2.x_axis.length());
        let height = cells(to.y, per_cell.y * map.matrix2.y_axis.length());
        let back = map.inverse();
        let value = |row: u32, column: u32| {
            let centre = DVec2::new(column.into(), row.into()) + 0.5;
            let place = back.transform_point2(to * centre / DVec2::new(width.into(), height.into())) / from;
            let is_inside = place.cmpge(DVec2::ZERO).all() && place.cmple(DVec2::ONE).all();
            if is_inside { (255.0 * self.at(place)).round() as u8 } else { 0 }
        };
        let values: Vec<u8> = (0..height)
            .flat_map(|row| (0..width).map(move |column| (row, column)))
            .map(|(row, column)| value(row, column))
            .collect();
        values.iter().any(|&value| value > 0).then_some(Self { width, height, values })
    }

    pub(super) fn check(&self, at: &Path<'_>) -> Result<(), ProjectError> {
        validate::whole_number(&at.key("width"), self.width, &CELLS)?;
        validate::whole_number(&at.key("height"), self.height, &CELLS)?;
        if self.values.len() == validate::entries([self.width, self.height]) {
            return Ok(());
        }
        let Self { width, height, values } = self;
        at.key("values").refuse(format_args!("expected {width} × {height} bytes, found {}", values.len()))
    }
}

/// The stiffness at a point in a grid of columns × rows, given as fractions of the picture's size.
pub(crate) fn bilinear([columns, rows]: [u32; 2], values: &[u8], place: DVec2) -> f64 {
    let [(left, right, x), (top, bottom, y)] = [(place.x, columns), (place.y, rows)].map(|(at, cells)| next(at, cells));
    let value = |column: usize, row: usize| f64::from(values[row * columns as usize + column]) / 255.0;
    let of_row = |row: usize| (1.0 - x) * value(left, row) + x * value(right, row);
    (1.0 - y) * of_row(top) + y * of_row(bottom)
}

/// The two cells whose centres are next to a position from 0 to 1, and the share of the second.
fn next(at: f64, cells: u32) -> (usize, usize, f64) {
    let last = cells - 1;
    let at = (at * f64::from(cells) - 0.5).clamp(0.0, last.into());
    let first = at as u32;
    (first as usize, (first + 1).min(last) as usize, at - f64::from(first))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_bilinear_between_centres_and_stay_beyond() {
        let mask = Stiffness::new(2, 1, vec![0, 255]);
        for (place, expected) in [(0.0, 0.0), (0.25, 0.0), (0.5, 0.5), (0.6, 0.7), (0.75, 1.0), (1.0, 1.0), (7.0, 1.0)]
        {
            assert!((mask.at(DVec2::new(place, 0.3)) - expected).abs() < 1e-12, "{place}");
        }
    }

    #[test]
    fn mask_of_another_picture_covers_the_same_points() {
        let mask = Stiffness::new(4, 2, vec![0, 0, 255, 255, 0, 0, 51, 0]);
        let [from, to] = [DVec2::new(40.0, 20.0), DVec2::new(80.0, 60.0)];
        assert_eq!(mask.mapped(&DAffine2::from_scale(to / from), from, to), Some(mask.clone()));
        // A picture with ten more pixels on the left, and without the right half.
        let map = DAffine2::from_translation(DVec2::new(10.0, 0.0));
        assert_eq!(mask.mapped(&map, from, DVec2::new(30.0, 20.0)), None);
        let wider = mask.mapped(&map, from, DVec2::new(50.0, 20.0));
        assert_eq!(wider, Some(Stiffness::new(5, 2, vec![0, 0, 0, 255, 255, 0, 0, 0, 51, 0])));
    }
}
