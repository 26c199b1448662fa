//! The bent course of one segment of a path: a cubic Hermite spline through samples of the map.
//!
//! Samples are dense enough that the spline is within [`SPLINE_ERROR`] of the map midway between them. At kinks of the
//! map, on the outline of the domain, samples are [`LEAST_STEP`] apart.

use std::ops::Range;

use kurbo::{CubicBez, CurveFitSample, ParamCurve, ParamCurveArclen, ParamCurveFit, PathSeg, Point, Vec2};

/// Initial distance of samples, in pixels: shorter than any bend of a smooth warp.
const FIRST_STEP: f64 = 8.0;
/// Maximum number of initial samples, for segments that extend far outside the picture.
const MOST_FIRST: f64 = 512.0;
const LEAST_STEP: f64 = 0.25;
const SPLINE_ERROR: f64 = 0.002;
/// Number of lines between two samples: each is at most two pixels long.
const PIECES: u32 = 4;
/// Step for finding the direction at an end, in pixels.
const END_STEP: f64 = 0.05;

/// A sample: the parameter, the position at rest, the posed position and its derivative with respect to the parameter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) t: f64,
    pub(crate) rest: Point,
    pub(crate) posed: Point,
    slope: Vec2,
}

/// The samples of a course, ascending.
#[derive(Debug)]
pub(crate) struct Course {
    pub(crate) samples: Vec<Sample>,
}

impl Course {
    /// The course of a segment in pixels.
    pub(crate) fn new(segment: PathSeg, place: &dyn Fn(Point) -> Point) -> Self {
        let length = segment.arclen(0.1);
        let sample = |t: f64| {
            let rest = segment.eval(t);
            Sample { t, rest, posed: place(rest), slope: Vec2::ZERO }
        };
        let count = (length / FIRST_STEP).ceil().clamp(2.0, MOST_FIRST) as usize;
        let mut samples: Vec<Sample> = (0..=count).map(|k| sample(k as f64 / count as f64)).collect();
        let step = (END_STEP / length.max(END_STEP)).min(0.01);
        let slope = |from: f64, to: f64| (place(segment.eval(to)) - place(segment.eval(from))) / step;
        let ends = [slope(0.0, step), slope(1.0 - step, 1.0)];
        // An interval is measured once: the first flag refers to the interval that begins at its sample.
        let mut is_fine = vec![false; samples.len()];
        loop {
            set_slopes(&mut samples, ends);
            let mut refined = Vec::with_capacity(2 * samples.len());
            let mut fine = Vec::with_capacity(2 * samples.len());
            for (at, pair) in samples.windows(2).enumerate() {
                let [from, to] = [pair[0], pair[1]];
                refined.push(from);
                let middle = (!is_fine[at]).then(|| sample(f64::midpoint(from.t, to.t)));
                let is_short = from.rest.distance(to.rest) < LEAST_STEP;
                match middle {
                    Some(middle)
                        if !is_short && between(&from, &to, middle.t).0.distance(middle.posed) > SPLINE_ERROR =>
                    {
                        fine.extend([false, false]);
                        refined.push(middle);
                    }
                    _ => fine.push(true),
                }
            }
            let is_done = refined.len() + 1 == samples.len();
            refined.extend(samples.last());
            fine.push(true);
            (samples, is_fine) = (refined, fine);
            if is_done {
                return Self { samples };
            }
        }
    }

    /// The spline from a sample to the next one.
    pub(crate) fn hermite(&self, from: usize) -> CubicBez {
        let [from, to] = [self.samples[from], self.samples[from + 1]];
        let third = (to.t - from.t) / 3.0;
        CubicBez::new(from.posed, from.posed + third * from.slope, to.posed - third * to.slope, to.posed)
    }

    /// Points between two samples, dense enough that lines between them follow the course.
    pub(crate) fn points(&self, samples: Range<usize>) -> Vec<Point> {
        let samples = &self.samples[samples.start..=samples.end];
        let pieces = samples.windows(2).flat_map(|pair| {
            let at = |k: u32| pair[0].t + (pair[1].t - pair[0].t) * f64::from(k) / f64::from(PIECES);
            (0..PIECES).map(move |k| between(&pair[0], &pair[1], at(k)).0)
        });
        pieces.chain(samples.last().map(|last| last.posed)).collect()
    }

    /// The position and the derivative at a parameter.
    fn at(&self, t: f64) -> (Point, Vec2) {
        let after = self.samples.partition_point(|sample| sample.t <= t).clamp(1, self.samples.len() - 1);
        between(&self.samples[after - 1], &self.samples[after], t)
    }
}

/// Slopes from the parabola through three samples, and given slopes at the ends.
fn set_slopes(samples: &mut [Sample], ends: [Vec2; 2]) {
    for at in 1..samples.len() - 1 {
        let [before, here, after] = [samples[at - 1], samples[at], samples[at + 1]];
        let (h0, h1) = (here.t - before.t, after.t - here.t);
        let [d0, d1] = [(here.posed - before.posed) / h0, (after.posed - here.posed) / h1];
        samples[at].slope = (d0 * h1 + d1 * h0) / (h0 + h1);
    }
    let last = samples.len() - 1;
    (samples[0].slope, samples[last].slope) = (ends[0], ends[1]);
}

/// The position and the derivative of the spline between two samples.
fn between(from: &Sample, to: &Sample, t: f64) -> (Point, Vec2) {
    let width = to.t - from.t;
    let u = (t - from.t) / width;
    let chord = to.posed - from.posed;
    let (start, end) = (from.slope * width, to.slope * width);
    let place = from.posed + chord * (u * u * (3.0 - 2.0 * u)) + start * (u * (1.0 - u) * (1.0 - u))
        - end * (u * u * (1.0 - u));
    let slope = chord * (6.0 * u * (1.0 - u)) + start * ((1.0 - u) * (1.0 - 3.0 * u)) + end * (u * (3.0 * u - 2.0));
    (place, slope / width)
}

impl ParamCurveFit for Course {
    fn sample_pt_tangent(&self, t: f64, _sign: f64) -> CurveFitSample {
        let (p, slope) = self.at(t);
        let chord = self.samples[self.samples.len() - 1].posed - self.samples[0].posed;
        CurveFitSample { p, tangent: if slope.hypot2() > 0.0 { slope } else { chord } }
    }

    fn sample_pt_deriv(&self, t: f64) -> (Point, Vec2) {
        self.at(t)
    }

    fn break_cusp(&self, _range: Range<f64>) -> Option<f64> {
        None
    }
}
