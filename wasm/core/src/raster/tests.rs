//! Tests of the rasteriser on whole pictures.

use glam::DVec2;

use super::options::{Canvas, Filter, ResampleOptions};
use super::warped_size;
use crate::error::Error;
use crate::picture::Picture;

/// A picture with a different colour and opacity everywhere; none of its pixels is wholly transparent.
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

fn opaque(mut rgba: Vec<u8>) -> Vec<u8> {
    rgba.iter_mut().skip(3).step_by(4).for_each(|alpha| *alpha = 255);
    rgba
}

const GROWN: ResampleOptions = ResampleOptions { scale: 1.0, canvas: Canvas::Grown, filter: Filter::Cubic };

/// The bytes alone.
fn warp(picture: &Picture<'_>, rest: &[DVec2], posed: &[DVec2], triangles: &[[u32; 3]], scale: f64) -> Vec<u8> {
    super::warp(picture, rest, posed, triangles, ResampleOptions { scale, ..ResampleOptions::default() }).unwrap().rgba
}

fn picture(width: u32, height: u32, rgba: &[u8]) -> Picture<'_> {
    Picture::new(width, height, rgba).unwrap()
}

/// A mesh of cells over the rectangle, its inner vertices pushed about.
fn mesh(width: f64, height: f64, cells: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let mut state = 7_u32;
    let mut push = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (f64::from(state >> 8) / f64::from(1 << 24) - 0.5) * 0.6
    };
    let side = cells + 1;
    let vertices = (0..side * side)
        .map(|i| {
            let (x, y) = (i % side, i / side);
            let inner = |k: u32| k > 0 && k < cells;
            let dx = if inner(x) { push() } else { 0.0 };
            let dy = if inner(y) { push() } else { 0.0 };
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

#[test]
fn a_mesh_at_rest_gives_the_bytes_back() {
    for (width, height, cells) in [(64, 40, 1), (63, 41, 9), (257, 131, 40)] {
        let rgba = noise(width, height);
        let (rest, triangles) = mesh(f64::from(width), f64::from(height), cells);
        assert!(warp(&picture(width, height, &rgba), &rest, &rest, &triangles, 1.0) == rgba);
    }
}

#[test]
fn whole_pixels_move_exactly() {
    let rgba = noise(50, 30);
    let (rest, triangles) = mesh(50.0, 30.0, 7);
    let moved = warp(&picture(50, 30, &rgba), &rest, &shifted(&rest, DVec2::new(7.0, -4.0)), &triangles, 1.0);
    for y in 0..30 {
        for x in 0..50 {
            let expected = if x >= 7 && y < 26 { pixel(&rgba, 50, x - 7, y + 4) } else { [0; 4] };
            assert_eq!(pixel(&moved, 50, x, y), expected, "at {x}, {y}");
        }
    }
}

#[test]
fn half_a_pixel_is_read_by_the_cubic() {
    let rgba = opaque(noise(20, 10));
    let (rest, triangles) = mesh(20.0, 10.0, 3);
    let moved = warp(&picture(20, 10, &rgba), &rest, &shifted(&rest, DVec2::new(0.5, 0.0)), &triangles, 1.0);
    for (x, y) in (1..20_usize).zip((0..10).cycle()) {
        let at = |x: usize| pixel(&rgba, 20, x.min(19), y).map(f64::from);
        let [before, left, right, after] = [at(x.saturating_sub(2)), at(x - 1), at(x), at(x + 1)];
        let expected = std::array::from_fn(|c| {
            (0.5625 * (left[c] + right[c]) - 0.0625 * (before[c] + after[c])).clamp(0.0, 255.0).round() as u8
        });
        assert_eq!(pixel(&moved, 20, x, y), expected, "at {x}, {y}");
    }
    // Half of the first pixel is covered: the picture's rim, half as opaque.
    let [r, g, b, _] = pixel(&rgba, 20, 0, 0);
    assert_eq!(pixel(&moved, 20, 0, 0), [r, g, b, 128]);
}

#[test]
fn what_is_squeezed_stays_sharp_along() {
    // Lines of one pixel, which the picture is squeezed along: to a quarter of its width, at full height.
    let rgba: Vec<u8> = (0..64 * 64).flat_map(|i| if i / 64 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] }).collect();
    let (rest, triangles) = mesh(64.0, 64.0, 4);
    let posed: Vec<_> = rest.iter().map(|p| DVec2::new(p.x * 0.25, p.y)).collect();
    let squeezed = warp(&picture(64, 64, &rgba), &rest, &posed, &triangles, 1.0);
    for y in 0..64 {
        assert_eq!(pixel(&squeezed, 64, 8, y), pixel(&rgba, 64, 8, y), "row {y}");
    }
}

#[test]
fn a_soft_edge_keeps_its_colour_and_stays_within_its_opacity() {
    // A disc of one colour whose opacity falls off over three pixels, and steps at a line.
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
        let warped = warp(&picture(40, 40, &rgba), &rest, &posed, &triangles, scale);
        for pixel in warped.chunks_exact(4).filter(|pixel| pixel[3] > 0) {
            assert_eq!(pixel[..3], [180, 90, 30], "of opacity {}", pixel[3]);
        }
    }
}

#[test]
fn a_small_checkerboard_is_grey() {
    let rgba: Vec<u8> = (0..64 * 64)
        .flat_map(|i| if (i % 64 + i / 64) % 2 == 0 { [255, 255, 255, 255] } else { [0, 0, 0, 255] })
        .collect();
    let (rest, triangles) = mesh(64.0, 64.0, 4);
    let small = warp(&picture(64, 64, &rgba), &rest, &rest, &triangles, 0.25);
    assert_eq!(small.len(), 16 * 16 * 4);
    assert!(small.chunks_exact(4).all(|pixel| pixel == [128, 128, 128, 255]), "{small:?}");
}

#[test]
fn an_odd_side_loses_no_pixel_when_halved() {
    // One bright column at the far end of 5; of 2 texels, the second shows half of it and all of what is left of it.
    let rgba: Vec<u8> = (0..5 * 2).flat_map(|i| [if i % 5 == 4 { 250 } else { 0 }, 0, 0, 255]).collect();
    let quad = [DVec2::ZERO, DVec2::new(5.0, 0.0), DVec2::new(5.0, 2.0), DVec2::new(0.0, 2.0)];
    let posed = quad.map(|vertex| vertex * DVec2::new(0.4, 0.5));
    let small = warp(&picture(5, 2, &rgba), &quad, &posed, &[[0, 1, 2], [0, 2, 3]], 1.0);
    let sum = f64::from(pixel(&small, 5, 0, 0)[0]) + f64::from(pixel(&small, 5, 1, 0)[0]);
    assert!(sum > 60.0, "{small:?}");
}

#[test]
fn an_opaque_picture_has_no_seams() {
    let rgba = opaque(noise(120, 90));
    let (rest, triangles) = mesh(120.0, 90.0, 30);
    let posed: Vec<_> = rest
        .iter()
        .map(|p| {
            DVec2::new(p.x * 0.9 + 6.0 * libm::sin(p.y * 0.1) + 9.0, p.y * 0.83 + 4.0 * libm::cos(p.x * 0.13) + 9.0)
        })
        .collect();
    for scale in [0.5, 1.0, 2.0] {
        let warped = warp(&picture(120, 90, &rgba), &rest, &posed, &triangles, scale);
        let (width, height) = warped_size(120, 90, scale).unwrap();
        let inside = |lo: f64, hi: f64, side: u32| (f64::from(side) * lo) as usize..(f64::from(side) * hi) as usize;
        for y in inside(0.2, 0.8, height) {
            for x in inside(0.2, 0.8, width) {
                assert_eq!(pixel(&warped, width as usize, x, y)[3], 255, "at {x}, {y} at scale {scale}");
            }
        }
    }
}

#[test]
fn a_faint_picture_has_no_seams_either() {
    let rgba = [90, 120, 30, 100].repeat(60 * 60);
    let (rest, triangles) = mesh(60.0, 60.0, 17);
    let warped = warp(&picture(60, 60, &rgba), &rest, &shifted(&rest, DVec2::splat(0.3)), &triangles, 1.0);
    for (x, y) in (1..60).flat_map(|y| (1..60).map(move |x| (x, y))) {
        assert_eq!(pixel(&warped, 60, x, y), [90, 120, 30, 100], "at {x}, {y}");
    }
}

#[test]
fn doubling_keeps_flat_colours_and_sides() {
    let rgba = [10, 20, 30, 255].repeat(9 * 5);
    let (rest, triangles) = mesh(9.0, 5.0, 2);
    assert!(warp(&picture(9, 5, &rgba), &rest, &rest, &triangles, 2.0) == [10, 20, 30, 255].repeat(18 * 10));
}

#[test]
fn a_turned_over_triangle_is_drawn_mirrored() {
    let rgba = noise(16, 16);
    let (rest, triangles) = mesh(16.0, 16.0, 1);
    let posed: Vec<_> = rest.iter().map(|p| DVec2::new(16.0 - p.x, p.y)).collect();
    let mirrored = warp(&picture(16, 16, &rgba), &rest, &posed, &triangles, 1.0);
    for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
        assert_eq!(pixel(&mirrored, 16, x, y), pixel(&rgba, 16, 15 - x, y));
    }
}

#[test]
fn later_triangles_lie_over_earlier_ones() {
    let rgba: Vec<u8> = (0..8 * 8).flat_map(|i| if i % 8 < 4 { [200, 0, 0, 255] } else { [0, 0, 200, 128] }).collect();
    let quad = |x: f64| [[x, 0.0], [x + 4.0, 0.0], [x + 4.0, 8.0], [x, 8.0]].map(DVec2::from_array);
    let rest = [quad(0.0), quad(4.0)].concat();
    let posed = [quad(0.0), quad(0.0)].concat();
    let (red, blue) = ([[0, 1, 2], [0, 2, 3]], [[4, 5, 6], [4, 6, 7]]);
    let under = warp(&picture(8, 8, &rgba), &rest, &posed, &[blue, red].concat(), 1.0);
    let over = warp(&picture(8, 8, &rgba), &rest, &posed, &[red, blue].concat(), 1.0);
    assert_eq!(pixel(&under, 8, 1, 4), [200, 0, 0, 255]);
    assert_eq!(pixel(&over, 8, 1, 4), [100, 0, 100, 255]);
}

#[test]
fn colours_do_not_bleed_out_of_transparent_pixels() {
    let rgba: Vec<u8> =
        (0..16 * 4).flat_map(|i| if i % 16 < 8 { [200, 100, 50, 255] } else { [0, 255, 0, 0] }).collect();
    let (rest, triangles) = mesh(16.0, 4.0, 3);
    for (shift, scale) in [(0.5, 1.0), (0.25, 0.3), (0.0, 3.0)] {
        let shift = DVec2::new(shift, 0.0);
        let warped = warp(&picture(16, 4, &rgba), &rest, &shifted(&rest, shift), &triangles, scale);
        for pixel in warped.chunks_exact(4).filter(|pixel| pixel[3] > 0) {
            assert_eq!(pixel[..3], [200, 100, 50]);
        }
    }
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let rgba = noise(8, 8);
    let rest = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
    for corner in [DVec2::new(f64::NAN, 0.0), DVec2::splat(f64::INFINITY), DVec2::splat(1e300), DVec2::new(4.0, 0.0)] {
        let posed = [rest[0], rest[1], corner];
        let warped = warp(&picture(8, 8, &rgba), &rest, &posed, &[[0, 1, 2], [0, 0, 1]], 1.0);
        assert!(warped.iter().all(|&byte| byte == 0));
    }
}

#[test]
fn a_triangle_that_reaches_far_beyond_the_picture_fills_it() {
    let rgba = opaque(noise(8, 8));
    let rest = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
    let posed = rest.map(|p| p * 100_000.0 - 300_000.0);
    let warped = warp(&picture(8, 8, &rgba), &rest, &posed, &[[0, 1, 2]], 1.0);
    assert_eq!(warped, warped[..4].repeat(8 * 8));
    assert_eq!(warped[3], 255);
}

#[test]
fn sizes_that_make_no_picture_are_named() {
    assert_eq!(warped_size(100, 51, 0.5), Ok((50, 26)));
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e9, 164.0] {
        assert!(matches!(warped_size(100, 50, scale), Err(Error::Scale { .. })), "{scale}");
        let rgba = opaque(noise(100, 50));
        let warped = super::warp(
            &picture(100, 50, &rgba),
            &[],
            &[],
            &[],
            ResampleOptions { scale, ..ResampleOptions::default() },
        );
        assert!(matches!(warped, Err(Error::Scale { .. })), "{scale}");
    }
}

#[test]
fn a_grown_canvas_holds_what_is_cut_off_and_no_more() {
    let bytes = opaque(noise(20, 12));
    let picture = picture(20, 12, &bytes);
    let (rest, triangles) = mesh(20.0, 12.0, 3);
    let moved = |by: DVec2| rest.iter().map(|&p| p + by).collect::<Vec<_>>();
    let grown = |posed: &[DVec2]| super::warp(&picture, &rest, posed, &triangles, GROWN).unwrap();

    let at_rest = grown(&rest);
    assert_eq!((at_rest.width, at_rest.height, at_rest.origin), (20, 12, [0, 0]));
    assert!(at_rest.rgba == bytes);

    // To the left and down: the picture's own rectangle stays, and its bytes are those of the small canvas.
    let left = moved(DVec2::new(-7.0, 3.0));
    let all = grown(&left);
    assert_eq!((all.width, all.height, all.origin), (27, 15, [7, 0]));
    let small = warp(&picture, &rest, &left, &triangles, 1.0);
    for (y, row) in small.chunks_exact(20 * 4).enumerate() {
        let start = (y * 27 + 7) * 4;
        assert!(all.rgba[start..start + 20 * 4] == *row, "row {y}");
    }
    // The whole picture is there.
    for (y, row) in bytes.chunks_exact(20 * 4).enumerate() {
        let start = (y + 3) * 27 * 4;
        assert!(all.rgba[start..start + 20 * 4] == *row, "row {y}");
    }
}

#[test]
fn a_grown_canvas_is_trimmed_to_what_is_seen() {
    // Nothing but a square in the middle.
    let mut bytes = opaque(noise(20, 20));
    for (i, pixel) in bytes.chunks_exact_mut(4).enumerate() {
        if !(8..12).contains(&(i % 20)) || !(8..12).contains(&(i / 20)) {
            pixel.fill(0);
        }
    }
    let picture = picture(20, 20, &bytes);
    let (rest, triangles) = mesh(20.0, 20.0, 1);
    let posed: Vec<_> = rest.iter().map(|&p| p + DVec2::new(15.0, -10.0)).collect();
    let warped = super::warp(&picture, &rest, &posed, &triangles, GROWN).unwrap();
    assert_eq!((warped.width, warped.height, warped.origin), (27, 22, [0, 2]));
}

#[test]
fn a_canvas_that_would_grow_too_large_is_refused() {
    let bytes = noise(4, 4);
    let picture = picture(4, 4, &bytes);
    let (rest, triangles) = mesh(4.0, 4.0, 1);
    let posed: Vec<_> = rest.iter().map(|&p| p + DVec2::new(30_000.0, 0.0)).collect();
    let refused = super::warp(&picture, &rest, &posed, &triangles, GROWN);
    assert_eq!(refused, Err(Error::Canvas { width: 30_004, height: 4 }));
}

#[test]
fn pixel_art_keeps_its_pixels() {
    let rgba = opaque(noise(24, 18));
    let (rest, triangles) = mesh(24.0, 18.0, 6);
    let drawn = |posed: &[DVec2], scale| {
        let options = ResampleOptions { scale, filter: Filter::Nearest, ..ResampleOptions::default() };
        super::warp(&picture(24, 18, &rgba), &rest, posed, &triangles, options).unwrap().rgba
    };
    assert!(drawn(&rest, 1.0) == rgba);
    // Half a pixel aside, centres lie between two pixels: the second is shown, everywhere.
    let aside = drawn(&shifted(&rest, DVec2::new(0.5, 0.0)), 1.0);
    assert!((1..24).all(|x| pixel(&aside, 24, x, 7) == pixel(&rgba, 24, x, 7)));
    let large = drawn(&rest, 3.0);
    assert!((0..72).all(|x| pixel(&large, 72, x, 25) == pixel(&rgba, 24, x / 3, 8)));
    // Turned, squeezed and bent: pixels of the picture, or none.
    let posed: Vec<DVec2> =
        rest.iter().map(|p| DVec2::new(0.6 * p.x + 0.3 * p.y, p.y - 0.2 * p.x + libm::sin(p.x))).collect();
    let known: std::collections::HashSet<[u8; 4]> = rgba.as_chunks().0.iter().copied().chain([[0; 4]]).collect();
    for scale in [0.5, 1.0, 2.5] {
        let warped = drawn(&posed, scale);
        let pixels = warped.as_chunks::<4>().0;
        assert!(pixels.iter().all(|pixel| known.contains(pixel)), "at scale {scale}");
        assert!(pixels.iter().filter(|pixel| pixel[3] == 255).count() > pixels.len() / 3);
    }
}

#[test]
fn translucent_pixel_art_takes_the_place_of_what_it_lies_over() {
    let rgba: Vec<u8> = [[200, 0, 0, 255], [0, 0, 200, 100]].into_iter().cycle().take(16).flatten().collect();
    let side = |x: f64| [(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 8.0), (x, 8.0)].map(DVec2::from);
    let rest = [side(0.0), side(1.0)].concat();
    let posed = [side(0.0), side(0.0)].concat();
    let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let options = ResampleOptions { filter: Filter::Nearest, ..ResampleOptions::default() };
    let warped = super::warp(&picture(2, 8, &rgba), &rest, &posed, &triangles, options).unwrap().rgba;
    assert_eq!(pixel(&warped, 2, 0, 3), [0, 0, 200, 100]);
}
