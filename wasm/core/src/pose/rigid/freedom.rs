//! The parts of the sites' motions that the handles leave free.

use glam::DVec2;

/// The part of a site's motion that the handles leave free.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Freedom {
    /// The whole motion: a virtual site.
    Whole,
    /// The linear part: a point, unless its rotation is set.
    Linear,
    /// A bar along this direction. Only the stretch and shear across the bar are free. They do not move the bar.
    Across(DVec2),
    /// Nothing: a polygon keeps its inside, and a held outline does not move.
    None,
}

/// The image of a site's rest place, and the columns of its linear part. Lengths are in [units](super::model::Model).
pub(super) type Parts = [DVec2; 3];

impl Freedom {
    /// The unknowns of a site, each as the factors of its value in the three parts.
    pub(super) fn factors(self) -> impl Iterator<Item = [f64; 3]> {
        let all = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (list, from, to) = match self {
            Self::Whole => (all, 0, 3),
            Self::Linear => (all, 1, 3),
            Self::Across(along) => ([[0.0, -along.y, along.x]; 3], 0, 1),
            Self::None => (all, 0, 0),
        };
        list.into_iter().take(to).skip(from)
    }

    /// The part of a change that the handles make, with a rotation that is free or set.
    pub(super) fn driven(self, by: Parts, is_free: bool) -> Parts {
        match self {
            Self::Whole => [DVec2::ZERO; 3],
            Self::Linear if is_free => [by[0], DVec2::ZERO, DVec2::ZERO],
            Self::Across(along) => {
                let change = along.x * by[1] + along.y * by[2];
                [by[0], along.x * change, along.y * change]
            }
            Self::Linear | Self::None => by,
        }
    }
}

/// What a pose requests, besides where the handles are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Request<'a> {
    /// Whether the rotation of each site is free.
    pub(super) is_free: &'a [bool],
    /// The scale that handles request at each site; `None` if it is 1 everywhere.
    pub(super) scales: Option<&'a [f64]>,
}
