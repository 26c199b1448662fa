//! Area, centroid and spread of a part of the picture.

use std::ops::AddAssign;

use glam::{DMat2, DVec2};

use crate::pose::motion::turn;

/// A part has too few samples if the root of its covariance's determinant is below this fraction of its area. For a
/// densely sampled rectangle, the fraction is a twelfth.
const FEW: f64 = 0.02;

/// Area of a part, and its first and second moments about a nearby point. Moments of a distant part about the picture's
/// corner would lose digits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moments {
    about: DVec2,
    pub(super) area: f64,
    first: DVec2,
    second: DMat2,
}

impl Moments {
    /// The moments of an area at one point.
    pub(super) fn of(at: DVec2, area: f64, about: DVec2) -> Self {
        let from = at - about;
        let first = area * from;
        Self { about, area, first, second: DMat2::from_cols(from.x * first, from.y * first) }
    }

    pub(super) fn centroid(&self) -> DVec2 {
        self.about + self.first / self.area
    }

    /// The matrix of second moments about the centroid, for an area of 1.
    fn covariance(&self) -> DMat2 {
        let mean = self.first / self.area;
        1.0 / self.area * self.second - DMat2::from_cols(mean.x * mean, mean.y * mean)
    }

    /// Two points that, with half the area each, have the second moment along the longer axis. `None` if the standard
    /// deviations along both axes differ by less than `least`: equal ones define no axis.
    pub(super) fn halves(&self, least: f64) -> Option<[DVec2; 2]> {
        let at = self.centroid();
        let [xx, xy, _, yy] = self.covariance().to_cols_array();
        let half = (xx - yy) / 2.0;
        let excess = libm::hypot(half, xy);
        (2.0 * excess > least * least).then(|| {
            let along = (f64::midpoint(xx, yy) + excess).sqrt() * turn(libm::atan2(xy, half) / 2.0);
            [at - along, at + along]
        })
    }

    /// Four points that, with a quarter of the area each, have all second moments: the corners of a square, mapped by
    /// the root of the covariance. Points along the axes would be undefined for axes of equal length. `None` for a
    /// single sample, or samples on one line: rounding would determine the points.
    pub(super) fn quarters(&self) -> Option<[DVec2; 4]> {
        let covariance = self.covariance();
        let trace = covariance.x_axis.x + covariance.y_axis.y;
        let det = covariance.determinant().max(0.0).sqrt();
        if det < FEW * self.area {
            return None;
        }
        // Cayley and Hamilton: the root of C is (C + √det C I) / √(tr C + 2 √det C).
        let root = 1.0 / (trace + 2.0 * det).sqrt() * (covariance + DMat2::from_diagonal(DVec2::splat(det)));
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
        Some(corners.map(|corner| self.centroid() + root * DVec2::from(corner)))
    }
}

/// Adds moments of the same part.
impl AddAssign for Moments {
    fn add_assign(&mut self, more: Self) {
        self.area += more.area;
        self.first += more.first;
        self.second += more.second;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equal areas on a turned grid of places about a place.
    fn rectangle(long: i32, wide: i32, apart: f64, turned: f64, middle: DVec2) -> Moments {
        let about = middle + DVec2::new(apart, -2.0 * apart);
        let mut sum = Moments::of(middle, 0.0, about);
        for (x, y) in (0..long).flat_map(|x| (0..wide).map(move |y| (x, y))) {
            let (x, y) = (f64::from(2 * x + 1 - long) / 2.0, f64::from(2 * y + 1 - wide) / 2.0);
            let at = middle + turn(turned).rotate(apart * DVec2::new(x, y));
            sum += Moments::of(at, apart * apart / 4.0, about);
        }
        sum
    }

    /// In a picture, and as small as in a mesh that lies far away.
    #[test]
    fn a_long_part_is_halved_along_its_axis() {
        for (apart, middle) in [(1.0, DVec2::new(900.0, -70.0)), (0.01, DVec2::new(1e6, -1e6))] {
            for turned in [0.0, 0.4, 1.6, 3.0] {
                let moments = rectangle(40, 10, apart, turned, middle);
                // The deviation of n numbers one apart: √((n² − 1) / 12).
                let along = apart * (1599.0_f64 / 12.0).sqrt() * turn(turned);
                let halves = moments.halves(2.0 * apart).expect("long");
                for half in [middle - along, middle + along] {
                    assert!(halves.iter().any(|at| at.distance(half) < 1e-9), "{half} is not of {halves:?}");
                }
            }
        }
    }

    #[test]
    fn quarters_have_the_second_moments() {
        for (turned, middle) in [(0.4, DVec2::new(900.0, -70.0)), (2.0, DVec2::new(1e4, -1e4))] {
            let moments = rectangle(40, 10, 1.0, turned, middle);
            let about = middle + DVec2::new(3.0, 5.0);
            let mut sum = Moments::of(about, 0.0, about);
            for at in moments.quarters().expect("not flat") {
                sum += Moments::of(at, moments.area / 4.0, about);
            }
            assert!(sum.centroid().distance(moments.centroid()) < 1e-9);
            assert!(sum.covariance().abs_diff_eq(moments.covariance(), 1e-6));
        }
    }

    #[test]
    fn samples_on_one_line_have_no_quarters() {
        assert_eq!(rectangle(40, 1, 1.0, 0.4, DVec2::new(900.0, -70.0)).quarters(), None);
        assert_eq!(rectangle(1, 1, 1.0, 0.4, DVec2::new(900.0, -70.0)).quarters(), None);
    }

    #[test]
    fn a_short_or_square_part_is_not_halved() {
        for (apart, middle) in [(1.0, DVec2::new(900.0, -70.0)), (0.01, DVec2::new(1e6, -1e6))] {
            assert_eq!(rectangle(40, 10, apart, 0.4, middle).halves(12.0 * apart), None);
            assert_eq!(rectangle(40, 40, apart, 0.4, middle).halves(1e-3 * apart), None);
        }
    }
}
