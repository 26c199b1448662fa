//! `c2warp warp --stmap`.

use std::path::Path;

use crate::command::{command, refuse, succeed};
use crate::tables::table;
use crate::workplace::Workplace;

const WARP: &str = "warp scene.c2warp.json -o out.png --stmap map.exr";

/// Where each pixel of the result comes from is what `map --inverse` says.
#[test]
fn the_map_for_compositors_is_that_of_the_result() {
    let place = Workplace::with("ring").changed(|project| {
        for handle in project["handles"].as_array_mut().unwrap() {
            handle["posed"][0] = (handle["posed"][0].as_f64().unwrap() - 20.0).into();
        }
    });
    let origin = succeed(place.folder(), &format!("{WARP} --grow --scale 2"));
    let origin: Vec<f64> = String::from_utf8(origin).unwrap().trim().split(',').map(|n| n.parse().unwrap()).collect();
    let (width, height, map) = stmap(&place.file("map.exr"));
    let (picture, result) = (place.picture("ring.png"), place.picture("out.png"));
    assert!(result.dimensions() == (width as u32, height as u32) && origin[0] > 0.0, "{origin:?}");

    let centre = |pixel: usize| [(pixel % width, origin[0]), (pixel / width, origin[1])];
    let at: Vec<[f64; 2]> =
        (0..map.len()).map(|pixel| centre(pixel).map(|(i, from)| (i as f64 + 0.5 - from) / 2.0)).collect();
    let sides = [picture.width(), picture.height()].map(f64::from);
    let (mut inside, mut beside) = (0, 0);
    for (([u, v, det, coverage], row), pixel) in
        map.iter().zip(table(&place, "map --inverse", &at).1).zip(result.pixels())
    {
        let told = [f64::from(*u) * sides[0], (1.0 - f64::from(*v)) * sides[1]];
        match [2, 3].map(|cell| row[cell].parse::<f64>()) {
            [Ok(x), Ok(y)] => {
                // Single precision, and corners of triangles that are rounded to 1/256 px for drawing.
                assert!((told[0] - x).hypot(told[1] - y) < 0.01 && *coverage > 0.0, "{told:?}, not {x}, {y}");
                assert!(*det > 0.0, "{det}");
                inside += 1;
            }
            _ if *coverage == 0.0 => {
                assert_eq!((u, v, det, pixel[3]), (&0.0, &0.0, &0.0, 0));
                beside += 1;
            }
            // Part of a pixel, beside the mesh.
            _ => assert!(*coverage < 1.0),
        }
    }
    assert!(inside > 1000 && beside > 1000, "{inside} and {beside}");
}

#[test]
fn a_map_on_standard_output_is_the_map_alone() {
    let place = Workplace::with("strip");
    let origin = succeed(place.folder(), &format!("{WARP} --grow"));
    let run = command(place.folder(), "warp scene.c2warp.json -o out.png --stmap - --grow").output().unwrap();
    assert!(run.stdout == std::fs::read(place.file("map.exr")).unwrap());
    assert_eq!(run.stderr, origin);
}

#[test]
fn picture_and_map_are_never_one_file() {
    let place = Workplace::with("strip");
    std::fs::create_dir(place.file("inner")).unwrap();
    for other in ["same", "./same", "inner/../same"] {
        let line = refuse(place.folder(), &format!("warp scene.c2warp.json -o same --stmap {other}"));
        assert!(line.contains("same"), "{line}");
        assert!(!place.file("same").exists());
    }
}

#[test]
fn what_is_drawn_out_at_the_border_has_finite_numbers_within_the_picture() {
    // The rim of a hole at the border has triangles without area at rest.
    let place = Workplace::with("strip").changed(|project| {
        project["domain"] = serde_json::json!({ "kind": "alpha", "threshold": 0.5 });
    });
    let mut picture = place.picture("strip.png");
    let (width, height) = picture.dimensions();
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        pixel[3] = if y + 1 == height && x % 16 < 3 || x % 24 == 0 && y == 0 { 0 } else { 255 };
    }
    picture.save(place.file("strip.png")).unwrap();
    succeed(place.folder(), WARP);
    let (_, _, map) = stmap(&place.file("map.exr"));
    assert_eq!(map.len(), (width * height) as usize);
    for [u, v, det, _] in map {
        assert!((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v) && det.abs() < 1e6, "{u}, {v}, {det}");
    }
}

#[test]
fn at_rest_the_map_is_the_identity() {
    let place = Workplace::with("strip").at_rest();
    succeed(place.folder(), WARP);
    let (width, height, map) = stmap(&place.file("map.exr"));
    for (pixel, &[u, v, det, coverage]) in map.iter().enumerate() {
        let [x, y] = [pixel % width, pixel / width].map(|i| i as f32 + 0.5);
        let (off_u, off_v) = (u - x / width as f32, 1.0 - v - y / height as f32);
        assert!(off_u.abs() < 1e-6 && off_v.abs() < 1e-6 && (det - 1.0).abs() < 1e-6 && coverage == 1.0, "{pixel}");
    }
}

/// Width, height and pixels of a map.
fn stmap(path: &Path) -> (usize, usize, Vec<[f32; 4]>) {
    let image = exr::image::read::read_first_rgba_layer_from_file(
        path,
        |size, _| (size.width(), vec![[0.0; 4]; size.area()]),
        |(width, pixels), at, (r, g, b, a): (f32, f32, f32, f32)| pixels[at.y() * *width + at.x()] = [r, g, b, a],
    )
    .unwrap();
    let size = image.layer_data.size;
    (size.width(), size.height(), image.layer_data.channel_data.pixels.1)
}
