//! The parts of the sites' motions that the handles leave free, as a vector of unknowns.

use glam::DVec2;

/// The part of a site's motion that the handles leave free.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Freedom {
    /// The whole motion: a virtual site.
    Whole,
    /// The linear part: a point, unless its rotation is set.
    Linear,
    /// The image of the normal of this direction under the linear part: a bar. It has no effect on the bar itself.
    Across(DVec2),
    /// Nothing: a polygon keeps its inside, and a held outline does not move.
    None,
}

/// Posed position of a site, and the columns of its linear part; lengths in [units](super::Relaxation::unit).
pub(super) type Parts = [DVec2; 3];

/// The unknowns of all sites, one after another.
#[derive(Debug, Clone)]
pub(super) struct Unknowns {
    freedom: Vec<Freedom>,
    /// The first unknown of each site.
    first: Vec<u32>,
    /// Number of all unknowns.
    count: usize,
}

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
}

impl Unknowns {
    pub(super) fn new(freedom: &[Freedom]) -> Self {
        let mut count = 0;
        let first = |freedom: &Freedom| {
            let first = count as u32;
            count += freedom.factors().count();
            first
        };
        let first = freedom.iter().map(first).collect();
        Self { freedom: freedom.to_vec(), first, count }
    }

    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// The freedom of each site, and its first unknown.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Freedom, usize)> {
        self.freedom.iter().zip(&self.first).map(|(&freedom, &first)| (freedom, first as usize))
    }

    /// The freedom of a site, and its first unknown.
    pub(super) fn of(&self, site: u32) -> (Freedom, u32) {
        (self.freedom[site as usize], self.first[site as usize])
    }

    /// The unknowns of each site that has any.
    pub(super) fn groups(&self) -> Vec<Vec<u32>> {
        let ends = self.first.iter().skip(1).copied().chain([self.count as u32]);
        let groups = self.first.iter().zip(ends).filter(|(from, to)| *from < to);
        groups.map(|(&from, to)| (from..to).collect()).collect()
    }

    /// Sets the unknowns of points whose rotation is set to 0.
    pub(super) fn keep(&self, is_free: &[bool], values: &mut [DVec2]) {
        for ((freedom, first), &is_free) in self.iter().zip(is_free) {
            if freedom == Freedom::Linear && !is_free {
                values[first..first + 2].fill(DVec2::ZERO);
            }
        }
    }

    /// Calls `visit` with the parts of each free site that the unknowns represent.
    pub(super) fn expand(&self, unknown: &[DVec2], mut visit: impl FnMut(usize, Parts)) {
        for (site, (freedom, first)) in self.iter().enumerate() {
            let by = &unknown[first..];
            match freedom {
                Freedom::Whole => visit(site, [by[0], by[1], by[2]]),
                Freedom::Linear => visit(site, [DVec2::ZERO, by[0], by[1]]),
                Freedom::Across(along) => visit(site, [DVec2::ZERO, -along.y * by[0], along.x * by[0]]),
                Freedom::None => {}
            }
        }
    }

    /// The gradient with respect to the unknowns, from that with respect to the parts.
    pub(super) fn gather(&self, forces: impl Fn(usize) -> Parts, gradient: &mut [DVec2]) {
        for (site, (freedom, first)) in self.iter().enumerate() {
            let to = &mut gradient[first..];
            match freedom {
                Freedom::Whole => to[..3].copy_from_slice(&forces(site)),
                Freedom::Linear => to[..2].copy_from_slice(&forces(site)[1..]),
                Freedom::Across(along) => {
                    let [_, x, y] = forces(site);
                    to[0] = along.x * y - along.y * x;
                }
                Freedom::None => {}
            }
        }
    }
}
