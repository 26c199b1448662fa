//! How a brush has displaced the picture at rest: a grid of control points over it.

use std::ops::RangeInclusive;

use glam::{DAffine2, DVec2};

use super::error::ProjectError;
use super::path::Path;
use super::spline::{PARTS, SIDE_LEAST, Spline, control_points};
use super::validate;

/// 256 segments, each 16 px long in a picture of 4,096 px. With more, the grid would dominate the size of the project
/// file.
const SIDE_MOST: u32 = 259;
pub(super) const SIDES: RangeInclusive<u32> = SIDE_LEAST..=SIDE_MOST;

/// The displacement of the picture at rest, applied before the handles pose it: a cubic B-spline over the picture.
///
/// A point p moves where the handles would move p + d(p), with the weights of p. Of `width` × `height` control points,
/// one row and column lies beyond each edge of the picture. Beyond the picture, the displacement at its edge continues.
///
/// ```
/// use c2warp::project::{Displacement, Project};
///
/// let mut project = Project::for_picture(640, 480);
/// // Everything moves by half a spacing to the right, and by a quarter up: a segment has 320 × 240 px.
/// project.displacement = Some(Displacement::new(5, 5, [128, -64].repeat(25)));
/// let displacement = project.displacement.as_ref().unwrap();
/// let moved = displacement.at([320.0, 90.0].into(), [640.0, 480.0].into());
/// assert!(moved.distance([160.0, -60.0].into()) < 1e-9);
/// assert_eq!(Project::from_json(&project.to_json())?, project);
/// # Ok::<(), c2warp::project::ProjectError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Displacement {
    /// Number of columns of control points, from 4 to 259. They are the picture's width / (`width` − 3) apart.
    #[cfg_attr(feature = "schema", schemars(range(min = SIDE_LEAST, max = SIDE_MOST)))]
    pub width: u32,
    /// Number of rows of control points, from 4 to 259. They are the picture's height / (`height` − 3) apart.
    #[cfg_attr(feature = "schema", schemars(range(min = SIDE_LEAST, max = SIDE_MOST)))]
    pub height: u32,
    /// For each control point, rows from top to bottom, its displacement in x, then in y: 256 is the distance between
    /// columns, or rows. In base64: signed 16-bit integers, little-endian.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::json::numbers_as_base64"))]
    #[cfg_attr(feature = "schema", schemars(with = "String", extend("contentEncoding" = "base64", "pattern" = "^[A-Za-z0-9+/]+={0,2}$")))]
    pub values: Vec<i16>,
}

impl Displacement {
    /// A grid of control points, with rows from top to bottom: alternating displacements in x and y.
    #[must_use]
    pub fn new(width: u32, height: u32, values: Vec<i16>) -> Self {
        Self { width, height, values }
    }

    /// The displacement d(p) of a point, in pixels of a picture of this size.
    ///
    /// # Panics
    /// If a side is out of range, or there are not two values for each control point.
    #[must_use]
    pub fn at(&self, place: DVec2, size: DVec2) -> DVec2 {
        self.spline(size).at(place)
    }

    /// Whether nothing moves.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.values.iter().all(|&value| value == 0)
    }

    fn spline(&self, size: DVec2) -> Spline<'_> {
        Spline { size, sides: [self.width, self.height], values: &self.values }
    }

    /// The displacement for another picture of a given size in pixels, related to this one by a map. Control points are
    /// about as dense as before, so features a few spacings wide are preserved. `None` if nothing is displaced.
    pub(super) fn mapped(&self, map: &DAffine2, from: DVec2, to: DVec2) -> Option<Self> {
        let scaled = DAffine2::from_scale(to / from);
        if map.abs_diff_eq(scaled, 1e-9 * to.max_element()) {
            // Values are relative to the spacing.
            return (!self.is_zero()).then(|| self.clone());
        }
        let spacing = self.spline(from).spacing();
        let along = [map.matrix2.x_axis.length(), map.matrix2.y_axis.length()];
        let segments = (to / (spacing * DVec2::from(along))).round();
        let [width, height] = segments.to_array().map(|segments| {
            let side = segments + f64::from(SIDE_LEAST - 1);
            side.clamp(SIDE_LEAST.into(), SIDE_MOST.into()) as u32
        });
        let knots = [width, height].map(|side| side - (SIDE_LEAST - 2));
        let spacing = to / DVec2::from(knots.map(|knots| f64::from(knots - 1)));
        let back = map.inverse();
        let sample = |column: u32, row: u32| {
            let place = back.transform_point2(spacing * DVec2::new(column.into(), row.into()));
            map.transform_vector2(self.at(place, from))
        };
        let row = |row| control_points(&(0..knots[0]).map(|column| sample(column, row)).collect::<Vec<_>>());
        let rows: Vec<Vec<DVec2>> = (0..knots[1]).map(row).collect();
        let column = |column: usize| control_points(&rows.iter().map(|row| row[column]).collect::<Vec<_>>());
        let columns: Vec<Vec<DVec2>> = (0..width as usize).map(column).collect();
        let rounded = |value: f64| value.round().clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        let values = (0..height as usize)
            .flat_map(|row| columns.iter().map(move |column| column[row]))
            .flat_map(|point| (PARTS * point / spacing).to_array().map(rounded));
        let mapped = Self { width, height, values: values.collect() };
        (!mapped.is_zero()).then_some(mapped)
    }

    /// Checks the displacement of a project.
    pub(crate) fn check(&self) -> Result<(), ProjectError> {
        let (at, Self { width, height, values }) = (Path::Top.key("displacement"), self);
        validate::whole_number(&at.key("width"), *width, &SIDES)?;
        validate::whole_number(&at.key("height"), *height, &SIDES)?;
        if values.len() == 2 * validate::entries([*width, *height]) {
            return Ok(());
        }
        at.key("values").refuse(format_args!("expected {width} × {height} × 2 numbers, found {}", values.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FROM: DVec2 = DVec2::new(80.0, 60.0);

    /// Moves the middle of the left half to the right.
    fn bump() -> Displacement {
        let mut values = vec![0; 2 * 11 * 9];
        values[2 * (4 * 11 + 3)] = 200;
        Displacement::new(11, 9, values)
    }

    #[test]
    fn displacement_is_greatest_beside_its_control_point() {
        // Column 3 stands at 2 spacings of 10 px, row 4 at 3 spacings.
        let expected = 200.0 / 256.0 * 10.0 * (4.0 / 6.0) * (4.0 / 6.0);
        assert!(bump().at([20.0, 30.0].into(), FROM).distance(DVec2::new(expected, 0.0)) < 1e-12);
        assert_eq!(bump().at([40.0, 30.0].into(), FROM), DVec2::ZERO);
    }

    #[test]
    fn a_scaled_picture_has_the_same_grid() {
        let to = DVec2::new(160.0, 180.0);
        assert_eq!(bump().mapped(&DAffine2::from_scale(to / FROM), FROM, to), Some(bump()));
    }

    #[test]
    fn points_of_a_cropped_picture_move_as_before() {
        let wide = |k: i32| {
            let apart = DVec2::new(f64::from(k % 11) - 3.0, f64::from(k / 11) - 4.0);
            [(200.0 * (1.0 - apart.length_squared() / 16.0).max(0.0).powi(3)) as i16, 0]
        };
        let wide = Displacement::new(11, 9, (0..99).flat_map(wide).collect());
        let to = DVec2::new(50.0, 40.0);
        let map = DAffine2::from_translation(DVec2::new(-5.0, -13.0));
        let cropped = wide.mapped(&map, FROM, to).unwrap();
        for p in [[20.0, 30.0], [15.0, 27.0], [31.0, 33.0], [50.0, 50.0]].map(DVec2::from) {
            let (before, after) = (wide.at(p, FROM), cropped.at(map.transform_point2(p), to));
            assert!(before.distance(after) < 0.3, "{before} and {after} at {p}");
        }
        assert_eq!(
            bump().mapped(&DAffine2::from_translation(DVec2::new(-45.0, 0.0)), FROM, DVec2::new(30.0, 60.0)),
            None
        );
    }

    #[test]
    fn displacements_turn_with_the_picture() {
        let map = DAffine2 { translation: DVec2::new(60.0, 0.0), ..DAffine2::from_angle(std::f64::consts::FRAC_PI_2) };
        let to = DVec2::new(60.0, 80.0);
        let turned = bump().mapped(&map, FROM, to).unwrap();
        let (before, after) = (bump().at([20.0, 30.0].into(), FROM), turned.at([30.0, 20.0].into(), to));
        assert!(after.distance(DVec2::new(0.0, before.x)) < 0.05, "{before} and {after}");
    }
}
