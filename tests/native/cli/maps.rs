//! Tests of `c2warp maps`, read by other decoders.

use std::fs;

use exr::meta::MetaData;
use glam::DVec2;
use image::DynamicImage;

use crate::command::{fail, succeed};
use crate::scene_folder::SceneFolder;
use crate::stmap::stmap;
use crate::tables::table;

const MAPS: &str = "maps scene.c2warp.json";

/// The pixels of a 16-bit PNG as fractions.
fn levels(folder: &SceneFolder, name: &str) -> Vec<[f64; 4]> {
    let DynamicImage::ImageRgba16(picture) = image::open(folder.file(name)).unwrap() else {
        panic!("{name} has other channels");
    };
    picture.pixels().map(|pixel| pixel.0.map(|level| f64::from(level) / 65535.0)).collect()
}

/// The strip with colours that rise steadily, so that a linear filter reads them without loss.
fn graded(scene: &str) -> SceneFolder {
    let folder = SceneFolder::new(scene);
    let name = format!("{scene}.png");
    let mut picture = folder.picture(&name);
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        pixel.0 = [2 * x as u8, 4 * y as u8, 40, 255];
    }
    picture.save(folder.file(&name)).unwrap();
    folder
}

#[test]
fn applying_the_inverse_map_gives_the_warped_picture() {
    let folder = graded("strip");
    succeed(folder.path(), "warp scene.c2warp.json --scale 2 -o out.png --stmap same.exr");
    succeed(folder.path(), &format!("{MAPS} --scale 2 --inverse map.exr"));
    assert_eq!(fs::read(folder.file("same.exr")).unwrap(), fs::read(folder.file("map.exr")).unwrap());
    succeed(folder.path(), &format!("{MAPS} --scale 2 --inverse map.png"));
    let (width, _, map) = stmap(&folder.file("map.exr"));
    let (warped, levels) = (folder.picture("out.png"), levels(&folder, "map.png"));
    let mut compared = 0;
    for (pixel, ([u, v, det, alpha], level)) in map.into_iter().zip(levels).enumerate() {
        let drawn = warped.get_pixel((pixel % width) as u32, (pixel / width) as u32).0;
        assert!((f64::from(alpha) - level[3]).abs() < 1e-4);
        // Filters repeat the picture's border, and are wider where it shrinks or folds.
        let place = [f64::from(u) * 96.0, (1.0 - f64::from(v)) * 48.0];
        if alpha < 1.0
            || !(0.7..2.0).contains(&det)
            || !(2.0..94.0).contains(&place[0])
            || !(2.0..46.0).contains(&place[1])
        {
            continue;
        }
        let found = [2.0 * (place[0] - 0.5), 4.0 * (place[1] - 0.5)];
        for channel in 0..2 {
            let off = found[channel] - f64::from(drawn[channel]);
            assert!(off.abs() < 1.5, "{pixel}: {found:?}, not {drawn:?}");
        }
        assert!((level[0] - f64::from(u)).abs() < 1e-5 && (level[1] - f64::from(v)).abs() < 1e-5 && level[2] == 0.0);
        compared += 1;
    }
    assert!(compared > 10_000, "{compared}");
}

#[test]
fn forward_map_is_that_of_the_map_command_at_pixel_centres() {
    let folder = SceneFolder::new("ring");
    let origin = succeed(folder.path(), &format!("{MAPS} --scale 2 --grow --forward map.exr --inverse back.exr"));
    let origin: Vec<f64> = String::from_utf8(origin).unwrap().trim().split(',').map(|n| n.parse().unwrap()).collect();
    let (width, height, map) = stmap(&folder.file("map.exr"));
    let (result_width, result_height, back) = stmap(&folder.file("back.exr"));
    assert_eq!((width, height), (128, 128));
    let centres: Vec<[f64; 2]> =
        (0..map.len()).map(|pixel| [pixel % width, pixel / width].map(|i| i as f64 + 0.5)).collect();
    let (_, rows) = table(&folder, "map", &centres);
    let (mut inside, mut returned) = (0, 0);
    for ((&[u, v, _, alpha], row), centre) in map.iter().zip(rows).zip(centres) {
        assert!([u, v, alpha].iter().all(|value| value.is_finite()));
        let Ok(x) = row[2].parse::<f64>() else { continue };
        let expected = DVec2::new(x, row[3].parse().unwrap()) * 2.0 + DVec2::new(origin[0], origin[1]);
        let found = DVec2::new(f64::from(u) * result_width as f64, (1.0 - f64::from(v)) * result_height as f64);
        assert!(found.distance(expected) < 1e-3 && alpha == 1.0, "{found}, not {expected}");
        inside += 1;
        // The inverse map leads back to the pixel, where no other part covers it.
        let [column, line] = found.floor().to_array().map(|place| place as usize);
        let [u, v, _, coverage] = back[line * result_width + column];
        let source = DVec2::new(f64::from(u) * 128.0, (1.0 - f64::from(v)) * 128.0);
        returned += usize::from(coverage == 1.0 && source.distance(centre.into()) < 1.0);
    }
    assert!(inside > 3000 && returned > inside * 95 / 100, "{returned} of {inside}");
}

#[test]
fn header_names_the_convention_and_the_picture() {
    let folder = SceneFolder::new("strip");
    fs::copy(folder.file("strip.png"), folder.file("Größe.png")).unwrap();
    succeed(folder.path(), &format!("{MAPS} --image Größe.png --forward map.exr --inverse map.png --stretch s.exr"));
    let meta = MetaData::read_from_file(folder.file("map.exr"), true).unwrap();
    let own = &meta.headers[0].own_attributes;
    let comments = own.comments.as_ref().unwrap().to_string();
    for part in [
        "Forward ST map by c2warp: for each pixel of the picture \"Gr\\u{f6}\\u{df}e.png\" of 96 x 48 pixels",
        "u to the right and green is v upwards",
        "lower left corner",
        "half a pixel",
        "0 pixels from the left and 0 from the top, and the scale is 1.",
    ] {
        assert!(comments.contains(part), "{part}: {comments}");
    }
    assert_eq!(own.software_name.as_ref().unwrap().to_string(), "c2warp");
    let reader = png::Decoder::new(std::io::BufReader::new(fs::File::open(folder.file("map.png")).unwrap()));
    let reader = reader.read_info().unwrap();
    let text = reader.info().utf8_text.iter().find(|chunk| chunk.keyword == "Comment").unwrap().get_text().unwrap();
    assert!(text.starts_with("Inverse ST map by c2warp") && text.contains("\"Größe.png\""), "{text}");
    let again = fs::read(folder.file("map.exr")).unwrap();
    succeed(folder.path(), &format!("{MAPS} --image Größe.png --forward map.exr"));
    assert_eq!(fs::read(folder.file("map.exr")).unwrap(), again);
}

#[test]
fn stretch_has_the_growth_of_areas_and_lengths() {
    let folder = SceneFolder::new("strip");
    succeed(folder.path(), &format!("{MAPS} --stretch s.exr --inverse i.exr"));
    succeed(folder.path(), &format!("{MAPS} --stretch s.png"));
    let ((_, _, stretch), (_, _, inverse)) = (stmap(&folder.file("s.exr")), stmap(&folder.file("i.exr")));
    for ((&[area, greatest, least, alpha], [_, _, det, coverage]), level) in
        stretch.iter().zip(inverse).zip(levels(&folder, "s.png"))
    {
        assert_eq!((area, alpha), (det, coverage));
        assert!((greatest * least - area).abs() < 1e-4 && greatest >= least, "{greatest} × {least} of {area}");
        let expected = if area > 0.0 { 0.5 + f64::from(area).log2() / 8.0 } else { 0.0 };
        assert!((level[0] - expected).abs() < 1e-4, "{level:?} of {area}");
    }
    // The handle `right` grows by 1.1.
    let [_, greatest, least, _] = stretch[30 * 96 + 82];
    assert!((greatest - 1.1).abs() < 0.03 && (least - 1.1).abs() < 0.03, "{greatest}, {least}");
}

#[test]
fn disocclusion_has_the_gained_and_the_lost_opacity() {
    let folder = SceneFolder::new("ring");
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    succeed(folder.path(), &format!("{MAPS} --disocclusion mask.png"));
    let (before, after) = (folder.picture("ring.png"), folder.picture("out.png"));
    let (mut uncovered, mut covered) = (0, 0);
    for ((before, after), [red, green, blue, alpha]) in
        before.pixels().zip(after.pixels()).zip(levels(&folder, "mask.png"))
    {
        let gained = (f64::from(after[3]) - f64::from(before[3])) / 255.0;
        assert!((green - red - gained).abs() < 1e-4 && (red == 0.0 || green == 0.0) && (blue, alpha) == (0.0, 1.0));
        uncovered += usize::from(red > 0.9);
        covered += usize::from(green > 0.9);
    }
    assert!(uncovered > 50 && covered > 50, "{uncovered}, {covered}");
}

#[test]
fn maps_of_a_picture_without_handles_are_the_identity() {
    let folder = SceneFolder::new("strip").edited(|project| project["handles"] = serde_json::json!([]));
    succeed(folder.path(), &format!("{MAPS} --inverse i.exr --forward f.exr --stretch s.exr --disocclusion d.exr"));
    let [inverse, forward, stretch, mask] =
        ["i.exr", "f.exr", "s.exr", "d.exr"].map(|name| stmap(&folder.file(name)).2);
    for pixel in 0..96 * 48 {
        let (u, v) = (((pixel % 96) as f32 + 0.5) / 96.0, 1.0 - ((pixel / 96) as f32 + 0.5) / 48.0);
        for [found_u, found_v, _, alpha] in [inverse[pixel], forward[pixel]] {
            assert!((found_u - u).abs() < 1e-6 && (found_v - v).abs() < 1e-6 && alpha == 1.0, "{pixel}");
        }
        assert_eq!((stretch[pixel], mask[pixel]), ([1.0; 4], [0.0, 0.0, 0.0, 1.0]));
    }
}

#[test]
fn map_outputs_are_checked_before_the_work() {
    let folder = SceneFolder::new("strip");
    for (arguments, expected) in [
        ("--inverse a.exr --forward a.exr", "a.exr: this is also the output a.exr"),
        ("--inverse a.tif", "a.tif: the name of a map must end with .exr or .png"),
        ("--inverse a.exr --scale 0", "--scale: "),
        ("--inverse a.exr --clip wave --at 0", "there is no clip \"wave\""),
    ] {
        let line = fail(folder.path(), &format!("{MAPS} {arguments}"));
        assert!(line.contains(expected), "{line}");
        assert!(!folder.file("a.exr").exists());
    }
}
