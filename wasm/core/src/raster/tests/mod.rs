//! Tests of the rasteriser on whole pictures.

mod canvas;
mod coverage;
mod filter;
mod pixel_art;

use glam::DVec2;

use super::options::{Canvas, Filter, ResampleOptions};
use crate::picture::Picture;

/// Returns pseudo-random RGBA without fully transparent pixels.
fn noise(width: u32, height: u32) -> Vec<u8> {
    let mut state = 1_u32;
    (0..width * height * 4)
        .map(|i| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let byte = (state >> 24) as u8;
            if i % 4 == 3 { byte.max(1) } else { byte }
        })
        .collect()
}

/// Makes every pixel opaque.
fn opaque(mut rgba: Vec<u8>) -> Vec<u8> {
    rgba.iter_mut().skip(3).step_by(4).for_each(|alpha| *alpha = 255);
    rgba
}

/// The grown canvas at scale 1.
const GROWN: ResampleOptions =
    ResampleOptions { scale: 1.0, canvas: Canvas::Grown, filter: Filter::Cubic, edges: false };

/// Warps on the picture's own canvas and returns the bytes.
fn warp_bytes(picture: &Picture<'_>, rest: &[DVec2], posed: &[DVec2], triangles: &[[u32; 3]], scale: f64) -> Vec<u8> {
    super::warp(picture, rest, posed, triangles, ResampleOptions { scale, ..ResampleOptions::default() }).unwrap().rgba
}

fn picture(width: u32, height: u32, rgba: &[u8]) -> Picture<'_> {
    Picture::new(width, height, rgba).unwrap()
}

/// Returns a grid of `cells × cells` quads over the rectangle, with jittered inner vertices.
fn mesh(width: f64, height: f64, cells: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let mut state = 7_u32;
    let mut jitter = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (f64::from(state >> 8) / f64::from(1 << 24) - 0.5) * 0.6
    };
    let side = cells + 1;
    let vertices = (0..side * side)
        .map(|i| {
            let (x, y) = (i % side, i / side);
            let inner = |k: u32| k > 0 && k < cells;
            let dx = if inner(x) { jitter() } else { 0.0 };
            let dy = if inner(y) { jitter() } else { 0.0 };
            DVec2::new(f64::from(x) + dx, f64::from(y) + dy) * DVec2::new(width, height) / f64::from(cells)
        })
        .collect();
    let triangles = (0..cells * cells)
        .flat_map(|i| {
            let a = i / cells * side + i % cells;
            [[a, a + 1, a + side], [a + side + 1, a + side, a + 1]]
        })
        .collect();
    (vertices, triangles)
}

fn shifted(vertices: &[DVec2], by: DVec2) -> Vec<DVec2> {
    vertices.iter().map(|&vertex| vertex + by).collect()
}

fn pixel(rgba: &[u8], width: usize, x: usize, y: usize) -> [u8; 4] {
    let start = (y * width + x) * 4;
    rgba[start..start + 4].try_into().unwrap()
}
