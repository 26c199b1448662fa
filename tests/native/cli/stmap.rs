//! Tests of `c2warp warp --stmap`.

use std::path::Path;

use crate::command::{command, fail, succeed};
use crate::scene_folder::SceneFolder;
use crate::tables::table;

const WARP: &str = "warp scene.c2warp.json -o out.png --stmap map.exr";

#[test]
fn stmap_agrees_with_the_inverse_map() {
    let folder = SceneFolder::new("ring").edited(|project| {
        for handle in project["handles"].as_array_mut().unwrap() {
            handle["posed"][0] = (handle["posed"][0].as_f64().unwrap() - 20.0).into();
        }
    });
    let origin = succeed(folder.path(), &format!("{WARP} --grow --scale 2"));
    let origin: Vec<f64> = String::from_utf8(origin).unwrap().trim().split(',').map(|n| n.parse().unwrap()).collect();
    let (width, height, map) = stmap(&folder.file("map.exr"));
    let (picture, result) = (folder.picture("ring.png"), folder.picture("out.png"));
    assert!(result.dimensions() == (width as u32, height as u32) && origin[0] > 0.0, "{origin:?}");

    let index_and_origin = |pixel: usize| [(pixel % width, origin[0]), (pixel / width, origin[1])];
    let at: Vec<[f64; 2]> = (0..map.len())
        .map(|pixel| index_and_origin(pixel).map(|(i, origin)| (i as f64 + 0.5 - origin) / 2.0))
        .collect();
    let sides = [picture.width(), picture.height()].map(f64::from);
    let (mut inside, mut outside) = (0, 0);
    for (([u, v, det, coverage], row), pixel) in
        map.iter().zip(table(&folder, "map --inverse", &at).1).zip(result.pixels())
    {
        let source = [f64::from(*u) * sides[0], (1.0 - f64::from(*v)) * sides[1]];
        match [2, 3].map(|cell| row[cell].parse::<f64>()) {
            [Ok(x), Ok(y)] => {
                // The file has single precision, and the rasteriser rounds corners to 1/256 px.
                assert!((source[0] - x).hypot(source[1] - y) < 0.01 && *coverage > 0.0, "{source:?}, not {x}, {y}");
                assert!(*det > 0.0, "{det}");
                inside += 1;
            }
            _ if *coverage == 0.0 => {
                assert_eq!((u, v, det, pixel[3]), (&0.0, &0.0, &0.0, 0));
                outside += 1;
            }
            // The mesh covers a part of the pixel, but not its centre.
            _ => assert!(*coverage < 1.0),
        }
    }
    assert!(inside > 1000 && outside > 1000, "{inside} and {outside}");
}

#[test]
fn stmap_on_standard_output_has_no_other_text() {
    let folder = SceneFolder::new("strip");
    let origin = succeed(folder.path(), &format!("{WARP} --grow"));
    let run = command(folder.path(), "warp scene.c2warp.json -o out.png --stmap - --grow").output().unwrap();
    assert!(run.stdout == std::fs::read(folder.file("map.exr")).unwrap());
    assert_eq!(run.stderr, origin);
}

#[test]
fn picture_and_stmap_need_different_files() {
    let folder = SceneFolder::new("strip");
    std::fs::create_dir(folder.file("inner")).unwrap();
    for other in ["same", "./same", "inner/../same"] {
        let line = fail(folder.path(), &format!("warp scene.c2warp.json -o same --stmap {other}"));
        assert!(line.contains("same"), "{line}");
        assert!(!folder.file("same").exists());
    }
}

#[test]
fn stretched_border_has_finite_sources_inside_the_picture() {
    // The mesh around a hole at the border has triangles without area at rest.
    let folder = SceneFolder::new("strip").edited(|project| {
        project["domain"] = serde_json::json!({ "kind": "alpha", "threshold": 0.5 });
    });
    let mut picture = folder.picture("strip.png");
    let (width, height) = picture.dimensions();
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        pixel[3] = if y + 1 == height && x % 16 < 3 || x % 24 == 0 && y == 0 { 0 } else { 255 };
    }
    picture.save(folder.file("strip.png")).unwrap();
    succeed(folder.path(), WARP);
    let (_, _, map) = stmap(&folder.file("map.exr"));
    assert_eq!(map.len(), (width * height) as usize);
    for [u, v, det, _] in map {
        assert!((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v) && det.abs() < 1e6, "{u}, {v}, {det}");
    }
}

#[test]
fn stmap_at_rest_is_the_identity() {
    let folder = SceneFolder::new("strip").at_rest();
    succeed(folder.path(), WARP);
    let (width, height, map) = stmap(&folder.file("map.exr"));
    for (pixel, &[u, v, det, coverage]) in map.iter().enumerate() {
        let [x, y] = [pixel % width, pixel / width].map(|i| i as f32 + 0.5);
        let (off_u, off_v) = (u - x / width as f32, 1.0 - v - y / height as f32);
        assert!(off_u.abs() < 1e-6 && off_v.abs() < 1e-6 && (det - 1.0).abs() < 1e-6 && coverage == 1.0, "{pixel}");
    }
}

/// Reads the width, height and pixels of a map.
pub(crate) fn stmap(path: &Path) -> (usize, usize, Vec<[f32; 4]>) {
    let image = exr::image::read::read_first_rgba_layer_from_file(
        path,
        |size, _| (size.width(), vec![[0.0; 4]; size.area()]),
        |(width, pixels), at, (r, g, b, a): (f32, f32, f32, f32)| pixels[at.y() * *width + at.x()] = [r, g, b, a],
    )
    .unwrap();
    let size = image.layer_data.size;
    (size.width(), size.height(), image.layer_data.channel_data.pixels.1)
}
