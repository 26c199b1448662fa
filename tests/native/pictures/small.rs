//! Small pictures for tests of the command line. Their colours are asymmetric, so tests detect flips and rotations.

use image::{Rgba, RgbaImage};

/// Returns the picture with this file name.
pub(super) fn drawn(name: &str) -> RgbaImage {
    match name {
        "strip.png" => strip(),
        "ring.png" => ring(),
        "islands.png" => islands(),
        other => panic!("no scene has a picture {other}"),
    }
}

fn colour(x: u32, y: u32) -> [u8; 3] {
    let square = if (x / 8 + y / 8).is_multiple_of(2) { 40 } else { 0 };
    [(60 + 2 * (x % 64) + square) as u8, (30 + 3 * (y % 64)) as u8, (200 - square - x % 64) as u8]
}

/// Draws a picture with the opacity of `opacity` at each pixel's centre.
fn painted(width: u32, height: u32, opacity: impl Fn(f64, f64) -> f64) -> RgbaImage {
    RgbaImage::from_fn(width, height, |x, y| {
        let [r, g, b] = colour(x, y);
        let opacity = opacity(f64::from(x) + 0.5, f64::from(y) + 0.5).clamp(0.0, 1.0);
        Rgba([r, g, b, (opacity * 255.0).round() as u8])
    })
}

/// An opaque rectangle.
fn strip() -> RgbaImage {
    painted(96, 48, |_, _| 1.0)
}

/// A ring around (64, 64), from 30 to 58 px.
fn ring() -> RgbaImage {
    painted(128, 128, |x, y| {
        let radius = (x - 64.0).hypot(y - 64.0);
        (58.0 - radius).min(radius - 30.0) + 0.5
    })
}

/// Two discs of 24 px around (32, 32) and (88, 32).
fn islands() -> RgbaImage {
    painted(120, 64, |x, y| {
        let disc = |centre: f64| 24.0 - (x - centre).hypot(y - 32.0);
        disc(32.0).max(disc(88.0)) + 0.5
    })
}
