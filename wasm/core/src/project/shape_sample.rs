//! The shape in which a drag has left the picture, as samples of its map.

use glam::{DAffine2, DMat2, DVec2};

use super::error::ProjectError;
use super::path::Path;
use super::validate;

/// Most samples of a shape. A shape of a picture of 1,000 px then takes less than 5 kB.
pub(super) const MOST_SAMPLES: usize = 64;

/// The map of the picture around one of its places: p ↦ `posed` + `linear` · (p − `rest`).
///
/// In a file, it is a list of eight numbers: x and y of `rest`, x and y of `posed`, and the columns of `linear`.
///
/// ```
/// use c2warp::project::{Project, ShapeSample};
/// use glam::DMat2;
///
/// let mut project = Project::for_picture(640, 480);
/// project.shape = vec![ShapeSample::new([10.0, 20.0], [30.0, 25.0], DMat2::from_cols_array(&[0.0, 1.0, -1.0, 0.0]))];
/// assert!(project.to_json().contains("[10, 20, 30, 25, 0, 1, -1, 0]"));
/// assert_eq!(Project::from_json(&project.to_json())?, project);
/// # Ok::<(), c2warp::project::ProjectError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ShapeSample {
    /// The place at rest, in image pixels.
    pub rest: DVec2,
    /// The posed place, in image pixels.
    pub posed: DVec2,
    /// The linear part.
    pub linear: DMat2,
}

impl ShapeSample {
    /// The map around a place.
    pub fn new(rest: impl Into<DVec2>, posed: impl Into<DVec2>, linear: DMat2) -> Self {
        Self { rest: rest.into(), posed: posed.into(), linear }
    }

    /// The sample of the eight numbers of a file.
    #[must_use]
    pub fn from_numbers([x, y, posed_x, posed_y, a, b, c, d]: [f64; 8]) -> Self {
        Self::new([x, y], [posed_x, posed_y], DMat2::from_cols_array(&[a, b, c, d]))
    }

    /// The eight numbers of a file.
    #[must_use]
    pub fn numbers(&self) -> [f64; 8] {
        let Self { rest, posed, linear } = self;
        let [a, b, c, d] = linear.to_cols_array();
        [rest.x, rest.y, posed.x, posed.y, a, b, c, d]
    }

    /// The posed place of any place.
    pub(crate) fn place(&self, at: DVec2) -> DVec2 {
        self.posed + self.linear * (at - self.rest)
    }

    /// The sample of a picture that is mapped at rest and posed.
    pub(super) fn mapped(&self, map: &DAffine2) -> Self {
        let [rest, posed] = [self.rest, self.posed].map(|at| map.transform_point2(at));
        Self { rest, posed, linear: map.matrix2 * self.linear * map.matrix2.inverse() }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for ShapeSample {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.numbers().serialize(serializer)
    }
}

/// Checks the shape of a project.
pub(crate) fn check(shape: &[ShapeSample]) -> Result<(), ProjectError> {
    let at = Path::Top.key("shape");
    if shape.len() > MOST_SAMPLES {
        return at.refuse(format_args!("expected at most {MOST_SAMPLES} samples, found {}", shape.len()));
    }
    shape.iter().enumerate().try_for_each(|(index, sample)| {
        let at = at.index(index);
        sample.numbers().iter().enumerate().try_for_each(|(k, &number)| validate::bounded(&at.index(k), number))
    })
}
