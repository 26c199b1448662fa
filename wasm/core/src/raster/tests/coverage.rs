//! Tests of coverage: seams, drawing order and extreme triangles.

use glam::DVec2;

use super::super::warped_size;
use super::{mesh, noise, opaque, picture, pixel, shifted, warp_bytes};

#[test]
fn mesh_at_rest_returns_the_picture() {
    for (width, height, cells) in [(64, 40, 1), (63, 41, 9), (257, 131, 40)] {
        let rgba = noise(width, height);
        let (rest, triangles) = mesh(f64::from(width), f64::from(height), cells);
        assert!(warp_bytes(&picture(width, height, &rgba), &rest, &rest, &triangles, 1.0) == rgba);
    }
}

#[test]
fn opaque_picture_has_no_seams() {
    let rgba = opaque(noise(120, 90));
    let (rest, triangles) = mesh(120.0, 90.0, 30);
    let posed: Vec<_> = rest
        .iter()
        .map(|p| {
            DVec2::new(p.x * 0.9 + 6.0 * libm::sin(p.y * 0.1) + 9.0, p.y * 0.83 + 4.0 * libm::cos(p.x * 0.13) + 9.0)
        })
        .collect();
    for scale in [0.5, 1.0, 2.0] {
        let warped = warp_bytes(&picture(120, 90, &rgba), &rest, &posed, &triangles, scale);
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
fn translucent_picture_has_no_seams() {
    let rgba = [90, 120, 30, 100].repeat(60 * 60);
    let (rest, triangles) = mesh(60.0, 60.0, 17);
    let warped = warp_bytes(&picture(60, 60, &rgba), &rest, &shifted(&rest, DVec2::splat(0.3)), &triangles, 1.0);
    for (x, y) in (1..60).flat_map(|y| (1..60).map(move |x| (x, y))) {
        assert_eq!(pixel(&warped, 60, x, y), [90, 120, 30, 100], "at {x}, {y}");
    }
}

#[test]
fn flipped_triangle_is_drawn_mirrored() {
    let rgba = noise(16, 16);
    let (rest, triangles) = mesh(16.0, 16.0, 1);
    let posed: Vec<_> = rest.iter().map(|p| DVec2::new(16.0 - p.x, p.y)).collect();
    let mirrored = warp_bytes(&picture(16, 16, &rgba), &rest, &posed, &triangles, 1.0);
    for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
        assert_eq!(pixel(&mirrored, 16, x, y), pixel(&rgba, 16, 15 - x, y));
    }
}

#[test]
fn later_triangles_cover_earlier_ones() {
    let rgba: Vec<u8> = (0..8 * 8).flat_map(|i| if i % 8 < 4 { [200, 0, 0, 255] } else { [0, 0, 200, 128] }).collect();
    let quad = |x: f64| [[x, 0.0], [x + 4.0, 0.0], [x + 4.0, 8.0], [x, 8.0]].map(DVec2::from_array);
    let rest = [quad(0.0), quad(4.0)].concat();
    let posed = [quad(0.0), quad(0.0)].concat();
    let (red, blue) = ([[0, 1, 2], [0, 2, 3]], [[4, 5, 6], [4, 6, 7]]);
    let under = warp_bytes(&picture(8, 8, &rgba), &rest, &posed, &[blue, red].concat(), 1.0);
    let over = warp_bytes(&picture(8, 8, &rgba), &rest, &posed, &[red, blue].concat(), 1.0);
    assert_eq!(pixel(&under, 8, 1, 4), [200, 0, 0, 255]);
    assert_eq!(pixel(&over, 8, 1, 4), [100, 0, 100, 255]);
}

#[test]
fn degenerate_and_far_triangles_are_not_drawn() {
    let rgba = noise(8, 8);
    let rest = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
    for corner in [DVec2::new(f64::NAN, 0.0), DVec2::splat(f64::INFINITY), DVec2::splat(1e300), DVec2::new(4.0, 0.0)] {
        let posed = [rest[0], rest[1], corner];
        let warped = warp_bytes(&picture(8, 8, &rgba), &rest, &posed, &[[0, 1, 2], [0, 0, 1]], 1.0);
        assert!(warped.iter().all(|&byte| byte == 0));
    }
}

#[test]
fn huge_triangle_fills_the_picture() {
    let rgba = opaque(noise(8, 8));
    let rest = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
    let posed = rest.map(|p| p * 100_000.0 - 300_000.0);
    let warped = warp_bytes(&picture(8, 8, &rgba), &rest, &posed, &[[0, 1, 2]], 1.0);
    assert_eq!(warped, warped[..4].repeat(8 * 8));
    assert_eq!(warped[3], 255);
}
