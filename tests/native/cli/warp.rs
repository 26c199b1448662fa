//! Tests of `c2warp warp`.

use std::collections::HashSet;
use std::fs;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::codecs::webp::WebPEncoder;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageReader, RgbImage, Rgba};

use crate::command::{command, fail, succeed};
use crate::scene_folder::{SceneFolder, all_by_24_px};

const WARP: &str = "warp scene.c2warp.json -o out.png";

#[test]
fn picture_at_rest_is_unchanged() {
    let folder = SceneFolder::new("strip").at_rest();
    succeed(folder.path(), WARP);
    assert!(folder.picture("out.png") == folder.picture("strip.png"));
}

#[test]
fn picture_without_handles_is_unchanged() {
    let folder = SceneFolder::new("untouched");
    succeed(folder.path(), WARP);
    assert!(folder.picture("out.png") == folder.picture("strip.png"));
}

#[test]
fn pixels_outside_the_domain_stay_without_handles() {
    let folder = SceneFolder::new("ring").edited(|project| {
        project["handles"] = serde_json::json!([]);
        project["domain"] = serde_json::json!({ "kind": "alpha", "threshold": 1 });
    });
    let mut picture = folder.picture("ring.png");
    // Add a soft shadow and a speck.
    picture.enumerate_pixels_mut().for_each(|(x, _, pixel)| pixel[3] = pixel[3].max((x % 100) as u8));
    picture.put_pixel(1, 1, Rgba([200, 10, 10, 255]));
    picture.pixels_mut().filter(|pixel| pixel[3] == 0).for_each(|pixel| pixel.0 = [0; 4]);
    picture.save(folder.file("ring.png")).unwrap();
    succeed(folder.path(), WARP);
    assert!(folder.picture("out.png") == picture);
}

#[test]
fn ring_at_rest_keeps_its_pixels_and_edges() {
    let folder = SceneFolder::new("ring").at_rest();
    succeed(folder.path(), WARP);
    let (before, after) = (folder.picture("ring.png"), folder.picture("out.png"));
    for (x, y, &Rgba([r, g, b, a])) in before.enumerate_pixels() {
        let warped = after.get_pixel(x, y).0;
        if a == 255 {
            assert_eq!(warped, [r, g, b, a], "at {x}, {y}");
        }
        assert!(warped[3].abs_diff(a) <= 4, "at {x}, {y}: {} was {a}", warped[3]);
    }
}

#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let folder = SceneFolder::new("fold");
    let written = |jobs: u32| {
        succeed(folder.path(), &format!("{WARP} --scale 2 --stmap out.exr --jobs {jobs}"));
        ["out.png", "out.exr"].map(|name| fs::read(folder.file(name)).unwrap())
    };
    assert!(written(1) == written(7));
}

#[test]
fn single_handle_moves_its_island_only() {
    let folder = SceneFolder::new("islands");
    succeed(folder.path(), WARP);
    let (before, after) = (folder.picture("islands.png"), folder.picture("out.png"));
    for (x, y, pixel) in before.enumerate_pixels().filter(|(_, _, pixel)| pixel[3] == 255) {
        let (x, y) = if x < 60 { (x + 5, y - 3) } else { (x, y) };
        assert_eq!(after.get_pixel(x, y), pixel, "at {x}, {y}");
    }
}

#[test]
fn handle_moves_the_picture_below_it() {
    let folder = SceneFolder::new("strip");
    succeed(folder.path(), WARP);
    let after = folder.picture("out.png");
    // The handle `middle` moves its checkerboard square from (48, 24) to (50, 18).
    let difference = |a: Rgba<u8>, b: Rgba<u8>| a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    let before = folder.picture("strip.png");
    assert!(difference(*after.get_pixel(52, 21), *before.get_pixel(51, 27)) < 12);
    assert!(after != before);
}

#[test]
fn displaced_picture_moves_with_and_without_handles() {
    let displaced = || SceneFolder::new("strip").at_rest().edited(|project| project["displacement"] = all_by_24_px());
    for folder in [displaced(), displaced().edited(|project| project["handles"] = serde_json::json!([]))] {
        succeed(folder.path(), WARP);
        let (before, after) = (folder.picture("strip.png"), folder.picture("out.png"));
        let difference = |a: &Rgba<u8>, b: &Rgba<u8>| a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap();
        for (x, y, pixel) in before.enumerate_pixels().filter(|&(x, ..)| x < 72) {
            assert!(difference(pixel, after.get_pixel(x + 24, y)) <= 1, "at {x}, {y}");
        }
        assert!(after.pixels().filter(|pixel| pixel[3] == 0).count() >= 23 * 48);
        assert_eq!(succeed(folder.path(), &format!("{WARP} --grow")), b"0,0\n");
        assert_eq!(folder.picture("out.png").dimensions(), (120, 48));
    }
}

#[test]
fn handle_moves_the_displaced_picture() {
    let folder = SceneFolder::new("strip").at_rest().edited(|project| {
        let handles = project["handles"].as_array_mut().unwrap();
        handles.truncate(1);
        let [x, y] = [0, 1].map(|axis| handles[0]["rest"][axis].as_f64().unwrap());
        handles[0]["posed"] = serde_json::json!([x - 24.0, y + 6.0]);
        project["displacement"] = all_by_24_px();
    });
    succeed(folder.path(), WARP);
    let (before, after) = (folder.picture("strip.png"), folder.picture("out.png"));
    let difference = |a: &Rgba<u8>, b: &Rgba<u8>| a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    for (x, y, pixel) in before.enumerate_pixels().filter(|&(_, y, _)| y < 42) {
        assert!(difference(pixel, after.get_pixel(x, y + 6)) <= 1, "at {x}, {y}");
    }
}

#[test]
fn scale_sets_the_size_of_the_result() {
    let folder = SceneFolder::new("strip").at_rest();
    for (scale, size) in [("0.5", (48, 24)), ("2", (192, 96)), ("1.01", (97, 48))] {
        succeed(folder.path(), &format!("{WARP} --scale {scale}"));
        let after = folder.picture("out.png");
        assert_eq!(after.dimensions(), size);
        assert!(after.pixels().all(|pixel| pixel[3] == 255), "at scale {scale}");
    }
}

#[test]
fn grown_result_holds_the_picture_and_prints_its_origin() {
    let folder = SceneFolder::new("strip").at_rest();
    assert_eq!(succeed(folder.path(), &format!("{WARP} --grow")), b"0,0\n");
    assert!(folder.picture("out.png") == folder.picture("strip.png"));

    let folder = folder.edited(|project| {
        for handle in project["handles"].as_array_mut().unwrap() {
            let [x, y] = [0, 1].map(|axis| handle["rest"][axis].as_f64().unwrap());
            handle["posed"] = serde_json::json!([x - 20.0, y + 6.0]);
        }
    });
    assert_eq!(succeed(folder.path(), &format!("{WARP} --grow")), b"20,0\n");
    let grown = folder.picture("out.png");
    assert_eq!(grown.dimensions(), (116, 54));
    for (x, y, pixel) in folder.picture("strip.png").enumerate_pixels() {
        assert_eq!(grown.get_pixel(x, y + 6), pixel, "at {x}, {y}");
    }
    assert_eq!(succeed(folder.path(), &format!("{WARP} --grow --scale 0.5")), b"10,0\n");
    assert_eq!(folder.picture("out.png").dimensions(), (58, 27));
}

#[test]
fn grown_result_with_a_far_handle_is_rejected() {
    for far in [1e6, 1.2e6, 9e6] {
        let folder = SceneFolder::new("strip").edited(|project| {
            let handles = project["handles"].as_array_mut().unwrap();
            handles.truncate(1);
            handles[0]["posed"] = serde_json::json!([far, 20.0]);
        });
        let line = fail(folder.path(), &format!("{WARP} --grow"));
        assert!(line.contains("the whole warped picture would have"), "{line}");
    }
}

#[test]
fn pixelated_result_has_no_new_colours() {
    let folder = SceneFolder::new("strip");
    let known: HashSet<Rgba<u8>> = folder.picture("strip.png").pixels().copied().chain([Rgba([0; 4])]).collect();
    let new_colours = |name: &str| folder.picture(name).pixels().filter(|pixel| !known.contains(pixel)).count();
    succeed(folder.path(), WARP);
    assert!(new_colours("out.png") > 100);
    for more in ["--pixelated", "--pixelated --grow --scale 2"] {
        succeed(folder.path(), &format!("{WARP} {more}"));
        assert_eq!(new_colours("out.png"), 0, "{more}");
    }
}

#[test]
fn output_is_deterministic() {
    let folder = SceneFolder::new("ring");
    succeed(folder.path(), WARP);
    succeed(folder.path(), "warp scene.c2warp.json -o again.png");
    let bytes = |name| std::fs::read(folder.file(name)).unwrap();
    assert!(bytes("out.png") == bytes("again.png"));
}

#[test]
fn image_option_replaces_the_picture() {
    let folder = SceneFolder::new("strip").at_rest();
    let mut grey = folder.picture("strip.png");
    grey.pixels_mut().for_each(|pixel| pixel.0 = [7, 7, 7, 255]);
    // The contents decide the type, not the extension.
    grey.save_with_format(folder.file("grey.jpg"), image::ImageFormat::WebP).unwrap();
    std::fs::remove_file(folder.file("strip.png")).unwrap();
    succeed(folder.path(), &format!("{WARP} --image grey.jpg"));
    assert!(folder.picture("out.png") == grey);
}

/// A TIFF header and one entry: tag 0x0112 (orientation), one short, 6 (a clockwise quarter turn).
const TURNED: &[u8] = b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";

/// A picture that was stored sideways: red on the left, and after a clockwise quarter turn on top.
fn sideways() -> RgbImage {
    RgbImage::from_fn(48, 96, |x, _| if x < 24 { [250, 0, 0] } else { [0, 0, 250] }.into())
}

#[test]
fn exif_orientation_is_applied() {
    let folder = SceneFolder::new("untouched");
    let mut jpeg = Vec::new();
    let mut encoder = JpegEncoder::new_with_quality(&mut jpeg, 100);
    encoder.set_exif_metadata(TURNED.to_vec()).unwrap();
    encoder.encode_image(&sideways()).unwrap();
    let mut webp = Vec::new();
    let mut encoder = WebPEncoder::new_lossless(&mut webp);
    encoder.set_exif_metadata([b"Exif\0\0", TURNED].concat()).unwrap();
    encoder.write_image(&sideways(), 48, 96, ExtendedColorType::Rgb8).unwrap();
    for file in [jpeg, webp] {
        folder.write("photo", file);
        succeed(folder.path(), &format!("{WARP} --image photo"));
        let upright = folder.picture("out.png");
        assert_eq!(upright.dimensions(), (96, 48));
        assert!(upright.get_pixel(48, 4)[0] > 240 && upright.get_pixel(48, 44)[2] > 240);
    }
}

#[test]
fn jpeg_without_its_end_marker_is_read() {
    let folder = SceneFolder::new("untouched");
    let mut jpeg = Vec::new();
    let picture = DynamicImage::ImageRgba8(folder.picture("strip.png"));
    JpegEncoder::new(&mut jpeg).encode_image(&picture.into_rgb8()).unwrap();
    folder.write("whole.jpg", &jpeg);
    succeed(folder.path(), &format!("{WARP} --image whole.jpg"));
    let whole = folder.picture("out.png");
    let unmarked = &jpeg[..jpeg.len() - 2];
    for trailer in [&b""[..], b"data of the camera"] {
        folder.write("unmarked.jpg", [unmarked, trailer].concat());
        succeed(folder.path(), &format!("{WARP} --image unmarked.jpg"));
        assert!(folder.picture("out.png") == whole);
    }
    folder.write("unmarked.jpg", &unmarked[..unmarked.len() - 3]);
    assert!(fail(folder.path(), &format!("{WARP} --image unmarked.jpg")).contains("damaged or truncated"));
}

#[test]
fn rgb_colour_profiles_are_kept() {
    let folder = SceneFolder::new("untouched");
    // Only the colour space of the profile matters, so the other bytes are filler.
    let profile = |space: &[u8; 4]| [[7; 16].as_slice(), space, &[7; 700]].concat();
    let out = || {
        succeed(folder.path(), &format!("{WARP} --image tagged"));
        let mut decoder = ImageReader::open(folder.file("out.png")).unwrap().into_decoder().unwrap();
        decoder.icc_profile().unwrap()
    };
    let tagged = RgbImage::from_pixel(96, 48, [200, 100, 50].into());
    for (space, kept) in [(b"RGB ", Some(profile(b"RGB "))), (b"GRAY", None)] {
        let mut jpeg = Vec::new();
        let mut encoder = JpegEncoder::new(&mut jpeg);
        encoder.set_icc_profile(profile(space)).unwrap();
        encoder.encode_image(&tagged).unwrap();
        folder.write("tagged", jpeg);
        assert_eq!(out(), kept);
        let mut png = Vec::new();
        let mut encoder = PngEncoder::new(&mut png);
        encoder.set_icc_profile(profile(space)).unwrap();
        encoder.write_image(&tagged, 96, 48, ExtendedColorType::Rgb8).unwrap();
        folder.write("tagged", png);
        assert_eq!(out(), kept);
    }
    // A gAMA chunk becomes a profile. Here it holds a gamma of 1.
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(&tagged, 96, 48, ExtendedColorType::Rgb8).unwrap();
    let end_of_header = 33;
    png.splice(end_of_header..end_of_header, *b"\0\0\0\x04gAMA\0\x01\x86\xa0\x31\xe8\x96\x5f");
    folder.write("tagged", png);
    assert!(out().is_some());
}

#[cfg(unix)]
#[test]
fn links_and_pipes_are_written_through() {
    let folder = SceneFolder::new("untouched");
    folder.write("real.png", "");
    std::os::unix::fs::symlink("real.png", folder.file("out.png")).unwrap();
    succeed(folder.path(), WARP);
    assert!(folder.file("out.png").is_symlink());
    let piped = command(folder.path(), "warp scene.c2warp.json -o /dev/stdout").output().unwrap().stdout;
    assert!(piped == std::fs::read(folder.file("real.png")).unwrap());
    assert_eq!(folder.file_names(), ["out.png", "real.png", "scene.c2warp.json", "strip.png"]);
    // A link to a file that does not exist yet.
    std::fs::remove_file(folder.file("real.png")).unwrap();
    succeed(folder.path(), WARP);
    assert!(folder.file("out.png").is_symlink() && folder.file("real.png").is_file());
}

#[test]
fn a_clip_poses_the_handles_at_a_time() {
    let folder = SceneFolder::new("strip").at_rest().edited(|project| {
        let id = project["handles"][0]["id"].clone();
        let keys = serde_json::json!([{ "time": 0, "ease": "linear", "rotation": 0 }, { "time": 2, "rotation": 40 }]);
        let tracks = serde_json::json!([{ "handle": id, "keys": keys }]);
        project["clips"] = serde_json::json!([{ "name": "turn", "duration": 2, "loop": "none", "tracks": tracks }]);
    });
    succeed(folder.path(), "warp scene.c2warp.json --clip turn --at 1 -o clip.png");
    let line = fail(folder.path(), "warp scene.c2warp.json --clip wave --at 1 -o out.png");
    assert!(line.contains(r#"there is no clip "wave": the clips are ["turn"]"#), "{line}");
    let folder = folder.edited(|project| project["handles"][0]["rotation"] = 20.into());
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    assert!(folder.picture("clip.png") == folder.picture("out.png"));
    let run = command(folder.path(), "warp scene.c2warp.json --clip turn -o out.png").output().unwrap();
    assert_eq!(run.status.code(), Some(2), "a clip without a time");
}
