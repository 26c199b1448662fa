//! Tests of the cubic filter and the mip levels.

use glam::DVec2;

use super::{mesh, noise, opaque, picture, pixel, shifted, warp_bytes};

#[test]
fn shift_by_whole_pixels_is_exact() {
    let rgba = noise(50, 30);
    let (rest, triangles) = mesh(50.0, 30.0, 7);
    let moved = warp_bytes(&picture(50, 30, &rgba), &rest, &shifted(&rest, DVec2::new(7.0, -4.0)), &triangles, 1.0);
    for y in 0..30 {
        for x in 0..50 {
            let expected = if x >= 7 && y < 26 { pixel(&rgba, 50, x - 7, y + 4) } else { [0; 4] };
            assert_eq!(pixel(&moved, 50, x, y), expected, "at {x}, {y}");
        }
    }
}

#[test]
fn shift_by_half_a_pixel_applies_the_cubic() {
    let rgba = opaque(noise(20, 10));
    let (rest, triangles) = mesh(20.0, 10.0, 3);
    let moved = warp_bytes(&picture(20, 10, &rgba), &rest, &shifted(&rest, DVec2::new(0.5, 0.0)), &triangles, 1.0);
    for (x, y) in (1..20_usize).zip((0..10).cycle()) {
        let at = |x: usize| pixel(&rgba, 20, x.min(19), y).map(f64::from);
        let [before, left, right, after] = [at(x.saturating_sub(2)), at(x - 1), at(x), at(x + 1)];
        let expected = std::array::from_fn(|c| {
            (0.5625 * (left[c] + right[c]) - 0.0625 * (before[c] + after[c])).clamp(0.0, 255.0).round() as u8
        });
        assert_eq!(pixel(&moved, 20, x, y), expected, "at {x}, {y}");
    }
    // The mesh covers half of the first column, so its colour is half as opaque.
    let [r, g, b, _] = pixel(&rgba, 20, 0, 0);
    assert_eq!(pixel(&moved, 20, 0, 0), [r, g, b, 128]);
}

#[test]
fn squeeze_along_lines_keeps_the_lines_sharp() {
    // Horizontal lines of one pixel, squeezed along x to a quarter of the width.
    let rgba: Vec<u8> = (0..64 * 64).flat_map(|i| if i / 64 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] }).collect();
    let (rest, triangles) = mesh(64.0, 64.0, 4);
    let posed: Vec<_> = rest.iter().map(|p| DVec2::new(p.x * 0.25, p.y)).collect();
    let squeezed = warp_bytes(&picture(64, 64, &rgba), &rest, &posed, &triangles, 1.0);
    for y in 0..64 {
        assert_eq!(pixel(&squeezed, 64, 8, y), pixel(&rgba, 64, 8, y), "row {y}");
    }
}

#[test]
fn soft_edge_keeps_its_colour() {
    // A disc of one colour. Its opacity falls off over three pixels, and has a step at x = 0.
    let rgba: Vec<u8> = (0..40 * 40)
        .flat_map(|i| {
            let (x, y) = (f64::from(i % 40) - 19.5, f64::from(i / 40) - 19.5);
            let opacity = ((15.0 - x.hypot(y)) / 3.0).clamp(0.0, if x < 0.0 { 1.0 } else { 0.5 });
            [180, 90, 30, (255.0 * opacity).round() as u8]
        })
        .collect();
    let (rest, triangles) = mesh(40.0, 40.0, 5);
    let turn = DVec2::new(0.96, 0.28);
    for scale in [0.4, 0.8, 1.0, 1.7] {
        let posed: Vec<_> = rest.iter().map(|&p| turn.rotate(p - 20.0) * 0.9 + 20.0).collect();
        let warped = warp_bytes(&picture(40, 40, &rgba), &rest, &posed, &triangles, scale);
        for pixel in warped.chunks_exact(4).filter(|pixel| pixel[3] > 0) {
            assert_eq!(pixel[..3], [180, 90, 30], "of opacity {}", pixel[3]);
        }
    }
}

#[test]
fn shrunken_checkerboard_is_grey() {
    let rgba: Vec<u8> = (0..64 * 64)
        .flat_map(|i| if (i % 64 + i / 64) % 2 == 0 { [255, 255, 255, 255] } else { [0, 0, 0, 255] })
        .collect();
    let (rest, triangles) = mesh(64.0, 64.0, 4);
    let small = warp_bytes(&picture(64, 64, &rgba), &rest, &rest, &triangles, 0.25);
    assert_eq!(small.len(), 16 * 16 * 4);
    assert!(small.chunks_exact(4).all(|pixel| pixel == [128, 128, 128, 255]), "{small:?}");
}

#[test]
fn halving_an_odd_side_keeps_every_pixel() {
    // Only the last of 5 columns is bright. It must still count once the row has 2 texels.
    let rgba: Vec<u8> = (0..5 * 2).flat_map(|i| [if i % 5 == 4 { 250 } else { 0 }, 0, 0, 255]).collect();
    let quad = [DVec2::ZERO, DVec2::new(5.0, 0.0), DVec2::new(5.0, 2.0), DVec2::new(0.0, 2.0)];
    let posed = quad.map(|vertex| vertex * DVec2::new(0.4, 0.5));
    let small = warp_bytes(&picture(5, 2, &rgba), &quad, &posed, &[[0, 1, 2], [0, 2, 3]], 1.0);
    let sum = f64::from(pixel(&small, 5, 0, 0)[0]) + f64::from(pixel(&small, 5, 1, 0)[0]);
    assert!(sum > 60.0, "{small:?}");
}

#[test]
fn enlargement_keeps_flat_colours() {
    let rgba = [10, 20, 30, 255].repeat(9 * 5);
    let (rest, triangles) = mesh(9.0, 5.0, 2);
    assert!(warp_bytes(&picture(9, 5, &rgba), &rest, &rest, &triangles, 2.0) == [10, 20, 30, 255].repeat(18 * 10));
}

#[test]
fn transparent_pixels_do_not_bleed_colour() {
    let rgba: Vec<u8> =
        (0..16 * 4).flat_map(|i| if i % 16 < 8 { [200, 100, 50, 255] } else { [0, 255, 0, 0] }).collect();
    let (rest, triangles) = mesh(16.0, 4.0, 3);
    for (shift, scale) in [(0.5, 1.0), (0.25, 0.3), (0.0, 3.0)] {
        let shift = DVec2::new(shift, 0.0);
        let warped = warp_bytes(&picture(16, 4, &rgba), &rest, &shifted(&rest, shift), &triangles, scale);
        for pixel in warped.chunks_exact(4).filter(|pixel| pixel[3] > 0) {
            assert_eq!(pixel[..3], [200, 100, 50]);
        }
    }
}
