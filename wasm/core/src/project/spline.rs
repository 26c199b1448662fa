//! A uniform cubic B-spline over a picture with two values: twice continuously differentiable.
//!
//! Cost: sixteen control points for each point.

use glam::{DMat2, DVec2};

/// A cubic spline has four control points at each position.
pub(super) const SIDE_LEAST: u32 = 4;
/// Values are multiples of this fraction of the spacing.
pub(super) const PARTS: f64 = 256.0;

/// Control points over a picture of a given size in pixels: pairs of values, rows from top to bottom.
///
/// One row and column of them lies beyond each edge of the picture. Values are in parts of the spacing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spline<'a> {
    pub(crate) size: DVec2,
    pub(crate) sides: [u32; 2],
    pub(crate) values: &'a [i16],
}

/// The four control points that affect one position, along one axis.
struct Span {
    first: usize,
    shares: [f64; 4],
    /// Derivatives of the shares along the axis.
    slopes: [f64; 4],
}

impl Span {
    /// The control points at a coordinate from 0 to `side`, of a spline with a number of segments. Beyond this range,
    /// the value is constant.
    fn new(at: f64, side: f64, segments: u32) -> Self {
        let inside = at.clamp(0.0, side);
        let at_segments = inside * f64::from(segments) / side;
        let first = (at_segments as u32).min(segments - 1);
        let t = at_segments - f64::from(first);
        let (u, square) = (1.0 - t, t * t);
        let shares = [
            u * u * u / 6.0,
            ((3.0 * t - 6.0) * square + 4.0) / 6.0,
            (((3.0 - 3.0 * t) * t + 3.0) * t + 1.0) / 6.0,
            square * t / 6.0,
        ];
        let scale = if inside == at { f64::from(segments) / side } else { 0.0 };
        let slopes = [-u * u / 2.0, (3.0 * t - 4.0) * t / 2.0, ((2.0 - 3.0 * t) * t + 1.0) / 2.0, square / 2.0];
        Self { first: first as usize, shares, slopes: slopes.map(|slope| scale * slope) }
    }
}

impl Spline<'_> {
    /// The distance between control points, in pixels.
    pub(crate) fn spacing(&self) -> DVec2 {
        self.size / DVec2::from(self.segments().map(f64::from))
    }

    /// The value at a point, in pixels.
    pub(crate) fn at(&self, p: DVec2) -> DVec2 {
        let [x, y] = self.spans(p);
        self.unit() * self.sum(&x, x.shares, &y, y.shares)
    }

    /// The value at a point, in pixels, and its Jacobian.
    pub(crate) fn with_slopes(&self, p: DVec2) -> (DVec2, DMat2) {
        let [x, y] = self.spans(p);
        let unit = self.unit();
        let along_x = unit * self.sum(&x, x.slopes, &y, y.shares);
        let along_y = unit * self.sum(&x, x.shares, &y, y.slopes);
        (unit * self.sum(&x, x.shares, &y, y.shares), DMat2::from_cols(along_x, along_y))
    }

    /// A value of 1, in pixels.
    fn unit(&self) -> DVec2 {
        self.spacing() / PARTS
    }

    fn segments(&self) -> [u32; 2] {
        self.sides.map(|side| side - (SIDE_LEAST - 1))
    }

    fn spans(&self, p: DVec2) -> [Span; 2] {
        let [across, down] = self.segments();
        [Span::new(p.x, self.size.x, across), Span::new(p.y, self.size.y, down)]
    }

    fn sum(&self, x: &Span, across: [f64; 4], y: &Span, down: [f64; 4]) -> DVec2 {
        let columns = self.sides[0] as usize;
        let mut sum = DVec2::ZERO;
        for (row, share) in down.into_iter().enumerate() {
            let start = 2 * ((y.first + row) * columns + x.first);
            let points = self.values[start..start + 8].as_chunks::<2>().0;
            let of_row: DVec2 =
                points.iter().zip(across).map(|(&[x, y], share)| share * DVec2::new(x.into(), y.into())).sum();
            sum += share * of_row;
        }
        sum
    }
}

/// The control points of the cubic spline through samples at its knots, without curvature at both ends. There are two
/// more control points than samples, and at least two samples.
pub(super) fn control_points(samples: &[DVec2]) -> Vec<DVec2> {
    let last = samples.len() - 1;
    let mut points = vec![DVec2::ZERO; samples.len() + 2];
    // The ends, where the second difference is 0, have the values of their samples. In between, by elimination:
    // c_{k−1} + 4 c_k + c_{k+1} = 6 s_k.
    (points[1], points[last + 1]) = (samples[0], samples[last]);
    let mut factors = vec![0.0; samples.len()];
    for k in 1..last {
        factors[k] = 1.0 / (4.0 - factors[k - 1]);
        points[k + 1] = factors[k] * (6.0 * samples[k] - points[k]);
    }
    for k in (1..last).rev() {
        let next = points[k + 2];
        points[k + 1] -= factors[k] * next;
    }
    points[0] = 2.0 * points[1] - points[2];
    points[last + 2] = 2.0 * points[last + 1] - points[last];
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDES: [u32; 2] = [7, 6];

    fn values() -> Vec<i16> {
        (0..84).map(|k: i32| ((k * 37 + k * k * 11) % 301 - 150) as i16).collect()
    }

    #[test]
    fn equal_control_points_have_their_value_everywhere() {
        let values = [64, -128].repeat(42);
        let spline = Spline { size: DVec2::new(80.0, 60.0), sides: SIDES, values: &values };
        for p in [[0.0, 0.0], [33.3, 59.9], [80.0, 60.0], [-5.0, 900.0]].map(DVec2::from) {
            let (value, slopes) = spline.with_slopes(p);
            assert!(value.distance(DVec2::new(5.0, -10.0)) < 1e-12, "{value}");
            assert!(slopes.abs_diff_eq(DMat2::ZERO, 1e-12), "{slopes}");
        }
    }

    #[test]
    fn slopes_are_those_of_the_value() {
        let values = values();
        let spline = Spline { size: DVec2::new(80.0, 60.0), sides: SIDES, values: &values };
        let step = 1e-5;
        for p in [[1.0, 1.0], [33.3, 59.9], [39.0, 41.0], [79.0, 20.0], [-3.0, 12.0], [90.0, 70.0]].map(DVec2::from) {
            let slope = |axis: DVec2| (spline.at(p + step * axis) - spline.at(p - step * axis)) / (2.0 * step);
            let expected = DMat2::from_cols(slope(DVec2::X), slope(DVec2::Y));
            let (value, slopes) = spline.with_slopes(p);
            assert!(slopes.abs_diff_eq(expected, 1e-8), "{slopes} is not {expected} at {p}");
            assert_eq!(value, spline.at(p));
        }
    }

    #[test]
    fn second_derivatives_do_not_jump_at_knots() {
        let values = values();
        let spline = Spline { size: DVec2::new(80.0, 60.0), sides: SIDES, values: &values };
        let step = 1e-3;
        for (knot, axis) in [(DVec2::new(40.0, 33.0), DVec2::X), (DVec2::new(33.0, 40.0), DVec2::Y)] {
            let second = |p: DVec2| {
                (spline.at(p + step * axis) - 2.0 * spline.at(p) + spline.at(p - step * axis)) / (step * step)
            };
            let jump = second(knot + 2.0 * step * axis) - second(knot - 2.0 * step * axis);
            assert!(jump.length() < 0.01 * second(knot).length(), "{jump} beside {}", second(knot));
        }
    }

    #[test]
    fn control_points_make_a_spline_through_the_samples() {
        for count in [2, 3, 9] {
            let samples: Vec<DVec2> = (0..count).map(|k| DVec2::new(f64::from(k * k % 5), f64::from(-k))).collect();
            let points = control_points(&samples);
            assert_eq!(points.len(), samples.len() + 2);
            for (sample, around) in samples.iter().zip(points.windows(3)) {
                assert!(sample.distance((around[0] + 4.0 * around[1] + around[2]) / 6.0) < 1e-12);
            }
        }
    }
}
