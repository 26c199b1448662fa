//! Tests of the nearest filter.

use glam::DVec2;

use super::super::{
    options::{Filter, ResampleOptions},
    warp,
};
use super::{mesh, noise, opaque, picture, pixel, shifted};

#[test]
fn nearest_filter_mixes_no_colours() {
    let rgba = opaque(noise(24, 18));
    let (rest, triangles) = mesh(24.0, 18.0, 6);
    let drawn = |posed: &[DVec2], scale| {
        let options = ResampleOptions { scale, filter: Filter::Nearest, ..ResampleOptions::default() };
        warp(&picture(24, 18, &rgba), &rest, posed, &triangles, options).unwrap().rgba
    };
    assert!(drawn(&rest, 1.0) == rgba);
    // Shifted by half a pixel, each centre lies between two pixels. The second pixel is drawn.
    let shifted_by_half = drawn(&shifted(&rest, DVec2::new(0.5, 0.0)), 1.0);
    assert!((1..24).all(|x| pixel(&shifted_by_half, 24, x, 7) == pixel(&rgba, 24, x, 7)));
    let large = drawn(&rest, 3.0);
    assert!((0..72).all(|x| pixel(&large, 72, x, 25) == pixel(&rgba, 24, x / 3, 8)));
    // Rotated, squeezed and bent: every pixel is one of the picture, or empty.
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
fn translucent_pixel_art_replaces_lower_pixels() {
    let rgba: Vec<u8> = [[200, 0, 0, 255], [0, 0, 200, 100]].into_iter().cycle().take(16).flatten().collect();
    let side = |x: f64| [(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 8.0), (x, 8.0)].map(DVec2::from);
    let rest = [side(0.0), side(1.0)].concat();
    let posed = [side(0.0), side(0.0)].concat();
    let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let options = ResampleOptions { filter: Filter::Nearest, ..ResampleOptions::default() };
    let warped = warp(&picture(2, 8, &rgba), &rest, &posed, &triangles, options).unwrap().rgba;
    assert_eq!(pixel(&warped, 2, 0, 3), [0, 0, 200, 100]);
}
