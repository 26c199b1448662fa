//! Tests of the size of the result.

use glam::DVec2;

use super::super::{
    Drawing,
    extent::Extent,
    options::{Canvas, ResampleOptions},
    warp,
    warped::Warped,
    warped_size,
};
use super::{GROWN, mesh, noise, opaque, picture, warp_bytes};
use crate::error::Error;

#[test]
fn scales_without_a_valid_size_are_rejected() {
    assert_eq!(warped_size(100, 51, 0.5), Ok((50, 26)));
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e9, 164.0] {
        assert!(matches!(warped_size(100, 50, scale), Err(Error::Scale { .. })), "{scale}");
        let rgba = opaque(noise(100, 50));
        let warped =
            warp(&picture(100, 50, &rgba), &[], &[], &[], ResampleOptions { scale, ..ResampleOptions::default() });
        assert!(matches!(warped, Err(Error::Scale { .. })), "{scale}");
    }
}

#[test]
fn grown_canvas_holds_the_whole_picture() {
    let bytes = opaque(noise(20, 12));
    let picture = picture(20, 12, &bytes);
    let (rest, triangles) = mesh(20.0, 12.0, 3);
    let moved = |by: DVec2| rest.iter().map(|&p| p + by).collect::<Vec<_>>();
    let grown = |posed: &[DVec2]| warp(&picture, &rest, posed, &triangles, GROWN).unwrap();

    let at_rest = grown(&rest);
    assert_eq!((at_rest.width, at_rest.height, at_rest.origin), (20, 12, [0, 0]));
    assert!(at_rest.rgba == bytes);

    // Moved left and down: inside the picture's own rectangle, both canvases have the same bytes.
    let left = moved(DVec2::new(-7.0, 3.0));
    let all = grown(&left);
    assert_eq!((all.width, all.height, all.origin), (27, 15, [7, 0]));
    let small = warp_bytes(&picture, &rest, &left, &triangles, 1.0);
    for (y, row) in small.chunks_exact(20 * 4).enumerate() {
        let start = (y * 27 + 7) * 4;
        assert!(all.rgba[start..start + 20 * 4] == *row, "row {y}");
    }
    // The whole picture is inside the grown canvas.
    for (y, row) in bytes.chunks_exact(20 * 4).enumerate() {
        let start = (y + 3) * 27 * 4;
        assert!(all.rgba[start..start + 20 * 4] == *row, "row {y}");
    }
}

#[test]
fn grown_canvas_is_trimmed_to_visible_pixels() {
    // All but a square in the middle is transparent.
    let mut bytes = opaque(noise(20, 20));
    for (i, pixel) in bytes.chunks_exact_mut(4).enumerate() {
        if !(8..12).contains(&(i % 20)) || !(8..12).contains(&(i / 20)) {
            pixel.fill(0);
        }
    }
    let picture = picture(20, 20, &bytes);
    let (rest, triangles) = mesh(20.0, 20.0, 1);
    let posed: Vec<_> = rest.iter().map(|&p| p + DVec2::new(15.0, -10.0)).collect();
    let warped = warp(&picture, &rest, &posed, &triangles, GROWN).unwrap();
    assert_eq!((warped.width, warped.height, warped.origin), (27, 22, [0, 2]));
}

#[test]
fn covered_canvas_has_no_empty_border() {
    // A square and a lower, wider bar are opaque.
    let mut bytes = opaque(noise(40, 60));
    for (i, pixel) in bytes.chunks_exact_mut(4).enumerate() {
        let (x, y) = (i % 40, i / 40);
        let square = (18..22).contains(&x) && (8..12).contains(&y);
        let bar = (3..37).contains(&x) && (30..33).contains(&y);
        if !square && !bar {
            pixel.fill(0);
        }
    }
    let picture = picture(40, 60, &bytes);
    let (rest, triangles) = mesh(40.0, 60.0, 6);
    let options = |canvas| ResampleOptions { canvas, ..ResampleOptions::default() };
    for by in [DVec2::ZERO, DVec2::new(-20.0, -11.0), DVec2::new(30.0, 40.0)] {
        let posed: Vec<_> = rest.iter().map(|&p| p + by).collect();
        let covered = warp(&picture, &rest, &posed, &triangles, options(Canvas::Covered)).unwrap();
        let origin = [-3 - by.x as i32, -8 - by.y as i32];
        assert_eq!((covered.width, covered.height, covered.origin), (34, 25, origin), "{by}");
        for (y, row) in covered.rgba.chunks_exact(34 * 4).enumerate() {
            let start = ((y + 8) * 40 + 3) * 4;
            assert!(bytes[start..start + 34 * 4] == *row, "{by}, row {y}");
        }
    }
    let nothing = vec![0; 40 * 60 * 4];
    let empty = warp(&super::picture(40, 60, &nothing), &rest, &rest, &triangles, options(Canvas::Covered));
    assert_eq!(empty, Err(Error::NothingDrawn));
}

#[test]
fn bands_are_rows_of_the_whole_result() {
    let bytes = noise(33, 70);
    let picture = picture(33, 70, &bytes);
    let (rest, triangles) = mesh(33.0, 70.0, 4);
    let posed: Vec<_> = rest.iter().map(|&p| DVec2::new(p.x * 1.3 - 9.0, p.y * 0.8 + p.x * 0.2 - 5.0)).collect();
    for canvas in [Canvas::Picture, Canvas::Grown, Canvas::Covered] {
        let options = ResampleOptions { canvas, scale: 1.5, ..ResampleOptions::default() };
        let drawing = Drawing::new(&picture, &rest, &posed, &triangles, options).unwrap();
        let height = drawing.height();
        let bands = (0..height).step_by(48).map(|row| drawing.rows(&picture, row..height.min(row + 48)));
        let whole = warp(&picture, &rest, &posed, &triangles, options).unwrap();
        assert!(bands.collect::<Vec<_>>().concat() == whole.rgba, "{canvas:?}");
    }
}

#[test]
fn fixed_canvas_is_a_window_on_the_grown_one() {
    let bytes = noise(33, 70);
    let picture = picture(33, 70, &bytes);
    let (rest, triangles) = mesh(33.0, 70.0, 4);
    let posed: Vec<_> = rest.iter().map(|&p| DVec2::new(p.x * 1.3 - 9.0, p.y * 0.8 + p.x * 0.2 - 5.0)).collect();
    let warped = |canvas| {
        warp(&picture, &rest, &posed, &triangles, ResampleOptions { canvas, ..ResampleOptions::default() }).unwrap()
    };
    let grown = warped(Canvas::Grown);
    let origin = grown.origin;
    let same = Extent { origin, width: grown.width, height: grown.height };
    assert_eq!(warped(Canvas::Fixed(same)), grown);
    let larger = warped(Canvas::Fixed(Extent {
        origin: [origin[0] + 5, origin[1] + 21],
        width: grown.width + 12,
        height: grown.height + 40,
    }));
    let row = |of: &Warped, y: usize| of.rgba.chunks_exact(of.width as usize * 4).nth(y).unwrap().to_vec();
    for y in 0..larger.height as usize {
        let expected = if (21..21 + grown.height as usize).contains(&y) {
            [vec![0; 5 * 4], row(&grown, y - 21), vec![0; 7 * 4]].concat()
        } else {
            vec![0; larger.width as usize * 4]
        };
        assert!(row(&larger, y) == expected, "row {y}");
    }
    let smaller = warped(Canvas::Fixed(Extent { origin: [origin[0] - 3, origin[1] - 2], width: 20, height: 30 }));
    for y in 0..30 {
        assert!(row(&smaller, y) == row(&grown, y + 2)[3 * 4..23 * 4], "row {y}");
    }
    let empty = Canvas::Fixed(Extent { origin, width: 0, height: 3 });
    let refused = warp(&picture, &rest, &posed, &triangles, ResampleOptions { canvas: empty, ..GROWN });
    assert_eq!(refused, Err(Error::NothingDrawn));
}

#[test]
fn canvas_beyond_the_largest_size_is_rejected() {
    let bytes = noise(4, 4);
    let picture = picture(4, 4, &bytes);
    let (rest, triangles) = mesh(4.0, 4.0, 1);
    let posed: Vec<_> = rest.iter().map(|&p| p + DVec2::new(30_000.0, 0.0)).collect();
    let refused = warp(&picture, &rest, &posed, &triangles, GROWN);
    assert_eq!(refused, Err(Error::Canvas { width: 30_004, height: 4 }));
}
