//! Paints pictures from formulas: a picture is a function from a point to a colour, with 4×4 samples a pixel.

use glam::DVec2;
use image::{Rgba, RgbaImage};

/// Red, green, blue from 0 to 255 and opacity from 0 to 1.
pub(super) type Colour = [f64; 4];

/// A transparent colour.
pub(super) const CLEAR: Colour = [0.0; 4];

/// Returns an opaque colour.
pub(super) fn rgb(red: u8, green: u8, blue: u8) -> Colour {
    [red.into(), green.into(), blue.into(), 1.0]
}

/// Interpolates between two colours.
pub(super) fn between(a: Colour, b: Colour, t: f64) -> Colour {
    let t = t.clamp(0.0, 1.0);
    [0, 1, 2, 3].map(|k| a[k] + (b[k] - a[k]) * t)
}

/// Draws a picture of `width × height`, enlarged `times` times.
pub(super) fn painted(width: u32, height: u32, times: u32, paint: fn(DVec2) -> Colour) -> RgbaImage {
    const STEPS: u32 = 4;
    RgbaImage::from_fn(width * times, height * times, |x, y| {
        let mut sum = [0.0; 4];
        for step in 0..STEPS * STEPS {
            let offset = DVec2::new(f64::from(step % STEPS) + 0.5, f64::from(step / STEPS) + 0.5) / f64::from(STEPS);
            let [red, green, blue, opacity] = paint((DVec2::new(x.into(), y.into()) + offset) / f64::from(times));
            [red * opacity, green * opacity, blue * opacity, opacity].iter().zip(&mut sum).for_each(|(a, s)| *s += a);
        }
        let opacity: f64 = sum[3];
        let byte = |value: f64| if opacity > 0.0 { (value / opacity).round() as u8 } else { 0 };
        let mean = opacity / f64::from(STEPS * STEPS);
        Rgba([byte(sum[0]), byte(sum[1]), byte(sum[2]), (mean * 255.0).round() as u8])
    })
}

/// Returns the distance of `p` from a tapering limb with round ends. It is negative inside.
pub(super) fn limb(p: DVec2, from: (f64, f64), from_radius: f64, to: (f64, f64), to_radius: f64) -> f64 {
    let (from, to) = (DVec2::from(from), DVec2::from(to));
    let along = to - from;
    let t = ((p - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    p.distance(from + along * t) - (from_radius + (to_radius - from_radius) * t)
}

/// Returns whether `p` is on a thin line.
pub(super) fn line(p: DVec2, from: (f64, f64), to: (f64, f64), width: f64) -> bool {
    limb(p, from, width / 2.0, to, width / 2.0) <= 0.0
}

/// Returns whether `p` is in a disc.
pub(super) fn disc(p: DVec2, centre: (f64, f64), radius: f64) -> bool {
    p.distance(centre.into()) <= radius
}

/// Returns whether `p` is in an ellipse.
pub(super) fn ellipse(p: DVec2, centre: (f64, f64), radii: (f64, f64)) -> bool {
    ((p - DVec2::from(centre)) / DVec2::from(radii)).length() <= 1.0
}
